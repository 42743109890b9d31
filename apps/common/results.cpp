#include <apps/common/results.h>

#include <iostream>

#include <libhair/files/atomic_write.h>

namespace hair {

void writeResults(const ResultFiles& files, const Performance& performance, const StatsLog& stats) {
  if (!files.profile.empty())
    writeAtomically(files.profile, [&](std::ostream& out) { performance.log.writeCsv(out); });
  if (!files.stats.empty())
    writeAtomically(files.stats, [&](std::ostream& out) { out << stats.csv(); });
  std::cout << performance.hair.strands().strandCount() << " strands, "
            << performance.hair.strands().pointCount()
            << " points: " << performance.log.milliseconds(Stage::Motion, Stage::Shade, 0.5)
            << " ms a frame (median, without drawing)\n";
  if (files.hash) std::cout << "hash " << stateHash(performance.hair) << '\n';
}

}  // namespace hair
