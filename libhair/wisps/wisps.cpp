#include <libhair/wisps/wisps.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/model/mesh_sdf.h>

namespace hair {

namespace {

void check(const Groom& groom) {
  const std::size_t strands = groom.strandCount();
  require(groom.first.size() == strands + 1 && groom.weights.size() == strands, "groom: ", strands,
          " strands, but ", groom.first.size(), " offsets and ", groom.weights.size(), " weights");
  require(groom.offsets.empty() || groom.offsets.size() == groom.pointCount(),
          "groom: ", groom.pointCount(), " points, but ", groom.offsets.size(), " offsets");
  for (std::size_t s = 0; s < strands; ++s) {
    require(groom.first[s] + 2 <= groom.first[s + 1], "groom: strand ", s,
            " has fewer than 2 points");
    for (int j = 0; j < 3; ++j)
      require(groom.parents[s][j] < groom.guideCount(), "groom: strand ", s, " follows guide ",
              groom.parents[s][j], " of ", groom.guideCount());
    const glm::vec3 w = groom.weights[s];
    require(std::abs(w.x + w.y + w.z - 1) < 1e-3f, "groom: weights of strand ", s, " sum to ",
            w.x + w.y + w.z);
  }
}

std::uint32_t longestStrand(const Groom& groom) {
  std::uint32_t n = 2;
  for (std::size_t s = 0; s + 1 < groom.first.size(); ++s)
    n = std::max(n, groom.first[s + 1] - groom.first[s]);
  return n;
}

// One strand while it is made.
struct Strand {
  const Wisps& wisps;
  std::uint32_t n;
  glm::vec3 weights;
  const glm::vec3 *main, *second, *third;
  const GuideCurves::Frame* frames;
  const glm::vec3* offsets;  // null: none
  glm::vec3 rootOffset;

  glm::vec3 shape(std::uint32_t k, std::uint32_t sample) const {
    return offsets ? frames[sample].toWorld(offsets[k]) : glm::vec3(0);
  }
  glm::vec3 multi(std::uint32_t k) const {
    const std::uint32_t m = wisps.sampleOf(k, n);
    return weights.x * main[m] + weights.y * second[m] + weights.z * third[m] + shape(k, m);
  }
  glm::vec3 single(std::uint32_t k) const {
    const std::uint32_t m = wisps.sampleOf(k, n);
    return main[m] + frames[m].toWorld(rootOffset) + shape(k, m);
  }
};

// The nearest of head and body at a point: distance beyond what must be kept, and the way out.
struct Obstacles {
  const ColliderState& colliders;
  glm::mat3 worldFromHead;
  float skin, headClearance;
  std::uint64_t near;

  glm::vec3 inHead(glm::vec3 p) const {
    return (p - colliders.worldFromHead.translation) * worldFromHead;
  }
  // Exact where it is below zero; where it is not, no more than the distance.
  float headDistance(glm::vec3 p) const {
    if (!colliders.head) return 1e3f;
    const glm::vec3 local = inHead(p);
    const float bound = colliders.head->lowerBound(local) - headClearance;
    return bound > 0 ? bound : colliders.head->distance(local) - headClearance;
  }
  float bodyDistance(glm::vec3 p) const {
    float nearest = 1e3f;
    for (std::uint64_t rest = near; rest != 0; rest &= rest - 1) {
      const auto c = static_cast<std::size_t>(__builtin_ctzll(rest));
      const float keep = colliders.capsules[c].radius + skin, within = nearest + keep;
      const float d2 = axisDistance2(colliders.capsules[c], p);
      if (d2 < within * within) nearest = std::sqrt(d2) - keep;
    }
    return nearest;
  }
  // The way out as well: direction, distance.
  glm::vec4 at(glm::vec3 p) const {
    glm::vec4 nearest(0, 1, 0, 1e3f);
    if (colliders.head) {
      const glm::vec4 d = colliders.head->distanceAndGradient(inHead(p));
      nearest = glm::vec4(worldFromHead * glm::vec3(d), d.w - headClearance);
    }
    for (std::uint64_t rest = near; rest != 0; rest &= rest - 1) {
      const auto c = static_cast<std::size_t>(__builtin_ctzll(rest));
      glm::vec4 d = distanceAndGradient(colliders.capsules[c], p);
      d.w -= skin;
      if (d.w < nearest.w) nearest = d;
    }
    return nearest;
  }
};

// First point from `from` on that is inside an obstacle, n if none. A distance holds for a way as
// long as itself: points closer than that to one that is clear need no look.
std::uint32_t firstHit(std::span<const glm::vec3> points, std::uint32_t from,
                       const Obstacles& obstacles) {
  float head = -1, body = -1;
  for (std::uint32_t k = from; k < points.size(); ++k) {
    if (k > from) {
      const float way = glm::distance(points[k], points[k - 1]);
      head -= way, body -= way;
    }
    if (head <= 0) head = obstacles.headDistance(points[k]);
    if (head < 0) return k;
    if (body <= 0) body = obstacles.bodyDistance(points[k]);
    if (body < 0) return k;
  }
  return static_cast<std::uint32_t>(points.size());
}

void pushOut(std::span<glm::vec3> points, std::uint32_t from, const Obstacles& obstacles) {
  for (std::uint32_t k = firstHit(points, from, obstacles); k < points.size();
       k = firstHit(points, k + 1, obstacles))
    // Twice: out of one collider may be into its neighbour.
    for (int round = 0; round < 2; ++round) {
      const glm::vec4 d = obstacles.at(points[k]);
      if (d.w >= 0) break;
      points[k] -= d.w * glm::vec3(d);
    }
}

void avoid(const Strand& strand, const Obstacles& obstacles, std::uint32_t blend,
           std::span<glm::vec3> points) {
  const std::uint32_t hit = firstHit(points, 1, obstacles);
  if (hit == strand.n) return;
  const std::uint32_t start = hit > blend ? hit - blend : 1;
  for (std::uint32_t k = start; k < strand.n; ++k) {
    const float t =
        hit > start
            ? std::min(1.0f, static_cast<float>(k - start) / static_cast<float>(hit - start))
            : 1.0f;
    points[k] = glm::mix(points[k], strand.single(k), t * t * (3 - 2 * t));
  }
  pushOut(points, 1, obstacles);
}

void findNearBodies(const ColliderState& colliders, Wisps& wisps) {
  // Strands stray from their guides by less than this.
  constexpr float kReach = 0.05f;
  parallelFor(wisps.nearBodies.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      const Bounds box = bounds(
          std::span(wisps.curves.points).subspan(g * wisps.curves.samples, wisps.curves.samples));
      std::uint64_t near = 0;
      for (std::size_t c = 0; c < colliders.capsules.size(); ++c) {
        const Capsule& capsule = colliders.capsules[c];
        const glm::vec3 reach(capsule.radius + kReach);
        if (glm::all(glm::lessThan(glm::min(capsule.a, capsule.b) - reach, box.upper)) &&
            glm::all(glm::lessThan(box.lower, glm::max(capsule.a, capsule.b) + reach)))
          near |= std::uint64_t{1} << c;
      }
      wisps.nearBodies[g] = near;
    }
  });
}

