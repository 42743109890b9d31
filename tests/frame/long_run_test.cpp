// Half an hour of dance: memory, lengths and the shape at rest are at the end what they were at the
// start, and the bits do not depend on the threads. By default a short run; HAIR_SOAK_FRAMES=100000
// is the half hour.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;

constexpr int kWindow = 1000;  // frames at the start, and at the end, that are compared

int framesAsked() {
  const char* const asked = std::getenv("HAIR_SOAK_FRAMES");
  return std::max(2 * kWindow, asked ? std::atoi(asked) : 0);
}

// Memory that is in use, in the machine's pages; 0 where the system does not say.
std::size_t residentPages() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident;
}

// Dances to the end of the loop; there the head gets up within a second, and the body sinks away
// under it, for ten. Hair that hangs free from a head that is upright, as it was groomed, has one
// shape at rest; on a shoulder it has as many as there are ways to lie.
//
// How far tips then are from where they were groomed, metres: of nineteen in twenty guides no more.
double tipsWhenTheMusicStops(Scene& scene) {
  while (std::fmod(scene.time, scene.motion.duration()) > 1.0 / 60) scene.step();
  BodyState body = scene.bodyAt(0);
  std::vector<Capsule> sinking(body.capsules.begin(), body.capsules.end());
  body.capsules = sinking;
  const RigidTransform bowed = body.worldFromHead;
  const RigidTransform upright{Motion::still().pose(0).worldFromHead.rotation, bowed.translation};
  for (int f = 0; f < 600; ++f) {
    body.worldFromHead = blend(bowed, upright, glm::smoothstep(0.0f, 60.0f, 1.0f * f));
    for (Capsule& c : sinking) c.a.y -= 0.005f, c.b.y -= 0.005f;
    frame(body, scene.settings, 1.0f / 60, scene.hair, scene.profile);
  }
  std::vector<float> moved;
  for (std::size_t g = 0; g < scene.groom.guideCount(); ++g)
    moved.push_back(glm::distance(body.worldFromHead.point(scene.groom.guide(g).back()),
                                  scene.hair.guides.point(g, scene.groom.pointsPerGuide - 1)));
  std::sort(moved.begin(), moved.end());
  return moved[moved.size() * 19 / 20];
}

struct LongRun {
  std::size_t pagesAtStart = 0, pagesAtEnd = 0;
  float stretchAtStart = 0, stretchAtEnd = 0;  // max over links and frames of a window
  std::uint64_t hash = 0;
  double tipsAtRest = 0;
};

LongRun danceFor(int frames, int threads) {
  const ThreadLimit limit(threads);
  Scene scene(styleSettings(Style::Smooth), Motion::dance());
  LongRun run;
  for (int f = 0; f < frames; ++f) {
    scene.step();
    if (f == kWindow) run.pagesAtStart = residentPages();
    if (f < kWindow) run.stretchAtStart = std::max(run.stretchAtStart, scene.stats().stretchMax);
    if (f >= frames - kWindow)
      run.stretchAtEnd = std::max(run.stretchAtEnd, scene.stats().stretchMax);
  }
  run.pagesAtEnd = residentPages();
  run.hash = scene.hash();
  run.tipsAtRest = tipsWhenTheMusicStops(scene);
  std::cout << frames << " frames, " << threads << " threads: pages " << run.pagesAtStart << " to "
            << run.pagesAtEnd << ", stretch " << run.stretchAtStart << " to " << run.stretchAtEnd
            << ", tips from the groom " << 1e3 * run.tipsAtRest << " mm, hash " << std::hex
            << run.hash << std::dec << '\n';
  return run;
}

TEST(LongRun, MemoryLengthsRestShapeAndBitsHold) {
  const int frames = framesAsked();
  const LongRun one = danceFor(frames, 1), two = danceFor(frames, 2);
  EXPECT_EQ(one.hash, two.hash);
  for (const LongRun& run : {one, two}) {
    EXPECT_LE(run.pagesAtEnd, run.pagesAtStart + 64);
    EXPECT_LE(run.stretchAtEnd, 1e-5f);
    EXPECT_LE(run.stretchAtStart, 1e-5f);
    EXPECT_LE(run.tipsAtRest, 1.6e-3);
  }
}

}  // namespace
}  // namespace hair
