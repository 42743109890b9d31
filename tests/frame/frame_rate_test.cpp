// Hair does not depend on how often a second it is looked at.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/random.h>

#include "scene.h"

namespace hair {
namespace {

using test::rmsDistance;
using test::Scene;
using test::small;
using test::tipsOf;

// At these times every run has a frame.
constexpr double kMark = 1.0 / 6;
constexpr int kMarks = 12;

using Marks = std::vector<std::vector<glm::vec3>>;  // [kMarks] tips

// Where somebody is who is filmed 30 times a second.
struct Filmed {
  std::vector<Capsule> capsules;
  BodyState body;

  Filmed(Scene& scene, double t) {
    const double before = std::floor(30 * t + 1e-6) / 30;
    const auto share = static_cast<float>(30 * (t - before));
    const BodyPose from = scene.motion.pose(before), to = scene.motion.pose(before + 1.0 / 30);
    for (std::size_t c = 0; c < from.capsules.size(); ++c) {
      const Capsule &a = from.capsules[c], &b = to.capsules[c];
      capsules.push_back({glm::mix(a.a, b.a, share), glm::mix(a.b, b.b, share),
                          glm::mix(a.radius, b.radius, share)});
    }
    body = {blend(from.worldFromHead, to.worldFromHead, share), capsules};
  }
};

struct Dance {
  bool selfCollision = true;
  double from = 0;   // seconds
  float faster = 0;  // m/s, at the start
  bool filmed = false;
};

// The built-in dance in frames of `seconds(f)`, cut where a mark is.
template <class Length>
Marks run(const Dance& dance, Length&& seconds) {
  FrameSettings settings = Scene::simulationOnly();
  settings.selfCollision = dance.selfCollision;
  settings.repulsion.strandStride = 1;  // of the few there are
  Scene scene(small(Style::Smooth), Motion::dance(), settings);
  restart(scene.bodyAt(dance.from), settings, 0.5f, scene.hair);
  for (LaneVec3& v : scene.hair.guides.velocity) v.x = v.x + dance.faster;
  Marks tips;
  int frames = 0;
  for (int mark = 1; mark <= kMarks; ++mark) {
    const double until = dance.from + mark * kMark;
    for (double now = until - kMark; now < until - 1e-6;) {
      double next = now + seconds(frames++);
      if (next > until - 1e-4) next = until;
      const Filmed filmed(scene, next);
      frame(dance.filmed ? filmed.body : scene.bodyAt(next), settings,
            static_cast<float>(next - now), scene.hair, scene.profile);
      now = next;
    }
    tips.push_back(tipsOf(scene.hair));
  }
  return tips;
}

auto every(double rate) {
  return [rate](int) { return 1 / rate; };
}
double irregular(int f) {
  return 1 / 240.0 +
         (1 / 24.0 - 1 / 240.0) * static_cast<double>(uniform(static_cast<std::uint32_t>(f), 7));
}

// Root of the mean squared distance of tips, over all marks, millimetres.
double apart(const Marks& a, const Marks& b) {
  double sum = 0;
  for (std::size_t m = 0; m < a.size(); ++m) {
    const double d = 1e3 * rmsDistance(a[m], b[m]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Most that runs may be apart from the one at 60 frames a second, millimetres; twice what they
/// are. Tips go 1.0 m from 5 s on, 3.3 m (a spin) from 8 s on.
struct Bounds {
  const char* name;
  Dance dance;
  double twin, at120, at144, at30, irregular;
};

class FrameRate : public testing::TestWithParam<Bounds> {};

TEST_P(FrameRate, ChangesLittle) {
  const Bounds& most = GetParam();
  const Marks at60 = run(most.dance, every(60));
  Dance faster = most.dance;
  faster.faster = 1e-5f;
  const auto expect = [&](const char* name, const Marks& marks, double bound) {
    const double d = apart(at60, marks);
    RecordProperty(std::string(name) + "_mm", std::to_string(d));
    EXPECT_LT(d, bound) << name;
  };
  // Where a next to nothing grows there is no saying what a frame rate changes.
  expect("twin", run(faster, every(60)), most.twin);
  expect("at_120", run(most.dance, every(120)), most.at120);
  expect("at_144", run(most.dance, every(144)), most.at144);
  expect("at_30", run(most.dance, every(30)), most.at30);
  expect("irregular", run(most.dance, irregular), most.irregular);
}

INSTANTIATE_TEST_SUITE_P(Dances, FrameRate,
                         testing::Values(Bounds{"Steps", {false, 5}, 0.1, 0.5, 0.9, 4, 1.4},
                                         Bounds{
                                             "StepsInContact", {true, 5}, 0.1, 0.7, 1.3, 4.4, 1.9},
                                         Bounds{"Spin", {false, 8}, 0.15, 4.6, 13, 21, 17},
                                         Bounds{"SpinInContact", {true, 8}, 0.15, 4.5, 13, 21, 17}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(FrameRateOfPoses, AsOftenAsTheBodyIsKnownIsAsGoodAsMoreOften) {
  // What is between two poses is blended in the frame as it would be outside of it.
  for (const double from : {5.0, 8.0}) {
    const Dance dance{false, from, 0, true};
    const Marks at30 = run(dance, every(30));
    EXPECT_LT(apart(at30, run(dance, every(60))), 0.1);
    EXPECT_LT(apart(at30, run(dance, every(120))), 0.7);
  }
}

}  // namespace
}  // namespace hair
