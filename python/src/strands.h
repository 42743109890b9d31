#pragma once

#include <memory>

#include <libhair/core/strands.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/geometry/triangle_mesh.h>

#include "arrays.h"

namespace hair::python {

/// Strands in arrays of Python's: the library works on their memory.
struct Strands {
  py::array points;  ///< [N, 3] float32
  py::array first;   ///< [S + 1] uint32

  /// Throws as requireArray.
  Strands(const py::object& points, const py::object& first);
  /// Takes them over.
  explicit Strands(StrandSet strands);

  std::size_t strandCount() const { return static_cast<std::size_t>(first.size()) - 1; }
  /// What the library reads, checked: whoever has the arrays may have written anything meanwhile.
  /// Throws Error.
  StrandView view(std::size_t minPoints = 1) const;
  StrandView unchecked() const {
    return {pointsOf(points), spanOf<const std::uint32_t, std::uint32_t>(first)};
  }
};

using Field = std::shared_ptr<MeshSdf>;
using Mesh = std::shared_ptr<TriangleMesh>;

/// A copy of the arrays' items, with normals.
Mesh meshOf(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

}  // namespace hair::python
