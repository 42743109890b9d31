#include <benchmarks/suite.h>

#include <optional>

#include <benchmarks/shadow_pass.h>
#include <libhair/core/parallel.h>

namespace hair::bench {

namespace {

double secondsOfStages(const FrameProfile& profile, Stage from, Stage to) {
  std::int64_t nanoseconds = 0;
  for (int stage = static_cast<int>(from); stage <= static_cast<int>(to); ++stage)
    nanoseconds += profile[static_cast<std::size_t>(stage)].nanoseconds;
  return 1e-9 * static_cast<double>(nanoseconds);
}

// Stages are timed inside of whole frames: in the caches are then what the stage before has left.
void runStages(benchmark::State& state, Scene& scene, Stage from, Stage to) {
  const double seconds = meanSeconds(state, [&] {
    scene.player.step();
    return secondsOfStages(scene.player.profile, from, to);
  });
  state.SetLabel("state " + scene.hash);
  setFloor(state, leastBytes(from, to, scene.counts()), seconds);
}

struct Pass {
  const char* name;
  std::optional<Filter> paperWith;  // points as the paper has them; else as frames are shadowed
  int threads;                      // 0: as many as there are
};
constexpr Pass kPasses[] = {{"as_in_frame", {}, 0},
                            {"points_centred", Filter::Centred, 0},
                            {"points_centred_1_thread", Filter::Centred, 1},
                            {"points_paper", Filter::Paper, 0},
                            {"points_paper_1_thread", Filter::Paper, 1}};

void runPass(benchmark::State& state, const Scene& scene, const Pass& how) {
  const ThreadLimit limit(how.threads);
  ShadowPass pass(scene,
                  how.paperWith ? paperSettings(scene, *how.paperWith) : scene.player.settings.map);
  const double seconds = meanSeconds(state, [&] { return secondsOf([&] { pass.run(); }); });
  state.SetLabel("state " + scene.hash);
  setFloor(state, pass.leastBytes(), seconds);
}

void runLiteral(benchmark::State& state, const Scene& scene) {
  const DensityMapSettings settings = paperSettings(scene, Filter::Paper);
  LiteralPass literal(scene, settings);
  const double seconds = meanSeconds(state, [&] { return secondsOf([&] { literal.run(); }); });
  ShadowPass fast(scene, settings);
  fast.run();
  state.SetLabel("state " + scene.hash);
  const ThreadLimit one(1);
  setFloor(state, fast.leastBytes(), seconds);
}

void registerScene(Scenes& scenes, const SceneOptions& options, int frames) {
  const auto addStages = [&](const std::string& name, Stage from, Stage to) {
    add("stage/" + options.name + '/' + name, [&scenes, options, from, to](auto& state) {
      runStages(state, scenes.of(options), from, to);
    })->Iterations(frames);
  };
  for (const Stage stage : {Stage::Guides, Stage::Wisps, Stage::SelfCollision, Stage::Deposit,
                            Stage::Transmittance, Stage::Filter, Stage::Shade})
    addStages(std::string(stageName(stage)), stage, stage);
  addStages("frame", Stage::Motion, Stage::Shade);
  for (const Pass& pass : kPasses)
    add("shadow/" + options.name + '/' + pass.name,
        [&scenes, options, pass](auto& state) { runPass(state, scenes.of(options), pass); });
  add("shadow/" + options.name + "/literal_1_thread",
      [&scenes, options](auto& state) { runLiteral(state, scenes.of(options)); });
}

}  // namespace

void setFloor(benchmark::State& state, double bytes, double seconds) {
  const double bandwidth = copyBandwidth(bytes);
  state.counters["floor_ms"] = 1e3 * bytes / bandwidth;
  state.counters["over_floor"] = seconds * bandwidth / bytes;
  state.counters["copy_GBps"] = 1e-9 * bandwidth;
}

void runFrames(benchmark::State& state, Scene& scene) {
  const double seconds =
      meanSeconds(state, [&] { return secondsOf([&] { scene.player.step(); }); });
  state.SetLabel("state " + scene.hash);
  setFloor(state, leastBytes(Stage::Motion, Stage::Shade, scene.counts()), seconds);
}

void runShadows(benchmark::State& state, const Scene& scene, int cells) {
  DensityMapSettings settings = scene.player.settings.map;
  settings.cellSize = settings.extent() / static_cast<float>(cells);
  settings.cells = cells;
  ShadowPass pass(scene, settings);
  const double seconds = meanSeconds(state, [&] { return secondsOf([&] { pass.run(); }); });
  state.SetLabel("state " + scene.hash);
  setFloor(state, pass.leastBytes(), seconds);
}

void registerStages(Scenes& scenes) {
  registerScene(scenes, smoothScene(), 240);
  registerScene(scenes, millionScene(), 40);
  registerScene(scenes, manyScene(), 40);
}

}  // namespace hair::bench
