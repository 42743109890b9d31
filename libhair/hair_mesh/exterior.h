#pragma once

#include <cstdint>
#include <vector>

#include <libhair/hair_mesh/hair_mesh.h>

namespace hair {

/// [layer][vertex], 1 for exterior vertices: those of the scalp, of tip faces, and of side quads
/// that a single bundle has (Yuksel et al. 2009, section 3.3, figure 2a). What is 0 lies inside the
/// volume, where no one sees it. `mesh` is valid (validate).
std::vector<std::vector<std::uint8_t>> exteriorVertices(const HairMesh& mesh);

}  // namespace hair
