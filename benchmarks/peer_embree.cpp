#include <benchmarks/peers.h>

#include <cmath>
#include <memory>
#include <vector>

#include <libhair/core/parallel.h>
#include <libhair/measure/embree/embree_tracer.h>

namespace hair::bench {

ShadowPeer makeEmbreeShadow(StrandView strands, const Fibre& fibre, const LightSpace& light) {
  struct State {
    std::vector<ShadowRay> rays;
    std::vector<std::uint32_t> crossings;
  };
  auto state = std::make_shared<State>();
  state->rays.resize(strands.pointCount());
  state->crossings.resize(strands.pointCount());
  return [=](std::span<float> out) {
    const auto tracer = makeEmbreeTracer(strands, fibre);
    parallelFor(strands.strandCount(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s)
        for (std::uint32_t p = strands.first[s]; p < strands.first[s + 1]; ++p)
          state->rays[p] = {strands.points[p], -light.directionAt(strands.points[p]), INFINITY,
                            static_cast<std::uint32_t>(s)};
    });
    tracer->countCrossings(state->rays, state->crossings);
    parallelFor(out.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
        out[p] = std::pow(1 - fibre.opacity, static_cast<float>(state->crossings[p]));
    });
  };
}

}  // namespace hair::bench
