#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/repulsion/repulsion.cpp"
#include <hwy/foreach_target.h>
#include <libhair/density/cells-inl.h>

#include <libhair/repulsion/repulsion.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// DensityGrid::density and sampleDensity for sixteen points at once, bit-identical.
class DensityLookup {
 public:
  HWY_INLINE explicit DensityLookup(const DensityGrid& grid)
      : grid_(grid),
        frame_(grid.cells->frame),
        codes_(grid),
        slots_(grid.cells->bricks.slots(0)),
        counts_(grid.cells->bricks.cells(0)),
        perCount_(grid.quantum /
                  (grid.settings.cellSize * grid.settings.cellSize * grid.settings.cellSize)) {}

  // Direction of the push, of length <= 1, and the density.
  HWY_INLINE void push(RepulsionKind kind, const Vec3& p, Vec3& direction, Floats& density) const {
    if (kind == RepulsionKind::CellCentre) {
      const Cell c = cellOf(cellCoordinates(frame_, p));
      density = densitiesOf(c, 0, 0).first;
      const Floats half = 0.5f;
      const Vec3 inFrame =
          Vec3(c.whole.x + half, c.whole.y + half, c.whole.z + half) - Vec3(frame_.fraction);
      const Vec3 out = p - (Vec3(frame_.anchor) + rotate(frame_.worldFromCell, inFrame));
      const Floats l = length(out);
      direction = select(l > Floats(0.0f), (Floats(1.0f) / l) * out, Vec3(glm::vec3(0)));
      return;
    }
    Vec3 gradient;
    sample(p, density, gradient);
    // Scale first: the squared gradient overflows for cells of 0.01 mm. A power of two is exact.
    constexpr float kSmall = 0x1p-32f;
    gradient = Floats(kSmall) * gradient;
    // Push less where the density is nearly uniform across a cell: its gradient leads nowhere.
    const float cellSize = grid_.settings.cellSize;
    const Floats across = Floats(cellSize) * length(gradient);
    const Floats steepness = across / (across + Floats(0.1f * kSmall) * density + Floats(1e-30f));
    direction = select(across > Floats(0.0f), (Floats(-cellSize) / across * steepness) * gradient,
                       Vec3(glm::vec3(0)));
  }

  // sampleDensity.
  HWY_INLINE void sample(const Vec3& p, Floats& density, Vec3& gradient) const {
    const Vec3 u = cellCoordinates(frame_, p) - Vec3(glm::vec3(0.5f));
    const Cell c = cellOf(u);
    const Vec3 f = u - c.whole, g = Vec3(glm::vec3(1)) - f;
    // Along z, then y, then x; a derivative replaces the mean of two values by their difference.
    Floats alongY[2], acrossY[2], acrossZ[2];
    for (int a = 0; a < 2; ++a) {
      const Pairs d0 = densitiesOf(c, a, 0), d1 = densitiesOf(c, a, 1);
      const Floats alongZ0 = d0.first * g.z + d1.first * f.z;
      const Floats alongZ1 = d0.second * g.z + d1.second * f.z;
      alongY[a] = alongZ0 * g.y + alongZ1 * f.y;
      acrossY[a] = alongZ1 - alongZ0;
      acrossZ[a] = (d1.first - d0.first) * g.y + (d1.second - d0.second) * f.y;
    }
    const Vec3 perCell(alongY[1] - alongY[0], acrossY[0] * g.x + acrossY[1] * f.x,
                       acrossZ[0] * g.x + acrossZ[1] * f.x);
    density = alongY[0] * g.x + alongY[1] * f.x;
    // d/dworld = (dcell/dworld)^T d/dcell.
    gradient = rotate(glm::transpose(frame_.cellFromWorld), perCell);
  }

 private:
  // Along one axis: a cell and the next, wrapped, and whether they are within the hair's bounds.
  struct Axis {
    Ints cell[2];
    Mask inside[2];
  };
  struct Cell {
    Vec3 whole;  // unwrapped
    Axis x, y, z;
  };

  HWY_INLINE Axis axisOf(Ints cell, int axis) const {
    const Ints lower(grid_.lower[axis]), upper(grid_.upper[axis]),
        wrapped = codes_.wrap(cell, axis);
    const auto inside = [&](Ints c) HWY_ATTR { return !((c < lower) | (c > upper)); };
    return {{wrapped, codes_.next(wrapped)}, {inside(cell), inside(cell + Ints(1))}};
  }
  HWY_INLINE Cell cellOf(const Vec3& u) const {
    const Ints i = floorToInt(u.x), j = floorToInt(u.y), k = floorToInt(u.z);
    return {{toFloats(i), toFloats(j), toFloats(k)}, axisOf(i, 0), axisOf(j, 1), axisOf(k, 2)};
  }

