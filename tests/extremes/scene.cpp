#include "scene.h"

#include <algorithm>
#include <cmath>

namespace hair::extremes {

namespace {

// Below this the library takes two points for one.
constexpr float kShortest = 2e-6f;
constexpr std::uint32_t kDrawnPoints = 12;

glm::vec3 ballPoint(std::uint32_t s, std::uint32_t count) {
  const float y = -(static_cast<float>(s) + 0.5f) / static_cast<float>(count);
  const float a = 2.39996323f * static_cast<float>(s), r = std::sqrt(1 - y * y);
  return {r * std::cos(a), y, r * std::sin(a)};
}

float linkLength(const Setup& setup, std::uint32_t i) {
  const bool shortOne = i % 3 == 1;
  return shortOne ? std::max(setup.longestLink / setup.ratio, kShortest) : setup.longestLink;
}

void addGuide(const Setup& setup, std::uint32_t s, Groom& groom) {
  const glm::vec3 out = ballPoint(s, setup.strands);
  glm::vec3 p = setup.spread * out;
  for (std::uint32_t i = 0;; ++i) {
    groom.guidePoints.push_back(p);
    if (i == setup.links) break;
    // Leaves the ball slantwise, and turns down; a string cannot, and hangs.
    const float way = static_cast<float>(i) / static_cast<float>(setup.links);
    const float slant = setup.settings.guides.bendingStiffness > 0 ? 0.4f * (1 - way) : 0.0f;
    p += linkLength(setup, i) * glm::normalize(glm::vec3(0, -1, 0) + slant * out);
  }
}

Groom makeGroom(const Setup& setup) {
  Groom groom;
  groom.pointsPerGuide = setup.links + 1;
  for (std::uint32_t s = 0; s < setup.strands; ++s) addGuide(setup, s, groom);
  for (std::uint32_t s = 0; s < 2 * setup.strands; ++s) {
    const std::uint32_t g = s % setup.strands, n = setup.strands;
    groom.parents.push_back({g, (g + 1) % n, (g + 2) % n});
    groom.weights.push_back(s < n ? glm::vec3(1, 0, 0) : glm::vec3(0.5f, 0.3f, 0.2f));
    for (std::uint32_t k = 0; k < kDrawnPoints; ++k)
      groom.offsets.push_back(1e-3f * setup.longestLink * glm::vec3(k % 2, k % 3, 0));
    groom.first.push_back(kDrawnPoints * (s + 1));
  }
  return groom;
}

}  // namespace

Scene::Scene(const Setup& setup) : setup_(setup), groom_(makeGroom(setup)) {
  for (std::uint32_t i = 0; i < setup.links; ++i) {
    length_ += linkLength(setup, i);
    shortest_ = std::min(shortest_, linkLength(setup, i));
  }
}

RigidTransform Scene::headAt(int frame) const {
  const HeadMotion& m = setup_.motion;
  const float dt = setup_.frame;
  const bool there = m.reversing ? frame % 2 == 1 : frame >= 3;
  const float turned =
      m.reversing ? (frame % 2 == 1 ? m.spin * dt : 0.0f) : m.spin * dt * static_cast<float>(frame);
  return {glm::angleAxis(turned, glm::normalize(glm::vec3(0.3f, 0.2f, 1))),
          setup_.place + (there ? m.jump : 0.0f) * glm::vec3(0.6f, 0, 0.8f)};
}

std::vector<Capsule> Scene::bodyAt(int frame) const {
  const glm::vec3 head = headAt(frame).translation;
  const float r = 0.2f * length_, t = static_cast<float>(frame) / kDisturbed;
  const glm::vec3 below = head + glm::vec3(0, -setup_.spread - 0.5f * length_, 0);
  const auto beside = [&](float x, float y) { return below + r * glm::vec3(x, y, 0.3f * x); };
  switch (setup_.body) {
    case Body::None:
      return {};
    case Body::Ball:
      return {{beside(1, 0), beside(1, 0), r}};
    case Body::Overlap:
      return {{beside(0, 0), beside(0, 0), r},
              {beside(0, -1), beside(0, 1), 0.9f * r},
              {beside(0.5f, 0), beside(-0.5f, 0), 0.5f * r},
              {beside(0, 0), beside(0, 0), 0.1f * r}};
    case Body::Shrinking:
      return {{beside(0, 0), beside(0, 0), (1 - t) * r},
              {beside(1, -1), beside(1 - t, -1), (1 - t) * r}};
    case Body::Swallowing:
      return {{head, head, (0.5f + t) * setup_.spread}};
    case Body::Shot: {
      const float x = 300 * setup_.frame * (static_cast<float>(frame) - 4.5f);
      return {{below + glm::vec3(x, 0, 0), below + glm::vec3(x, 0.5f * r, 0), r}};
    }
    case Body::Crowd: {
      std::vector<Capsule> heap;
      for (std::uint32_t c = 0; c < kMaxCapsules; ++c)
        heap.push_back({below + r * ballPoint(c, kMaxCapsules),
                        below - r * ballPoint(63 - c, kMaxCapsules), 0.2f * r});
      return heap;
    }
  }
  return {};
}

Inputs Scene::at(int frame) const {
  Inputs in = calm();
  in.head = headAt(frame);
  in.capsules = bodyAt(frame);
  in.settings.wind = setup_.settings.wind;
  in.settings.shadow = in.settings.shade = true;
  if (frame == 0) return in;
  in.seconds = setup_.frame;
  GuideSettings& guides = in.settings.guides;
  if (setup_.substeps > 0)
    guides.substep = std::clamp(setup_.frame / static_cast<float>(setup_.substeps), 1e-5f, 0.1f);
  const float way = setup_.reversingGravity && frame % 2 == 1 ? -1.0f : 1.0f;
  const glm::vec3 down = setup_.anyGravity ? glm::vec3(0.48f, 0.8f, -0.36f) : glm::vec3(0, -1, 0);
  guides.gravity = way * setup_.gravity * down;
  return in;
}

Inputs Scene::calm() const {
  Inputs in;
  in.groom = groom_;
  in.settings = setup_.settings;
  in.settings.wind = {};
  in.settings.shadow = in.settings.shade = false;
  in.head = headAt(kDisturbed);
  in.capsules = bodyAt(kDisturbed);
  in.seconds = 1.0f / 60;
  return in;
}

double Scene::promisedRecovery() const {
  const GuideSettings& g = setup_.settings.guides;
  const glm::vec3 at = glm::abs(headAt(kDisturbed).translation);
  const float far = std::max({at.x, at.y, at.z}) + reach();
  const float spacing = std::nextafter(far, INFINITY) - far;
  if (setup_.body != Body::None || !(g.airDrag > 0) || spacing > 1e-3f * shortest_) return 0;
  // The slowest swing, x'' + drag x' + omega² x = 0 with omega² = g / L, of a strand of one link;
  // chains and bending only make it faster (a long chain has 1.446 g / L), but for bending's
  // damping.
  const double omega2 = 9.81 / length_, half = 0.5 * g.airDrag;
  const double rate = half - std::sqrt(std::max(half * half - omega2, 0.0));
  // From the other side, two lengths away, to a hundredth; and half of that again, as large swings
  // are slower and gravity first has to find them.
  return 0.5 + 1.5 * std::log(200.0) * (1 / rate + g.bendDamping);
}

}  // namespace hair::extremes
