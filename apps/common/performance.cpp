#include <apps/common/performance.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/guides/measure.h>
#include <libhair/simulation/hair_state.h>

namespace hair {

FrameSettings frameSettings(const Subject& subject, const PerformanceOptions& options) {
  require(options.fps >= 1 && options.fps <= 1000, "--fps: ", options.fps, " is not in 1 to 1000");
  FrameSettings settings;
  settings.selfCollision = options.selfCollision;
  settings.wind.velocity = options.wind;
  settings.guides.linkSolver = options.linkSolver;
  settings.guides.iterations = options.linkIterations;
  settings.shadow = options.shadow;
  settings.appearance = subject.look;
  settings.lights = options.lights;
  if (settings.lights.empty()) settings.lights = {kDefaultLight};
  for (Light& light : settings.lights)
    if (light.kind == Light::Kind::Parallel)
      light.direction = makeLightSpace(light.direction).direction();
  const glm::vec3 headSize = bounds(subject.head.mesh.positions).size();
  settings.map.cells = options.cells;
  settings.map.cellSize = mapExtentNeeded(subject.longestStrand, std::min(0.3f, headSize.y)) /
                          static_cast<float>(options.cells);
  return settings;
}

Performance::Performance(const Subject& subject_, const PerformanceOptions& options)
    : subject(subject_),
      settings(frameSettings(subject_, options)),
      hair(subject_.groom, settings,
           {subject_.motion.pose(0).worldFromHead, subject_.motion.pose(0).capsules},
           subject_.headCollider.get()),
      pose(subject_.motion.pose(0)),
      fps_(options.fps),
      settle_(options.settle),
      motionSpeed_(options.motionSpeed) {
  restart();
}

void Performance::restart() {
  log = {};
  begin();
}

void Performance::begin() {
  time = 0;
  frame_ = 0;
  subject.motion.pose(0, pose);
  hair::restart({pose.worldFromHead, pose.capsules}, settings, static_cast<float>(settle_), hair);
  relight();
}

void Performance::resume(std::istream& state) {
  restoreState(state, hair);
  log = {};
  frame_ = std::round(hair.time * fps_);
  time = frame_ / fps_ * motionSpeed_;
  subject.motion.pose(time, pose);
  relight();
}

void Performance::step() {
  profile = {};
  const double duration = subject.motion.duration();
  if (!subject.motion.isLoop() && duration > 0 &&
      (frame_ + 1) / fps_ * motionSpeed_ > duration + 1e-6)
    begin();
  time = ++frame_ / fps_ * motionSpeed_;
  {
    const StageTimer timer(profile, Stage::Motion,
                           static_cast<std::int64_t>(pose.worldFromJoint.size()));
    subject.motion.pose(time, pose);
  }
  frame({pose.worldFromHead, pose.capsules}, settings, static_cast<float>(1 / fps_), hair, profile);
  log.add(profile);
}

void Performance::relight() {
  FrameProfile unused{};
  light(settings, hair, unused);
}

void Performance::setSelfCollision(bool on, const RepulsionSettings& repulsion) {
  const bool sameMap = repulsion.kind == settings.repulsion.kind &&
                       repulsion.cellSize == settings.repulsion.cellSize &&
                       repulsion.cells == settings.repulsion.cells;
  if (on && (hair.repulsion.allowed.empty() || !sameMap)) {
    FrameSettings atRest = settings;
    atRest.selfCollision = true;
    atRest.repulsion = repulsion;
    const BodyPose first = subject.motion.pose(0);
    hair.repulsion = std::move(
        Hair(*hair.groom, atRest, {first.worldFromHead, first.capsules}, hair.head).repulsion);
  }
  // What was felt before hair-hair contact was last off is of no use now.
  if (!settings.selfCollision)
    std::fill(hair.repulsion.push.begin(), hair.repulsion.push.end(), LaneVec3{});
  settings.selfCollision = on;
  settings.repulsion = repulsion;
}

void StatsLog::add(const Performance& p) {
  const GuideStats s =
      measureGuides(p.hair.guides, p.settings.guides, p.pose.capsules, p.hair.head);
  rows_ += text(frames_++, ',', s.stretchMax, ',', s.stretchRms, ',', s.penetrationMax, ',',
                s.kineticEnergy, ',', s.speedMax, '\n');
}

std::string StatsLog::csv() const {
  return rows_;
}

std::string stateHash(const Hair& hair) {
  StateHash hash;
  hair.guides.addTo(hash);
  hash.add(std::span<const glm::vec3>(hair.wisps.points));
  std::ostringstream out;
  out << std::hex << std::setw(16) << std::setfill('0') << hash.value();
  return out.str();
}

}  // namespace hair
