#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/repulsion/repulsion.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <libhair/repulsion/repulsion.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// Look-ups in a density map of parallel axes for sixteen points at once: DensityMap::density and
// sampleDensity, bit for bit.
class DensityLookup {
 public:
  explicit DensityLookup(const DensityMap& map)
      : map_(map),
        table_(map.bricks.slots(0)),
        counts_(map.bricks.cells(0)),
        perAxis_(map.bricks.perAxis()),
        first_(map.wrap(map.lower)),
        perCount_(map.quantum /
                  (map.settings.cellSize * map.settings.cellSize * map.settings.cellSize)) {}

  // Unwrapped cell coordinates.
  HWY_INLINE Vec3 cellCoordinates(const Vec3& p) const {
    const CellFrame& frame = map_.frame;
    const Vec3 u = Vec3(frame.fraction) + rotate(frame.cellFromWorld, p - Vec3(frame.anchor));
    const Floats most = 1e9f;
    return {min(max(u.x, -most), most), min(max(u.y, -most), most), min(max(u.z, -most), most)};
  }

  // Which way points are pushed, unit or shorter, and the density there.
  HWY_INLINE void push(RepulsionKind kind, const Vec3& p, Vec3& direction, Floats& density) const {
    if (kind == RepulsionKind::CellCentre) {
      const Vec3 u = cellCoordinates(p);
      const Ints i = floorToInt(u.x), j = floorToInt(u.y), k = floorToInt(u.z);
      const Axis x = axis<0>(i), y = axis<1>(j), z = axis<2>(k);
      density = densityOf(x, y, z, 0, 0, 0);
      const Floats half = 0.5f;
      const Vec3 inFrame = Vec3(toFloats(i) + half, toFloats(j) + half, toFloats(k) + half) -
                           Vec3(map_.frame.fraction);
      const Vec3 out = p - (Vec3(map_.frame.anchor) + rotate(map_.frame.worldFromCell, inFrame));
      const Floats l = length(out);
      direction = select(l > Floats(0.0f), (Floats(1.0f) / l) * out, Vec3(glm::vec3(0)));
      return;
    }
    Vec3 gradient;
    sample(p, density, gradient);
    // Where density hardly changes across a cell there is no way out: push less.
    const float cellSize = map_.settings.cellSize;
    const Floats across = Floats(cellSize) * length(gradient);
    const Floats steepness = across / (across + Floats(0.1f) * density + Floats(1e-20f));
    direction = select(across > Floats(0.0f), (Floats(-cellSize) / across * steepness) * gradient,
                       Vec3(glm::vec3(0)));
  }

  // sampleDensity.
  HWY_INLINE void sample(const Vec3& p, Floats& density, Vec3& gradient) const {
    const Vec3 u = cellCoordinates(p) - Vec3(glm::vec3(0.5f));
    const Ints i = floorToInt(u.x), j = floorToInt(u.y), k = floorToInt(u.z);
    const Vec3 f = u - Vec3(toFloats(i), toFloats(j), toFloats(k));
    const Vec3 g = Vec3(glm::vec3(1)) - f;
    const Axis x = axis<0>(i), y = axis<1>(j), z = axis<2>(k);
    // Along z, then y, then x; a derivative replaces the mean of two values by their difference.
    Floats alongY[2], acrossY[2], acrossZ[2];
    for (int a = 0; a < 2; ++a) {
      Floats alongZ[2], difference[2];
      for (int b = 0; b < 2; ++b) {
        const Floats d0 = densityOf(x, y, z, a, b, 0), d1 = densityOf(x, y, z, a, b, 1);
        alongZ[b] = d0 * g.z + d1 * f.z;
        difference[b] = d1 - d0;
      }
      alongY[a] = alongZ[0] * g.y + alongZ[1] * f.y;
      acrossY[a] = alongZ[1] - alongZ[0];
      acrossZ[a] = difference[0] * g.y + difference[1] * f.y;
    }
    const Vec3 perCell(alongY[1] - alongY[0], acrossY[0] * g.x + acrossY[1] * f.x,
                       acrossZ[0] * g.x + acrossZ[1] * f.x);
    density = alongY[0] * g.x + alongY[1] * f.x;
    // d/dworld = (dcell/dworld)^T d/dcell.
    gradient = rotate(glm::transpose(map_.frame.cellFromWorld), perCell);
  }

 private:
  // An axis of a cell and of the one after it: what they add to the number of their brick and to
  // their number in it, and whether they are within the bounds of the hair.
  struct Axis {
    Ints brick[2], offset[2];
    Mask inside[2];
  };

  template <int kAxis>
  HWY_INLINE Axis axis(Ints cell) const {
    const int cells = map_.settings.cells, lower = map_.lower[kAxis], upper = map_.upper[kAxis];
    // Counted from the first cell that holds hair, which is wrapped already.
    const Ints from = min(max(cell, Ints(lower - 1)), Ints(upper)) - Ints(lower);
    Axis r;
    for (int a = 0; a < 2; ++a) {
      const Ints here = from + Ints(a);
      r.inside[a] = (cell + Ints(a) > Ints(lower - 1)) & !(cell + Ints(a) > Ints(upper));
      Ints at = Ints(first_[kAxis]) + max(here, Ints(0));
      // Whole turns of the map: the second time takes what rounding left of many.
      for (int time = 0; time < 2; ++time)
        at = at - Ints(cells) * floorToInt(toFloats(at) * Floats(1.0f / static_cast<float>(cells)));
      at = at - select(at > Ints(cells - 1), Ints(cells), Ints(0));
      at = at + select(at < Ints(0), Ints(cells), Ints(0));
      static_assert(brick::kX == 4 && brick::kY == 16 && brick::kZ == 4);
      if (kAxis == 0) {
        r.brick[a] = shiftRight<2>(at) * Ints(perAxis_.y * perAxis_.z);
        r.offset[a] = shiftLeft<6>(at & Ints(3));
      } else if (kAxis == 1) {
        r.brick[a] = shiftRight<4>(at);
        r.offset[a] = at & Ints(15);
      } else {
        r.brick[a] = shiftRight<2>(at) * Ints(perAxis_.y);
        r.offset[a] = shiftLeft<4>(at & Ints(3));
      }
    }
    return r;
  }

