#pragma once

#include <cstddef>
#include <filesystem>

#include <apps/common/performance.h>
#include <libhair/files/strand_file.h>

namespace hair {

/// One struct of options and one function a command of the program `hair`; each in a file of its
/// own. Functions print results on the standard output and throw Error for bad input.

/// hair info FILE
struct InfoOptions {
  std::filesystem::path file;  ///< .hair, .tfx, .data, .obj or .bvh
  ReadOptions read;
};
void runInfo(const InfoOptions& options);

/// hair convert IN OUT
struct ConvertOptions {
  std::filesystem::path in;   ///< .hair, .tfx or .data
  std::filesystem::path out;  ///< .hair
  ReadOptions read;
  std::size_t strands = 0;  ///< keep so many, chosen at random but always the same; 0: all
  std::size_t points = 0;   ///< a strand, evenly along its length; 0: as they are
  float minLength = 1e-3f;  ///< shorter strands are dropped, metres
};
void runConvert(const ConvertOptions& options);

/// hair simulate
struct SimulateOptions {
  SubjectOptions subject;
  PerformanceOptions performance;
  int frames = 120;
  int threads = 0;                ///< 0: as many as the machine has
  std::filesystem::path out;      ///< .hair; one file a frame, numbered before the extension
  std::filesystem::path profile;  ///< CSV: stage,items,ms_median,ms_p95
  std::filesystem::path stats;    ///< CSV, one row a frame (StatsLog)
  bool hash = false;              ///< last line: `hash` and 16 hexadecimal digits
};
void runSimulate(const SimulateOptions& options);

}  // namespace hair
