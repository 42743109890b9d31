#include <benchmarks/scenes.h>

#include <algorithm>
#include <utility>

#include <libhair/core/state_hash.h>

namespace hair::bench {

namespace {

std::unique_ptr<Character> makeSubject(const SceneOptions& options) {
  CharacterOptions who;
  if (options.wisps == 0) {
    who.strands = options.strands;
    who.points = options.points;
    return std::make_unique<Character>(who);
  }
  auto character = std::make_unique<Character>(who);
  StyleSettings style = styleSettings(who.style);
  style.wisps = options.wisps;
  if (options.strands > 0) style.strands = options.strands;
  if (options.points > 0) style.points = options.points;
  character->groom = makeGroom(style, *character->headCollider);
  return character;
}

PlayerOptions playerOptions(const SceneOptions& options) {
  PlayerOptions how;
  how.cells = options.cells;
  how.settle = options.settle;
  return how;
}

}  // namespace

SceneOptions smoothScene() {
  return {.name = "smooth"};
}

SceneOptions millionScene() {
  return {.name = "million", .strands = 33'500};
}

SceneOptions manyScene() {
  return {.name = "many", .strands = 100'000, .points = 17, .wisps = 3'334};
}

Scene::Scene(const SceneOptions& options_)
    : options(options_),
      character(makeSubject(options_)),
      player(*character, playerOptions(options_)) {
  for (int f = 0; f < options.frames; ++f) player.step();
  hash = hexText(pictureHash(player.hair));
  strands.points = player.hair.wisps.points;
  strands.first = character->groom.first;
}

std::size_t Scene::segmentCount() const {
  return character->groom.pointCount() - character->groom.strandCount();
}

Counts Scene::counts() const {
  const Hair& hair = player.hair;
  Counts counts;
  counts.strands = static_cast<double>(character->groom.strandCount());
  counts.points = static_cast<double>(character->groom.pointCount());
  counts.guidePoints = static_cast<double>(character->groom.guidePoints.size());
  for (const DensityMap& map : hair.maps)
    counts.bricks += static_cast<double>(map.grid.brickCount());
  counts.countedPoints = counts.points / player.settings.repulsion.strandStride;
  counts.countedBricks = static_cast<double>(hair.repulsion.density.brickCount());
  return counts;
}

Scene& Scenes::of(const SceneOptions& options) {
  if (!last_ || !(last_->options == options)) {
    last_.reset();  // before the next one is made: some are large
    last_ = std::make_unique<Scene>(options);
  }
  return *last_;
}

}  // namespace hair::bench
