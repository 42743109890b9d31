// Interior placement beside two other implementations of section 3.3: sparse Cholesky on the
// residuals as they stand, and Ceres.
#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/surface.h>

#include <gtest/gtest.h>
#include <Eigen/SparseCholesky>

#include <tests/hair_mesh/ceres_placement.h>
#include <tests/hair_mesh/placement_samples.h>

namespace hair {
namespace {

double sizeOf(const HairMesh& mesh) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const HairMesh::Layer& layer : mesh.layers)
    for (const glm::vec3 p : layer.positions) low = glm::min(low, p), high = glm::max(high, p);
  return glm::distance(low, high);
}

// J has a row for every side quad of every bundle, with 1 and -1 where its residual has them, and a
// column for every free vertex; what is held stands on the right. The solution of J^T J x = J^T b.
std::vector<std::vector<glm::dvec3>> solveDirectly(const HairMesh& mesh) {
  const auto exterior = exteriorVertices(mesh);
  std::vector<std::vector<int>> column;
  std::vector<std::vector<glm::dvec3>> places;
  int columns = 0, rows = 0;
  for (std::size_t k = 0; k < mesh.layerCount(); ++k) {
    const HairMesh::Layer& layer = mesh.layers[k];
    column.emplace_back(layer.vertexCount(), -1);
    places.emplace_back(layer.positions.begin(), layer.positions.end());
    for (std::size_t v = 0; v < layer.vertexCount(); ++v)
      if (exterior[k][v] == 0 && layer.pinned[v] == 0) column[k][v] = columns++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<glm::dvec3> right;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::size_t k = 0; k < mesh.lastLayer[j]; ++k)
      for (std::size_t i = 0; i < mesh.sides(j); ++i, ++rows) {
        right.emplace_back(0);
        const auto add = [&](std::size_t layer, std::size_t at, double sign) {
          const std::uint32_t v = mesh.face(layer, j)[at % mesh.sides(j)];
          if (column[layer][v] >= 0) {
            entries.emplace_back(rows, column[layer][v], sign);
          } else {
            right.back() -= sign * places[layer][v];
          }
        };
        add(k + 1, i, 1), add(k, i, -1), add(k + 1, i + 1, -1), add(k, i + 1, 1);
      }
  Eigen::SparseMatrix<double> jacobian(rows, columns);
  jacobian.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixXd b(rows, 3);
  for (int r = 0; r < rows; ++r)
    for (int axis = 0; axis < 3; ++axis) b(r, axis) = right[static_cast<std::size_t>(r)][axis];
  const Eigen::SparseMatrix<double> normal = jacobian.transpose() * jacobian;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(normal);
  EXPECT_EQ(factors.info(), Eigen::Success);
  const Eigen::MatrixXd x = factors.solve(jacobian.transpose() * b);
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < column[k].size(); ++v)
      if (column[k][v] >= 0)
        for (int axis = 0; axis < 3; ++axis) places[k][v][axis] = x(column[k][v], axis);
  return places;
}

class PlacementOf : public testing::TestWithParam<test::Sample> {
 public:
  const HairMesh& mesh = GetParam().mesh;
};
INSTANTIATE_TEST_SUITE_P(Sample, PlacementOf, testing::ValuesIn(test::samples()), test::nameOf);

TEST_P(PlacementOf, IsWhatSparseCholeskyFinds) {
  HairMesh ours = test::shakenInside(mesh, 0.05f);
  ASSERT_TRUE(placeInterior(ours).unique);
  const auto direct = solveDirectly(mesh);
  double most = 0;
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < direct[k].size(); ++v)
      most = std::max(most, glm::distance(glm::dvec3(ours.layers[k].positions[v]), direct[k][v]));
  EXPECT_LT(most, 1e-6 * sizeOf(mesh));
}

TEST_P(PlacementOf, IsWhatCeresFinds) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "Ceres is not built for sanitizers: they see races, and frees by another "
                  "allocator of Eigen's, that there are not without them";
#endif
  const HairMesh start = test::shakenInside(mesh, 0.05f);
  HairMesh ours = start;
  placeInterior(ours);
  for (const auto solver : {ceres::CGNR, ceres::SPARSE_NORMAL_CHOLESKY}) {
    HairMesh theirs = start;
    test::CeresPlacement(theirs).place(solver, theirs);
    double most = 0;
    for (std::size_t k = 0; k < mesh.layerCount(); ++k)
      for (std::size_t v = 0; v < ours.layers[k].vertexCount(); ++v)
        most = std::max<double>(
            most, glm::distance(ours.layers[k].positions[v], theirs.layers[k].positions[v]));
    EXPECT_LT(most, 1e-6 * sizeOf(mesh)) << ceres::LinearSolverTypeToString(solver);
  }
}

}  // namespace
}  // namespace hair
