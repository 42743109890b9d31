// Who moves: the built-in dance, recorded clips.
#include "motion.h"

#include <utility>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/motion/body_mesh.h>

#include "strands.h"
#include "topics.h"

namespace hair::python {

namespace {

std::vector<std::string> notesOf(const Motion& motion) {
  std::vector<std::string> notes = motion.notes();
  for (std::string& detail : motion.details()) notes.push_back(std::move(detail));
  return notes;
}

}  // namespace

void bindMotion(py::module_& m) {
  py::class_<BodyPose, PosePtr>(m, "Pose", "Where head and body are at one time.")
      .def(py::init([](const RigidTransform& worldFromHead, const py::object& capsules) {
             auto pose = std::make_shared<BodyPose>();
             pose->worldFromHead = worldFromHead;
             pose->capsules = rowsOf<Capsule>(capsules, "capsules");
             return pose;
           }),
           py::arg("world_from_head") = RigidTransform{}, py::arg("capsules") = py::none(),
           "capsules: (C, 7), each a, b and radius, metres.")
      .def_readonly("world_from_head", &BodyPose::worldFromHead, "Where the head is.")
      .def_property_readonly(
          "capsules",
          [](const PosePtr& pose) {
            return arrayOver(reinterpret_cast<const float*>(pose->capsules.data()),
                             {static_cast<py::ssize_t>(pose->capsules.size()), 7}, capsuleOf(pose));
          },
          "(C, 7) float32, each a, b and radius, metres; a read-only view.")
      .def_property_readonly(
          "joints",
          [](const BodyPose& pose) {
            std::vector<glm::vec3> places;
            for (const RigidTransform& t : pose.worldFromJoint) places.push_back(t.translation);
            return arrayOfPoints(std::move(places));
          },
          "Where the joints are, (J, 3) float32, metres; a copy.")
      .def("__repr__", [](const BodyPose& pose) {
        return text("<Pose: ", pose.capsules.size(), " capsules, ", pose.worldFromJoint.size(),
                    " joints>");
      });

  py::class_<Motion, std::shared_ptr<Motion>>(m, "Motion", "A body that moves.")
      .def_static(
          "dance", [] { return std::make_shared<Motion>(Motion::dance()); },
          "The built-in dance: 15 s, a loop.")
      .def_static(
          "still", [] { return std::make_shared<Motion>(Motion::still()); },
          "The dancer standing at ease.")
      .def_static(
          "read",
          [](const std::filesystem::path& path, float scale, const std::string& up,
             const std::string& headJoint, bool dropLeadIn, std::size_t first, std::size_t last,
             bool removeFlips) {
            MotionSettings settings;
            settings.scale = scale;
            if (!up.empty()) settings.up = clipUpFromText(up);
            settings.headJoint = headJoint;
            settings.dropLeadIn = dropLeadIn;
            settings.firstFrame = first;
            settings.lastFrame = last;
            settings.removeFlips = removeFlips;
            return withoutLock([&] { return std::make_shared<Motion>(readBvh(path), settings); });
          },
          py::arg("path"), py::kw_only(), py::arg("scale") = 0.0f, py::arg("up") = "",
          py::arg("head_joint") = "", py::arg("drop_lead_in") = MotionSettings{}.dropLeadIn,
          py::arg("first_frame") = MotionSettings{}.firstFrame,
          py::arg("last_frame") = MotionSettings{}.lastFrame,
          py::arg("remove_flips") = MotionSettings{}.removeFlips,
          R"(A recorded clip (.bvh). Error names file, line and cause.

scale: metres per unit of the file; 0: what makes a person of it. up: its axis that points up, as
hair --motion-up takes it; "": along which the body stands. head_joint: name of the joint that the
head turns on; "": found. notes says what was taken. drop_lead_in: drop a calibration pose at the start.
first_frame, last_frame: of the clip, one past the last; 0: to the end.)")
      .def_property_readonly("duration", &Motion::duration, "Seconds; 0: it never moves.")
      .def_property_readonly("is_loop", &Motion::isLoop, "Whether it goes round.")
      .def_property_readonly("floor_height", &Motion::floorHeight, "Of the floor, metres.")
      .def_property_readonly(
          "notes", &notesOf,
          "Who was recognised, what was repaired: strings, the most important first.")
      .def_property_readonly(
          "joint_names", [](const Motion& motion) { return motion.clip().skeleton.names; },
          "Of Pose.joints.")
      .def(
          "pose",
          [](const Motion& motion, double seconds) {
            return std::make_shared<BodyPose>(motion.pose(seconds));
          },
          py::arg("seconds"), "Pose at that time.")
      .def(
          "body_mesh",
          [](const Motion& motion, const BodyPose& pose) {
            return withoutLock([&] {
              auto mesh = std::make_shared<TriangleMesh>();
              require(pose.worldFromJoint.size() == motion.clip().skeleton.jointCount(),
                      "body_mesh: a pose of ", pose.worldFromJoint.size(),
                      " joints; take one of this motion (pose)");
              BodyMesh(motion.body()).skin(pose.worldFromJoint, *mesh);
              return mesh;
            });
          },
          py::arg("pose"), "A tailor's dummy in that pose of this motion, a Mesh to look at.")
      .def("__repr__", [](const Motion& motion) {
        return text("<Motion of ", motion.duration(), " s, ", motion.pose(0).capsules.size(),
                    " capsules>");
      });
}

}  // namespace hair::python
