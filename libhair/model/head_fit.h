#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/model/head.h>

namespace HAIR_API hair {

/// Moves a loaded bust (metres, +Y up, face to +Z) into head space: its skull is aligned with that
/// of the built-in head, so that the origin is about the top of its neck. The skull is the sphere
/// that fits `hairRoots` best, in the mesh's coordinates; or, for fewer than 16 roots, the
/// uppermost 8 cm of the mesh. Translation only.
RigidTransform placeHead(const TriangleMesh& mesh, std::span<const glm::vec3> hairRoots);

/// A head fitted to hair that has none.
struct HeadFit {
  RigidTransform headFromHair;  ///< where the hair comes to lie in head space; translation only
  Head head;                    ///< the built-in head, scaled along each axis under the roots
  float residual;               ///< mean distance of the roots to it, metres
};

/// Scales the built-in head (by 0.6 to 1.7 along each axis) so that its scalp passes through the
/// roots (metres, +Y up, face to +Z), by least squares. Throws Error for fewer than 16 roots, or
/// if the roots are nowhere near a head (mean distance above 3 cm): the units are wrong then.
HeadFit fitHeadToRoots(std::span<const glm::vec3> hairRoots);

}  // namespace hair
