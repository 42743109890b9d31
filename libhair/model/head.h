#pragma once

#include <libhair/core/api.h>
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

}  // namespace hair
