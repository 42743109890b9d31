#include <libhair/motion/body_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/geometry/surface_nets.h>
#include <libhair/motion/landmarks.h>

namespace hair {
namespace {

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// A sphere of radius ra at a that moves to b and becomes rb.
struct RoundCone {
  glm::vec3 a, b;
  float ra, rb;
};

/// Distance to the sphere at the nearest point of the axis: exact for capsules, close for cones
/// with the small taper of limbs.
float distance(const RoundCone& cone, glm::vec3 p) {
  const glm::vec3 axis = cone.b - cone.a;
  const float length2 = glm::dot(axis, axis);
  const float t = length2 > 0 ? std::clamp(glm::dot(p - cone.a, axis) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, cone.a + t * axis) - glm::mix(cone.ra, cone.rb, t);
}

/// Smooth union: blends within k of both surfaces and adds at most k / 4.
float meltedUnion(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0f) / k;
  return std::min(a, b) - 0.25f * k * h * h;
}

/// Cones that follow one another with the same radius where they meet.
using Tube = std::vector<RoundCone>;
/// Tubes joined by smooth unions.
using Flesh = std::vector<Tube>;

constexpr float kMostCells = 4e5f, kMostCellsAlong = 1000;

TriangleMesh surfaceOf(const Flesh& flesh, float k, float cell) {
  Bounds box;
  for (const Tube& tube : flesh)
    for (const RoundCone& cone : tube) {
      const float r = std::max(cone.ra, cone.rb) + 0.5f * k;
      for (const glm::vec3 p : {cone.a, cone.b}) {
        box.extend(p - r);
        box.extend(p + r);
      }
    }
  // Bodies of any size and proportions are as much work as a person's, in coarser cells.
  const glm::vec3 size = box.upper - box.lower;
  cell = std::max({cell, std::cbrt(size.x * size.y * size.z / kMostCells),
                   std::max({size.x, size.y, size.z}) / kMostCellsAlong});
  box.lower -= 2.0f * cell;
  box.upper += 2.0f * cell;
  return surfaceNets(
      [&](glm::vec3 p) {
        float d = 1e9f;
        for (const Tube& tube : flesh) {
          float nearest = 1e9f;
          for (const RoundCone& cone : tube) nearest = std::min(nearest, distance(cone, p));
          d = meltedUnion(d, nearest, k);
        }
        return d;
      },
      box, cell);
}

/// The trunk's capsules, thinner by what the smooth union adds, and a neck that ends in the head.
Flesh trunkFlesh(const Body& body, const Landmarks& m) {
  const float s = m.size;
  Flesh flesh;
  const auto isTrunk = [&](int j) {
    return j == body.map.hips || j == body.map.collar[0] || j == body.map.collar[1] ||
           std::find(body.map.spine.begin(), body.map.spine.end(), j) != body.map.spine.end();
  };
  for (const BodyCapsule& c : body.capsules) {
    if (!isTrunk(c.jointA) || !isTrunk(c.jointB)) continue;
    const float r = c.radius - 0.008f * s;
    flesh.push_back(
        {{body.rest[index(c.jointA)].point(c.a), body.rest[index(c.jointB)].point(c.b), r, r}});
  }
  flesh.push_back({{m.neck - glm::vec3(0, 0.03f * s, 0), m.head + glm::vec3(0, 0.02f, 0.008f) * s,
                    0.045f * s, 0.042f * s}});
  return flesh;
}

Flesh armFlesh(const Landmarks& m, std::size_t side) {
  const float s = m.size;
  const glm::vec3 shoulder = m.shoulder[side], elbow = m.elbow[side], wrist = m.wrist[side];
  const glm::vec3 upper = glm::mix(shoulder, elbow, 0.4f), fore = glm::mix(elbow, wrist, 0.25f);
  Flesh flesh = {{{shoulder, upper, 0.046f * s, 0.041f * s},
                  {upper, elbow, 0.041f * s, 0.034f * s},
                  {elbow, fore, 0.034f * s, 0.036f * s},
                  {fore, wrist, 0.036f * s, 0.023f * s}}};
  // A mitten: three fingers' breadths of palm and fingers, and a thumb to the front.
  const glm::vec3 across = m.handFlat[side] * s, tips = m.fingertips[side], palm = m.knuckles[side];
  for (float f : {-1.0f, 0.0f, 1.0f}) {
    const glm::vec3 knuckle = palm + 0.023f * f * across;
    const glm::vec3 tip = glm::mix(palm, tips, 0.95f - 0.12f * std::abs(f)) + 0.016f * f * across;
    flesh.push_back({{wrist + 0.007f * f * across, knuckle, 0.018f * s, 0.014f * s},
                     {knuckle, tip, 0.014f * s, 0.009f * s}});
  }
  const glm::vec3 base = glm::mix(wrist, palm, 0.3f) + 0.018f * across;
  flesh.push_back({{base, glm::mix(wrist, palm, 0.85f) + 0.05f * across, 0.014f * s, 0.010f * s}});
  return flesh;
}

Flesh legFlesh(const Landmarks& m, std::size_t side) {
  const float s = m.size;
  const glm::vec3 hip = m.hip[side], knee = m.knee[side], ankle = m.ankle[side];
  const glm::vec3 thigh = glm::mix(hip, knee, 0.35f);
  const glm::vec3 calf = glm::mix(knee, ankle, 0.28f) - glm::vec3(0, 0, 0.010f * s);
  return {{{hip, thigh, 0.083f * s, 0.077f * s},
           {thigh, knee, 0.077f * s, 0.050f * s},
           {knee, calf, 0.050f * s, 0.052f * s},
           {calf, ankle, 0.052f * s, 0.032f * s}},
          {{ankle, m.heel[side], 0.032f * s, 0.029f * s}},
          {{glm::mix(ankle, m.heel[side], 0.3f), m.ball[side], 0.030f * s, 0.025f * s},
           {m.ball[side], m.toe[side], 0.025f * s, 0.018f * s}},
          {{m.heel[side], m.ball[side], 0.027f * s, 0.025f * s}}};
}

}  // namespace

