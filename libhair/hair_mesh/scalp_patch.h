#pragma once

#include <libhair/core/api.h>
#include <libhair/hair_mesh/hair_mesh.h>
#include <libhair/model/styles.h>

namespace HAIR_API hair {

/// A scalp as rings of polygons around a pole: `sectors` triangles around it, then rings of quads.
/// Ring r (0 the innermost), sector s is face r · sectors + s; sectors are numbered
/// counter-clockwise as seen from above, from the front (+Z) on: the edges between the last sector
/// and sector 0 lead straight from the pole to the front.
struct ScalpPatch {
  std::uint32_t rings = 4;     ///< >= 1
  std::uint32_t sectors = 16;  ///< >= 3
};

/// The scalp of the built-in head: vertices on its surface, the last ring on the hairline
/// (scalpMask). The pole is the whorl, and the edges that lead from it to the front are the
/// parting.
PolygonMesh headScalp(const ScalpPatch& patch, const Parting& parting = {});

/// The top of a sphere around the origin, down to `degrees` (0, 180) from its pole.
PolygonMesh sphereScalp(const ScalpPatch& patch, float radius, float degrees);

}  // namespace hair
