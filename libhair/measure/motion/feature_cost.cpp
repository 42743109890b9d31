#include <libhair/measure/motion/feature_cost.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <libhair/core/error.h>

namespace hair {

namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// Standard error of the median of values that are normal but for a few outliers.
double medianError(const std::vector<double>& values) {
  const double centre = median(values);
  std::vector<double> off;
  off.reserve(values.size());
  for (double v : values) off.push_back(std::abs(v - centre));
  return 1.2533 * 1.4826 * median(off) / std::sqrt(static_cast<double>(values.size()));
}

// One performance, and its times.
struct Contender {
  explicit Contender(const MeasuredScene& scene) : player(scene) {}
  ScenePlayer player;
  std::vector<double> blockMs;  // median of each block
  ProfileLog log;

  void performBlock(int frames, const std::function<void(const Hair&)>& look) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    for (int f = 0; f < frames; ++f) {
      const Clock::time_point start = Clock::now();
      player.step();
      const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      if (look) look(player.hair);
      if (f == 0) continue;
      times.push_back(ms);
      log.add(player.profile);
    }
    blockMs.push_back(median(times));
  }
};

// Whether its cells had to be larger than set.
bool watchMap(const DensityMap& map, float cellSizeSet, SceneWatch& watch) {
  if (map.empty()) return false;
  const DensityGrid& grid = map.grid;
  watch.cells = grid.settings.cells;
  watch.cellsUsed = glm::max(watch.cellsUsed, grid.upper - grid.lower + 1);
  watch.saturatedCells = std::max(watch.saturatedCells, grid.saturatedCells);
  return map.settings.cellSize > cellSizeSet || map.aliased();
}

void watchFrame(const ScenePlayer& player, SceneWatch& watch) {
  const Hair& hair = player.hair;
  ++watch.frames;
  if (player.scene.settings.selfCollision) {
    std::size_t pushed = 0;
    const std::uint32_t n = hair.guides.pointsPerGuide();
    for (std::size_t g = 0; g < hair.guides.guideCount(); ++g)
      for (std::uint32_t i = 0; i < n; ++i)
        pushed += lane(hair.repulsion.push[g / kLanes * n + i], g % kLanes) != glm::vec3(0);
    watch.pushed += static_cast<double>(pushed) / static_cast<double>(hair.guides.guideCount() * n);
  }
  for (float t : hair.transmittance) watch.darkest = std::min(watch.darkest, t);
  const DensityMapSettings set = mapAt(hair.wisps.drawn.level, player.scene.settings.map);
  bool enlarged = false;
  for (const DensityMap& map : hair.maps) enlarged |= watchMap(map, set.cellSize, watch);
  watch.enlargedFrames += enlarged;
}

// Squares of what differs between two performances, added up over frames.
struct Change {
  double moved = 0, recoloured = 0, relit = 0;
  double points = 0, colours = 0, lights = 0;

  void add(const Hair& with, const Hair& without) {
    const std::size_t n = with.wisps.points.size();
    if (n != without.wisps.points.size()) return;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::vec3 d = with.wisps.points[i] - without.wisps.points[i];
      moved += static_cast<double>(glm::dot(d, d));
    }
    points += static_cast<double>(n);
    if (with.colours.size() == n && without.colours.size() == n) {
      for (std::size_t i = 0; i < n; ++i)
        for (int shift = 0; shift < 24; shift += 8) {
          const auto byte = [&](std::uint32_t c) { return static_cast<int>(c >> shift & 255u); };
          const int d = byte(with.colours[i]) - byte(without.colours[i]);
          recoloured += static_cast<double>(d * d);
        }
      colours += 3.0 * static_cast<double>(n);
    }
    // Compare only equal numbers of lights.
    const std::size_t m = with.transmittance.size(), left = without.transmittance.size();
    if (m > 0 && (left == m || left == 0)) {
      for (std::size_t i = 0; i < m; ++i) {
        const float other = left == m ? without.transmittance[i] : 1.0f;
        const auto d = static_cast<double>(with.transmittance[i] - other);
        relit += d * d;
      }
      lights += static_cast<double>(m);
    }
  }
  static std::optional<double> root(double sum, double count) {
    if (count == 0) return std::nullopt;
    return std::sqrt(sum / count);
  }
};

