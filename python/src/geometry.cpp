// Places, meshes, and distances to them.
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/model/head.h>

#include "choices.h"
#include "strands.h"
#include "topics.h"
#ifdef HAIR_PYTHON_MODEL
#include <libhair/files/obj.h>
#endif

namespace hair::python {

namespace {

// Else it would show up frames later, in the hair.
glm::vec3 finite(glm::vec3 translation) {
  for (int c = 0; c < 3; ++c)
    if (!std::isfinite(translation[c]))
      throw py::value_error("translation: not finite; metres are wanted");
  return translation;
}

// Rows of a 4 × 4 matrix that turns and moves, no more.
RigidTransform transformOf(const py::sequence& rows) {
  using Matrix = py::array_t<double, py::array::c_style | py::array::forcecast>;
  // A list first: what other programs have for matrices is a sequence of sequences, no array.
  py::object source = rows;
  if (!py::isinstance<py::array>(source)) {
    py::list list;
    for (const py::handle row : rows)
      list.append(py::list(py::reinterpret_borrow<py::object>(row)));
    source = list;
  }
  const Matrix matrix = Matrix::ensure(source);
  if (!matrix) throw py::error_already_set();
  if (matrix.ndim() != 2 || matrix.shape(0) != 4 || matrix.shape(1) != 4)
    throw py::value_error("transform: a matrix of (4, 4) is wanted");
  for (int c = 0; c < 4; ++c)
    if (!(std::abs(matrix.at(3, c) - (c == 3 ? 1 : 0)) < 1e-6))
      throw py::value_error(
          "transform: the last row is not (0, 0, 0, 1); of a matrix with its move in that row, "
          "give "
          "matrix.T");
  glm::dmat3 turn;
  glm::dvec3 move;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) turn[c][r] = matrix.at(r, c);
    move[r] = matrix.at(r, 3);
  }
  for (int c = 0; c < 3; ++c) {
    const double length = glm::length(turn[c]);
    if (glm::determinant(turn) < 0) throw py::value_error("transform: the matrix mirrors");
    if (!(std::abs(length - 1) < 1e-3) || !(std::abs(glm::dot(turn[c], turn[(c + 1) % 3])) < 1e-3))
      throw py::value_error(text("transform: not only a turn and a move (column ", c,
                                 " has length ", length, "); take scale and shear out of it"));
  }
  return {glm::normalize(glm::quat(glm::quat_cast(turn))), finite(glm::vec3(move))};
}

py::array matrixOf(const RigidTransform& t) {
  const glm::dmat3 turn = glm::mat3_cast(glm::dquat(t.rotation));
  py::array_t<double> matrix({4, 4});
  auto m = matrix.mutable_unchecked<2>();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      m(r, c) = r == 3   ? (c == 3 ? 1.0 : 0.0)
                : c == 3 ? static_cast<double>(t.translation[r])
                         : turn[c][r];
  return matrix;
}

void bindTransform(py::module_& m) {
  py::class_<RigidTransform>(m, "Transform", R"(A turn, then a move: the place of a rigid thing.

rotation: unit quaternion (w, x, y, z); translation: metres. Wherever a Transform is wanted, a 4 x 4
matrix (array or sequence of rows) does too.)")
      .def(py::init([](const py::sequence& matrix) { return transformOf(matrix); }),
           py::arg("matrix"),
           "From a matrix (4, 4) that turns and moves; ValueError where it scales or shears.")
      .def(py::init([](glm::quat rotation, glm::vec3 translation) {
             const float length = glm::length(rotation);
             if (!(length > 1e-6f) || !std::isfinite(length))
               throw py::value_error("rotation: a quaternion (w, x, y, z) without a length");
             return RigidTransform{glm::normalize(rotation), finite(translation)};
           }),
           py::kw_only(), py::arg("rotation") = glm::quat(1, 0, 0, 0),
           py::arg("translation") = glm::vec3(0), "From quaternion (w, x, y, z) and metres.")
      .def_readonly("rotation", &RigidTransform::rotation, "(w, x, y, z), unit.")
      .def_readonly("translation", &RigidTransform::translation, "(x, y, z), metres.")
      .def_property_readonly("matrix", &matrixOf, "The same as a matrix, (4, 4) float64; a copy.")
      .def(
          "inverse", [](const RigidTransform& t) { return inverse(t); }, "The way back.")
      .def(
          "apply",
          [](const RigidTransform& t, const py::object& points) {
            const py::array in = requirePoints(points, "points");
            std::vector<glm::vec3> out;
            out.reserve(pointsOf(in).size());
            for (const glm::vec3 p : pointsOf(in)) out.push_back(t.point(p));
            return arrayOfPoints(std::move(out));
          },
          py::arg("points"), "Points (N, 3) float32, turned and moved: a new array.")
      .def(
          "__matmul__", [](const RigidTransform& a, const RigidTransform& b) { return a * b; },
          py::arg("other"), "world_from_head @ head_from_local.")
      .def("__repr__", [](const RigidTransform& t) {
        const glm::quat& q = t.rotation;
        const glm::vec3& p = t.translation;
        return text("Transform(rotation=(", q.w, ", ", q.x, ", ", q.y, ", ", q.z,
                    "), translation=(", p.x, ", ", p.y, ", ", p.z, "))");
      });
  py::implicitly_convertible<py::sequence, RigidTransform>();
}

// Read-only arrays over a mesh that they keep.
template <class Scalar, class T>
py::array meshArray(const Mesh& mesh, const std::vector<T>& items) {
  return arrayOver(reinterpret_cast<const Scalar*>(items.data()),
                   {static_cast<py::ssize_t>(items.size()), 3}, capsuleOf(mesh));
}

}  // namespace