Strand strandOf(const Wisps& wisps, std::size_t s) {
  const Groom& groom = *wisps.groom;
  const std::size_t samples = wisps.curves.samples;
  const glm::uvec3 parents = groom.parents[s];
  const glm::vec3* curve = wisps.curves.points.data();
  return {wisps,
          groom.first[s + 1] - groom.first[s],
          groom.weights[s],
          curve + parents.x * samples,
          curve + parents.y * samples,
          curve + parents.z * samples,
          wisps.curves.frames.data() + parents.x * samples,
          groom.offsets.empty() ? nullptr : groom.offsets.data() + groom.first[s],
          wisps.rootOffsets.empty() ? glm::vec3(0) : wisps.rootOffsets[s]};
}

}  // namespace

Wisps::Wisps(const Groom& groom_, const GuideStrands& guidesAtRest, const WispSettings& settings_,
             const MeshSdf* head)
    : groom((check(groom_), &groom_)),
      settings(settings_),
      points(groom_.pointCount()),
      curves(guidesAtRest, longestStrand(groom_), true) {
  nearBodies.resize(groom->guideCount());
  WispSettings free = settings;
  free.avoidColliders = false;
  settings = free;
  interpolateWisps(guidesAtRest, {}, *this);
  settings = settings_;
  rootOffsets.resize(groom->strandCount());
  clearance.resize(groom->strandCount());
  const RigidTransform headFromWorld = inverse(guidesAtRest.worldFromHead);
  for (std::size_t s = 0; s < groom->strandCount(); ++s) {
    const Strand strand = strandOf(*this, s);
    const glm::vec3 root = points[groom->first[s]];
    rootOffsets[s] = strand.frames[0].fromWorld(root - strand.main[0] - strand.shape(0, 0));
    clearance[s] = settings.clearance;
    for (std::uint32_t k = 1; head && k < strand.n; ++k)
      clearance[s] =
          std::min(clearance[s], head->distance(headFromWorld.point(points[groom->first[s] + k])));
  }
}

void interpolateWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps) {
  require(colliders.capsules.size() <= 64, "interpolateWisps: ", colliders.capsules.size(),
          " capsules; at most 64");
  sampleGuides(guides, wisps.curves);
  if (wisps.settings.avoidColliders) findNearBodies(colliders, wisps);
  const glm::mat3 worldFromHead = glm::mat3_cast(colliders.worldFromHead.rotation);
  parallelFor(wisps.groom->strandCount(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Strand strand = strandOf(wisps, s);
      const std::span<glm::vec3> points =
          std::span(wisps.points).subspan(wisps.groom->first[s], strand.n);
      for (std::uint32_t k = 0; k < strand.n; ++k) points[k] = strand.multi(k);
      if (!wisps.settings.avoidColliders) continue;
      const glm::uvec3 parents = wisps.groom->parents[s];
      const Obstacles obstacles{
          colliders, worldFromHead, wisps.settings.clearance, wisps.clearance[s],
          wisps.nearBodies[parents.x] | wisps.nearBodies[parents.y] | wisps.nearBodies[parents.z]};
      if (obstacles.near != 0 || colliders.head)
        avoid(strand, obstacles, wisps.settings.blendPoints, points);
    }
  });
}

}  // namespace hair
