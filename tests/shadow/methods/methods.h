#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/density_map_method.h>
#include <libhair/shadow/methods/opacity_map.h>
#include <libhair/shadow/methods/shadow_map.h>
#include <libhair/shadow/methods/shadow_method.h>

#include "../fixture.h"

namespace hair::test {

/// A method with its settings, made anew by each call.
struct Candidate {
  std::string name;
  std::function<std::unique_ptr<ShadowMethod>()> make;
};

inline std::vector<Candidate> candidates() {
  std::vector<Candidate> all;
  all.push_back({"density map", [] {
                   DensityMapSettings s;
                   s.cells = 256;
                   s.cellSize = 4e-3f;
                   return makeDensityMapMethod(s);
                 }});
  all.push_back({"shadow map", [] { return makeShadowMap({}); }});
  for (int slices : {1, 16})
    for (LateralFilter filter : {LateralFilter::Linear, LateralFilter::Nearest})
      all.push_back(
          {text("opacity map, slices ", slices, ", filter ", static_cast<int>(filter)), [=] {
             OpacityMapSettings s;
             s.slices = slices;
             s.filter = filter;
             return makeOpacityMap(s);
           }});
  using Deep = DeepOpacityMapSettings;
  for (auto beyond : {Deep::Beyond::Ignored, Deep::Beyond::InLastLayer, Deep::Beyond::LargerLayers})
    for (auto growth : {Deep::Growth::Linear, Deep::Growth::Doubling})
      for (int bits : {8, 32})
        all.push_back({text("deep opacity map, beyond ", static_cast<int>(beyond), ", growth ",
                            static_cast<int>(growth), ", bits ", bits),
                       [=] {
                         Deep s;
                         s.beyond = beyond;
                         s.growth = growth;
                         s.depthBits = bits;
                         return makeDeepOpacityMap(s);
                       }});
  return all;
}

inline std::vector<float> sampled(const ShadowMethod& method, std::span<const glm::vec3> points) {
  std::vector<float> out(points.size(), -1.0f);
  method.sample(points, out);
  return out;
}

inline std::vector<float> shadowed(ShadowMethod& method, StrandView strands,
                                   const LightSpace& light, const Fibre& fibre = {}) {
  method.build(strands, fibre, light);
  return sampled(method, strands.points);
}

inline LightSpace parallelLight() {
  return makeLightSpace(kSlanted);
}
/// From the same side as parallelLight(), near enough to matter.
inline LightSpace nearLight(float distance = 2.0f) {
  return makePointLightSpace(-distance * glm::normalize(kSlanted), glm::vec3(0));
}

}  // namespace hair::test