Mesh meshOf(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->positions.assign(positions.begin(), positions.end());
  mesh->triangles.assign(triangles.begin(), triangles.end());
  for (const glm::uvec3 t : mesh->triangles)
    if (glm::max(glm::max(t.x, t.y), t.z) >= positions.size())
      throw py::value_error(text("triangles: vertex ", glm::max(glm::max(t.x, t.y), t.z),
                                 " of only ", positions.size()));
  computeNormals(*mesh);
  return mesh;
}

void bindGeometry(py::module_& m) {
  bindTransform(m);

  py::class_<TriangleMesh, Mesh>(m, "Mesh",
                                 "Triangles, counter-clockwise seen from outside; metres.")
      .def(py::init([](const py::object& positions, const py::object& triangles) {
             const py::array p = requirePoints(positions, "positions");
             const py::array t =
                 requireArray(triangles, "triangles", py::dtype::of<std::uint32_t>(), {kAny, 3});
             return meshOf(pointsOf(p), spanOf<const glm::uvec3, std::uint32_t>(t));
           }),
           py::arg("positions"), py::arg("triangles"),
           "positions (V, 3) float32, metres; triangles (T, 3) uint32. Copies, and makes normals.")
      .def_property_readonly(
          "positions", [](const Mesh& mesh) { return meshArray<float>(mesh, mesh->positions); },
          "(V, 3) float32, metres; a read-only view.")
      .def_property_readonly(
          "normals", [](const Mesh& mesh) { return meshArray<float>(mesh, mesh->normals); },
          "(V, 3) float32, unit, smooth; a read-only view.")
      .def_property_readonly(
          "triangles",
          [](const Mesh& mesh) { return meshArray<std::uint32_t>(mesh, mesh->triangles); },
          "(T, 3) uint32; a read-only view.")
      .def("__repr__", [](const TriangleMesh& mesh) {
        return text("<Mesh of ", mesh.positions.size(), " vertices, ", mesh.triangles.size(),
                    " triangles>");
      });

  m.def(
      "builtin_head",
      [] { return withoutLock([] { return std::make_shared<TriangleMesh>(builtinHead().mesh); }); },
      "The mannequin that the built-in styles grow on, as a Mesh in head space.");
  m.def(
      "read_obj",
      [](const std::filesystem::path& path, float scale, UpAxis up) -> Mesh {
#ifdef HAIR_PYTHON_MODEL
        return withoutLock(
            [&] { return std::make_shared<TriangleMesh>(readObj(path, {scale, up})); });
#else
        (void)scale, (void)up;
        throw Error(path.string() + ": this libhair was built without OBJ files (HAIR_WITH_MODEL)");
#endif
      },
      py::arg("path"), py::arg("scale") = 0.0f, py::arg("up") = UpAxis::AsFile,
      R"(The faces of an OBJ file, triangulated, in metres, +Y up.

scale: metres per unit of the file, 0: what it states, or 1. up: which axis of the file points up.)");

  py::class_<MeshSdf, std::shared_ptr<MeshSdf>>(
      m, "DistanceField", R"(Signed distance to a mesh on a grid: what hair collides with.

Made once (up to seconds) and shared by any number of simulations.)")
      .def(py::init([](const Mesh& mesh, float cell, float margin) {
             return withoutLock([&] { return std::make_shared<MeshSdf>(*mesh, cell, margin); });
           }),
           py::arg("mesh").none(false), py::arg("cell") = 0.004f, py::arg("margin") = 0.03f,
           "cell: of the grid, metres. margin: how far it reaches beyond the mesh, metres.")
      .def(
          "distance",
          [](const MeshSdf& field, const py::object& points, const py::object& out) {
            const py::array in = requirePoints(points, "points");
            py::array result = outputOf<float>(out, {in.shape(0)});
            const auto to = spanOf<float, float>(result);
            const auto from = pointsOf(in);
            withoutLock([&] {
              for (std::size_t i = 0; i < from.size(); ++i) to[i] = field.distance(from[i]);
            });
            return result;
          },
          py::arg("points"), py::arg("out") = py::none(),
          "Metres from points (N, 3) float32 to the surface, negative inside: (N,) float32.")
      .def("__repr__", [](const MeshSdf& field) {
        const glm::ivec3 n = field.nodes();
        return text("<DistanceField of ", n.x, " x ", n.y, " x ", n.z, " nodes>");
      });

  py::class_<HeadFit>(m, "HeadFit", "A head for hair that comes without one (fit_head).")
      .def_readonly("transform", &HeadFit::headFromHair, "Where the hair comes to lie, head space.")
      .def_property_readonly(
          "mesh", [](const HeadFit& fit) { return std::make_shared<TriangleMesh>(fit.head.mesh); },
          "The head, scaled under the roots: a Mesh in head space.")
      .def_readonly("residual", &HeadFit::residual,
                    "Mean distance of the roots to the head, metres.")
      .def("__repr__",
           [](const HeadFit& fit) { return text("<HeadFit to ", 1000 * fit.residual, " mm>"); });
  m.def(
      "fit_head",
      [](const py::object& roots) {
        const py::array in = requirePoints(roots, "roots");
        return withoutLock([&] { return fitHeadToRoots(pointsOf(in)); });
      },
      py::arg("roots"),
      "The built-in head, scaled so that its scalp passes through roots (N, 3) float32, N >= 16.");
  m.def(
      "place_head",
      [](const Mesh& mesh, const py::object& roots) {
        const py::array in = requirePoints(roots, "roots");
        return withoutLock([&] { return placeHead(*mesh, pointsOf(in)); });
      },
      py::arg("mesh").none(false), py::arg("roots"),
      "How to move a loaded bust, whose hair has these roots (N, 3) float32, into head space.");
}

}  // namespace hair::python
