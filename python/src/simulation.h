#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <libhair/simulation/frame.h>

#include "groom.h"
#include "level_of_detail.h"
#include "motion.h"
#include "shared_vector.h"

namespace hair::python {

/// A distance field and its place.
struct PlacedField {
  Field field;
  RigidTransform worldFromMesh;
  float scale;
};

/// What a call says of the body; null, None: as it was.
struct BodyChange {
  PosePtr pose{};
  std::optional<RigidTransform> worldFromHead{};
  py::object capsules = py::none(), planes = py::none();  ///< rows of 7, of 6
  std::optional<std::vector<PlacedField>> meshes{};
};

/// A head of hair with all that it refers to.
class Simulation {
 public:
  Simulation(GroomPtr groom, const FrameSettings& settings, Field head, const BodyChange& body,
             const WispSettings& wisps);

  void step(double seconds, const BodyChange& change);
  /// Frames with the motion's poses, or as the body stands. Returns how many it did.
  int run(int frames, double seconds, const Motion* motion, std::optional<double> start,
          const py::object& onFrame);
  void restart(double settle, const BodyChange& change);
  void light();
  void teleport(const RigidTransform& worldFromHead);
  void moveOrigin(glm::vec3 origin);
  void changeColliders(const BodyChange& change);
  bool changeGroom(GroomPtr groom);
  py::bytes saveState();
  void restoreState(const py::bytes& state);

  void setDetail(DetailPtr detail);
  /// Of the frames to come. Measures the groom where no detail was given.
  void setLevel(const LevelOfDetail& level);

  py::array points();
  py::array first();
  py::array transmittance();
  py::array radiance();
  py::array colours();
  Strands strands();
  py::array guidePoints() const;
  py::object visibility() const;
  void setVisibility(const py::object& visibility);
  double time() const;
  RigidTransform worldFromHead() const;
  py::dict profile() const;
  py::dict stats();
  std::string stateHash() const;

  /// The hair itself; throws where a call is at work on it.
  const Hair& idleHair() const;
  const DetailPtr& detail() const;
  std::string repr() const;

  FrameSettings settings;

 private:
  struct Body {
    RigidTransform worldFromHead;
    std::vector<Capsule> capsules;
    std::vector<Plane> planes;
    std::vector<MeshCollider> meshes;
    std::vector<Field> fields;  // of the meshes

    BodyState state() const { return {worldFromHead, capsules, {planes, meshes}}; }
  };
  static Body changed(Body body, const BodyChange& change);
  void frameTo(Body next, double seconds);
  void becoming();
  void lettingGo();

  GroomPtr groom_;
  DetailPtr detail_;
  Field head_;
  Body body_;
  std::vector<Field> fieldsGiven_;  // by the last call: hair_ may point at them where it threw
  std::shared_ptr<Hair> hair_;
  FrameProfile profile_{};
  bool busy_ = false;
  SharedVector<glm::vec3> points_, radiance_;
  SharedVector<float> transmittance_;
  SharedVector<std::uint32_t> first_, colours_;
};

}  // namespace hair::python
