#include <fstream>
#include <iostream>

#include <apps/common/progress.h>
#include <apps/hair/commands.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>

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
  performing.shadow = performing.shadow && !options.profile.empty();
  Performance performance(subject, performing);
  performance.settings.shade = performing.shadow;
  StatsLog stats;
  Progress progress("simulate", options.frames);
  for (int f = 0; f < options.frames; ++f) {
    performance.step();
    if (!options.stats.empty()) stats.add(performance);
    if (!options.out.empty()) writeStrands(numbered(options.out, f), performance.hair.strands());
    progress.step();
  }
  progress.finish();
  if (!options.profile.empty())
    writeAtomically(options.profile, [&](std::ostream& out) { performance.log.writeCsv(out); });
  if (!options.stats.empty())
    writeAtomically(options.stats, [&](std::ostream& out) { out << stats.csv(); });
  std::cout << options.frames << " frames, " << performance.hair.strands().strandCount()
            << " strands, " << performance.log.milliseconds(Stage::Motion, Stage::Draw, 0.5)
            << " ms a frame (median)\n";
  if (options.hash) std::cout << "hash " << stateHash(performance.hair) << '\n';
}

}  // namespace hair