  // DensityGrid::density of cell a along x and d along z, for both cells along y. Usually a single
  // gather, because rows of a brick are contiguous along y. Missing bricks read as zeros.
  HWY_INLINE Pairs densitiesOf(const Cell& c, int a, int d) const {
    const Ints along = codes_.along(c.x.cell[a]);
    const Ints here = codeInStore(along + codes_.across(c.y.cell[0], c.z.cell[d]));
    Pairs counts = gatherPairs(reinterpret_cast<const float*>(counts_), here);
    const Mask elsewhere = (c.y.cell[1] & Ints(brick::kY - 1)) == Ints(0);
    if (any(elsewhere)) {
      const Ints beside = codeInStore(along + codes_.across(c.y.cell[1], c.z.cell[d]));
      counts.second = select(elsewhere, asFloats(gather(counts_, beside)), counts.second);
    }
    const Mask inside = c.x.inside[a] & c.z.inside[d];
    return {densityOf(counts.first, inside & c.y.inside[0]),
            densityOf(counts.second, inside & c.y.inside[1])};
  }
  HWY_INLINE Ints codeInStore(Ints code) const {
    return shiftLeft<8>(gather(slots_, shiftRight<8>(code))) + (code & Ints(brick::kCells - 1));
  }
  HWY_INLINE Floats densityOf(Floats count, Mask inside) const {
    return select(inside, toFloatsUnsigned(asInts(count)) * Floats(perCount_), Floats(0.0f));
  }

  static_assert(brick::kCells == 256);
  const DensityGrid& grid_;
  const CellFrame& frame_;
  CellCodes codes_;
  const std::uint32_t* slots_;
  const std::uint32_t* counts_;
  float perCount_;
};

// Density at `count` · 16 points.
void densities(const DensityGrid& grid, RepulsionKind kind, const LaneVec3* points,
               std::size_t count, Lanes* out) {
  const DensityLookup lookup(grid);
  for (std::size_t at = 0; at < count; ++at) {
    Vec3 direction;
    Floats density;
    lookup.push(kind, points[at], direction, density);
    store(density, out[at]);
  }
}

// Push at `count` · 16 points.
void pushes(const DensityGrid& grid, const RepulsionSettings& settings, const LaneVec3* points,
            const Lanes* allowed, std::size_t count, LaneVec3* out) {
  const DensityLookup lookup(grid);
  for (std::size_t at = 0; at < count; ++at) {
    Vec3 direction;
    Floats density;
    lookup.push(settings.kind, points[at], direction, density);
    const Floats excess = max(density / Floats(allowed[at]) - Floats(1.0f), Floats(0.0f));
    store(min(Floats(settings.strength) * excess, Floats(settings.limit)) * direction, out[at]);
  }
}