/// Skinning weights of a vertex, before the largest four are chosen.
struct BodyMesh::Weights {
  std::vector<std::pair<int, float>> of;

  void add(int joint, float weight) {
    if (weight > 1e-3f) of.emplace_back(joint, weight);
  }
};

namespace {

float step(float middle, float half, float x) {
  return glm::smoothstep(middle - half, middle + half, x);
}

/// A joint of a chain: it carries what is beyond its position, `at` metres along the chain, and
/// blends with the previous joint within ±half of it.
struct Link {
  int joint;
  float at, half;
};

template <class Add>
void alongChain(std::span<const Link> chain, float u, const Add& add) {
  float beyond = 1.0f;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const float next = i + 1 < chain.size() ? step(chain[i + 1].at, chain[i + 1].half, u) : 0.0f;
    add(chain[i].joint, std::max(0.0f, beyond - std::min(beyond, next)));
    beyond = std::min(beyond, next);
  }
}

/// Arc length, metres, of the point of a polyline nearest to p.
float alongLine(std::span<const glm::vec3> line, glm::vec3 p) {
  float best = 1e9f, at = 0, start = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const glm::vec3 axis = line[i + 1] - line[i];
    const float length = glm::length(axis);
    // Extend the first bone backwards: the region before a limb's joint belongs to the trunk.
    const float t =
        std::clamp(glm::dot(p - line[i], axis) / (length * length), i == 0 ? -1.0f : 0.0f, 1.0f);
    const float d = glm::distance(p, line[i] + t * axis);
    if (d < best) {
      best = d;
      at = start + t * length;
    }
    start += length;
  }
  return at;
}

}  // namespace

