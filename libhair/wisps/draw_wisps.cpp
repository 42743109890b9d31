// Drawn strands from guide curves, sixteen points ("a block") of one strand at once:
//
//   1. draw block by block by multi-strand interpolation, the weighted sum of three guide curves;
//   2. test each block for points inside of obstacles, and go on while there are none;
//   3. else, from the first such point `hit`, change over to single-strand interpolation, the main
//      guide moved to the strand's root, and push out of obstacles what is inside even then.
//
//      root o---o---o---o---o---o---o---x---x---o tip
//           multi   |   blend       |   single
//                 start            hit
//
// Most points skip the test: they are nearer to their main guide than any obstacle (`room`).
#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/wisps/draw_wisps.cpp"
#include <hwy/foreach_target.h>
#include <libhair/wisps/obstacles-inl.h>

#include <libhair/model/fewer_points.h>
#include <libhair/wisps/wisps.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// One strand while it is drawn. Its last sixteen points are one block, which may overlap the
// previous block; a strand of fewer points is one block with unused lanes. kEven: the strand has as
// many points as the curves have samples, so that these are contiguous.
template <bool kEven>
struct Strand {
  const Wisps& wisps;
  const WispObstacles& obstacles;
  std::size_t s, first, n;
  std::uint32_t main;
  const float* curves[3];  // the parents' rows
  const float* room;       // of the main guide
  const std::int32_t* table;
  glm::vec3 weights;

  HWY_INLINE Strand(const Wisps& w, std::size_t strand)
      : wisps(w),
        obstacles(*w.obstacles),
        s(strand),
        first(w.groom->first[s]),
        n(w.groom->first[s + 1] - first),
        main(w.groom->parents[s].x),
        room(obstacles.roomOf(main, w.curves->samples)),
        table(w.sampleTable.data() + w.tableOf[n]),
        weights(w.groom->weights[s]) {
    for (int j = 0; j < 3; ++j) curves[j] = w.curves->row(w.groom->parents[s][j], 0);
  }

  std::size_t blockAt(std::size_t k) const { return n > kLanes ? std::min(k, n - kLanes) : 0; }
  // Lanes of the block at k that hold points from `from` on.
  HWY_INLINE Mask lanesFrom(std::size_t from, std::size_t k) const {
    return firstLanes(n) & !firstLanes(from > k ? from - k : 0);
  }

  // The samples of the guide curves that sixteen points follow.
  struct At {
    std::size_t k;
    Ints sample;
  };
  HWY_INLINE At at(std::size_t k) const {
    At a;
    a.k = k;
    if constexpr (!kEven) a.sample = loadInts(table + k);
    return a;
  }
  HWY_INLINE Floats load(const float* row, const At& a) const {
    if constexpr (kEven)
      return loadFloats(row + a.k);
    else
      return gather(row, a.sample);
  }
  HWY_INLINE Vec3 vector(int parent, std::size_t component, const At& a) const {
    const std::size_t samples = wisps.curves->samples;
    const float* x = curves[parent] + component * samples;
    return {load(x, a), load(x + samples, a), load(x + 2 * samples, a)};
  }
  HWY_INLINE Vec3 loadBlock(const glm::vec3* from) const {
    if (n >= kLanes) return loadPoints(from);
    glm::vec3 block[kLanes] = {};
    std::copy_n(from, n, block);
    return loadPoints(block);
  }
  HWY_INLINE void storeBlock(Vec3 p, glm::vec3* to) const {
    if (n >= kLanes) return storePoints(p, to);
    glm::vec3 block[kLanes];
    storePoints(p, block);
    std::copy_n(block, n, to);
  }

  struct Frame {
    Vec3 normal, binormal, tangent;
    HWY_INLINE Vec3 toWorld(Vec3 v) const { return v.x * normal + v.y * binormal + v.z * tangent; }
  };
  HWY_INLINE Frame frame(const At& a) const {
    const Vec3 normal = vector(0, GuideCurves::kNormal, a),
               tangent = vector(0, GuideCurves::kTangent, a);
    return {normal, cross(tangent, normal), tangent};
  }