// Attenuation of the wind at `count` · 16 points. `step`: upwind vector whose largest component is
// one cell.
void attenuateWind(const DensityGrid& grid, float occlusion, const glm::vec3& step,
                   const LaneVec3* points, std::size_t count, Lanes* out) {
  const DensityLookup lookup(grid);
  const Floats perDensity = occlusion * glm::length(step);
  for (std::size_t at = 0; at < count; ++at) {
    const Vec3 p = points[at];
    Floats sum = 0.0f;
    // Start at 1.5 cells: trilinear samples nearer would include the point's own hair.
    for (const float cells : {1.5f, 2.5f, 3.5f, 4.5f}) {
      Vec3 gradient;
      Floats density;
      lookup.sample(p + Vec3(cells * step), density, gradient);
      sum = sum + density;
    }
    store(expMinusApproximate(perDensity * sum), out[at]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>
#include <libhair/density/density_grid.h>

namespace hair {

namespace {

HWY_EXPORT(densities);
HWY_EXPORT(pushes);
HWY_EXPORT(attenuateWind);

// Skip an empty grid: it may have no memory.
void lookUp(const DensityGrid& grid, RepulsionKind kind, std::span<const LaneVec3> points,
            std::span<Lanes> out) {
  if (grid.empty()) return std::fill(out.begin(), out.end(), lanes(0));
  HWY_DYNAMIC_DISPATCH(densities)(grid, kind, points.data(), points.size(), out.data());
}

void push(const DensityGrid& grid, const RepulsionSettings& settings,
          std::span<const LaneVec3> points, const Lanes* allowed, LaneVec3* out) {
  if (grid.empty()) return void(std::fill_n(out, points.size(), LaneVec3{}));
  HWY_DYNAMIC_DISPATCH(pushes)(grid, settings, points.data(), allowed, points.size(), out);
}

}  // namespace

void validate(const RepulsionSettings& s) {
  validateFields(s, "repulsion settings");
}

int repelPasses(float seconds, const RepulsionSettings& settings, Repulsion& repulsion) {
  const float waited = repulsion.waiting + seconds;
  // The tolerance counts a pass that only rounding makes late.
  const float turns = std::floor(waited / settings.interval + 1e-3f);
  repulsion.waiting = std::max(0.0f, waited - turns * settings.interval);
  // Two passes update all guides; more would read the same density again.
  return static_cast<int>(std::min(2.0f, turns));
}

std::uint32_t strideCounted(std::size_t strands, const RepulsionSettings& settings) {
  // Splat at least 30 strands: a lone strand with a large weight would push itself away.
  constexpr std::size_t kFewest = 30;
  return static_cast<std::uint32_t>(
      std::min<std::size_t>(std::max<std::size_t>(strands / kFewest, 1), settings.strandStride));
}

void measureDensity(StrandView drawn, const Fibre& fibre, const RepulsionSettings& settings,
                    DensityGrid& density) {
  clear(density, {settings.cells, settings.cellSize, Deposit::Points});
  deposit(drawn, metresOfHair(fibre.hairsPerStrand), density,
          strideCounted(drawn.strandCount(), settings));
}

void allowRestDensity(StrandView drawn, const Fibre& fibre, const GuideStrands& guides,
                      const RepulsionSettings& settings, Repulsion& repulsion) {
  validate(settings);
  measureDensity(drawn, fibre, settings, repulsion.density);
  const std::uint32_t n = guides.pointsPerGuide();
  repulsion.allowed.assign(guides.position.size(), lanes(0));
  repulsion.push.assign(guides.position.size(), LaneVec3{});
  repulsion.turn = 0;
  repulsion.waiting = 0;
  lookUp(repulsion.density, settings.kind, guides.position, repulsion.allowed);
  for (Lanes& allowed : repulsion.allowed)
    allowed = max(lanes(settings.threshold), settings.tolerance * allowed);
  // Hair slides along its neighbours: allow each point the mean of its own and the guide's maximum.
  for (std::size_t g = 0; g < guides.groupCount(); ++g) {
    Lanes most = lanes(0);
    for (std::uint32_t i = 0; i < n; ++i) most = max(most, repulsion.allowed[g * n + i]);
    for (std::uint32_t i = 0; i < n; ++i)
      repulsion.allowed[g * n + i] = 0.5f * (repulsion.allowed[g * n + i] + most);
  }
  repulsion.learntWith = restDensityKey(settings);
}

std::uint32_t restDensityKey(const RepulsionSettings& s) {
  const auto kind = static_cast<std::uint32_t>(s.kind), cells = static_cast<std::uint32_t>(s.cells);
  const std::array<std::uint32_t, 6> words = {kind,
                                              cells,
                                              s.strandStride,
                                              std::bit_cast<std::uint32_t>(s.cellSize),
                                              std::bit_cast<std::uint32_t>(s.threshold),
                                              std::bit_cast<std::uint32_t>(s.tolerance)};
  StateHash hash;
  hash.add(std::span<const std::uint32_t>(words));
  return static_cast<std::uint32_t>(hash.value()) | 1u;
}

void repel(const GuideStrands& guides, const RepulsionSettings& settings, Repulsion& repulsion) {
  require(repulsion.allowed.size() == guides.position.size() &&
              repulsion.push.size() == guides.position.size(),
          "repel: no density is allowed yet; call allowRestDensity with the hair at rest first");
  const std::uint32_t n = guides.pointsPerGuide();
  const std::size_t groups = guides.groupCount(), turn = repulsion.turn;
  parallelFor((groups + 1 - turn) / 2, 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t half = begin; half < end; ++half) {
      const std::size_t at = (2 * half + turn) * n;
      push(repulsion.density, settings, std::span(guides.position).subspan(at, n),
           &repulsion.allowed[at], &repulsion.push[at]);
    }
  });
  repulsion.turn = 1 - turn;
}

void occludeWind(const GuideStrands& guides, const Wind& wind, Repulsion& repulsion) {
  validate(wind);
  const std::size_t points = guides.position.size();
  repulsion.windShare.assign(points, lanes(1));
  if (wind.still() || wind.occlusion == 0 || repulsion.density.empty()) return;
  const glm::vec3 size = glm::abs(wind.velocity);
  const glm::vec3 step = -repulsion.density.settings.cellSize /
                         glm::max(size.x, glm::max(size.y, size.z)) * wind.velocity;
  const auto fill = HWY_DYNAMIC_DISPATCH(attenuateWind);
  parallelFor(points, 64, [&](std::size_t begin, std::size_t end) {
    fill(repulsion.density, wind.occlusion, step, &guides.position[begin], end - begin,
         &repulsion.windShare[begin]);
  });
}

}  // namespace hair

#endif
