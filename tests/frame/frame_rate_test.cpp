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

// Frames of `seconds(f)`, cut where a mark is; from time `from` of the dance on.
template <class Length>
Marks run(Style style, bool selfCollision, double from, Length&& seconds, float faster = 0,
          float interval = 1.0f / 60) {
  FrameSettings settings = Scene::simulationOnly();
  settings.selfCollision = selfCollision;
  settings.repulsion.strandStride = 1;  // of the few there are
  settings.repulsion.interval = interval;
  Scene scene(small(style), Motion::dance(), settings);
  restart(scene.bodyAt(from), settings, 0.5f, scene.hair);
  for (LaneVec3& v : scene.hair.guides.velocity) v.x = v.x + faster;
  Marks tips;
  int frames = 0;
  for (int mark = 1; mark <= kMarks; ++mark) {
    const double until = from + mark * kMark;
    double now = until - kMark;
    while (now < until - 1e-6) {
      double next = now + seconds(frames++);
      if (next > until - 1e-4) next = until;
      frame(scene.bodyAt(next), settings, static_cast<float>(next - now), scene.hair,
            scene.profile);
      now = next;
    }
    tips.push_back(tipsOf(scene.hair));
  }
  return tips;
}

double apart(const Marks& a, const Marks& b) {
  double sum = 0;
  for (int m = 0; m < kMarks; ++m) {
    const double d = rmsDistance(a[m], b[m]);
    sum += d * d;
  }
  return std::sqrt(sum / kMarks);
}

double path(const Marks& a) {
  double sum = 0;
  for (int m = 1; m < kMarks; ++m) sum += rmsDistance(a[m], a[m - 1]);
  return sum;
}

auto every(double rate) {
  return [rate](int) { return 1 / rate; };
}
double irregular(int f) {
  return 1 / 240.0 +
         (1 / 24.0 - 1 / 240.0) * static_cast<double>(uniform(static_cast<std::uint32_t>(f), 7));
}

TEST(FrameRate, TheHairIsTheSame) {
  for (const Style style : {Style::Smooth, Style::Long})
    for (const bool self : {false, true})
      for (const double from : {0.0, 5.0, 8.0}) {
        const Marks at60 = run(style, self, from, every(60));
        std::printf("style %d self %d from %.0f path %.3f twin %.4f |", (int)style, self, from,
                    path(at60), 1e3 * apart(at60, run(style, self, from, every(60), 1e-5f)));
        for (int rate : {240, 144, 120, 30}) {
          std::printf(" %d: %.4f", rate, 1e3 * apart(at60, run(style, self, from, every(rate))));
          if (self)
            std::printf(" (%.4f)",
                        1e3 * apart(at60, run(style, self, from, every(rate), 0, 1.0f / rate)));
        }
        std::printf(" irregular %.4f mm\n", 1e3 * apart(at60, run(style, self, from, irregular)));
        fflush(stdout);
      }
}

}  // namespace
}  // namespace hair
