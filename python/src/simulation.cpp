// Hair over its frames.
#include "simulation.h"

#include <algorithm>
#include <sstream>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/simulation/insides.h>

#include "choices.h"
#include "topics.h"

namespace hair::python {

namespace {

static_assert(sizeof(Plane) == 6 * sizeof(float));

float secondsOf(double seconds) {
  return static_cast<float>(seconds);
}

}  // namespace

// Where nothing is said, the body stands where it was.
Simulation::Body Simulation::changed(const BodyChange& change) const {
  Body body;
  if (simulation_) {
    const BodyState before = simulation_->body();
    body.worldFromHead = before.worldFromHead;
    body.capsules.assign(before.capsules.begin(), before.capsules.end());
    body.planes.assign(before.scenery.planes.begin(), before.scenery.planes.end());
    body.meshes.assign(before.scenery.meshes.begin(), before.scenery.meshes.end());
    body.fields = fields_;
  }
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

Simulation::Simulation(const GroomPtr& groom, const FrameSettings& settings_, const Field& head,
                       const BodyChange& change, const WispSettings& wisps)
    : settings(settings_) {
  const Body body = changed(change);
  withoutLock([&] {
    simulation_ = std::make_shared<hair::Simulation>(groom, settings, body.state(), head, wisps);
  });
  fields_ = body.fields;
}

// Arrays that Python has of memory that the next call lets go.
void Simulation::lettingGo() {
  Hair& hair = simulation_->hair();
  points_.letGo(hair.wisps.points);
  first_.letGo(hair.wisps.drawn.first);
  transmittance_.letGo(hair.transmittance);
  radiance_.letGo(hair.radiance);
  colours_.letGo(hair.colours);
}

void Simulation::becoming() {
  Hair& hair = simulation_->hair();
  if (hair.level != hair.wisps.drawn.level) return lettingGo();
  const std::size_t points = hair.wisps.points.size();
  const std::size_t lights = settings.shadow ? settings.lights.size() : 0;
  transmittance_.resizing(hair.transmittance, lights * points);
  radiance_.resizing(hair.radiance, settings.shade && settings.radiance ? points : 0);
  colours_.resizing(hair.colours, settings.shade && settings.encode ? points : 0);
}

// A call that hands the body to the simulation. Another thread may change `settings` meanwhile: the
// simulation has its own.
template <class Call>
void Simulation::withBody(Body next, Call&& call) {
  simulation_->setSettings(settings);
  fieldsGiven_ = next.fields;
  withoutLock([&] { call(next.state()); });
  fields_ = std::move(next.fields);
}

void Simulation::frameTo(Body next, double seconds) {
  becoming();
  withBody(std::move(next),
           [&](const BodyState& body) { simulation_->step(body, secondsOf(seconds)); });
}

void Simulation::step(double seconds, const BodyChange& change) {
  const Busy busy(busy_, "simulation");
  frameTo(changed(change), seconds);
}

int Simulation::run(int frames, double seconds, const Motion* motion, std::optional<double> start,
                    const py::object& onFrame) {
  require(frames >= 0, "run: frames: ", frames, "; there are 0 or more");
  const double begin = start ? *start : time();
  for (int i = 0; i < frames; ++i) {
    passInterrupts();
    {
      const Busy busy(busy_, "simulation");
      Body next = changed({});
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
  Body next = changed(change);
  // Settling makes neither shadows nor colours, but the light after it does.
  if (hair().level != hair().wisps.drawn.level) lettingGo();
  transmittance_.letGo(simulation_->hair().transmittance);
  radiance_.letGo(simulation_->hair().radiance);
  colours_.letGo(simulation_->hair().colours);
  withBody(std::move(next),
           [&](const BodyState& body) { simulation_->restart(body, secondsOf(settle)); });
}

void Simulation::light() {
  const Busy busy(busy_, "simulation");
  becoming();
  simulation_->setSettings(settings);
  withoutLock([&] { simulation_->relight(); });
}

void Simulation::teleport(const RigidTransform& worldFromHead) {
  const Busy busy(busy_, "simulation");
  becoming();
  simulation_->setSettings(settings);
  withoutLock([&] { simulation_->teleport(worldFromHead); });
}

void Simulation::moveOrigin(glm::vec3 origin) {
  const Busy busy(busy_, "simulation");
  simulation_->moveOrigin(origin);
}

void Simulation::changeColliders(const BodyChange& change) {
  const Busy busy(busy_, "simulation");
  withBody(changed(change), [&](const BodyState& body) { simulation_->changeColliders(body); });
}

bool Simulation::changeGroom(const GroomPtr& groom) {
  const Busy busy(busy_, "simulation");
  lettingGo();
  simulation_->setSettings(settings);
  return withoutLock([&] { return simulation_->setGroom(groom); });
}

void Simulation::setDetail(const DetailPtr& detail) {
  const Busy busy(busy_, "simulation");
  simulation_->setDetail(detail);
}

void Simulation::setLevel(const LevelOfDetail& level) {
  const Busy busy(busy_, "simulation");
  withoutLock([&] { simulation_->setLevel(level); });
}

py::bytes Simulation::saveState() {
  const Busy busy(busy_, "simulation");
  std::ostringstream out(std::ios::binary);
  simulation_->save(out);
  return py::bytes(out.str());
}

void Simulation::restoreState(const py::bytes& state) {
  const Busy busy(busy_, "simulation");
  becoming();
  points_.letGo(simulation_->hair().wisps.points);
  simulation_->setSettings(settings);
  std::istringstream in(std::string(state), std::ios::binary);
  withoutLock([&] { simulation_->restore(in); });
}

DetailPtr Simulation::detail() const {
  requireIdle(busy_, "simulation");
  return std::const_pointer_cast<GroomDetail>(simulation_->knownDetail());
}

const Hair& Simulation::idleHair() const {
  requireIdle(busy_, "simulation");
  return hair();
}

py::array Simulation::points() {
  const auto& points = idleHair().wisps.points;
  return points_.view<float>(simulation_, points, {static_cast<py::ssize_t>(points.size()), 3});
}

py::array Simulation::first() {
  requireIdle(busy_, "simulation");
  const auto& drawn = hair().wisps.drawn.first;
  if (!drawn.empty())
    return first_.view<std::uint32_t>(simulation_, drawn, {static_cast<py::ssize_t>(drawn.size())});
  const auto& first = simulation_->groom()->first;
  return arrayOver(first.data(), {static_cast<py::ssize_t>(first.size())},
                   capsuleOf(simulation_->groom()));
}

py::array Simulation::transmittance() {
  const auto& values = idleHair().transmittance;
  const auto points = static_cast<py::ssize_t>(hair().wisps.points.size());
  const auto lights = points > 0 ? static_cast<py::ssize_t>(values.size()) / points : 0;
  return transmittance_.view<float>(simulation_, values, {lights, points});
}

py::array Simulation::radiance() {
  const auto& values = idleHair().radiance;
  return radiance_.view<float>(simulation_, values, {static_cast<py::ssize_t>(values.size()), 3});
}

py::array Simulation::colours() {
  const auto& values = idleHair().colours;
  return colours_.view<std::uint8_t>(simulation_, values,
                                     {static_cast<py::ssize_t>(values.size()), 4});
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
  const auto points = static_cast<py::ssize_t>(hair().wisps.points.size());
  return arrayOf<float>(std::vector(hair().visibility),
                        {static_cast<py::ssize_t>(hair().visibility.size()) / points, points});
}

void Simulation::setVisibility(const py::object& visibility) {
  const Busy busy(busy_, "simulation");
  if (visibility.is_none()) return simulation_->hair().visibility.clear();
  const py::array given = requireArray(visibility, "visibility", py::dtype::of<float>(),
                                       {static_cast<py::ssize_t>(settings.lights.size()),
                                        static_cast<py::ssize_t>(hair().wisps.points.size())});
  const auto values = spanOf<const float, float>(given);
  simulation_->hair().visibility.assign(values.begin(), values.end());
}

double Simulation::time() const {
  return idleHair().time;
}

RigidTransform Simulation::worldFromHead() const {
  requireIdle(busy_, "simulation");
  return simulation_->body().worldFromHead;
}

py::dict Simulation::profile() const {
  requireIdle(busy_, "simulation");
  const FrameProfile& profile = simulation_->profile();
  py::dict stages;
  for (std::size_t s = 0; s < kStageCount; ++s)
    stages[py::str(std::string(stageName(static_cast<Stage>(s))))] =
        py::make_tuple(static_cast<double>(profile[s].nanoseconds) * 1e-6, profile[s].items);
  return stages;
}

py::dict Simulation::stats() {
  const Busy busy(busy_, "simulation");
  const GuideStats s = withoutLock([&] { return simulation_->stats(); });
  py::dict all;
  all["stretch_max"] = s.stretchMax;
  all["stretch_rms"] = s.stretchRms;
  all["penetration_max"] = s.penetrationMax;
  all["kinetic_energy"] = s.kineticEnergy;
  all["speed_max"] = s.speedMax;
  return all;
}

std::string Simulation::stateHash() const {
  requireIdle(busy_, "simulation");
  return hexText(simulation_->stateHash());
}

std::pair<py::array, py::array> Simulation::lines(const std::string& inside) const {
  std::string names;
  for (std::size_t i = 0; i < kInsideCount; ++i) {
    const auto what = static_cast<Inside>(i);
    names += text(i > 0 ? ", " : "", insideName(what));
    if (insideName(what) != inside) continue;
    std::vector<LineVertex> ends;
    addLines(what, idleHair(), settings.guides, ends);
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> colours;
    for (const LineVertex& end : ends) {
      positions.push_back(end.position);
      colours.push_back(end.colour);
    }
    const auto count = static_cast<py::ssize_t>(ends.size());
    return {arrayOf<float>(std::move(positions), {count, 3}),
            arrayOf<std::uint8_t>(std::move(colours), {count, 4})};
  }
  throw Error(text("lines: there is no '", inside, "'; there are ", names));
}

// Whoever prints things to look for a fault wants no other one.
std::string Simulation::repr() const {
  if (busy_) return "<Simulation: in use by another thread>";
  return text("<Simulation: ", hair().guides.guideCount(), " guides, ", hair().wisps.points.size(),
              " points, at ", hair().time, " s>");
}

}  // namespace hair::python
