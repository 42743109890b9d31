#pragma once

#include <libhair/core/api.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace HAIR_API hair {

/// Termination of the solver.
struct PlacementSettings {
  /// Residual: root mean square distance of free vertices from equilibrium with their neighbours,
  /// relative to the diagonal of the box around the fixed vertices; above 0.
  float tolerance = 1e-8f;
  std::uint32_t maxIterations = 0;  ///< 0: as many as there are free vertices, at most 10,000
};

/// Result of the solver.
struct PlacementResult {
  std::uint32_t iterations = 0;  ///< of conjugate gradients
  float residual = 0;            ///< as PlacementSettings::tolerance
  bool converged = true;         ///< residual <= tolerance
  bool unique = true;  ///< false: some layers have no fixed vertex; they keep their centroid
};

/// Places interior vertices (Yuksel et al. 2009, section 3.3): finds the positions of the vertices
/// that are neither exterior nor pinned which minimise
///
///   E = sum_j sum_k sum_i |(V_{j,i}^{k+1} - V_{j,i}^k) - (V_{j,i+1}^{k+1} - V_{j,i+1}^k)|^2
///
/// over bundles j, prisms k = 0 ... n_j - 1 between layers k and k + 1, and corners i. (The paper
/// counts k from 1 to n_j; it means every prism.) A side quad between two bundles is summed twice.
/// The quads of a single bundle are constant, as all four of their vertices are exterior, so that
/// summing each quad once would give the same minimum.
///
/// E is the same quadratic form in x, y and z: one symmetric integer matrix, assembled once from
/// topology and pins. After an edit of positions only the right-hand side and conjugate gradients
/// (Shewchuk 1994, Jacobi preconditioner), started from the current positions, are needed. They use
/// double: the condition number grows with the squares of the numbers of layers and of faces
/// across, and in float the residual would vanish in rounding before a large drag has converged.
/// One thread: the same bits on every machine.
///
/// The paper calls the minimum unique. It is, unless all vertices of a connected part of a layer
/// are free (an inner layer around a closed scalp): E is invariant under their common translation.
/// Such layers keep their centroid.
class InteriorPlacement {
 public:
  /// Throws Error if `mesh` is not valid.
  explicit InteriorPlacement(const HairMesh& mesh);

  /// Moves the free vertices of `mesh`, which has the topology and the pins of construction. Throws
  /// Error, and moves nothing, if these differ, if a position is not finite, or if a setting is not
  /// in its range.
  PlacementResult place(HairMesh& mesh, const PlacementSettings& settings = {});

  /// Vertices that are neither exterior nor pinned.
  std::size_t freeCount() const { return inverse_.size(); }

 private:
  void numberVertices(const HairMesh& mesh);
  void assemble(const HairMesh& mesh);
  void findIslands(const HairMesh& mesh);
  double gather(const HairMesh& mesh);
  PlacementResult solve(double size, const PlacementSettings& settings);

  std::uint64_t topology_ = 0;         ///< hash of topology and pins
  std::vector<std::uint32_t> number_;  ///< [vertexCount], root first: free ones 0 ..., held behind
  std::vector<std::vector<std::uint32_t>> islands_;  ///< free vertices that shift together

  // Rows of the matrix, for free vertices: columns of free vertices, then of held ones.
  std::vector<std::uint32_t> first_;      ///< [freeCount + 1]
  std::vector<std::uint32_t> firstHeld_;  ///< [freeCount]
  std::vector<std::uint32_t> columns_;
  std::vector<float> weights_;   ///< [columns], whole numbers
  std::vector<double> inverse_;  ///< [freeCount], 1 over the diagonal
  double diagonalSum_ = 0;

  // Workspace of place, by number_: kept so that an edit allocates nothing.
  std::vector<glm::dvec3> places_;                                ///< [vertexCount], metres
  std::vector<glm::dvec3> move_, residual_, direction_, change_;  ///< [freeCount]
};

/// Assembles the system and solves it, for a mesh that is edited once.
PlacementResult placeInterior(HairMesh& mesh, const PlacementSettings& settings = {});

}  // namespace hair
