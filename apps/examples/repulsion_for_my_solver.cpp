// Keeps hair apart in somebody else's solver: the library's density grid says how crowded each
// place is and which way is out of it; the solver does the rest.
//
//   example_repulsion_for_my_solver
//
// Look at: the solver (here five lines: positions, velocities, drag) knows nothing of hair, and no
// pair of strands is ever tested: the work is one pass over the strands and one look-up a point.
// Half of the points of a bundle that was pressed together leave it, until it is no denser than it
// should be; one that is thin enough would not move at all.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include <libhair/repulsion/repulsion.h>

int main() {
  // 400 upright strands of 10 points, 18 cm long, within a finger's width.
  hair::StrandSet strands;
  std::minstd_rand random;
  const auto uniform = [&] { return static_cast<float>(random()) / 0x1p31f; };
  for (int s = 0; s < 400; ++s) {
    const float angle = 6.2832f * uniform(), r = 0.01f * std::sqrt(uniform());
    std::vector<glm::vec3> strand;
    for (int i = 0; i < 10; ++i)
      strand.emplace_back(r * std::cos(angle), 0.02f * static_cast<float>(i), r * std::sin(angle));
    strands.append(strand);
  }
  const hair::Fibre fibre{.hairsPerStrand = 10};
  constexpr float kAllowed = 2e6f;   // metres of hair in a cubic metre
  constexpr float kStrength = 2.0f;  // m/s² where it is twice that
  hair::RepulsionSettings settings;
  settings.cellSize = 0.01f;
  settings.strandStride = 1;  // count every strand
  hair::DensityGrid density;

  const auto crowding = [&] {  // of the mean point
    float sum = 0;
    for (const glm::vec3 p : strands.points) sum += hair::sampleDensity(density, p).density;
    return sum / static_cast<float>(strands.points.size());
  };
  const auto width = [&] {  // that holds half of the points
    std::vector<float> radii;
    for (const glm::vec3 p : strands.points) radii.push_back(std::hypot(p.x, p.z));
    std::nth_element(radii.begin(), radii.begin() + 2000, radii.end());
    return 200 * radii[2000];
  };

  constexpr float kStep = 1.0f / 60;
  std::vector<glm::vec3> velocity(strands.points.size(), glm::vec3(0));
  float before = 0;
  for (int frame = 0; frame <= 120; ++frame) {
    hair::measureDensity(strands, fibre, settings, density);
    if (frame == 0) before = crowding();
    if (frame % 20 == 0)
      std::printf("%.2f s: half of the hair within %.1f cm, %.0f km of it in a m³ around a point\n",
                  kStep * static_cast<float>(frame), width(), 1e-3f * crowding());
    for (std::size_t p = 0; p < strands.points.size(); ++p) {
      // The push: out of places that are too dense, down the density.
      const hair::DensitySample here = hair::sampleDensity(density, strands.points[p]);
      const float steep = glm::length(here.gradient);
      glm::vec3 push(0);
      if (here.density > kAllowed && steep > 0)
        push = -kStrength * (here.density / kAllowed - 1) / steep * here.gradient;
      if (const float size = glm::length(push); size > kStrength) push *= kStrength / size;
      // The solver.
      velocity[p] = 0.8f * (velocity[p] + kStep * push);
      strands.points[p] += kStep * velocity[p];
    }
  }
  const float after = crowding();
  const bool apart = after < 1.1f * kAllowed && before > 3 * kAllowed;
  std::printf(apart ? "it came apart\n" : "it did NOT come apart: %g, was %g\n", after, before);
  return apart ? 0 : 1;
}
