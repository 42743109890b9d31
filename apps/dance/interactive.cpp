#include <chrono>
#include <iostream>
#include <memory>
#include <utility>

#include <apps/common/results.h>
#include <apps/dance/character_viewer.h>
#include <apps/dance/dance.h>
#include <apps/dance/panel.h>
#include <apps/draw/gl_context.h>
#include <apps/draw/window.h>
#include <libhair/core/error.h>
#include <libhair/motion/fixed_timestep.h>

namespace hair {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A moving average over some ten pictures.
void follow(double& average, double now) {
  average = average > 0 ? average + 0.1 * (now - average) : now;
}

class Interactive {
 public:
  explicit Interactive(const DanceOptions& options);
  int run();

 private:
  void makeRenderer();
  void grow();
  void obey(const Requests& asked, const draw::WindowRequests& keys);
  void simulate(double seconds);
  void stepOnce();
  void drawPicture(bool aboutToGrow);

  const DanceOptions& options_;
  draw::Window window_;
  std::unique_ptr<draw::Renderer> renderer_;
  int rendererSamples_ = 0;
  Controls controls_;
  Readout readout_;
  bool panelShown_ = true, stepAsked_ = false;
  bool moved_ = false;  // since the last picture
  bool editing_ = false;
  FixedTimestep pace_;
  double secondsAPicture_ = 0, simulatedAPicture_ = 0;  // averages
  StatsLog stats_;
  int framesDone_ = 0;
  std::unique_ptr<CharacterViewer> viewer_;
};

Interactive::Interactive(const DanceOptions& options)
    : options_(options),
      window_("dance", options.width, options.height),
      controls_(controlsOf(options)),
      pace_(options.player.fps) {
  readout_.softwareDrawing = draw::drawsOnCpu(draw::rendererName());
  readout_.hairFile = options.character.hair.filename().string();
  if (readout_.softwareDrawing) controls_.samples = 1;
  makeRenderer();
}

// Multisampling is fixed when a renderer is made.
void Interactive::makeRenderer() {
  if (rendererSamples_ == controls_.samples) return;
  draw::RenderSettings settings{controls_.samples, 2048, 60000};
  if (readout_.softwareDrawing) settings.shadowMapSize = 1024, settings.shadowHairSegments = 20000;
  renderer_.reset();  // gives its memory back first
  renderer_ = std::make_unique<draw::Renderer>(settings);
  rendererSamples_ = controls_.samples;
}

// Grows controls_.growth; what cannot be grown leaves everything as it is.
void Interactive::grow() {
  try {
    auto next = std::make_unique<CharacterViewer>(options_, controls_.growth);
    if (viewer_) next->takeOver(viewer_->view.scene);
    viewer_ = std::move(next);
    readout_.failure.clear();
    controls_.editMesh = editing_ = false;  // its mesh, if it has one, is another
    window_.holdDrag(false);
    readout_.history = {};
    pace_ = FixedTimestep(options_.player.fps);
    readout_.grown = controls_.growth;
    readout_.notes = viewer_->character.notes;
    for (const std::string& note : viewer_->character.notes) std::cerr << note << '\n';
  } catch (const Error& error) {
    if (!viewer_) throw;
    readout_.failure = error.what();
    controls_.growth = readout_.grown;
  }
}

void Interactive::obey(const Requests& asked, const draw::WindowRequests& keys) {
  if (keys.pause) controls_.paused = !controls_.paused;
  if (keys.panel) panelShown_ = !panelShown_;
  stepAsked_ = asked.step || keys.step;
  if (stepAsked_) controls_.paused = true;
  if (asked.reset || keys.reset) {
    viewer_->player.restart();
    pace_ = FixedTimestep(options_.player.fps);
  }
  if (asked.undo) viewer_->undo();
  if (asked.redo) viewer_->redo();
  if (controls_.editMesh) {
    controls_.paused = true;
    if (!editing_) {
      controls_.internals.mesh = true;
      viewer_->rest();
    }
    window_.holdDrag(viewer_->edit(window_.pointer(), {window_.width(), window_.height()}));
  }
  editing_ = controls_.editMesh;
  if (controls_.ownLook) controls_.look = viewer_->character.look;
  viewer_->apply(controls_);
  makeRenderer();
}

void Interactive::stepOnce() {
  viewer_->player.step();
  moved_ = true;
  if (!options_.results.stats.empty()) stats_.add(viewer_->player);
  if (++framesDone_ == options_.frames) window_.close();
}

void Interactive::simulate(double seconds) {
  pace_.setSpeed(controls_.speed);
  pace_.setPaused(controls_.paused);
  const int due = controls_.paused ? stepAsked_ : pace_.framesDue(seconds);
  int run = 0;
  while (run < due && (options_.frames == 0 || framesDone_ < options_.frames)) stepOnce(), ++run;
  readout_.droppedSeconds = pace_.droppedSeconds();
  if (seconds <= 0) return;  // the first picture
  follow(secondsAPicture_, seconds);
  follow(simulatedAPicture_, controls_.paused ? 0 : run / options_.player.fps);
  readout_.picturesPerSecond = 1 / secondsAPicture_;
  readout_.simulatedPerSecond = controls_.paused ? 0 : simulatedAPicture_ / secondsAPicture_;
}

void Interactive::drawPicture(bool aboutToGrow) {
  if (aboutToGrow) drawNotice("Growing hair, please wait ...");
  SceneView& view = viewer_->view;
  const FrameProfile& profile = viewer_->player.profile;
  // Waiting for the picture keeps the CPU from running ahead: only while someone looks at times.
  if (panelShown_ && readout_.timesShown) {
    view.drawTimed(*renderer_, window_.width(), window_.height());
    readout_.history.pictures.add(milliseconds(profile[kDrawStage]));
    if (moved_) viewer_->drawn.add(profile);
  } else {
    renderer_->draw(view.update(*renderer_), window_.width(), window_.height());
  }
  if (std::exchange(moved_, false)) readout_.history.frames.add(profile);
  window_.endFrame(*renderer_);
}

int Interactive::run() {
  draw::Scene empty;
  empty.ground.visible = false;
  if (!window_.beginFrame(empty)) return 0;
  drawNotice("Growing hair, please wait ...");
  renderer_->draw(empty, window_.width(), window_.height());
  window_.endFrame(*renderer_);
  grow();

  bool fresh = true;
  auto before = Clock::now();
  while (window_.beginFrame(viewer_->view.scene)) {
    const double seconds = std::exchange(fresh, false) ? 0 : secondsSince(before);
    before = Clock::now();
    viewer_->report(readout_);
    const Requests asked = panelShown_ ? drawPanel(controls_, readout_) : Requests{};
    obey(asked, window_.requests());
    window_.setMargin(panelShown_ ? readout_.panelWidth : 0);
    simulate(seconds);
    drawPicture(asked.grow);
    if (asked.grow) {
      grow();
      fresh = true;  // that was no time to catch up with
    }
  }
  const ProfileLog& drawn = viewer_->drawn;
  std::cout << drawingTimes(drawn, drawnBy()) << '\n';
  writeResults(options_.results, viewer_->player,
               drawn.frameCount() > 0 ? drawn : viewer_->player.log, stats_);
  return 0;
}

}  // namespace

int runInteractive(const DanceOptions& options) {
  return Interactive(options).run();
}

}  // namespace hair
