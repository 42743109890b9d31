#include <apps/dance/character_viewer.h>

#include <chrono>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

namespace {

CharacterOptions subjectOf(const DanceOptions& options, const Controls::Growth& growth) {
  CharacterOptions character = options.character;
  if (!growth.fromFile) {
    character.hair.clear();
    character.heads.clear();
    character.style = growth.style;
  }
  character.strands = static_cast<std::uint32_t>(growth.strands);
  return character;
}

glm::vec3 velocityOf(const Controls::Breeze& wind) {
  const float around = glm::radians(wind.towards), up = glm::radians(wind.up);
  return wind.speed *
         glm::vec3(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
}

}  // namespace

Controls controlsOf(const DanceOptions& options) {
  Controls c;
  c.growth.fromFile = !options.character.hair.empty();
  c.growth.style = options.character.style;
  c.growth.strands = static_cast<int>(options.character.strands);
  c.shadow.cells = options.player.cells;
  if (!options.player.shadow)
    c.shadow.view = ShadowView::Off;
  else if (options.sideBySide)
    c.shadow.view = ShadowView::SideBySide;
  c.selfCollision.on = options.player.selfCollision;
  const glm::vec3 wind = options.player.wind;
  c.wind.speed = glm::length(wind);
  if (c.wind.speed > 0) {
    c.wind.towards = glm::degrees(std::atan2(wind.x, wind.z));
    c.wind.up = glm::degrees(std::asin(glm::clamp(wind.y / c.wind.speed, -1.0f, 1.0f)));
  }
  return c;
}

CharacterViewer::CharacterViewer(const DanceOptions& options, const Controls::Growth& growth)
    : character(subjectOf(options, growth)),
      player(character, options.player),
      view(player),
      applied_(controlsOf(options)),
      mapExtent_(player.settings.map.extent()) {
  view.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
}

void CharacterViewer::apply(const Controls& c) {
  FrameSettings& settings = player.settings;
  settings.appearance = c.look;
  view.headShadowsHair = c.headShadowsHair;
  view.follow = c.follow;
  view.shown = c.internals;
  view.edited = editor_ ? &editor_->hair().mesh : nullptr;
  view.editing = c.editMesh;
  view.scene.debug.onTop = c.internalsOnTop;
  view.scene.ground.visible = c.ground;
  view.scene.hair[0].primitive = c.primitive;
  view.scene.sideBySide = c.shadow.view == ShadowView::SideBySide;

  if (c.selfCollision != applied_.selfCollision) {
    settings.selfCollision = c.selfCollision.on;
    settings.repulsion.kind = c.selfCollision.kind;
    settings.repulsion.strength = c.selfCollision.strength;
  }
  if (c.wind != applied_.wind) {
    settings.wind.velocity = velocityOf(c.wind);
    settings.wind.gust = c.wind.gust;
  }
  if (c.shadow != applied_.shadow) {
    settings.shadow = c.shadow.view != ShadowView::Off;
    settings.map.cells = c.shadow.cells;
    settings.map.cellSize = mapExtent_ / static_cast<float>(c.shadow.cells);
    settings.map.deposit = c.shadow.deposit;
    settings.map.filter = c.shadow.filter;
    settings.map.footprint = 2 * settings.map.cellSize;
    player.relight();
  }
  applied_ = c;
}

void CharacterViewer::takeOver(const draw::Scene& before) {
  view.scene.camera.yaw = before.camera.yaw;
  view.scene.camera.pitch = before.camera.pitch;
  view.scene.camera.distance = before.camera.distance;
  view.scene.lights = before.lights;
}

// Hair of what an edit leaves.
void CharacterViewer::follow() {
  player.simulation.setSettings(player.settings);
  player.simulation.setGroom(std::make_shared<Groom>(groomOf(editor_->hair())));
  rest();
}

void CharacterViewer::rest() {
  player.simulation.restart(player.simulation.body(), 0);
}

bool CharacterViewer::edit(const draw::Pointer& pointer, glm::vec2 size) {
  if (!character.mesh) return false;
  if (!editor_) editor_ = std::make_unique<MeshEditor>(*character.mesh);
  const draw::Camera& camera = view.scene.camera;
  const glm::mat4 clipFromHead = camera.clipFromView(size.x / size.y) * camera.viewFromWorld() *
                                 matrixOf(player.pose.worldFromHead);
  if (pointer.pressed) {
    dragged_ = editor_->pick(clipFromHead, size, pointer.at);
    if (dragged_) grip_ = editor_->pixelOf(*dragged_, clipFromHead, size) - pointer.at;
    cursor_ = pointer.at;
  }
  if (!dragged_) return false;
  if (pointer.at != cursor_) {
    const auto start = std::chrono::steady_clock::now();
    cursor_ = pointer.at;
    try {
      editor_->drag(*dragged_, clipFromHead, size, cursor_ + grip_);
      follow();
      editFailure_.clear();
    } catch (const Error& error) {  // what cannot be simulated, as a chain without length
      editFailure_ = error.what();
      editor_->cancel();
      dragged_.reset();
      follow();
      return false;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    editMilliseconds_ = took.count();
  }
  if (!pointer.down) {
    editor_->drop();
    dragged_.reset();
  }
  return dragged_.has_value();
}

void CharacterViewer::undo() {
  editor_->undo();
  follow();
}

void CharacterViewer::redo() {
  editor_->redo();
  follow();
}

void CharacterViewer::report(Readout& r) const {
  const Hair& hair = player.hair;
  r.strands = hair.strands().strandCount();
  r.points = hair.strands().pointCount();
  r.guides = hair.guides.guideCount();
  r.guidePoints = r.guides * hair.guides.pointsPerGuide();
  r.saturatedCells = 0;
  r.enlarged = false;
  r.cellSize = mapAt(hair.wisps.drawn.level, player.settings.map).cellSize;
  for (const DensityMap& map : hair.maps) {
    r.saturatedCells += map.grid.saturatedCells;
    r.enlarged |= map.settings.cellSize > r.cellSize || map.aliased();
  }
  if (!hair.maps.empty()) r.cellSize = hair.maps.front().settings.cellSize;
  r.time = player.time;
  r.duration = character.motion.duration();
  r.hasMesh = character.mesh.has_value();
  r.canUndo = editor_ && editor_->canUndo();
  r.canRedo = editor_ && editor_->canRedo();
  r.editMilliseconds = editMilliseconds_;
  r.editFailure = editFailure_;
  r.placementIterations = editor_ ? editor_->placement().iterations : 0;
}

}  // namespace hair