BodyMesh::BodyMesh(const Body& body, float cell) {
  if (!body.map.complete()) {
    for (const BodyCapsule& c : body.capsules) {
      const RigidTransform joint = body.rest[index(c.jointA)];
      const TriangleMesh part =
          surfaceOf({{{joint.point(c.a), joint.point(c.b), c.radius, c.radius}}}, 0.01f, cell);
      std::vector<Weights> weights(part.positions.size());
      for (Weights& w : weights) w.add(c.jointA, 1.0f);
      add(part, body, weights);
    }
    return;
  }
  const Landmarks m = landmarksOf(body);
  const BodyMap& map = body.map;
  const float s = m.size;

  // Trunk: by height along hips, spine, neck, head; the shoulders follow the collar bones.
  {
    const TriangleMesh part = surfaceOf(trunkFlesh(body, m), 0.033f * s, cell);
    std::vector<Link> chain = {{map.hips, -1e9f, 1.0f}};
    const auto link = [&](int joint) {
      const float y = body.rest[index(joint)].translation.y;
      const float gap = chain.size() > 1 ? y - chain.back().at : 0.15f * s;
      chain.push_back({joint, y, std::clamp(0.48f * gap, 0.01f * s, 0.06f * s)});
    };
    for (int j : map.spine) link(j);
    const std::size_t trunkLinks = chain.size();
    link(map.neck);
    link(map.head);
    std::vector<Weights> weights(part.positions.size());
    for (std::size_t v = 0; v < weights.size(); ++v) {
      const glm::vec3 p = part.positions[v];
      const float t = (p.y - m.pelvis.y) / (m.neck.y - m.pelvis.y);
      const glm::vec3 axis = glm::mix(m.neck, m.head, std::clamp((t - 1.0f) * 4.0f, 0.0f, 1.0f));
      const float aside = glm::length(glm::vec2(p.x - axis.x, p.z - axis.z)) / s;
      const float isNeck = 1.0f - glm::smoothstep(0.045f, 0.085f, aside);
      const std::size_t side = p.x >= m.neck.x ? 0 : 1;
      float isCollar = 0;
      if (map.collar[side] >= 0)
        isCollar = glm::smoothstep(0.2f, 0.85f, std::abs(p.x - m.neck.x) / m.halfShoulders()) *
                   glm::smoothstep(0.65f, 0.88f, t);
      float chest = 0;
      std::size_t i = 0;
      alongChain(chain, p.y, [&](int joint, float w) {
        const bool trunk = i++ < trunkLinks;
        const float kept = trunk ? w : w * isNeck;
        chest += w - kept;
        if (joint == map.chest) {
          chest += w;
        } else {
          weights[v].add(joint, kept);
        }
      });
      weights[v].add(map.chest, chest * (1.0f - isCollar));
      if (isCollar > 0) weights[v].add(map.collar[side], chest * isCollar);
    }
    add(part, body, weights);
  }

  const auto limb = [&](const Flesh& flesh, float k, float limbCell,
                        std::span<const glm::vec3> line, std::span<const Link> chain) {
    const TriangleMesh part = surfaceOf(flesh, k, limbCell);
    std::vector<Weights> weights(part.positions.size());
    for (std::size_t v = 0; v < weights.size(); ++v)
      alongChain(chain, alongLine(line, part.positions[v]),
                 [&](int joint, float w) { weights[v].add(joint, w); });
    add(part, body, weights);
  };
  for (std::size_t side = 0; side < 2; ++side) {
    const int trunk = map.collar[side] >= 0 ? map.collar[side] : map.chest;
    const float elbow = glm::distance(m.shoulder[side], m.elbow[side]);
    const float wrist = elbow + glm::distance(m.elbow[side], m.wrist[side]);
    const std::array arm = {m.shoulder[side], m.elbow[side], m.wrist[side], m.fingertips[side]};
    const std::array<Link, 4> armChain = {{{trunk, -1e9f, 1.0f},
                                           {map.upperArm[side], -0.01f * s, 0.03f * s},
                                           {map.foreArm[side], elbow, 0.045f * s},
                                           {map.hand[side], wrist, 0.025f * s}}};
    // Fingers are thin: a finer grid.
    limb(armFlesh(m, side), 0.018f * s, 0.7f * cell, arm, armChain);

    const float knee = glm::distance(m.hip[side], m.knee[side]);
    const float ankle = knee + glm::distance(m.knee[side], m.ankle[side]);
    const float ball = ankle + glm::distance(m.ankle[side], m.ball[side]);
    const std::array leg = {m.hip[side], m.knee[side], m.ankle[side], m.ball[side], m.toe[side]};
    const std::array<Link, 5> legChain = {{{map.hips, -1e9f, 1.0f},
                                           {map.thigh[side], -0.01f * s, 0.05f * s},
                                           {map.shin[side], knee, 0.06f * s},
                                           {map.foot[side], ankle, 0.035f * s},
                                           {m.toes[side], ball, 0.02f * s}}};
    limb(legFlesh(m, side), 0.03f * s, cell, leg, legChain);
  }
}