  struct Block {
    Vec3 main, point;
  };
  // Multi-strand interpolation: the weighted sum of three guides, plus the offset in the frame of
  // the main guide.
  HWY_INLINE Block multi(std::size_t k) const {
    const At a = at(k);
    const Vec3 m = vector(0, GuideCurves::kPoint, a);
    Vec3 p = Floats(weights.x) * m + Floats(weights.y) * vector(1, GuideCurves::kPoint, a) +
             Floats(weights.z) * vector(2, GuideCurves::kPoint, a);
    if (!wisps.groom->offsets.empty())
      p = p + frame(a).toWorld(loadBlock(wisps.groom->offsets.data() + first + k));
    return {m, p};
  }
  // Single-strand interpolation: the main guide, moved to the strand's root.
  HWY_INLINE Block single(std::size_t k) const {
    const At a = at(k);
    const Frame f = frame(a);
    const Vec3 m = vector(0, GuideCurves::kPoint, a);
    Vec3 p = m + f.toWorld(Vec3(wisps.rootOffsets[s]));
    if (!wisps.groom->offsets.empty())
      p = p + f.toWorld(loadBlock(wisps.groom->offsets.data() + first + k));
    return {m, p};
  }

  // The capsules, one bit each, that points at these squared distances from the main guide may
  // reach.
  HWY_INLINE std::uint64_t capsulesNear(Floats stray2, Mask look) const {
    constexpr float kReach = WispObstacles::kReach;
    if (any(look & !(stray2 < Floats(kReach * kReach)))) {
      const std::size_t count = obstacles.axes.size();
      return count < 64 ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
    }
    return obstacles.near[main];
  }

  // The lanes of `look` whose points are nearer to an obstacle than their clearance.
  HWY_INLINE Mask inside(std::size_t k, Mask look, const Block& block) const {
    // Test points against the head where they are farther from the main guide than its room.
    const At a = at(k);
    const Vec3 away = block.point - block.main;
    const Floats stray2 = dot(away, away);
    Mask in = none();
    if (obstacles.head) {
      const Mask open = look & !(stray2 < load(room, a));
      if (any(open)) {
        const HeadLookup head(obstacles);
        const Floats clearance(wisps.clearance[s]);
        const Vec3 q = head.inHead(block.point);
        const Mask maybe = open & (head.sdf.lowerBound(q, open) <= clearance);
        if (any(maybe)) in = maybe & (head.sdf.distance(q, maybe) < clearance);
      }
    }
    // Test against capsules, planes and meshes in the same way.
    const Mask open = look & !(stray2 < load(room + wisps.curves->samples, a));
    if (any(open)) {
      for (std::uint64_t rest = capsulesNear(stray2, open); rest != 0; rest &= rest - 1) {
        const WispObstacles::Axis& c =
            obstacles.axes[static_cast<std::size_t>(__builtin_ctzll(rest))];
        const Vec3 out = fromAxis(c, block.point);
        in = in | (open & (dot(out, out) < Floats(c.keep * c.keep)));
      }
      for (const WispObstacles::Face& face : obstacles.faces)
        in = in | (open & (beyond(face, block.point) < Floats(0.0f)));
      for (const WispObstacles::Mesh& mesh : obstacles.meshes) {
        const MeshLookup lookup(mesh);
        const Vec3 q = lookup.inMesh(block.point);
        in = in | (open & (lookup.beyond(q, open) < Floats(0.0f)));
      }
    }
    return in;
  }

