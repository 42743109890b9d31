#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/files/strand_file.h>

namespace HAIR_API hair {

/// How much of a file of strands is wanted, and how it is read.
struct LoadOptions {
  ReadOptions read{};         ///< units and axes of the file
  std::uint32_t strands = 0;  ///< so many of them, chosen as chooseStrands does; 0: all
  std::uint32_t points = 0;   ///< of each, evenly spaced; 0: those it has
};

/// Strands of a file that can be simulated, drawn and measured.
struct LoadedStrands {
  StrandFile file;                      ///< metres, +Y up, +Z face; without degenerate strands
  std::vector<std::uint32_t> strandOf;  ///< [strandCount] number in the file; empty: the same
  /// [strandCount] place of the strand's first point among all the file's points; among those of
  /// `file` where points were asked for anew; empty: the same.
  std::vector<std::uint32_t> firstOf;
  std::vector<std::string> notes;  ///< what was assumed, dropped or missing, a sentence each
};

/// What all programs do with `--hair FILE` before anything else: reads the file (readStrands),
/// leaves out strands of a single point or shorter than 1 mm, then chooses and resamples. Throws
/// Error (file, place, cause), also where no strand is left.
LoadedStrands loadStrands(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace hair
