#pragma once

#include <filesystem>
#include <string>

#include <apps/common/player.h>

namespace hair {

/// Where the figures of a run go; the options --profile, --stats and --hash of every program.
struct ResultFiles {
  std::filesystem::path profile;  ///< CSV: stage,items,ms_median,ms_p95
  std::filesystem::path stats;    ///< CSV, one row a frame (StatsLog)
  bool hash = false;              ///< last line: `hash` and 16 hexadecimal digits
};

/// Writes what was asked for, prints the median time of a frame of the log, and the hash last.
void writeResults(const ResultFiles& files, const Player& player, const ProfileLog& log,
                  const StatsLog& stats);

/// One line: medians of the log's frames without Stage::Draw and of Stage::Draw alone, and how many
/// frames a second that makes without drawing and with it. `drawnBy`: what drew, or empty.
std::string drawingTimes(const ProfileLog& log, const std::string& drawnBy);

}  // namespace hair
