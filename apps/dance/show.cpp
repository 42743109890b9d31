#include <apps/dance/show.h>

#include <chrono>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

namespace {

SubjectOptions subjectOf(const DanceOptions& options, const Controls::Growth& growth) {
  SubjectOptions subject = options.subject;
  if (!growth.fromFile) {
    subject.hair.clear();
    subject.heads.clear();
    subject.style = growth.style;
  }
  subject.strands = static_cast<std::uint32_t>(growth.strands);
  return subject;
}

glm::vec3 velocityOf(const Controls::Breeze& wind) {
  const float around = glm::radians(wind.towards), up = glm::radians(wind.up);
  return wind.speed *
         glm::vec3(std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up));
}

}  // namespace

Controls controlsOf(const DanceOptions& options) {
  Controls c;
  c.growth.fromFile = !options.subject.hair.empty();
  c.growth.style = options.subject.style;
  c.growth.strands = static_cast<int>(options.subject.strands);
  c.shadow.cells = options.performance.cells;
  if (!options.performance.shadow)
    c.shadow.view = ShadowView::Off;
  else if (options.sideBySide)
    c.shadow.view = ShadowView::SideBySide;
  c.selfCollision.on = options.performance.selfCollision;
  const glm::vec3 wind = options.performance.wind;
  c.wind.speed = glm::length(wind);
  if (c.wind.speed > 0) {
    c.wind.towards = glm::degrees(std::atan2(wind.x, wind.z));
    c.wind.up = glm::degrees(std::asin(glm::clamp(wind.y / c.wind.speed, -1.0f, 1.0f)));
  }
  return c;
}

Show::Show(const DanceOptions& options, const Controls::Growth& growth)
    : subject(subjectOf(options, growth)),
      performance(subject, options.performance),
      staging(performance),
      applied_(controlsOf(options)),
      mapExtent_(performance.settings.map.extent()) {
  staging.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
}

void Show::apply(const Controls& c) {
  FrameSettings& settings = performance.settings;
  settings.appearance = c.look;
  staging.headShadowsHair = c.headShadowsHair;
  staging.follow = c.follow;
  staging.shown = c.internals;
  staging.edited = editor_ ? &editor_->hair().mesh : nullptr;
  staging.editing = c.editMesh;
  staging.scene.debug.onTop = c.internalsOnTop;
  staging.scene.ground.visible = c.ground;
  staging.scene.hair[0].primitive = c.primitive;
  staging.scene.sideBySide = c.shadow.view == ShadowView::SideBySide;

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
    performance.relight();
  }
  applied_ = c;
}

void Show::takeOver(const draw::Scene& before) {
  staging.scene.camera.yaw = before.camera.yaw;
  staging.scene.camera.pitch = before.camera.pitch;
  staging.scene.camera.distance = before.camera.distance;
  staging.scene.lights = before.lights;
}

// Hair of what an edit leaves.
void Show::follow() {
  performance.simulation.setGroom(std::make_shared<Groom>(groomOf(editor_->hair())));
  rest();
}

void Show::rest() {
  performance.simulation.restart(performance.simulation.body(), 0);
}

bool Show::edit(const draw::Pointer& pointer, glm::vec2 size) {
  if (!subject.mesh) return false;
  if (!editor_) editor_ = std::make_unique<MeshEditor>(*subject.mesh);
  const draw::Camera& camera = staging.scene.camera;
  const glm::mat4 clipFromHead = camera.clipFromView(size.x / size.y) * camera.viewFromWorld() *
                                 matrixOf(performance.pose.worldFromHead);
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

void Show::undo() {
  editor_->undo();
  follow();
}

void Show::redo() {
  editor_->redo();
  follow();
}

void Show::report(Readout& r) const {
  const Hair& hair = performance.hair;
  r.strands = hair.strands().strandCount();
  r.points = hair.strands().pointCount();
  r.guides = hair.guides.guideCount();
  r.guidePoints = r.guides * hair.guides.pointsPerGuide();
  r.saturatedCells = 0;
  r.aliased = false;
  for (const DensityMap& map : hair.maps) {
    r.saturatedCells += map.grid.saturatedCells;
    r.aliased |= map.aliased();
  }
  r.cellSize = performance.settings.map.cellSize;
  r.time = performance.time;
  r.duration = subject.motion.duration();
  r.hasMesh = subject.mesh.has_value();
  r.canUndo = editor_ && editor_->canUndo();
  r.canRedo = editor_ && editor_->canRedo();
  r.editMilliseconds = editMilliseconds_;
  r.editFailure = editFailure_;
  r.placementIterations = editor_ ? editor_->placement().iterations : 0;
}

}  // namespace hair
