// Hair at rest: built-in styles, strands of one's own, hair meshes.
#include "groom.h"

#include <algorithm>
#include <fstream>

#include <libhair/core/error.h>
#include <libhair/model/styles.h>
#include <libhair/wisps/load_groom.h>

#include "choices.h"
#include "topics.h"
#ifdef HAIR_PYTHON_MODEL
#include <libhair/files/obj.h>
#endif
#ifdef HAIR_PYTHON_HAIR_MESH
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <libhair/hair_mesh/mesh_groom.h>
#include <libhair/hair_mesh/script/script.h>
#endif

namespace hair::python {

namespace {

// A read-only array over a vector of the groom, which it keeps.
template <class Scalar, class T>
py::array groomArray(const GroomPtr& groom, const std::vector<T>& items, Shape shape) {
  return arrayOver(reinterpret_cast<const Scalar*>(items.data()), shape, capsuleOf(groom));
}
template <class Scalar, class T>
py::array rows(const GroomPtr& groom, const std::vector<T>& items) {
  return groomArray<Scalar>(groom, items, {static_cast<py::ssize_t>(items.size()), 3});
}

GroomPtr groomOf(const py::object& guidePoints, const py::object& first, const py::object& parents,
                 const py::object& weights, const py::object& offsets, const py::object& tied,
                 const Fibre& fibre) {
  const auto f32 = py::dtype::of<float>(), u32 = py::dtype::of<std::uint32_t>();
  const auto copy = []<class T>(auto span, std::vector<T>& to) {
    to.assign(span.begin(), span.end());
  };
  auto groom = std::make_shared<Groom>();
  const py::array g = requireArray(guidePoints, "guide_points", f32, {kAny, kAny, 3});
  groom->pointsPerGuide = static_cast<std::uint32_t>(g.shape(1));
  copy(pointsOf(g), groom->guidePoints);
  const py::array s = requireArray(first, "first", u32, {kAny});
  copy(spanOf<const std::uint32_t, std::uint32_t>(s), groom->first);
  const py::ssize_t strands = std::max<py::ssize_t>(s.size() - 1, 0);
  copy(spanOf<const glm::uvec3, std::uint32_t>(requireArray(parents, "parents", u32, {strands, 3})),
       groom->parents);
  copy(pointsOf(requireArray(weights, "weights", f32, {strands, 3})), groom->weights);
  if (!offsets.is_none()) copy(pointsOf(requirePoints(offsets, "offsets")), groom->offsets);
  if (!tied.is_none())
    copy(spanOf<const std::uint32_t, std::uint32_t>(requireArray(tied, "tied", u32, {g.shape(0)})),
         groom->tied);
  groom->fibre = fibre;
  require(!groom->first.empty(), "groom: first is empty; of no strands it is [0]");
  withoutLock([&] { validate(*groom); });
  return groom;
}

GroomPtr grow(const StyleSettings& settings, const Field& head) {
  return withoutLock([&] {
    // As the library's programs have it: cells of 4 mm.
    const Field field = head ? head : std::make_shared<MeshSdf>(builtinHead().mesh);
    return std::make_shared<Groom>(makeGroom(settings, *field));
  });
}

// A groom of a hair mesh, by the name of its file.
GroomPtr meshGroom(const std::filesystem::path& path, std::uint32_t strands, std::uint32_t points,
                   std::uint32_t pointsPerGuide, float hairs) {
#ifdef HAIR_PYTHON_HAIR_MESH
  return withoutLock([&] {
    Hairstyle style;
    if (path.extension() == ".hairmesh")
      style = applyScript(readHairMeshScript(path), filesBeside(path));
    else
      style.mesh = readHairMesh(path);
    if (style.groups.empty()) style.groups.emplace_back();
    for (StrandGroup& group : style.groups) {
      if (points > 0) group.points = points;
      if (strands > 0) {
        group.strands = strands;
        group.perSquareMetre = 0;
      }
    }
    const GrownHair grown = growHair(style.mesh, style.groups);
    return std::make_shared<Groom>(
        makeGroom(style.mesh, grown.roots, grown.strands, {pointsPerGuide, hairs, style.tied}));
  });
#else
  (void)strands, (void)points, (void)pointsPerGuide, (void)hairs;
  throw Error(path.string() + ": this libhair was built without hair meshes (HAIR_WITH_HAIR_MESH)");
#endif
}

void bindGroomClass(py::module_& m) {
  py::class_<Groom, GroomPtr>(m, "Groom",
                              R"(A hairstyle at rest: guides, and how drawn strands follow them.

Head space: metres, +Y up, +Z where the face looks, origin at the joint on which the head turns. It
does not change; a simulation works on its arrays. G guides of P points, S strands, N points.)")
      .def(py::init(&groomOf), py::arg("guide_points"), py::arg("first"), py::arg("parents"),
           py::arg("weights"), py::arg("offsets") = py::none(), py::arg("tied") = py::none(),
           py::arg("fibre") = Fibre{},
           R"(From arrays, which are copied; Error where they disagree.

guide_points (G, P, 3) float32; first (S + 1,) uint32; parents (S, 3) uint32, the first is the main
guide; weights (S, 3) float32, sum 1; offsets (N, 3) float32, metres in the main guide's frame;
tied (G,) uint32, points of each guide that keep their places on the head.)")
      .def_property_readonly(
          "guide_points",
          [](const GroomPtr& g) {
            return groomArray<float>(g, g->guidePoints,
                                     {static_cast<py::ssize_t>(g->guideCount()),
                                      static_cast<py::ssize_t>(g->pointsPerGuide), 3});
          },
          "(G, P, 3) float32, metres; a read-only view.")
      .def_property_readonly(
          "first",
          [](const GroomPtr& g) {
            return groomArray<std::uint32_t>(g, g->first,
                                             {static_cast<py::ssize_t>(g->first.size())});
          },
          "(S + 1,) uint32; a read-only view.")
      .def_property_readonly(
          "parents", [](const GroomPtr& g) { return rows<std::uint32_t>(g, g->parents); },
          "(S, 3) uint32; a read-only view.")
      .def_property_readonly(
          "weights", [](const GroomPtr& g) { return rows<float>(g, g->weights); },
          "(S, 3) float32; a read-only view.")
      .def_property_readonly(
          "offsets", [](const GroomPtr& g) { return rows<float>(g, g->offsets); },
          "(N, 3) float32, metres, or (0, 3) where there are none; a read-only view.")
      .def_property_readonly(
          "tied",
          [](const GroomPtr& g) {
            return groomArray<std::uint32_t>(g, g->tied,
                                             {static_cast<py::ssize_t>(g->tied.size())});
          },
          "(G,) uint32, or (0,) where roots alone are; a read-only view.")
      .def_property_readonly(
          "fibre", [](const Groom& g) { return g.fibre; }, "What a strand stands for; a copy.")
      .def_property_readonly("guide_count", &Groom::guideCount, "G.")
      .def_property_readonly(
          "points_per_guide", [](const Groom& g) { return g.pointsPerGuide; }, "P.")
      .def_property_readonly("strand_count", &Groom::strandCount, "S.")
      .def_property_readonly("point_count", &Groom::pointCount, "N.")
      .def_property_readonly("longest_guide", &longestGuide, "Metres.")
      .def("__repr__", [](const Groom& g) {
        return text("<Groom: ", g.guideCount(), " guides of ", g.pointsPerGuide, " points, ",
                    g.strandCount(), " strands, ", g.pointCount(), " points>");
      });
}

/// A LoadedGroom whose parts Python shares.
struct Loaded {
  GroomPtr groom;
  Mesh head;
  std::vector<Mesh> others;
  RigidTransform transform;
  std::vector<std::string> notes;
};

Mesh readMesh(const std::filesystem::path& path, ReadOptions& read) {
#ifdef HAIR_PYTHON_MODEL
  ObjReport report;
  auto mesh = std::make_shared<TriangleMesh>(readObj(path, &report));
  if (read.scale == 0) read.scale = report.scale;
  if (read.up == UpAxis::AsFile) read.up = report.up;
  return mesh;
#else
  (void)read;
  throw Error(path.string() + ": this libhair was built without OBJ files (HAIR_WITH_MODEL)");
#endif
}

Loaded loadedGroom(const std::filesystem::path& path,
                   const std::vector<std::filesystem::path>& heads, float scale, UpAxis up,
                   float headScale, UpAxis headUp, std::uint32_t strands, std::uint32_t points,
                   const std::string& prim, std::uint32_t pointsPerStrand,
                   const BindSettings& settings, float hairs) {
  HeadFiles files{{}, {headScale, headUp}};
  for (const std::filesystem::path& head : heads)
    files.meshes.push_back(*readMesh(head, files.read));
  LoadedGroom loaded = loadGroom(path, {{scale, up, prim, pointsPerStrand}, strands, points},
                                 std::move(files), settings, hairs);
  Loaded result{std::make_shared<Groom>(std::move(loaded.groom)),
                std::make_shared<TriangleMesh>(std::move(loaded.head.head.mesh)),
                {},
                loaded.head.headFromHair,
                std::move(loaded.notes)};
  for (TriangleMesh& other : loaded.head.others)
    result.others.push_back(std::make_shared<TriangleMesh>(std::move(other)));
  return result;
}

void bindLoading(py::module_& m) {
  py::class_<Loaded>(m, "LoadedGroom", "Hair of a file, and the head under it (load_groom).")
      .def_readonly("groom", &Loaded::groom, "The Groom, head space.")
      .def_readonly("head", &Loaded::head,
                    "Mesh in head space: the given one, or the built-in one.")
      .def_readonly("others", &Loaded::others, "Meshes that move with the head, head space.")
      .def_readonly("transform", &Loaded::transform,
                    "Where what has the hair's coordinates, in metres and +Y up, comes to lie.")
      .def_readonly("notes", &Loaded::notes,
                    "What was assumed, dropped or repaired, a sentence each.")
      .def("__repr__", [](const Loaded& loaded) {
        return text("<LoadedGroom of ", loaded.groom->strandCount(), " strands, ",
                    loaded.notes.size(), " notes>");
      });
  m.def(
      "load_groom",
      [](const std::filesystem::path& path, const std::vector<std::filesystem::path>& heads,
         float scale, UpAxis up, float headScale, UpAxis headUp, std::uint32_t strands,
         std::uint32_t points, const std::string& prim, std::uint32_t pointsPerStrand,
         const BindSettings& settings, float hairs) {
        return withoutLock([&] {
          return loadedGroom(path, heads, scale, up, headScale, headUp, strands, points, prim,
                             pointsPerStrand, settings, hairs);
        });
      },
      py::arg("path"), py::arg("heads") = std::vector<std::filesystem::path>{}, py::kw_only(),
      py::arg("scale") = 0.0f, py::arg("up") = UpAxis::AsFile, py::arg("head_scale") = 0.0f,
      py::arg("head_up") = UpAxis::AsFile, py::arg("strands") = 0, py::arg("points") = 0,
      py::arg("prim") = "", py::arg("points_per_strand") = 0, py::arg("settings") = BindSettings{},
      py::arg("hairs") = kHairsOnHead,
      R"(From a file of strands to a Groom on a head, as the programs do with --hair and --head.

heads: OBJ files, first the head, then what moves with it; none: the built-in head, scaled under the
roots. head_scale, head_up: theirs; left out, the hair's, or metres and +Y up where those fit. strands,
points: how many of each are taken, 0: all. The rest as in read_strands and bind_groom. Error names
file, place and cause, also for a head that does not fit the hair.)");
}

}  // namespace

void bindGrooms(py::module_& m) {
  bindGroomClass(m);
  bindLoading(m);
  m.def("style_settings", &styleSettings, py::arg("style") = Style::Smooth,
        "The StyleSettings of a built-in style: \"smooth\", \"curly\" or \"long\".");
  m.def(
      "make_groom", [](Style style, const Field& head) { return grow(styleSettings(style), head); },
      py::arg("style") = Style::Smooth, py::arg("head") = py::none(),
      R"(Grows a built-in style on the built-in head.

style: "smooth", "curly" or "long", or StyleSettings. head: DistanceField(builtin_head()), which is
made for the purpose where it is not given.)");
  m.def(
      "make_groom",
      [](const StyleSettings& settings, const Field& head) { return grow(settings, head); },
      py::arg("style"), py::arg("head") = py::none(), "The same with settings.");
  m.def(
      "bind_groom",
      [](const Strands& strands, const BindSettings& settings, float hairs) {
        const StrandView view = strands.view(2);
        return withoutLock(
            [&] { return std::make_shared<Groom>(bindGroom(view, settings, hairs)); });
      },
      py::arg("strands"), py::arg("settings") = BindSettings{}, py::arg("hairs") = 100'000.f,
      R"(A Groom from strands of one's own (head space, metres, at least 2 points each).

Some strands become guides, all follow them, and at rest they are where they were. hairs: that the
strands stand for together. Error for strands without length (Strands.without_degenerate).)");
  m.def("hair_mesh_groom", &meshGroom, py::arg("path"), py::arg("strands") = 0,
        py::arg("points") = 0, py::arg("points_per_guide") = 0, py::arg("hairs") = 100'000.f,
        R"(A Groom from a hair mesh: a script (.hairmesh), or layers (.obj).

strands: of each group, points: of a strand; 0: what the script says. Error where this libhair was
built without hair meshes.)");
#ifdef HAIR_PYTHON_HAIR_MESH
  m.attr("has_hair_mesh") = true;
#else
  m.attr("has_hair_mesh") = false;
#endif
}

}  // namespace hair::python