  // DensityMap::density of the first or second cells of three axes.
  HWY_INLINE Floats densityOf(const Axis& x, const Axis& y, const Axis& z, int a, int b,
                              int c) const {
    const Mask inside = x.inside[a] & y.inside[b] & z.inside[c];
    if (!any(inside)) return 0.0f;
    const Ints slot = gather(table_, select(inside, x.brick[a] + y.brick[b] + z.brick[c], Ints(0)));
    const Mask there = inside & (slot > Ints(0));
    if (!any(there)) return 0.0f;
    // Where no brick is, the first that is made is read for nothing.
    const Ints at = select(there, shiftLeft<8>(slot) + x.offset[a] + y.offset[b] + z.offset[c],
                           Ints(brick::kCells));
    return select(there, toFloatsUnsigned(gather(counts_, at)) * Floats(perCount_), Floats(0.0f));
  }

  // Of 32 bits without sign: rounded once, as the upper 16 and the lower 16 are exact.
  static HWY_INLINE Floats toFloatsUnsigned(Ints v) {
    const Ints upper = shiftRight<16>(v) & Ints(0xffff), lower = v & Ints(0xffff);
    return toFloats(upper) * Floats(65536.0f) + toFloats(lower);
  }

  const DensityMap& map_;
  const std::uint32_t* table_;
  const std::uint32_t* counts_;
  glm::ivec3 perAxis_, first_;
  float perCount_;
};

// Density at `count` · 16 points.
void densities(const DensityMap& map, RepulsionKind kind, const LaneVec3* points, std::size_t count,
               Lanes* out) {
  const DensityLookup lookup(map);
  for (std::size_t at = 0; at < count; ++at) {
    Vec3 direction;
    Floats density;
    lookup.push(kind, points[at], direction, density);
    store(density, out[at]);
  }
}

// What pushes `count` · 16 points.
void pushes(const DensityMap& map, const RepulsionSettings& settings, const LaneVec3* points,
            const Lanes* allowed, std::size_t count, LaneVec3* out) {
  const DensityLookup lookup(map);
  for (std::size_t at = 0; at < count; ++at) {
    Vec3 direction;
    Floats density;
    lookup.push(settings.kind, points[at], direction, density);
    const Floats excess = max(density / Floats(allowed[at]) - Floats(1.0f), Floats(0.0f));
    store(min(Floats(settings.strength) * excess, Floats(settings.limit)) * direction, out[at]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/deposit.h>

namespace hair {

namespace {

HWY_EXPORT(densities);
HWY_EXPORT(pushes);

// An empty map has no memory to look into.
void lookUp(const DensityMap& map, RepulsionKind kind, std::span<const LaneVec3> points,
            std::span<Lanes> out) {
  if (map.empty()) return std::fill(out.begin(), out.end(), lanes(0));
  HWY_DYNAMIC_DISPATCH(densities)(map, kind, points.data(), points.size(), out.data());
}

void push(const DensityMap& map, const RepulsionSettings& settings,
          std::span<const LaneVec3> points, const Lanes* allowed, LaneVec3* out) {
  if (map.empty()) return void(std::fill_n(out, points.size(), LaneVec3{}));
  HWY_DYNAMIC_DISPATCH(pushes)(map, settings, points.data(), allowed, points.size(), out);
}

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

}  // namespace

void measureDensity(StrandView drawn, const Fibre& fibre, const RepulsionSettings& settings,
                    DensityMap& density, float pointLength) {
  DensityMapSettings map;
  map.cells = settings.cells;
  map.cellSize = settings.cellSize;
  map.deposit = Deposit::Points;
  map.quantity = Quantity::Length;
  map.pointLength = pointLength;
  clear(density, map, {});
  deposit(drawn, fibre, density, settings.strandStride);
}

void allowRestDensity(StrandView drawn, const Fibre& fibre, const GuideStrands& guides,
                      const RepulsionSettings& settings, Repulsion& repulsion) {
  check(settings);
  repulsion.pointLength = meanPointLength(drawn);
  measureDensity(drawn, fibre, settings, repulsion.density, repulsion.pointLength);
  const std::uint32_t n = guides.pointsPerGuide();
  repulsion.allowed.assign(guides.position.size(), lanes(0));
  repulsion.push.assign(guides.position.size(), LaneVec3{});
  repulsion.turn = 0;
  lookUp(repulsion.density, settings.kind, guides.position, repulsion.allowed);
  for (Lanes& allowed : repulsion.allowed)
    allowed = max(lanes(settings.threshold), settings.tolerance * allowed);
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
      const std::size_t at = (2 * half + turn) * n;
      push(repulsion.density, settings, std::span(guides.position).subspan(at, n),
           &repulsion.allowed[at], &repulsion.push[at]);
    }
  });
  repulsion.turn = 1 - turn;
}

}  // namespace hair

#endif
