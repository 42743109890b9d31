#include <apps/common/results.h>

#include <iomanip>
#include <iostream>
#include <sstream>

#include <libhair/core/state_hash.h>
#include <libhair/files/atomic_write.h>

namespace hair {

void writeResults(const ResultFiles& files, const Player& player, const ProfileLog& log,
                  const StatsLog& stats) {
  if (!files.profile.empty())
    writeAtomically(files.profile, [&](std::ostream& out) { log.writeCsv(out); });
  if (!files.stats.empty())
    writeAtomically(files.stats, [&](std::ostream& out) { out << stats.csv(); });
  std::cout << player.hair.strands().strandCount() << " strands, "
            << player.hair.strands().pointCount()
            << " points: " << log.milliseconds(Stage::Motion, Stage::Shade, 0.5)
            << " ms a frame (median, without drawing)\n";
  if (files.hash) std::cout << "hash " << hexText(player.simulation.stateHash()) << '\n';
}

std::string drawingTimes(const ProfileLog& log, const std::string& drawnBy) {
  const double simulated = log.milliseconds(Stage::Motion, Stage::Shade, 0.5);
  const double drawn = log.milliseconds(Stage::Draw, 0.5);
  if (simulated <= 0 || drawn <= 0) return "no drawing was timed";
  std::ostringstream out;
  out << std::setprecision(3) << "simulated and shadowed " << simulated << " ms, drawn " << drawn
      << " ms a frame (median)" << (drawnBy.empty() ? "" : " by ") << drawnBy << ": "
      << 1000 / simulated << " frames a second without drawing, " << 1000 / (simulated + drawn)
      << " with it";
  return out.str();
}

}  // namespace hair
