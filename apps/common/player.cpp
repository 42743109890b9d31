#include <apps/common/player.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <libhair/core/error.h>

namespace hair {

FrameSettings frameSettings(const Character& character, const PlayerOptions& options) {
  require(options.fps >= 1 && options.fps <= 1000, "--fps: ", options.fps, " is not in 1 to 1000");
  FrameSettings settings;
  settings.selfCollision = options.selfCollision;
  settings.wind.velocity = options.wind;
  settings.guides.linkSolver = options.linkSolver;
  settings.guides.iterations = options.linkIterations;
  settings.shadow = options.shadow;
  settings.appearance = character.look;
  settings.lights = options.lights;
  if (settings.lights.empty()) settings.lights = {kDefaultLight};
  for (Light& light : settings.lights)
    if (light.kind == Light::Kind::Parallel)
      light.direction = makeLightSpace(light.direction).direction();
  settings.map.cells = options.cells;
  const glm::vec3 headSize = bounds(character.head.mesh.positions).size();
  settings.map = fitMap(settings.map, character.groom, std::min(0.3f, headSize.y));
  return settings;
}

Player::Player(const Character& character_, const PlayerOptions& options)
    : character(character_),
      settings(frameSettings(character_, options)),
      pose(character_.motion.pose(0)),
      simulation(borrowed(character_.groom), settings, body(), borrowed(*character_.headCollider)),
      hair(simulation.hair()),
      fps_(options.fps),
      settle_(options.settle),
      motionSpeed_(options.motionSpeed) {
  restart();
}

void Player::restart() {
  log = {};
  begin();
}

void Player::begin() {
  time = 0;
  frame_ = 0;
  character.motion.pose(0, pose);
  simulation.setSettings(settings);
  simulation.restart(body(), static_cast<float>(settle_));
}

void Player::resume(std::istream& state) {
  simulation.setSettings(settings);
  simulation.restore(state);
  log = {};
  frame_ = std::round(hair.time * fps_);
  time = frame_ / fps_ * motionSpeed_;
  character.motion.pose(time, pose);
}

void Player::step() {
  profile = {};
  const double duration = character.motion.duration();
  if (!character.motion.isLoop() && duration > 0 &&
      (frame_ + 1) / fps_ * motionSpeed_ > duration + 1e-6)
    begin();
  time = ++frame_ / fps_ * motionSpeed_;
  {
    const StageTimer timer(profile, Stage::Motion,
                           static_cast<std::int64_t>(pose.worldFromJoint.size()));
    character.motion.pose(time, pose);
  }
  simulation.setSettings(settings);
  const FrameProfile& stages = simulation.step(body(), static_cast<float>(1 / fps_));
  for (std::size_t s = 0; s < kStageCount; ++s)
    if (static_cast<Stage>(s) != Stage::Motion) profile[s] = stages[s];
  log.add(profile);
}

void Player::relight() {
  simulation.setSettings(settings);
  simulation.relight();
}

void StatsLog::add(const Player& p) {
  const GuideStats s = p.simulation.stats();
  rows_ += text(frames_++, ',', s.stretchMax, ',', s.stretchRms, ',', s.penetrationMax, ',',
                s.kineticEnergy, ',', s.speedMax, '\n');
}

std::string StatsLog::csv() const {
  return rows_;
}

}  // namespace hair
