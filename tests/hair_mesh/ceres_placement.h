#pragma once

#include <array>

#include <ceres/ceres.h>

#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/surface.h>

namespace hair::test {

/// Interior placement by Ceres: a cost function for each side quad of each bundle, exterior and
/// pinned vertices held.
class CeresPlacement {
 public:
  explicit CeresPlacement(const HairMesh& mesh) {
    auto held = exteriorVertices(mesh);
    for (const HairMesh::Layer& layer : mesh.layers) places_.emplace_back(layer.vertexCount());
    for (std::size_t k = 0; k + 1 < mesh.layerCount(); ++k)
      for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
        if (mesh.lastLayer[j] <= k) continue;
        const auto low = mesh.face(k, j), high = mesh.face(k + 1, j);
        for (std::size_t i = 0; i < low.size(); ++i) {
          const std::size_t next = (i + 1) % low.size();
          problem_.AddResidualBlock(
              new ceres::AutoDiffCostFunction<Difference, 3, 3, 3, 3, 3>(new Difference), nullptr,
              places_[k][low[i]].data(), places_[k][low[next]].data(),
              places_[k + 1][high[i]].data(), places_[k + 1][high[next]].data());
        }
      }
    for (std::size_t k = 0; k < mesh.layerCount(); ++k)
      for (std::size_t v = 0; v < held[k].size(); ++v) {
        const bool stays = held[k][v] != 0 || mesh.layers[k].pinned[v] != 0;
        double* place = places_[k][v].data();
        if (stays && problem_.HasParameterBlock(place)) problem_.SetParameterBlockConstant(place);
      }
  }

  /// From where the vertices of `mesh`, which is that of construction, are.
  void place(ceres::LinearSolverType solver, HairMesh& mesh) {
    for (std::size_t k = 0; k < mesh.layerCount(); ++k)
      for (std::size_t v = 0; v < places_[k].size(); ++v)
        for (int axis = 0; axis < 3; ++axis)
          places_[k][v][static_cast<std::size_t>(axis)] = mesh.layers[k].positions[v][axis];
    ceres::Solver::Options options;
    options.linear_solver_type = solver;
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.num_threads = 1;
    options.max_linear_solver_iterations = 10'000;
    options.eta = 1e-6;
    options.function_tolerance = 1e-12;
    // The sum is quadratic: no damping, one step.
    options.initial_trust_region_radius = 1e16;
    options.max_trust_region_radius = 1e20;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    for (std::size_t k = 0; k < mesh.layerCount(); ++k)
      for (std::size_t v = 0; v < places_[k].size(); ++v)
        for (int axis = 0; axis < 3; ++axis)
          mesh.layers[k].positions[v][axis] =
              static_cast<float>(places_[k][v][static_cast<std::size_t>(axis)]);
  }

 private:
  struct Difference {
    template <class T>
    bool operator()(const T* a, const T* b, const T* c, const T* d, T* difference) const {
      for (int i = 0; i < 3; ++i) difference[i] = (c[i] - a[i]) - (d[i] - b[i]);
      return true;
    }
  };

  std::vector<std::vector<std::array<double, 3>>> places_;
  ceres::Problem problem_;
};

}  // namespace hair::test
