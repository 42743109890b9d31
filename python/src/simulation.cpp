// Hair over its frames.
#include "simulation.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/guides/measure.h>
#include <libhair/simulation/hair_state.h>
#include <libhair/simulation/scene_changes.h>

#include "choices.h"
#include "topics.h"

namespace hair::python {

namespace {

static_assert(sizeof(Plane) == 6 * sizeof(float));

float secondsOf(double seconds) {
  return static_cast<float>(seconds);
}

}  // namespace

Simulation::Body Simulation::changed(Body body, const BodyChange& change) {
  if (change.pose) {
    body.worldFromHead = change.pose->worldFromHead;
    body.capsules = change.pose->capsules;
  }
  if (change.worldFromHead) body.worldFromHead = *change.worldFromHead;
  if (!change.capsules.is_none()) body.capsules = rowsOf<Capsule>(change.capsules, "capsules");
  if (!change.planes.is_none()) body.planes = rowsOf<Plane>(change.planes, "planes");
  if (change.meshes) {
    body.meshes.clear();
    body.fields.clear();
    for (const PlacedField& mesh : *change.meshes) {
      body.meshes.push_back({mesh.field.get(), mesh.worldFromMesh, mesh.scale});
      body.fields.push_back(mesh.field);
    }
  }
  return body;
}

Simulation::Simulation(GroomPtr groom, const FrameSettings& settings_, Field head,
                       const BodyChange& body, const WispSettings& wisps)
    : settings(settings_),
      groom_(std::move(groom)),
      head_(std::move(head)),
      body_(changed({}, body)) {
  withoutLock([&] {
    hair_ = std::make_shared<Hair>(*groom_, settings, body_.state(), head_.get(), wisps);
  });
}

// Arrays that Python has of memory that the next call lets go.
void Simulation::lettingGo() {
  points_.letGo(hair_->wisps.points);
  first_.letGo(hair_->wisps.drawn.first);
  transmittance_.letGo(hair_->transmittance);
  radiance_.letGo(hair_->radiance);
  colours_.letGo(hair_->colours);
}

void Simulation::becoming() {
  if (hair_->level != hair_->wisps.drawn.level) return lettingGo();
  const std::size_t points = hair_->wisps.points.size();
  const std::size_t lights = settings.shadow ? settings.lights.size() : 0;
  transmittance_.resizing(hair_->transmittance, lights * points);
  radiance_.resizing(hair_->radiance, settings.shade && settings.radiance ? points : 0);
  colours_.resizing(hair_->colours, settings.shade && settings.encode ? points : 0);
}

void Simulation::frameTo(Body next, double seconds) {
  becoming();
  // Another thread may change the settings meanwhile.
  const FrameSettings taken = settings;
  FrameProfile profile{};
  fieldsGiven_ = next.fields;
  withoutLock([&] { frame(next.state(), taken, secondsOf(seconds), *hair_, profile); });
  profile_ = profile;
  body_ = std::move(next);
}

void Simulation::step(double seconds, const BodyChange& change) {
  const Busy busy(busy_, "simulation");
  frameTo(changed(body_, change), seconds);
}

int Simulation::run(int frames, double seconds, const Motion* motion, std::optional<double> start,
                    const py::object& onFrame) {
  require(frames >= 0, "run: frames: ", frames, "; there are 0 or more");
  const double begin = start ? *start : time();
  for (int i = 0; i < frames; ++i) {
    passInterrupts();
    {
      const Busy busy(busy_, "simulation");
      Body next = body_;
      if (motion) {
        BodyPose pose = motion->pose(begin + (i + 1) * seconds);
        next.worldFromHead = pose.worldFromHead;
        next.capsules = std::move(pose.capsules);
      }
      frameTo(std::move(next), seconds);
    }
    if (!onFrame.is_none()) onFrame(i);
  }
  passInterrupts();
  return frames;
}

void Simulation::restart(double settle, const BodyChange& change) {
  const Busy busy(busy_, "simulation");
  Body next = changed(body_, change);
  const FrameSettings taken = settings;
  // Settling makes neither shadows nor colours; light() makes them again.
  if (hair_->level != hair_->wisps.drawn.level) lettingGo();
  transmittance_.letGo(hair_->transmittance);
  radiance_.letGo(hair_->radiance);
  colours_.letGo(hair_->colours);
  FrameProfile unused{};
  fieldsGiven_ = next.fields;
  withoutLock([&] {
    hair::restart(next.state(), taken, secondsOf(settle), *hair_);
    hair::light(taken, *hair_, unused);
  });
  body_ = std::move(next);
}

void Simulation::light() {
  const Busy busy(busy_, "simulation");
  becoming();
  const FrameSettings taken = settings;
  FrameProfile profile{};
  withoutLock([&] {
    if (hair_->level != hair_->wisps.drawn.level) redraw(*hair_);
    hair::light(taken, *hair_, profile);
  });
  profile_ = profile;
}

void Simulation::teleport(const RigidTransform& worldFromHead) {
  const Busy busy(busy_, "simulation");
  hair::teleport(worldFromHead, *hair_);
  body_.worldFromHead = hair_->worldFromHead;
  body_.capsules = hair_->capsules;
}

void Simulation::moveOrigin(glm::vec3 origin) {
  const Busy busy(busy_, "simulation");
  hair::moveOrigin(origin, *hair_);
  body_.worldFromHead = hair_->worldFromHead;
  body_.capsules = hair_->capsules;
  for (Plane& plane : body_.planes) plane.point -= origin;
  for (MeshCollider& mesh : body_.meshes) mesh.worldFromMesh.translation -= origin;
}

void Simulation::changeColliders(const BodyChange& change) {
  const Busy busy(busy_, "simulation");
  Body next = changed(body_, change);
  const FrameSettings taken = settings;
  fieldsGiven_ = next.fields;
  withoutLock([&] { hair::changeColliders(next.state(), taken, *hair_); });
  body_ = std::move(next);
}

bool Simulation::changeGroom(GroomPtr groom) {
  const Busy busy(busy_, "simulation");
  lettingGo();
  const FrameSettings taken = settings;
  const bool goesOn = withoutLock([&] { return hair::changeGroom(*groom, taken, *hair_); });
  groom_ = std::move(groom);
  detail_.reset();
  return goesOn;
}

void Simulation::setDetail(DetailPtr detail) {
  const Busy busy(busy_, "simulation");
  require(!detail || detail->strandCount() == groom_->strandCount(), "detail: of a groom of ",
          detail ? detail->strandCount() : 0, " strands, but this one has ", groom_->strandCount());
  require(detail || hair_->level == LevelOfDetail{}, "detail: None, but level needs one");
  detail_ = std::move(detail);
  hair_->detail = detail_.get();
}

void Simulation::setLevel(const LevelOfDetail& level) {
  const Busy busy(busy_, "simulation");
  validate(level);
  if (!detail_) detail_ = withoutLock([&] { return std::make_shared<GroomDetail>(*groom_); });
  hair_->detail = detail_.get();
  hair_->level = level;
}

py::bytes Simulation::saveState() {
  const Busy busy(busy_, "simulation");
  std::ostringstream out(std::ios::binary);
  hair::saveState(*hair_, out);
  return py::bytes(out.str());
}

void Simulation::restoreState(const py::bytes& state) {
  const Busy busy(busy_, "simulation");
  points_.letGo(hair_->wisps.points);
  std::istringstream in(std::string(state), std::ios::binary);
  hair::restoreState(in, *hair_);
  body_.worldFromHead = hair_->worldFromHead;
  body_.capsules = hair_->capsules;
  body_.planes = hair_->planes;
  // Meshes are those that this hair has met, where there are as many.
  if (body_.meshes.size() == hair_->meshes.size()) body_.meshes = hair_->meshes;
}

const DetailPtr& Simulation::detail() const {
  requireIdle(busy_, "simulation");
  return detail_;
}

const Hair& Simulation::idleHair() const {
  requireIdle(busy_, "simulation");
  return *hair_;
}

py::array Simulation::points() {
  const auto& points = idleHair().wisps.points;
  return points_.view<float>(hair_, points, {static_cast<py::ssize_t>(points.size()), 3});
}

py::array Simulation::first() {
  requireIdle(busy_, "simulation");
  const auto& drawn = hair_->wisps.drawn.first;
  if (!drawn.empty())
    return first_.view<std::uint32_t>(hair_, drawn, {static_cast<py::ssize_t>(drawn.size())});
  const auto& first = groom_->first;
  return arrayOver(first.data(), {static_cast<py::ssize_t>(first.size())}, capsuleOf(groom_));
}

py::array Simulation::transmittance() {
  const auto& values = idleHair().transmittance;
  const auto points = static_cast<py::ssize_t>(hair_->wisps.points.size());
  const auto lights = points > 0 ? static_cast<py::ssize_t>(values.size()) / points : 0;
  return transmittance_.view<float>(hair_, values, {lights, points});
}

py::array Simulation::radiance() {
  const auto& values = idleHair().radiance;
  return radiance_.view<float>(hair_, values, {static_cast<py::ssize_t>(values.size()), 3});
}

py::array Simulation::colours() {
  const auto& values = idleHair().colours;
  return colours_.view<std::uint8_t>(hair_, values, {static_cast<py::ssize_t>(values.size()), 4});
}

Strands Simulation::strands() {
  const py::array offsets = first();
  return {points(), offsets};
}

py::array Simulation::guidePoints() const {
  const GuideStrands& guides = idleHair().guides;
  std::vector<glm::vec3> points(guides.guideCount() * guides.pointsPerGuide());
  guides.copyPoints(points);
  return arrayOf<float>(std::move(points), {static_cast<py::ssize_t>(guides.guideCount()),
                                            static_cast<py::ssize_t>(guides.pointsPerGuide()), 3});
}

py::object Simulation::visibility() const {
  if (idleHair().visibility.empty()) return py::none();
  const auto points = static_cast<py::ssize_t>(hair_->wisps.points.size());
  return arrayOf<float>(std::vector(hair_->visibility),
                        {static_cast<py::ssize_t>(hair_->visibility.size()) / points, points});
}

void Simulation::setVisibility(const py::object& visibility) {
  const Busy busy(busy_, "simulation");
  if (visibility.is_none()) return hair_->visibility.clear();
  const py::array given = requireArray(visibility, "visibility", py::dtype::of<float>(),
                                       {static_cast<py::ssize_t>(settings.lights.size()),
                                        static_cast<py::ssize_t>(hair_->wisps.points.size())});
  const auto values = spanOf<const float, float>(given);
  hair_->visibility.assign(values.begin(), values.end());
}

double Simulation::time() const {
  return idleHair().time;
}

RigidTransform Simulation::worldFromHead() const {
  requireIdle(busy_, "simulation");
  return body_.worldFromHead;
}

py::dict Simulation::profile() const {
  requireIdle(busy_, "simulation");
  py::dict stages;
  for (std::size_t s = 0; s < kStageCount; ++s)
    stages[py::str(std::string(stageName(static_cast<Stage>(s))))] =
        py::make_tuple(static_cast<double>(profile_[s].nanoseconds) * 1e-6, profile_[s].items);
  return stages;
}

py::dict Simulation::stats() {
  const Busy busy(busy_, "simulation");
  const GuideSettings taken = settings.guides;
  const GuideStats s = withoutLock([&] {
    return measureGuides(hair_->guides, taken, body_.capsules, head_.get(),
                         {body_.planes, body_.meshes});
  });
  py::dict all;
  all["stretch_max"] = s.stretchMax;
  all["stretch_rms"] = s.stretchRms;
  all["penetration_max"] = s.penetrationMax;
  all["kinetic_energy"] = s.kineticEnergy;
  all["speed_max"] = s.speedMax;
  return all;
}

std::string Simulation::stateHash() const {
  const Hair& hair = idleHair();
  StateHash hash;
  hair.guides.addTo(hash);
  hash.add(std::span<const glm::vec3>(hair.wisps.points));
  std::ostringstream out;
  out << std::hex << std::setw(16) << std::setfill('0') << hash.value();
  return out.str();
}

// Whoever prints things to look for a fault wants no other one.
std::string Simulation::repr() const {
  if (busy_) return "<Simulation: in use by another thread>";
  return text("<Simulation: ", hair_->guides.guideCount(), " guides, ", hair_->wisps.points.size(),
              " points, at ", hair_->time, " s>");
}

}  // namespace hair::python
