#pragma once

#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/files/strand_file.h>

namespace HAIR_API hair {

/// The points of new strands as positions on the old ones: between points `index` and `index + 1`,
/// at t. With t = 0 it is an old point, bit for bit.
struct ResamplePlan {
  /// Where one new point is.
  struct Sample {
    std::uint32_t index;  ///< of an old point
    float t;              ///< [0, 1)
  };
  std::vector<Sample> samples;             ///< [new pointCount]
  std::vector<std::uint32_t> first = {0};  ///< [new strandCount + 1]
};

/// `count` of `total` strands, in order. The choice is pseudo-random but always the same; that of a
/// smaller count is a subset of that of a larger one.
std::vector<std::uint32_t> chooseStrands(std::size_t total, std::size_t count);

/// The chosen strands with `pointsPerStrand` points, evenly spaced along their length, root and
/// tip kept; 0: with the points they have.
ResamplePlan planResampling(StrandView strands, const std::vector<std::uint32_t>& chosen,
                            std::size_t pointsPerStrand);

/// One item for each new point, from one for each old point; empty stays empty.
template <class T>
std::vector<T> resample(const ResamplePlan& plan, const std::vector<T>& items) {
  std::vector<T> result;
  if (items.empty()) return result;
  result.reserve(plan.samples.size());
  for (const auto [index, t] : plan.samples)
    result.push_back(t == 0 ? items[index] : items[index] + t * (items[index + 1] - items[index]));
  return result;
}

/// The same for the strands of a file and all of their arrays.
inline void resample(const ResamplePlan& plan, StrandFile& file) {
  file.thickness = resample(plan, file.thickness);
  file.transparency = resample(plan, file.transparency);
  file.colours = resample(plan, file.colours);
  file.strands = {resample(plan, file.strands.points), plan.first};
}

}  // namespace hair
