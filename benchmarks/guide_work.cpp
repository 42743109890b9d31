#include <benchmarks/guide_work.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <apps/common/svg.h>
#include <benchmarks/timing.h>
#include <libhair/core/error.h>
#include <libhair/guides/guide_strands.h>

namespace hair::bench {

namespace {

class OwnGuides final : public GuideSolver {
 public:
  OwnGuides(const GuideWork& work, const GuideSettings& settings)
      : settings_(settings),
        guides_(sphereGroom(work), weightless(settings), sphereAt(0)),
        before_(colliderAt(sphereAt(0))) {}

  void step(const RigidTransform& sphere) override {
    const Capsule now = colliderAt(sphere);
    stepGuides({.worldFromHead = sphere, .capsules = {&now, 1}, .capsulesBefore = {&before_, 1}},
               settings_, kFrameSeconds, workspace_, guides_);
    before_ = now;
  }
  void copyPoints(std::span<glm::vec3> out) const override { guides_.copyPoints(out); }

 private:
  // Straight of their own: a groom that holds itself up against gravity would stand off the sphere.
  static GuideSettings weightless(GuideSettings settings) {
    settings.gravity = glm::vec3(0);
    return settings;
  }
  static Capsule colliderAt(const RigidTransform& sphere) {
    return {sphere.translation, sphere.translation, kSphereRadius};
  }

  GuideSettings settings_;
  GuideStrands guides_;
  GuideWorkspace workspace_;
  Capsule before_;
};

}  // namespace

RigidTransform sphereAt(double seconds) {
  const double turn = 2 * std::numbers::pi * seconds;
  return {glm::angleAxis(static_cast<float>(std::sin(turn)), glm::vec3(0, 1, 0)),
          {0, 0.05f * static_cast<float>(std::sin(2 * turn)), 0}};
}

Groom sphereGroom(const GuideWork& work) {
  Groom groom;
  groom.pointsPerGuide = work.links + 1;
  groom.guidePoints.reserve(work.pointCount());
  for (std::uint32_t s = 0; s < work.strands; ++s) {
    const float y = 1 - 1.2f * (static_cast<float>(s) + 0.5f) / static_cast<float>(work.strands);
    const float golden = 2.39996323f * static_cast<float>(s), r = std::sqrt(1 - y * y);
    const glm::vec3 out(r * std::cos(golden), y, r * std::sin(golden));
    for (std::uint32_t i = 0; i <= work.links; ++i)
      groom.guidePoints.push_back(out * (kSphereRadius + kGuideLength * static_cast<float>(i) /
                                                             static_cast<float>(work.links)));
  }
  return groom;
}

std::unique_ptr<GuideSolver> makeOwnGuides(const GuideWork& work, const GuideSettings& settings) {
  return std::make_unique<OwnGuides>(work, settings);
}

GuideRun::GuideRun(std::unique_ptr<GuideSolver> solver, const GuideWork& work)
    : solver_(std::move(solver)), work_(work), points_(work.pointCount()) {
  while (frame_ < work.warmUp) solver_->step(sphereAt(++frame_ * double{kFrameSeconds}));
}

double GuideRun::step() {
  const RigidTransform sphere = sphereAt(++frame_ * double{kFrameSeconds});
  const double seconds = secondsOf([&] { solver_->step(sphere); });
  measure();
  return seconds;
}

void GuideRun::measure() {
  solver_->copyPoints(points_);
  const glm::vec3 middle = sphereAt(frame_ * double{kFrameSeconds}).translation;
  const float length = kGuideLength / static_cast<float>(work_.links);
  tipHeight = 0;
  for (std::size_t s = 0; s < work_.strands; ++s) {
    const glm::vec3* strand = points_.data() + s * (work_.links + 1);
    for (std::uint32_t i = 1; i <= work_.links; ++i) {
      const float stretch = std::abs(glm::distance(strand[i], strand[i - 1]) - length) / length;
      // Not std::max: NaN, once there is one, must show.
      if (!(stretch <= stretchMax)) stretchMax = stretch;
      squares_ += double{stretch} * double{stretch};
      const float depth = kSphereRadius - glm::distance(strand[i], middle);
      if (!(depth <= penetration)) penetration = depth;
    }
    tipHeight += double{strand[work_.links].y - middle.y} / work_.strands;
  }
  links_ += static_cast<double>(work_.links) * work_.strands;
}

double GuideRun::stretchRms() const {
  return links_ > 0 ? std::sqrt(squares_ / links_) : 0;
}

std::string GuideRun::figures() const {
  return text("stretch ", brief(100 * double{stretchMax}), " % at most, ",
              brief(100 * stretchRms()), " % RMS; penetration ", brief(1000 * double{penetration}),
              " mm; tips ", brief(100 * tipHeight), " cm above the middle");
}

}  // namespace hair::bench