void BodyMesh::add(const TriangleMesh& part, const Body& body,
                   const std::vector<Weights>& weights) {
  const auto base = static_cast<std::uint32_t>(rest_.positions.size());
  rest_.positions.insert(rest_.positions.end(), part.positions.begin(), part.positions.end());
  rest_.normals.insert(rest_.normals.end(), part.normals.begin(), part.normals.end());
  for (const glm::uvec3& t : part.triangles) rest_.triangles.push_back(t + base);
  for (Weights w : weights) {
    std::stable_sort(w.of.begin(), w.of.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    w.of.resize(std::min<std::size_t>(w.of.size(), 4));
    float sum = 0;
    for (const auto& [joint, weight] : w.of) sum += weight;
    Binding binding{};
    for (std::size_t i = 0; i < w.of.size(); ++i) {
      const int joint = w.of[i].first;
      auto carrier = std::find_if(carriers_.begin(), carriers_.end(),
                                  [&](const Carrier& c) { return c.joint == joint; });
      if (carrier == carriers_.end()) {
        require(carriers_.size() < kMaxCarriers, "body mesh: more than ", kMaxCarriers,
                " joints carry flesh; leave out fingers and the like");
        carriers_.push_back({joint, inverse(body.rest[index(joint)])});
        carrier = carriers_.end() - 1;
      }
      binding.carrier[i] = static_cast<std::uint8_t>(carrier - carriers_.begin());
      binding.weight[i] = w.of[i].second / sum;
    }
    bindings_.push_back(binding);
  }
}

void BodyMesh::skin(std::span<const RigidTransform> worldFromJoint, TriangleMesh& out) const {
  out.positions.resize(rest_.positions.size());
  out.normals.resize(rest_.normals.size());
  if (out.triangles.size() != rest_.triangles.size()) out.triangles = rest_.triangles;

  struct Affine {
    glm::mat3 linear;
    glm::vec3 translation;
  };
  std::array<Affine, kMaxCarriers> worldFromBody;
  for (std::size_t c = 0; c < carriers_.size(); ++c) {
    const RigidTransform t = worldFromJoint[index(carriers_[c].joint)] * carriers_[c].jointFromBody;
    worldFromBody[c] = {glm::mat3_cast(t.rotation), t.translation};
  }
  parallelFor(rest_.positions.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Binding& binding = bindings_[v];
      glm::mat3 linear(0);
      glm::vec3 translation(0);
      for (std::size_t i = 0; i < 4; ++i) {
        const Affine& carrier = worldFromBody[binding.carrier[i]];
        linear += binding.weight[i] * carrier.linear;
        translation += binding.weight[i] * carrier.translation;
      }
      out.positions[v] = linear * rest_.positions[v] + translation;
      const glm::vec3 normal = linear * rest_.normals[v];
      const float length = glm::length(normal);
      out.normals[v] = length > 0 ? normal / length : glm::vec3(0, 1, 0);
    }
  });
}

}  // namespace hair
