// In place of the peers that were not found.

#include <benchmarks/peers.h>

namespace hair::bench {

#ifndef HAIR_BENCH_BULLET
std::unique_ptr<GuideSolver> makeBulletRopes(const GuideWork&, int) {
  return nullptr;
}
std::unique_ptr<GuideSolver> makeBulletChains(const GuideWork&, int) {
  return nullptr;
}
#endif

#ifndef HAIR_BENCH_OPENVDB
ShadowPeer makeOpenVdbShadow(StrandView, const LightSpace&, float, float) {
  return {};
}
#endif

#ifndef HAIR_BENCH_EMBREE
ShadowPeer makeEmbreeShadow(StrandView, const Fibre&, const LightSpace&) {
  return {};
}
#endif

}  // namespace hair::bench
