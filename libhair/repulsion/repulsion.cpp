#include <libhair/repulsion/repulsion.h>

#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/deposit.h>

namespace hair {

namespace {

void check(const RepulsionSettings& s) {
  const auto field = [](bool good, const char* name, auto value, const char* range) {
    require(good, "repulsion settings: ", name, " = ", value, " is not in ", range);
  };
  field(s.strandStride >= 1, "strandStride", s.strandStride, "[1, ...)");
  field(s.threshold >= 0, "threshold", s.threshold, "[0, ...) m/m^3");
  field(s.tolerance >= 1, "tolerance", s.tolerance, "[1, ...)");
  field(s.strength >= 0, "strength", s.strength, "[0, ...) m/s^2");
  field(s.limit >= 0, "limit", s.limit, "[0, ...) m/s^2");
}

// Which way a point is pushed, unit or zero, and the density there.
std::pair<glm::vec3, float> pushAt(const DensityMap& map, RepulsionKind kind, glm::vec3 p) {
  if (kind == RepulsionKind::CellCentre) {
    const glm::ivec3 cell = map.cellOf(p);
    const glm::vec3 out = p - map.cellCentre(cell);
    const float length = glm::length(out);
    return {length > 0 ? out / length : glm::vec3(0), map.density(cell)};
  }
  const DensitySample sample = sampleDensity(map, p);
  // Where density hardly changes across a cell there is no way out: push less.
  const float across = map.settings.cellSize * glm::length(sample.gradient);
  const float steepness = across / (across + 0.1f * sample.density + 1e-20f);
  return {
      across > 0 ? -sample.gradient * (map.settings.cellSize / across * steepness) : glm::vec3(0),
      sample.density};
}

}  // namespace

void measureDensity(StrandView drawn, const Fibre& fibre, const RepulsionSettings& settings,
                    DensityMap& density) {
  DensityMapSettings map;
  map.cells = settings.cells;
  map.cellSize = settings.cellSize;
  map.deposit = Deposit::Points;
  map.quantity = Quantity::Length;
  clear(density, map, {});
  deposit(drawn, fibre, density, settings.strandStride);
}

void allowRestDensity(StrandView drawn, const Fibre& fibre, const GuideStrands& guides,
                      const RepulsionSettings& settings, Repulsion& repulsion) {
  check(settings);
  measureDensity(drawn, fibre, settings, repulsion.density);
  const std::uint32_t n = guides.pointsPerGuide();
  repulsion.allowed.assign(guides.position.size(), lanes(settings.threshold));
  repulsion.push.assign(guides.position.size(), LaneVec3{});
  repulsion.turn = 0;
  for (std::size_t at = 0; at < guides.position.size(); ++at)
    for (std::size_t l = 0; l < kLanes; ++l) {
      const float rest =
          pushAt(repulsion.density, settings.kind, lane(guides.position[at], l)).second;
      repulsion.allowed[at][l] = std::max(settings.threshold, settings.tolerance * rest);
    }
  // Hair slides along its own strand's neighbours: what a strand met at rest it may meet anywhere.
  for (std::size_t g = 0; g < guides.groupCount(); ++g) {
    Lanes most = lanes(0);
    for (std::uint32_t i = 0; i < n; ++i) most = max(most, repulsion.allowed[g * n + i]);
    for (std::uint32_t i = 0; i < n; ++i)
      repulsion.allowed[g * n + i] = 0.5f * (repulsion.allowed[g * n + i] + most);
  }
}

void repel(const GuideStrands& guides, const RepulsionSettings& settings, Repulsion& repulsion) {
  require(repulsion.allowed.size() == guides.position.size() &&
              repulsion.push.size() == guides.position.size(),
          "repel: no density is allowed yet; call allowRestDensity with the hair at rest first");
  const std::uint32_t n = guides.pointsPerGuide();
  const std::size_t groups = guides.groupCount(), turn = repulsion.turn;
  parallelFor((groups + 1 - turn) / 2, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t half = begin; half < end; ++half) {
      const std::size_t group = 2 * half + turn;
      for (std::size_t at = group * n; at < (group + 1) * n; ++at)
        for (std::size_t l = 0; l < kLanes; ++l) {
          const auto [direction, density] =
              pushAt(repulsion.density, settings.kind, lane(guides.position[at], l));
          const float excess = std::max(0.0f, density / repulsion.allowed[at][l] - 1);
          setLane(repulsion.push[at], l,
                  std::min(settings.strength * excess, settings.limit) * direction);
        }
    }
  });
  repulsion.turn = 1 - turn;
}

}  // namespace hair
