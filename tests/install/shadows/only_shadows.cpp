// A program that only wants shadows on its own strands, and links no more than that needs.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <libhair/shadow/density_map.h>

int main() {
  // Its own arrays: a wall of 100 × 100 level strands, 10 cm wide and deep, light from above.
  constexpr int kAcross = 100, kLayers = 100, kPoints = 3;
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> first{0};
  for (int layer = 0; layer < kLayers; ++layer)
    for (int s = 0; s < kAcross; ++s) {
      for (int p = 0; p < kPoints; ++p)
        points.emplace_back(0.05f * static_cast<float>(p), 1.0f - 1e-3f * static_cast<float>(layer),
                            1e-3f * static_cast<float>(s));
      first.push_back(static_cast<std::uint32_t>(points.size()));
    }
  const hair::Fibre fibre{.width = 1e-4f, .opacity = 0.5f, .hairsPerStrand = 1};

  hair::DensityMapSettings settings;
  settings.cells = 64;
  settings.cellSize = 5e-3f;
  hair::DensityMap map;
  hair::clear(map, settings, hair::makeLightSpace({0, -1, 0}));
  hair::deposit({points, first}, fibre, map);
  hair::computeTransmittance(map);
  std::vector<float> light(points.size());
  hair::sampleTransmittance(map, points, light);

  // Below d metres of it, exp(-d · width · opacity / spacing²) of the light is left.
  bool good = true;
  for (int layer : {0, 25, 50, 75, 99}) {
    const auto p = static_cast<std::size_t>((layer * kAcross + kAcross / 2) * kPoints + 1);
    const float depth = 1.0f - points[p].y;
    const float expected = std::exp(-depth * fibre.width * fibre.opacity / 1e-6f);
    std::printf("%5.1f mm deep: light %.3f, expected %.3f\n", 1e3f * depth, light[p], expected);
    good = good && std::abs(light[p] - expected) < 0.06f;
  }
  std::puts(good ? "right" : "WRONG");
  return good ? 0 : 1;
}
