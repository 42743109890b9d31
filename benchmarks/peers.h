#pragma once

#include <functional>
#include <memory>
#include <span>

#include <benchmarks/guide_work.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/model/groom.h>

/// Other people's software at the same work. Each is built where it was found, and is null, or an
/// empty function, where it was not.
namespace hair::bench {

/// All strands as ropes of one btSoftBody of Bullet (HAIR_WITH_BULLET): links that `iterations` of
/// relaxation pull at, no bending, the sphere as a rigid body. One thread.
std::unique_ptr<GuideSolver> makeBulletRopes(const GuideWork& work, int iterations);

/// A btMultiBody of Bullet each (Featherstone): spherical joints, which cannot stretch, so many
/// `substeps` a frame. Without the collider: it is the cost of the links alone. One thread.
std::unique_ptr<GuideSolver> makeBulletChains(const GuideWork& work, int substeps);

/// Transmittance at every point of some strands, [pointCount].
using ShadowPeer = std::function<void(std::span<float> out)>;

/// A sparse grid of OpenVDB (HAIR_WITH_OPENVDB) that counts points, as the paper's map does, each
/// worth `extinction` (1/metre) on the length of a cell; then from every point a walk towards the
/// light, a cell a step. The grid is filled by one thread, the walks are on all.
ShadowPeer makeOpenVdbShadow(StrandView strands, const LightSpace& light, float cellSize,
                             float extinction);

/// Embree (hair::embree, HAIR_WITH_EMBREE): its tree over all segments, then a ray from every point
/// that counts the fibres on its way to the light. All threads.
ShadowPeer makeEmbreeShadow(StrandView strands, const Fibre& fibre, const LightSpace& light);

}  // namespace hair::bench