  // Finds the obstacle that each point is nearest to, or deepest in, and pushes points out of it.
  HWY_INLINE void pushOnce(Mask in, Block& block) const {
    const Vec3 away = block.point - block.main;
    Vec3 out(Floats(0.0f), Floats(1.0f), Floats(0.0f));
    Floats nearest(1e3f);
    for (std::uint64_t rest = capsulesNear(dot(away, away), in); rest != 0; rest &= rest - 1) {
      const WispObstacles::Axis& c =
          obstacles.axes[static_cast<std::size_t>(__builtin_ctzll(rest))];
      const Vec3 d = fromAxis(c, block.point);
      const Floats r = length(d), w = r - Floats(c.keep);
      const Mask nearer = w < nearest;
      if (!any(in & nearer)) continue;
      const Floats perLength = Floats(1.0f) / max(r, Floats(1e-9f));
      const Vec3 up(Floats(0.0f), Floats(1.0f), Floats(0.0f));
      out = select(nearer, select(r > Floats(1e-9f), perLength * d, up), out);
      nearest = select(nearer, w, nearest);
    }
    // Replace it where the head, a plane or a mesh is nearer.
    if (obstacles.head) {
      const HeadLookup head(obstacles);
      const Vec3 q = head.inHead(block.point);
      const Floats w = head.sdf.distance(q, in) - Floats(wisps.clearance[s]);
      const Mask nearer = in & (w <= nearest) & (w < Floats(0.0f));
      if (any(nearer)) {
        out = select(nearer, rotate(head.turn, head.sdf.direction(q, nearer)), out);
        nearest = select(nearer, w, nearest);
      }
    }
    for (const WispObstacles::Face& face : obstacles.faces) {
      const Floats w = beyond(face, block.point);
      out = select(w < nearest, Vec3(face.normal), out);
      nearest = min(w, nearest);
    }
    for (const WispObstacles::Mesh& mesh : obstacles.meshes) {
      const MeshLookup lookup(mesh);
      const Vec3 q = lookup.inMesh(block.point);
      const Floats w = lookup.beyond(q, in);
      const Mask nearer = in & (w < nearest) & (w < Floats(0.0f));
      if (!any(nearer)) continue;
      out = select(nearer, rotate(mesh.worldFromMesh, lookup.sdf.direction(q, nearer)), out);
      nearest = select(nearer, w, nearest);
    }
    // Move points by their depth along the outward normal.
    block.point = select(in & (nearest < Floats(0.0f)), block.point - nearest * out, block.point);
  }

  // Draws the strand again from blendPoints before `hit`, its first point inside of an obstacle:
  // blends into single-strand interpolation up to `hit`, and pushes points out of obstacles.
  HWY_INLINE void avoid(std::size_t hit, glm::vec3* points) const {
    const std::size_t blend = wisps.settings.blendPoints;
    const std::size_t start = hit > blend ? hit - blend : 1;
    const Floats from(static_cast<float>(start));
    const Floats length(static_cast<float>(std::max<std::size_t>(hit - start, 1)));
    for (std::size_t k = start; k < n; k += kLanes) {
      k = blockAt(k);
      // Blend the two interpolations before `hit`, by a smoothstep.
      Block block = single(k);
      if (k < hit) {
        const Floats number = toFloats(laneNumbers() + Ints(static_cast<std::int32_t>(k)));
        Floats t = min(max((number - from) / length, Floats(0.0f)), Floats(1.0f));
        if (hit == start) t = select(number < from, Floats(0.0f), Floats(1.0f));
        t = t * t * (Floats(3.0f) - Floats(2.0f) * t);
        const Vec3 many = multi(k).point;
        block.point = (Floats(1.0f) - t) * many + t * block.point;
      }
      // Push out twice: the first push may end in another obstacle.
      for (int round = 0; round < 2; ++round) {
        const Mask in = inside(k, lanesFrom(start, k), block);
        if (!any(in)) break;
        pushOnce(in, block);
      }
      storeBlock(block.point, points + k);
    }
  }

