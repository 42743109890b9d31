#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/triangle_mesh.h>

namespace HAIR_API hair {

/// The head that the built-in styles grow on: a plain mannequin made of smoothly joined
/// ellipsoids, 0.225 m from chin to crown. Head space: metres, +Y up, +Z where the face looks,
/// origin at the joint on which the head turns. The neck is closed 0.11 m below the origin, where
/// it is as wide as a body's neck (radius 0.05 m).
struct Head {
  TriangleMesh mesh;  ///< head space, metres
};

/// Makes its mesh from headField; the same bits every time.
Head builtinHead();

/// Distance to the built-in head's surface, metres, negative inside; within about 20 % of the
/// true distance near the surface, less exact far from it.
float headField(glm::vec3 p);

/// Where hair grows on the built-in head: 1 on the scalp, 0 on face, ears and neck, with a soft
/// edge of about 6 mm at the hairline (0.5 at the hairline itself). `p` on or near the surface.
float scalpMask(glm::vec3 p);

/// Moves a loaded bust (metres, +Y up, face to +Z) into head space: its skull is aligned with that
/// of the built-in head, so that the origin is about the top of its neck. The skull is the sphere
/// that fits `hairRoots` best, in the mesh's coordinates; or, for fewer than 16 roots, the
/// uppermost 8 cm of the mesh. Translation only.
RigidTransform placeHead(const TriangleMesh& mesh, std::span<const glm::vec3> hairRoots);

/// Throws Error, with the scale that would do, where roots (metres) spread over more than 1.2 m or
/// less than 2 cm: no head's. Fewer than 16 roots are let pass.
void requireHeadSized(std::span<const glm::vec3> hairRoots);

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
