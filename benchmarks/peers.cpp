#include <benchmarks/peers.h>

#include <benchmarks/shadow_pass.h>
#include <benchmarks/suite.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair::bench {

namespace {

// Guide points are read and written; a solver of one thread is held to the bandwidth of one.
void runGuides(benchmark::State& state, std::unique_ptr<GuideSolver> solver, const GuideWork& work,
               int threads) {
  const ThreadLimit limit(threads);
  GuideRun run(std::move(solver), work);
  const double seconds = meanSeconds(state, [&] { return run.step(); });
  state.SetLabel(run.figures());
  Counts counts;
  counts.guidePoints = static_cast<double>(work.pointCount());
  setFloor(state, leastBytes(Stage::Guides, counts), seconds);
}

template <class Make>
void addGuides(const std::string& who, const GuideWork& work, int threads, Make make) {
  if (!make(GuideWork{.strands = 1})) return;
  add(text("peers/guides_", work.strands, 'x', work.links, '/', who), [make, work,
                                                                       threads](auto& state) {
    runGuides(state, make(work), work, threads);
  })->Iterations(work.frames);
}

using MakeShadow = std::function<ShadowPeer(const Scene&, const DensityMapSettings&)>;

void runShadow(benchmark::State& state, const Scene& scene, const MakeShadow& make) {
  const DensityMapSettings settings = paperSettings(scene, Filter::Centred);
  ShadowPass own(scene, settings);
  own.run();
  const ShadowPeer peer = make(scene, settings);
  std::vector<float> transmittance(scene.strands.pointCount());
  const double seconds =
      meanSeconds(state, [&] { return secondsOf([&] { peer(transmittance); }); });
  state.SetLabel("state " + scene.hash);
  setFloor(state, own.leastBytes(), seconds);
}

void addShadow(Scenes& scenes, const std::string& who, const MakeShadow& make) {
  add("peers/shadow_smooth/" + who,
      [&scenes, make](auto& state) { runShadow(state, scenes.of(smoothScene()), make); });
}

LightSpace lightOf(const Scene& scene) {
  return makeLightSpace(scene.player.settings.lights.front().direction);
}

}  // namespace

void registerPeers(Scenes& scenes) {
  for (const std::uint32_t strands : {402u, 10'000u}) {
    const GuideWork work{.strands = strands};
    const auto make = [](const GuideWork& some) { return makeOwnGuides(some); };
    addGuides("ours", work, 0, make);
    addGuides("ours_1_thread", work, 1, make);
  }
  addGuides("bullet_ropes", {.strands = 10'000, .warmUp = 10, .frames = 10}, 1,
            [](const GuideWork& work) { return makeBulletRopes(work, 16); });
  addGuides("bullet_ropes", {.strands = 402}, 1,
            [](const GuideWork& work) { return makeBulletRopes(work, 16); });
  addGuides("bullet_chains_4_substeps", {.strands = 402}, 1,
            [](const GuideWork& work) { return makeBulletChains(work, 4); });

  addShadow(scenes, "ours", [](const Scene& scene, const DensityMapSettings& settings) {
    return
        [pass = std::make_shared<ShadowPass>(scene, settings)](std::span<float>) { pass->run(); };
  });
  addShadow(scenes, "literal_1_thread", [](const Scene& scene, const DensityMapSettings& settings) {
    return
        [pass = std::make_shared<LiteralPass>(scene, settings)](std::span<float>) { pass->run(); };
  });
  const StrandSet none;
  if (makeOpenVdbShadow(none, LightSpace{}, 1, 1))
    addShadow(scenes, "openvdb", [](const Scene& scene, const DensityMapSettings& settings) {
      return makeOpenVdbShadow(scene.strands, lightOf(scene), settings.cellSize,
                               settings.pointExtinction);
    });
  if (makeEmbreeShadow(none, Fibre{}, LightSpace{}))
    addShadow(scenes, "embree", [](const Scene& scene, const DensityMapSettings&) {
      return makeEmbreeShadow(scene.strands, scene.character->groom.fibre, lightOf(scene));
    });
}

}  // namespace hair::bench