// Whether all that could be compared is the same to the bit; colours, where there are some, must be
// among it.
bool changesNothing(const FeatureCost& cost, bool hasColours) {
  if (!cost.movedMetres || (hasColours && !cost.recoloured)) return false;
  return *cost.movedMetres == 0 && cost.recoloured.value_or(0) == 0 && cost.relit.value_or(0) == 0;
}

}  // namespace

FeaturePlan measureFeatures(const MeasuredScene& scene, std::span<const Feature> features,
                            const FeatureCostSettings& settings) {
  require(settings.blocks >= 2, "feature cost: blocks = ", settings.blocks, "; take at least 2");
  require(settings.framesPerBlock >= 2, "feature cost: framesPerBlock = ", settings.framesPerBlock,
          "; take at least 2, as the first is not counted");
  for (const Feature& feature : features)
    require(feature.turnOff != nullptr, "feature cost: ", feature.name, " cannot be turned off");

  Contender whole(scene);
  std::vector<std::unique_ptr<Contender>> without;
  for (const Feature& feature : features) {
    MeasuredScene less = scene;
    feature.turnOff(less);
    without.push_back(std::make_unique<Contender>(less));
  }

  FeaturePlan plan;
  std::vector<Change> changes(features.size());
  const std::function<void(const Hair&)> watch = [&](const Hair&) {
    watchFrame(whole.player, plan.watch);
  };
  for (int block = 0; block < settings.blocks; ++block) {
    // Alternate forward and backward order, which cancels linear drift.
    const std::size_t turns = features.size() + 1;
    for (std::size_t turn = 0; turn < turns; ++turn) {
      const std::size_t who = block % 2 == 0 ? turn : turns - 1 - turn;
      if (who == 0)
        whole.performBlock(settings.framesPerBlock, watch);
      else
        without[who - 1]->performBlock(settings.framesPerBlock, nullptr);
    }
    for (std::size_t i = 0; i < features.size(); ++i)
      changes[i].add(whole.player.hair, without[i]->player.hair);
  }
  plan.watch.pushed /= static_cast<double>(plan.watch.frames);

  plan.frameMs = median(whole.blockMs);
  plan.bytes = static_cast<double>(hairBytes(whole.player.hair));
  for (std::size_t i = 0; i < features.size(); ++i) {
    FeatureCost cost;
    cost.name = features[i].name;
    if (!features[i].stages.empty()) {
      cost.ownMs = 0;
      for (Stage stage : features[i].stages) *cost.ownMs += whole.log.milliseconds(stage, 0.5);
    }
    std::vector<double> saved;
    saved.reserve(whole.blockMs.size());
    for (std::size_t b = 0; b < whole.blockMs.size(); ++b)
      saved.push_back(whole.blockMs[b] - without[i]->blockMs[b]);
    cost.savedMs = median(saved);
    cost.savedMsError = medianError(saved);
    cost.savedShare = cost.savedMs / plan.frameMs;
    cost.savedBytes = plan.bytes - static_cast<double>(hairBytes(without[i]->player.hair));
    cost.movedMetres = Change::root(changes[i].moved, changes[i].points);
    cost.recoloured = Change::root(changes[i].recoloured, changes[i].colours);
    cost.relit = Change::root(changes[i].relit, changes[i].lights);
    if (features[i].advice) cost.advice = features[i].advice(plan.watch);
    if (cost.advice.empty() && changesNothing(cost, scene.settings.shade))
      cost.advice = "changes not one bit of this scene: leave it out";
    if (cost.advice.empty() && cost.savedMs < 2 * cost.savedMsError && cost.savedBytes <= 0)
      cost.advice = "costs nothing that this run can tell from noise";
    plan.features.push_back(std::move(cost));
  }
  return plan;
}

}  // namespace hair
