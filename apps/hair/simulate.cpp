#include <iostream>

#include <apps/common/progress.h>
#include <apps/hair/commands.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

// strands.hair, 7 -> strands.0007.hair
std::filesystem::path numbered(const std::filesystem::path& file, int frame) {
  std::string number = std::to_string(frame);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  std::filesystem::path out = file;
  return out.replace_extension(number + file.extension().string());
}

}  // namespace

void runSimulate(const SimulateOptions& options) {
  const ThreadLimit limit(options.threads);
  const Subject subject(options.subject);
  for (const std::string& note : subject.notes) std::cerr << note << '\n';
  PerformanceOptions performing = options.performance;
  // Shadows are work only for those who look at their times.
  performing.shadow = performing.shadow && !options.results.profile.empty();
  Performance performance(subject, performing);
  performance.settings.shade = performing.shadow;
  StatsLog stats;
  Progress progress("simulate", options.frames);
  for (int f = 0; f < options.frames; ++f) {
    performance.step();
    if (!options.results.stats.empty()) stats.add(performance);
    if (!options.out.empty()) writeStrands(numbered(options.out, f), performance.hair.strands());
    progress.step();
  }
  progress.finish();
  writeResults(options.results, performance, performance.log, stats);
}

}  // namespace hair
