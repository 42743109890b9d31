// What Python sees of a Simulation, and what every frame takes.
#include <libhair/core/error.h>

#include "choices.h"
#include "simulation.h"
#include "topics.h"

namespace hair::python {

namespace {

using OptionalTransform = std::optional<RigidTransform>;
using OptionalMeshes = std::optional<std::vector<PlacedField>>;

// The arguments by which a call moves the body.
#define HAIR_BODY_ARGS                                                   \
  py::arg("pose") = py::none(), py::arg("world_from_head") = py::none(), \
  py::arg("capsules") = py::none(), py::arg("planes") = py::none(), py::arg("meshes") = py::none()

void bindPlacedField(py::module_& m) {
  py::class_<PlacedField>(m, "MeshCollider",
                          "A closed mesh that hair collides with, and its place.")
      .def(py::init([](Field field, const RigidTransform& worldFromMesh, float scale) {
             return PlacedField{std::move(field), worldFromMesh, scale};
           }),
           py::arg("field").none(false), py::arg("world_from_mesh") = RigidTransform{},
           py::arg("scale") = 1.0f, "field: DistanceField; scale: [1e-6, 1000).")
      .def_readonly("field", &PlacedField::field, "DistanceField.")
      .def_readonly("world_from_mesh", &PlacedField::worldFromMesh, "Transform.")
      .def_readonly("scale", &PlacedField::scale, "Of the mesh in the world.")
      .def("__repr__",
           [](const PlacedField& mesh) { return text("<MeshCollider, scale ", mesh.scale, ">"); });
}

void bindMapFit(py::module_& m) {
  m.def(
      "fit_map",
      [](const FrameSettings& settings, const Groom& groom, float headSize, int cells) {
        FrameSettings fitted = settings;
        fitted.map.cells = cells;
        fitted.map = fitMap(fitted.map, groom, headSize);
        return fitted;
      },
      py::arg("settings"), py::arg("groom"), py::arg("head_size") = 0.3f,
      py::arg("cells") = DensityMapSettings{}.cells,
      R"(A copy of FrameSettings whose map is as large as this hair needs.

head_size: the head's largest dimension, metres. cells: of the map along each axis.)");
}

}  // namespace

void bindSimulation(py::module_& m) {
  bindPlacedField(m);
  bindMapFit(m);
  using S = Simulation;
  py::class_<S> c(m, "Simulation", R"(One head of hair over its frames.

Colliders are given where they are at the end of a frame; what is not given (None) stays where it
was. pose: a Pose, which has world_from_head and capsules. world_from_head: Transform or 4 x 4
matrix. capsules: (C, 7), each a, b and radius, metres; planes: (P, 6), each a point and a unit
normal to the free side; meshes: MeshCollider objects.

points, transmittance, radiance and colours are views that follow every step. restart, change_groom,
restore_state, another level, and settings that change how many there are, may give them other
memory: older views then go on showing what they last did. A second thread that works on the
simulation, or looks into it, while a call is at work gets RuntimeError; settings alone may be set
then.)");
  c.def(py::init([](const GroomPtr& groom, const FrameSettings& settings, const Field& head,
                    const PosePtr& pose, OptionalTransform world, const py::object& capsules,
                    const py::object& planes, OptionalMeshes meshes, const WispSettings& wisps) {
          return std::make_unique<S>(
              groom, settings, head,
              BodyChange{pose, std::move(world), capsules, planes, std::move(meshes)}, wisps);
        }),
        py::arg("groom").none(false), py::arg("settings") = FrameSettings{}, py::kw_only(),
        py::arg("head") = py::none(), HAIR_BODY_ARGS, py::arg("wisps") = WispSettings{},
        R"(At rest, as groomed; restart() settles it on the body.

settings: FrameSettings, copied. head: DistanceField of the head in head space, None: no head.)");
  c.def_readwrite(
      "settings", &S::settings,
      "FrameSettings of the frames to come. What shapes the rest state was taken at the "
      "start.");
  c.def(
      "step",
      [](S& s, double seconds, const PosePtr& pose, OptionalTransform world,
         const py::object& capsules, const py::object& planes, OptionalMeshes meshes) {
        s.step(seconds, {pose, std::move(world), capsules, planes, std::move(meshes)});
      },
      py::arg("seconds") = 1.0 / 60, py::kw_only(), HAIR_BODY_ARGS,
      "One frame: moves the hair by so many seconds to where the body is then, shadows and "
      "shades.");
  c.def("run", &S::run, py::arg("frames"), py::arg("seconds") = 1.0 / 60, py::kw_only(),
        py::arg("motion") = py::none(), py::arg("start") = py::none(),
        py::arg("on_frame") = py::none(),
        R"(So many frames; returns how many. Ctrl-C stops it between two of them.

motion: a Motion that moves the body; frame i ends at its time start + (i + 1) * seconds. start:
seconds, None: the simulation's own time. on_frame: called with i after each frame.)");
  c.def(
      "restart",
      [](S& s, double settle, const PosePtr& pose, OptionalTransform world,
         const py::object& capsules, const py::object& planes, OptionalMeshes meshes) {
        s.restart(settle, {pose, std::move(world), capsules, planes, std::move(meshes)});
      },
      py::arg("settle") = 1.0, py::kw_only(), HAIR_BODY_ARGS,
      "Back to rest on the body, then so many seconds of settling while colliders grow; lit.");
  c.def("light", &S::light, "Shadows and shades the hair as it stands, at its level.");
  c.def_property("detail", &S::detail, &S::setDetail,
                 "GroomDetail of the groom, or None until a level needs one.");
  c.def_property(
      "level", [](const S& s) { return s.idleHair().level; }, &S::setLevel,
      "LevelOfDetail that the next step or light() draws; a copy. Guides do not feel it.");
  c.def_property_readonly(
      "wider", [](const S& s) { return s.idleHair().wisps.drawn.wider; },
      "So much wider are strands to be drawn than all of them would be; 1 where all are.");
  c.def("teleport", &S::teleport, py::arg("world_from_head"),
        "To another place with its head: hair keeps its shape and does not see the jump.");
  c.def("move_origin", &S::moveOrigin, py::arg("origin"),
        "The world's origin moves there; what is given from now on counts from it.");
  c.def(
      "change_colliders",
      [](S& s, const PosePtr& pose, OptionalTransform world, const py::object& capsules,
         const py::object& planes, OptionalMeshes meshes) {
        s.changeColliders({pose, std::move(world), capsules, planes, std::move(meshes)});
      },
      py::kw_only(), HAIR_BODY_ARGS,
      "Others take their places, which did not move there; guides inside are brought out.");
  c.def("change_groom", &S::changeGroom, py::arg("groom").none(false),
        "Another hairstyle in the middle of the motion; whether the motion goes on in it.");
  c.def("save_state", &S::saveState, "All that a frame hands to the next, as bytes.");
  c.def("restore_state", &S::restoreState, py::arg("state"),
        "Goes on from saved bytes, bit for bit; Error where they are of another groom or damaged.");
  c.def_property_readonly("points", &S::points,
                          "Drawn points now, (N, 3) float32, metres; a read-only view.");
  c.def_property_readonly(
      "first", &S::first,
      "Offsets of drawn strands, (S + 1,) uint32, of which those that a level leaves out "
      "have no points; a read-only view.");
  c.def_property_readonly("strands", &S::strands, "Drawn hair as Strands over the same views.");
  c.def_property_readonly("transmittance", &S::transmittance,
                          "(lights, N) float32, [0, 1], of the last frame; a read-only view.");
  c.def_property_readonly("radiance", &S::radiance,
                          "(N, 3) float32 linear RGB, of the last frame, >= 0 and above 1 where "
                          "light is bright; (0, 3) unless settings.radiance; a read-only view.");
  c.def_property_readonly(
      "colours", &S::colours,
      "(N, 4) uint8 sRGB and opacity, of the last frame, 255 but for strands on their way "
      "out at a level; a read-only view.");
  c.def_property("visibility", &S::visibility, &S::setVisibility,
                 "What head and body leave of each light, (lights, N) float32, copied; or None.");
  c.def("guide_points", &S::guidePoints, "Guides now, (G, P, 3) float32, metres; a copy.");
  c.def_property_readonly("time", &S::time, "Simulated seconds.");
  c.def_property_readonly("world_from_head", &S::worldFromHead, "Where the head is: Transform.");
  c.def_property_readonly("profile", &S::profile,
                          "What the last frame cost: {stage: (milliseconds, items)}.");
  c.def("stats", &S::stats,
        "How guides keep their promises: stretch_max, stretch_rms (shares), penetration_max "
        "(metres), kinetic_energy (joules), speed_max (m/s).");
  c.def("state_hash", &S::stateHash,
        "16 hexadecimal digits over guides and drawn hair; the same on every machine.");
  c.def("lines", &S::lines, py::arg("inside"),
        R"(Lines of the hair's inside as it stands, to be drawn: (positions, colours).

inside: "guides", "tension", "guide frames", "contacts", "push", "colliders" or "bricks". positions
is (2 n, 3) float32, metres, two ends a line; colours (2 n, 4) uint8 sRGB and opacity.)");
  c.def("__repr__", &S::repr);
}

}  // namespace hair::python
