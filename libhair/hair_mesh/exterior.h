#pragma once

#include <cstdint>
#include <vector>

#include <libhair/hair_mesh/hair_mesh.h>

namespace hair {

/// A side quad of a prism: an edge of a face and the same edge in the layer below.
struct PrismSide {
  std::uint32_t corner,  ///< a corner of the face, among all corners of the mesh
      next;              ///< the one after it around the face
  bool outer;            ///< of one bundle alone
};

/// Side quads between `layer` (1 or above) and the one below, each once: one that two bundles share
/// is listed for the first of them.
std::vector<PrismSide> prismSides(const HairMesh& mesh, std::size_t layer);

}  // namespace hair
