#include <benchmarks/suite.h>

#include <algorithm>

#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>

namespace hair::bench {

namespace {

// Frames and shadow passes of one scene. `limit` makes what holds while they are measured.
template <class Limit>
void addPair(Scenes& scenes, const std::string& group, const std::string& x,
             const SceneOptions& options, int frames, Limit limit) {
  add(group + "/frame/" + x, [&scenes, options, limit](auto& state) {
    Scene& scene = scenes.of(options);
    [[maybe_unused]] const auto held = limit();
    runFrames(state, scene);
  })->Iterations(frames);
  add(group + "/shadow/" + x, [&scenes, options, limit](auto& state) {
    const Scene& scene = scenes.of(options);
    [[maybe_unused]] const auto held = limit();
    runShadows(state, scene, options.cells);
  });
}

}  // namespace

void registerScaling(Scenes& scenes) {
  const auto free = [] { return 0; };
  for (int threads = 1, most = std::max(threadCount(), 2); threads <= most; ++threads)
    addPair(scenes, "threads", std::to_string(threads), millionScene(), 40,
            [threads] { return std::make_unique<ThreadLimit>(threads); });

  // Few points a strand, so that a million strands fit into memory.
  for (const std::uint32_t strands :
       {1'000u, 3'350u, 10'000u, 33'500u, 100'000u, 335'000u, 1'000'000u})
    addPair(scenes, "strands", std::to_string(strands),
            {.name = "strands", .strands = strands, .points = 8, .settle = 0.1f, .frames = 3},
            strands < 50'000 ? 60 : 10, free);

  for (const std::uint32_t points : {4u, 8u, 16u, 31u, 61u, 121u, 241u})
    addPair(scenes, "points", std::to_string(points),
            {.name = "points", .points = points, .settle = 0.1f, .frames = 10}, 60, free);

  for (int cells = 32; cells <= 1024; cells *= 2) {
    SceneOptions options = smoothScene();
    add("cells/shadow/" + std::to_string(cells),
        [&scenes, options, cells](auto& state) { runShadows(state, scenes.of(options), cells); });
  }

  for (const std::string_view set : instructionSets())
    addPair(scenes, "sets", std::string(set), smoothScene(), 120,
            [set] { return std::make_unique<InstructionSetLimit>(set); });
}

}  // namespace hair::bench
