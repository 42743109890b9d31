#include <fstream>
#include <iostream>

#include <apps/common/progress.h>
#include <apps/hair/commands.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>
#include <libhair/hair_state.h>

namespace hair {

namespace {

// strands.hair, 7 -> strands.0007.hair
std::filesystem::path numbered(const std::filesystem::path& file, int frame) {
  std::string number = std::to_string(frame);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  std::filesystem::path out = file;
  return out.replace_extension(number + file.extension().string());
}

void load(const std::filesystem::path& file, Performance& performance) {
  std::ifstream in(file, std::ios::binary);
  require(in.is_open(), file.string(), ": cannot read");
  try {
    performance.resume(in);
  } catch (const Error& error) {
    throw Error(text(file.string(), ": ", error.what()));
  }
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
  if (!options.loadState.empty()) load(options.loadState, performance);
  StatsLog stats;
  Progress progress("simulate", options.frames);
  for (int f = 0; f < options.frames; ++f) {
    performance.step();
    if (!options.results.stats.empty()) stats.add(performance);
    if (!options.out.empty()) writeStrands(numbered(options.out, f), performance.hair.strands());
    progress.step();
  }
  progress.finish();
  if (!options.saveState.empty())
    writeAtomically(options.saveState,
                    [&](std::ostream& out) { saveState(performance.hair, out); });
  writeResults(options.results, performance, performance.log, stats);
}

}  // namespace hair
