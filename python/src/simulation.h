#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <libhair/simulation/simulation.h>

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

/// A hair::Simulation with what Python adds: arrays that stay valid, one thread at a time.
class Simulation {
 public:
  Simulation(const GroomPtr& groom, const FrameSettings& settings, const Field& head,
             const BodyChange& body, const WispSettings& wisps);

  void step(double seconds, const BodyChange& change);
  /// Frames with the motion's poses, or as the body stands. Returns how many it did.
  int run(int frames, double seconds, const Motion* motion, std::optional<double> start,
          const py::object& onFrame);
  void restart(double settle, const BodyChange& change);
  void light();
  void teleport(const RigidTransform& worldFromHead);
  void moveOrigin(glm::vec3 origin);
  void changeColliders(const BodyChange& change);
  bool changeGroom(const GroomPtr& groom);
  py::bytes saveState();
  void restoreState(const py::bytes& state);

  void setDetail(const DetailPtr& detail);
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
  /// Positions and colours of the lines of an Inside, by its name.
  std::pair<py::array, py::array> lines(const std::string& inside) const;

  /// The hair itself; throws where a call is at work on it.
  const Hair& idleHair() const;
  DetailPtr detail() const;
  std::string repr() const;

  FrameSettings settings;

 private:
  // What a call hands over: the arrays behind a BodyState, and the fields of its meshes.
  struct Body {
    RigidTransform worldFromHead;
    std::vector<Capsule> capsules;
    std::vector<Plane> planes;
    std::vector<MeshCollider> meshes;
    std::vector<Field> fields;

    BodyState state() const { return {worldFromHead, capsules, {planes, meshes}}; }
  };
  Body changed(const BodyChange& change) const;
  template <class Call>
  void withBody(Body next, Call&& call);
  void frameTo(Body next, double seconds);
  void becoming();
  void lettingGo();
  const Hair& hair() const { return std::as_const(*simulation_).hair(); }

  std::vector<Field> fields_;       // of the simulation's meshes
  std::vector<Field> fieldsGiven_;  // by the last call: the hair may point at them where it threw
  std::shared_ptr<hair::Simulation> simulation_;
  bool busy_ = false;
  SharedVector<glm::vec3> points_, radiance_;
  SharedVector<float> transmittance_;
  SharedVector<std::uint32_t> first_, colours_;
};

}  // namespace hair::python
