#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/model/head.h>

namespace HAIR_API hair {

/// Moves a loaded bust (metres, +Y up, face to +Z) into head space: its skull comes to lie where
/// the built-in head has its own, so that the origin is about the top of its neck. `hairRoots`,
/// in the mesh's coordinates, say where the skull is (the sphere they lie on best); without at
/// least 16 roots, the uppermost 8 cm of the mesh do. Translation only.
RigidTransform placeHead(const TriangleMesh& mesh, std::span<const glm::vec3> hairRoots);

/// Throws Error, with the scale that would do, where roots (metres) spread over more than 1.2 m or
/// less than 2 cm: no head's. Fewer than 16 roots are let pass.
void requireHeadSized(std::span<const glm::vec3> hairRoots);

/// A head for hair that comes without one.
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
