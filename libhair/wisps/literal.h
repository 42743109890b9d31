#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <libhair/guides/contact.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/model/groom.h>
#include <libhair/wisps/wisps.h>

namespace hair::literal {

/// Direct implementation of sampleGuides and interpolateWisps: one point at a time, in double, on
/// one thread. Slow; the reference for tests of the passes that draw sixteen points at once, with
/// which it shares only the distances to colliders (geometry/).
///
/// With G_j the curves through the three guides of a strand and F the frame carried along the
/// first, both at the sample nearest to the strand's point k (Bertails et al. 2005, sections 3.1
/// and 4.1: Catmull-Rom; Groom), a strand s is
///     multi(k)  = sum_j weights[s][j] G_j(k) + F(k) offset(k),
///     single(k) = G_0(k) + F(k) (r + offset(k)),    r such that both have one root at rest.
/// The first point of multi, after the root, that is nearer to a collider than its clearance is
/// `hit` (SIGGRAPH 2010 course, "Avoiding interpolated hair collisions"). From `start`, blendPoints
/// before it but after the root,
///     p(k) = mix(multi(k), single(k), t² (3 - 2 t)),    t = (k - start) / (hit - start) up to 1,
/// and is moved twice to the clearance of the nearest collider where it is nearer.
///
/// The clearance is settings.clearance; to the head no more than the strand, its root left out, has
/// at rest to `headAtRest` (null: not limited). `guides`, of this groom, and `colliders` at the end
/// of the frame. Returns [pointCount], metres, world. Arguments are not checked.
std::vector<glm::dvec3> interpolateWisps(const Groom& groom, const GuideStrands& guides,
                                         const ColliderState& colliders,
                                         const WispSettings& settings = {},
                                         const MeshSdf* headAtRest = nullptr);

}  // namespace hair::literal
