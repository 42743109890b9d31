#pragma once

#include <cstring>
#include <limits>

#include <libhair/core/random.h>
#include <libhair/files/strand_file.h>

namespace hair {

/// What a format holds, for samples that are all of it and no more.
struct Holds {
  std::size_t least = 1, most = 9;  ///< points of a strand; equal: all strands the same
  bool arrays = false;
};

/// A float of any size below 1e8, of either sign, now and then an edge of what floats can say.
inline float anyCoordinate(std::uint32_t seed, std::uint32_t use) {
  static constexpr float kEdges[] = {0.0f,
                                     -0.0f,
                                     std::numeric_limits<float>::denorm_min(),
                                     -std::numeric_limits<float>::min(),
                                     std::numeric_limits<float>::epsilon(),
                                     99999992.0f,
                                     -99999992.0f,
                                     1.0f / 3,
                                     16777216.0f,
                                     -0.1f};
  const float kind = uniform(seed, 4 * use),
              sign = uniform(seed, 4 * use + 1) < 0.5f ? -1.0f : 1.0f;
  if (kind < 0.2f)
    return kEdges[static_cast<int>(kind * 5 * static_cast<float>(std::size(kEdges)))];
  const float exponent = 15 * uniform(seed, 4 * use + 2) - 8;  // 1e-8 to 1e7
  return sign * (1 + uniform(seed, 4 * use + 3)) * std::pow(10.0f, exponent);
}

/// Random strands, the same for the same seed.
inline StrandFile anyStrands(std::uint32_t seed, const Holds& holds) {
  StrandFile file;
  std::uint32_t use = 0;
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(uniform(seed + 1000, use++) * static_cast<float>(n));
  };
  const std::size_t strandCount = 1 + below(12);
  for (std::size_t s = 0; s < strandCount; ++s) {
    std::vector<glm::vec3> points(holds.least + below(holds.most - holds.least + 1));
    for (glm::vec3& p : points)
      for (int c = 0; c < 3; ++c) p[c] = anyCoordinate(seed, use++);
    file.strands.append(points);
  }
  if (!holds.arrays) return file;
  for (std::size_t i = 0; i < file.strands.pointCount(); ++i) {
    file.thickness.push_back(1e-4f * uniform(seed, use++));
    file.transparency.push_back(uniform(seed, use++));
    file.colours.emplace_back(uniform(seed, use), uniform(seed, use + 1), uniform(seed, use + 2));
    use += 3;
  }
  return file;
}

/// Bit for bit: 0 is not -0.
template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace hair
