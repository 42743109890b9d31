// Shadows strands of one's own: arrays in, the light that gets to each point out. No simulation.
//
//   example_shadow_my_strands
//
// Look at: four lines do the work (clear, deposit, computeTransmittance, sampleTransmittance), the
// arrays stay the caller's, and any points can be asked, here those of the ground. In even hair
// light dies as exp(-depth) does, which is how a reader can tell that it is right.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <libhair/shadow/density_map.h>

int main() {
  // A curtain of 100 × 100 level strands, a millimetre apart, 10 cm wide, high and deep.
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> first{0};  // strand s owns points first[s] .. first[s + 1] - 1
  for (int layer = 0; layer < 100; ++layer)
    for (int s = 0; s < 100; ++s) {
      for (int p = 0; p < 3; ++p)
        points.emplace_back(0.05f * static_cast<float>(p), 1.0f - 1e-3f * static_cast<float>(layer),
                            1e-3f * static_cast<float>(s));
      first.push_back(static_cast<std::uint32_t>(points.size()));
    }
  const hair::Fibre fibre{.width = 1e-4f, .opacity = 0.5f, .hairsPerStrand = 1};

  // Light from above, cells of 5 mm. Keep the map from frame to frame: it keeps its memory.
  hair::DensityMapSettings settings;
  settings.cells = 64;
  settings.cellSize = 5e-3f;
  hair::DensityMap map;
  hair::clear(map, settings, hair::makeLightSpace({0, -1, 0}));
  hair::deposit({points, first}, fibre, map);
  hair::computeTransmittance(map);
  std::vector<float> light(points.size());
  hair::sampleTransmittance(map, points, light);

  bool right = true;
  std::puts("depth    light  expected");
  for (std::size_t layer = 0; layer < 100; layer += 9) {
    const std::size_t p = (layer * 100 + 50) * 3 + 1;  // in the middle of it
    const float depth = 1.0f - points[p].y;
    const float expected = std::exp(-depth * fibre.width * fibre.opacity / (1e-3f * 1e-3f));
    right = right && std::abs(light[p] - expected) < 0.06f;
    std::printf("%2.0f mm    %.3f  %.3f  %s\n", 1e3f * depth, light[p], expected,
                std::string(static_cast<std::size_t>(40 * light[p]), '#').c_str());
  }

  // The ground below, from the middle of the shadow to the light beside it.
  std::vector<glm::vec3> ground;
  for (int i = 0; i < 10; ++i) ground.emplace_back(0.05f + 0.01f * static_cast<float>(i), 0, 0.05f);
  std::vector<float> onGround(ground.size());
  hair::sampleTransmittance(map, ground, onGround);
  std::printf("on the ground, a step a centimetre:");
  for (const float l : onGround) std::printf(" %.2f", l);
  right = right && onGround.front() < 0.02f && onGround.back() == 1;
  std::puts(right ? "\nas expected" : "\nNOT as expected");
  return right ? 0 : 1;
}