  // Draws the last point alone, by the scalar form of `multi`, where it would need a block of its
  // own. False if the guide's room does not clear it of obstacles: it must be drawn as a block.
  HWY_INLINE bool drawTip(glm::vec3* points) const {
    const std::size_t k = n - 1, samples = wisps.curves->samples;
    const auto sample = kEven ? k : static_cast<std::size_t>(table[k]);
    const auto at = [&](int parent, std::size_t component) {
      const float* x = curves[parent] + component * samples + sample;
      return glm::vec3(x[0], x[samples], x[2 * samples]);
    };
    const glm::vec3 m = at(0, GuideCurves::kPoint);
    glm::vec3 p = weights.x * m + weights.y * at(1, GuideCurves::kPoint) +
                  weights.z * at(2, GuideCurves::kPoint);
    if (!wisps.groom->offsets.empty()) {
      const glm::vec3 normal = at(0, GuideCurves::kNormal), tangent = at(0, GuideCurves::kTangent);
      const GuideCurves::Frame f{normal, glm::cross(tangent, normal), tangent};
      p += f.toWorld(wisps.groom->offsets[first + k]);
    }
    points[k] = p;
    const glm::vec3 away = p - m;
    const float stray2 = glm::dot(away, away);
    return (!obstacles.head || stray2 < room[sample]) &&
           (obstacles.onlyHead() || stray2 < room[samples + sample]);
  }

  HWY_INLINE void draw(glm::vec3* points) const {
    const bool free = obstacles.none();
    // Never test or move the root.
    std::size_t from = 1;
    for (std::size_t k = 0; k < n; k += kLanes, from = k) {
      if (n > kLanes && k + 1 == n && drawTip(points)) return;
      k = blockAt(k);
      const Block block = multi(k);
      storeBlock(block.point, points + k);
      if (free) continue;
      if (const std::uint32_t in = bits(inside(k, lanesFrom(from, k), block)))
        return avoid(k + static_cast<std::size_t>(__builtin_ctz(in)), points);
    }
  }
};

// Not inlined, so that there is one copy of all that is inlined into it.
HWY_NOINLINE void drawStrand(const Wisps& wisps, std::size_t s, glm::vec3* points) {
  const std::uint32_t* first = wisps.groom->first.data();
  if (first[s + 1] - first[s] == wisps.curves->samples)
    Strand<true>(wisps, s).draw(points);
  else
    Strand<false>(wisps, s).draw(points);
}

void drawOne(std::size_t s, const Wisps& wisps, glm::vec3* points) {
  drawStrand(wisps, s, points);
}

// Draws the strands of the level of detail: each with all of its points, then resampled to fewer.
void drawFew(std::size_t begin, std::size_t end, Wisps& wisps) {
  constexpr std::size_t kUsual = 256;
  glm::vec3 room[kUsual];
  std::vector<glm::vec3> longer;
  const std::vector<std::uint32_t>&first = wisps.groom->first, &drawn = wisps.drawn.first;
  for (std::size_t s = begin; s < end; ++s) {
    const std::size_t n = first[s + 1] - first[s], kept = drawn[s + 1] - drawn[s];
    glm::vec3* points = wisps.points.data() + drawn[s];
    if (kept == 0) continue;
    if (kept == n) {
      drawStrand(wisps, s, points);
      continue;
    }
    if (n > kUsual) longer.resize(n);
    glm::vec3* all = n > kUsual ? longer.data() : room;
    drawStrand(wisps, s, all);
    takePoints({all, n}, {points, kept});
  }
}

void drawStrands(std::size_t begin, std::size_t end, Wisps& wisps) {
  if (!wisps.drawn.first.empty()) return drawFew(begin, end, wisps);
  const std::uint32_t* first = wisps.groom->first.data();
  for (std::size_t s = begin; s < end; ++s) drawStrand(wisps, s, wisps.points.data() + first[s]);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hair {

namespace {

HWY_EXPORT(drawStrands);
HWY_EXPORT(drawOne);

}  // namespace

void drawWisps(std::size_t begin, std::size_t end, Wisps& wisps) {
  HWY_DYNAMIC_DISPATCH(drawStrands)(begin, end, wisps);
}

void drawWhole(std::size_t strand, const Wisps& wisps, std::span<glm::vec3> points) {
  HWY_DYNAMIC_DISPATCH(drawOne)(strand, wisps, points.data());
}

}  // namespace hair

#endif  // HWY_ONCE
