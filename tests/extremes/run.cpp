#include "run.h"

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/guides/validate.h>

#include "energy.h"
#include "scene.h"

namespace hair::extremes {

namespace {

constexpr float kStretchPromised = 1e-3f;  // beside rounding
constexpr double kRecovered = 1e-2;        // of a strand's length
constexpr double kGrowth = 0.05;           // of a fall by a strand's length
constexpr double kGrowthBeside = 0.5;      // the same beside colliders, which put hair out of them
constexpr double kRounds = 3;              // so often a substep looks for colliders again
constexpr int kHalfSecond = 30;            // calm frames
constexpr double kLongestRecovery = 10;    // seconds that are waited for
constexpr double kSubstep = 1.0 / 480;     // of calm frames, seconds
constexpr glm::vec3 kGravity{0, -9.81f, 0};
constexpr int kCalmFrames = 30;  // where nothing is waited for

bool finite(glm::vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool pushed(const Hair& hair) {
  return std::ranges::any_of(hair.repulsion.push, [](const LaneVec3& p) {
    for (std::size_t l = 0; l < kLanes; ++l)
      if (lane(p, l) != glm::vec3(0)) return true;
    return false;
  });
}

/// Whether bends can hold the groom: no two directions differ by more than 2, so rest curvatures
/// beyond that are a torque without a bend, as in a wound-up string, and hold hair in other places
/// too.
bool held(const GuideStrands& guides) {
  return std::ranges::none_of(guides.curvature, [](const LaneVec3& c) {
    for (std::size_t l = 0; l < kLanes; ++l)
      if (glm::length(lane(c, l)) > 2) return true;
    return false;
  });
}

/// A substep adds g h² to a movement: what floats do not tell of it holds hair where it is, here
/// less than a twentieth.
bool floatsTellGravity(const GuideStrands& guides) {
  const RigidTransform& head = guides.worldFromHead;
  const glm::vec3 at = glm::abs(head.translation - stepOrigin(head));
  const double h = std::min(kSubstep, static_cast<double>(guides.longestSubstep(head)));
  return floatSpacing(std::max({at.x, at.y, at.z}) + guides.reach()) < 0.1 * 9.81 * h * h;
}

/// What work can all that disturbs the hair have done, by the laws of motion? As the speed (root
/// mean square over the mass of a strand, in the frame of its head) that this energy would be. A
/// head that changes its speed by dv, or its spin by dw, changes that of no strand by more than dv
/// + dw · reach; gravity that changes by dg lends dg · (strand's length) of energy, and so does
/// what pushes.
class SpeedBound {
 public:
  explicit SpeedBound(const Scene& scene) : scene_(scene) {}

  void head(const RigidTransform& before, const RigidTransform& now, double seconds) {
    const glm::dvec3 v = (glm::dvec3(now.translation) - glm::dvec3(before.translation)) / seconds;
    const glm::dquat turn(now.rotation * glm::conjugate(before.rotation));
    const double sine = glm::length(glm::dvec3(turn.x, turn.y, turn.z));
    const double angle = 2 * std::atan2(sine, std::abs(turn.w));
    const glm::dvec3 w =
        sine > 0 ? glm::dvec3(turn.x, turn.y, turn.z) / sine * (angle / seconds) : glm::dvec3(0);
    given_ += glm::distance(v, v_) + glm::distance(w, w_) * scene_.reach();
    spin_ = std::max(spin_, glm::length(w) * scene_.reach());
    v_ = v, w_ = w;
  }
  void gravity(glm::vec3 g) {
    lent_ += 2 * glm::distance(g, g_) * scene_.strandLength();
    g_ = g;
  }
  void push(double acceleration) { lent_ += 2 * acceleration * scene_.strandLength(); }
  void wind(double speed, double drag) {
    air_ = std::max(air_, 2 * speed);
    push(2 * drag * speed);
  }
  /// A point inside a collider is put out of it within a substep, by its diameter at most, maybe
  /// into another, and goes along with it.
  void colliders(const std::vector<Capsule>& before, const Inputs& in) {
    const double h = std::min(in.settings.guides.substep, in.seconds);
    for (std::size_t c = 0; c < in.capsules.size(); ++c) {
      const Capsule &was = before[c], &is = in.capsules[c];
      const double way = std::max(glm::distance(was.a, is.a), glm::distance(was.b, is.b));
      const double across = 2 * (std::max(was.radius, is.radius) + in.settings.guides.skin);
      put_ = std::max(put_, kRounds * across / h + way / in.seconds);
    }
  }
  /// Colliders may bend every joint right over.
  void bent(const GuideStrands& guides) {
    double most = 0, c = 0;
    for (std::size_t k = 0; k < guides.curvature.size(); ++k)
      for (std::size_t l = 0; l < kLanes; ++l) {
        most = std::max(most, static_cast<double>(guides.jointStiffness[k][l]));
        c = std::max(c, static_cast<double>(glm::length(lane(guides.curvature[k], l))));
      }
    lent_ += 0.5 * guides.linksPerGuide() * most * (2 + c) * (2 + c) / scene_.strandLength();
  }
  /// Each point is somewhere within the spacing of floats, bent as if it had been put there and as
  /// fast as if it had come from there.
  void rounding(const GuideStrands& guides) {
    const glm::vec3 at = glm::abs(guides.worldFromHead.translation);
    const float far = std::max({at.x, at.y, at.z}) + guides.reach();
    const double spacing = std::nextafter(far, INFINITY) - far;
    double stiffest = 0;
    for (const Lanes& kappa : guides.jointStiffness)
      stiffest = std::max(stiffest, static_cast<double>(kappa[0]));
    const double bend = 2 * spacing / guides.shortestLink(), speed = spacing / kSubstep;
    lent_ += guides.linksPerGuide() * stiffest * bend * bend / scene_.strandLength();
    lent_ += 1.5 * speed * speed;
  }
  double value() const {
    // A thousandth of a fall's speed is no matter of work.
    return given_ + spin_ + air_ + put_ + std::sqrt(2 * lent_) +
           1e-3 * std::sqrt(9.81 * scene_.strandLength());
  }

 private:
  const Scene& scene_;
  glm::dvec3 v_{0}, w_{0};
  glm::vec3 g_ = kGravity;
  double given_ = 0, spin_ = 0, air_ = 0, put_ = 0, lent_ = 0;
};

class Run {
 public:
  Run(const Setup& setup, Outcome& out) : setup_(setup), scene_(setup), bound_(scene_), out_(out) {}

  void all() {
    Inputs start = scene_.at(0);
    if (setup_.badField) prepareForBad(start);
    if (setup_.badField && badInput(setup_.badField).atStart) spoil(start);
    groom_ = start.groom;
    Hair hair(groom_, start.settings, start.body(), nullptr, start.wisps);
    disturb(start, hair);
    recover(hair);
  }

 private:
  // Things for all of badInputs() to be of.
  void prepareForBad(Inputs& in) const {
    in.settings.lights = {Light{}, Light::point({1, 2, 3})};
    const glm::vec3 at = in.head.translation + glm::vec3(0, -0.2f, 0);
    in.capsules = {{at, at + glm::vec3(0.1f, 0, 0), 0.05f}};
  }
  void spoil(Inputs& in) const { badInput(setup_.badField).of(in) = setup_.badValue; }

  Inputs inputs(int frame, const Inputs& start) const {
    Inputs in = scene_.at(frame);
    if (!setup_.badField) return in;
    prepareForBad(in);
    if (badInput(setup_.badField).atStart) {
      in.settings = start.settings;
      in.head = start.head;
    } else if (frame == 5) {
      spoil(in);
    }
    return in;
  }

  void disturb(const Inputs& start, Hair& hair) {
    RigidTransform before = start.head;
    std::vector<Capsule> capsules = start.capsules;
    restEnergy_ = energyOf(hair.guides, start.head, 1, kGravity);
    bound_.rounding(hair.guides);
    if (setup_.body != Body::None) bound_.bent(hair.guides);
    for (int f = 1; f <= kDisturbed; ++f) {
      const Inputs in = inputs(f, start);
      if (in.push != glm::vec3(0) && !hair.repulsion.push.empty())
        setLane(hair.repulsion.push[2], 0, in.push);
      try {
        frame(in.body(), in.settings, in.seconds, hair, profile_);
      } catch (const Error& e) {
        // Refused: what was there must still be good for the next frame.
        if (out_.refused.empty()) out_.refused = e.what();
        if (!hair.repulsion.push.empty()) setLane(hair.repulsion.push[2], 0, glm::vec3(0));
        continue;
      }
      check(in, hair, f);
      bound_.head(before, in.head, in.seconds);
      bound_.gravity(in.settings.guides.gravity);
      bound_.wind(glm::length(in.settings.wind.velocity), in.settings.guides.airDrag);
      if (in.settings.selfCollision) bound_.push(in.settings.repulsion.limit);
      bound_.colliders(capsules, in);
      if (!setup_.badField) checkEnergy(hair, before, in, bound_.value(), f);
      capsules = in.capsules;
      before = in.head;
    }
  }

  // All energy above that of rest, as the speed that it would be.
  void checkEnergy(const Hair& hair, const RigidTransform& before, const Inputs& in, double bound,
                   int frame) {
    const glm::vec3 gravity = in.settings.guides.gravity;
    const double total = energyOf(hair.guides, before, in.seconds, gravity);
    const double speed = std::sqrt(2 * std::max(total - restEnergy_, 0.0));
    out_.energy = std::max(out_.energy, speed / bound);
    if (!(speed <= bound) || std::isnan(total))
      fail("energy of ", speed, " m/s in frame ", frame, ", of at most ", bound, " m/s");
  }

  // Left alone, hair only loses energy.
  void checkGrowth(const Hair& hair, const Inputs& in, int frame) {
    const double energy = energyOf(hair.guides, in.head, in.seconds, kGravity);
    const double lift = 9.81 * scene_.strandLength();
    // A joint that is folded over has no frame to carry on, and its energy is that of another way
    // to unfold: that takes more than a fall.
    const bool fallen = least_ < restEnergy_ + lift, push = pushed(hair);
    if (push || pushed_ || !held(hair.guides)) least_ = INFINITY;
    pushed_ = push;
    if (fallen && least_ < INFINITY) {
      const double growth = (energy - least_) / lift;
      out_.growth = std::max(out_.growth, growth);
      if (growth > (setup_.body == Body::None ? kGrowth : kGrowthBeside))
        fail("energy grows by ", growth, " of a fall in frame ", frame, ", left alone");
    }
    least_ = std::min(least_, energy);
  }

  void check(const Inputs& in, const Hair& hair, int frame) {
    const GuideStats stats = measureGuides(hair.guides, in.settings.guides, {}, nullptr);
    if (!std::isfinite(stats.stretchMax) || !std::isfinite(stats.speedMax))
      fail("guides are not finite in frame ", frame);
    out_.stretch = std::max(out_.stretch, stats.stretchMax);
    // Each coordinate of both ends of a link is off by half of a float's spacing at most.
    const glm::vec3 at = glm::abs(hair.guides.worldFromHead.translation);
    const float spacing = floatSpacing(std::max({at.x, at.y, at.z}) + hair.guides.reach());
    const float most = kStretchPromised + 1.74f * spacing / hair.guides.shortestLink();
    if (!(stats.stretchMax <= most)) fail("stretch ", stats.stretchMax, " in frame ", frame);
    for (const glm::vec3& p : hair.wisps.points)
      if (!finite(p)) return fail("drawn points are not finite in frame ", frame);
    for (const float t : hair.transmittance)
      if (!(t >= 0 && t <= 1)) return fail("transmittance ", t, " in frame ", frame);
  }

  // Away from a twin that was never disturbed.
  void recover(Hair& hair) {
    Inputs in = scene_.calm();
    if (setup_.badField) return settle(in, hair);
    const double promised = scene_.promisedRecovery();
    const bool asked = promised > 0 && promised <= kLongestRecovery && out_.refused.empty() &&
                       held(hair.guides) && floatsTellGravity(hair.guides);
    const int frames = asked ? static_cast<int>(std::ceil(promised * 60)) : kCalmFrames;
    Hair twin(groom_, in.settings, in.body());
    FrameProfile unused{};
    int last = 0, lastPush = -kHalfSecond;
    double away = 0;
    bound_.head(in.head, in.head, in.seconds);
    bound_.gravity(kGravity);
    for (int f = 1; f <= frames; ++f) {
      frame(in.body(), in.settings, in.seconds, hair, profile_);
      frame(in.body(), in.settings, in.seconds, twin, unused);
      if (in.settings.selfCollision) bound_.push(in.settings.repulsion.limit);
      check(in, hair, kDisturbed + f);
      away = distance(hair, twin);
      if (!(away <= kRecovered)) last = f;
      if (pushed(hair) || pushed(twin)) lastPush = f;
      checkEnergy(hair, in.head, in, bound_.value(), kDisturbed + f);
      if (f > 1) checkGrowth(hair, in, kDisturbed + f);
      if (f - last > 30 && away < 0.25 * kRecovered) break;
    }
    if (!asked) return;
    // Hair that rests on hair has more than one way to do so.
    if (away > kRecovered && frames - lastPush < kHalfSecond) return;
    out_.recovery = last / 60.0;
    if (away > kRecovered)
      fail("after ", promised, " s still ", 100 * away, " % of a strand's length away");
  }

  // After a bad input: two frames with good ones.
  void settle(Inputs in, Hair& hair) {
    prepareForBad(in);
    in.settings.shadow = in.settings.shade = true;
    in.groom = groom_;
    for (int f = 1; f <= 2; ++f) {
      frame(in.body(), in.settings, in.seconds, hair, profile_);
      check(in, hair, kDisturbed + f);
    }
  }

  double distance(const Hair& a, const Hair& b) const {
    double most = 0;
    for (std::size_t g = 0; g < a.guides.guideCount(); ++g)
      for (std::uint32_t i = 0; i < a.guides.pointsPerGuide(); ++i) {
        const double d =
            glm::distance(glm::dvec3(a.guides.point(g, i)), glm::dvec3(b.guides.point(g, i)));
        if (!(d <= most)) most = d;
      }
    return most / scene_.strandLength();
  }

  template <class... Parts>
  void fail(const Parts&... parts) {
    if (out_.violations.size() < 3) out_.violations.push_back(text(parts...));
  }

  const Setup& setup_;
  Scene scene_;
  SpeedBound bound_;
  double restEnergy_ = 0, least_ = INFINITY;
  bool pushed_ = true;
  Outcome& out_;
  Groom groom_;
  FrameProfile profile_{};
};

}  // namespace

Outcome run(const Setup& setup) {
  Outcome out;
  try {
    Run(setup, out).all();
  } catch (const Error& e) {
    if (out.refused.empty()) out.refused = e.what();
  }
  if (setup.refused && out.refused.empty()) out.violations.push_back("accepted");
  return out;
}

}  // namespace hair::extremes
