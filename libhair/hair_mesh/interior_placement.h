#pragma once

#include <libhair/hair_mesh/hair_mesh.h>

namespace hair {

/// [layer][vertex], 1 for exterior vertices: those of the scalp, of tip faces, and of side quads
/// that a single bundle has (Yuksel et al. 2009, section 3.3, figure 2a).
std::vector<std::vector<std::uint8_t>> exteriorVertices(const HairMesh& mesh);

struct PlacementSettings {
  float tolerance = 1e-6f;          ///< of the residual, beside that of the right-hand side, > 0
  std::uint32_t maxIterations = 0;  ///< 0: as many as there are free vertices, at most 10,000
};

struct PlacementResult {
  std::uint32_t iterations = 0;
  float residual = 0;  ///< relative, what is left
  bool converged = true;
  bool unique = true;  ///< false: free vertices that nothing holds; they keep their mean offset
};

/// Places interior vertices (section 3.3): of all places of the vertices that are neither exterior
/// nor pinned, those that minimise
///
///   sum_j sum_k sum_i |(V_{j,i}^{k+1} - V_{j,i}^k) - (V_{j,i+1}^{k+1} - V_{j,i+1}^k)|^2
///
/// by conjugate gradients from where they are. The matrix depends on topology and pins alone: it is
/// assembled here, once; an edit of places costs its right-hand side and a warm start.
class InteriorPlacement {
 public:
  explicit InteriorPlacement(const HairMesh& mesh);

  /// `mesh` of the same topology and pins as at construction; moves its free vertices.
  PlacementResult place(HairMesh& mesh, const PlacementSettings& settings = {});
};

/// All of it for a mesh that is edited once.
PlacementResult placeInterior(HairMesh& mesh, const PlacementSettings& settings = {});

}  // namespace hair
