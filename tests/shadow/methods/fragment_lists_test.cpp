#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include <libhair/core/parallel.h>
#include <libhair/shadow/methods/fragment_lists.h>

#include "../fixture.h"

namespace hair {
namespace {

using test::alongX;
using test::headOfHair;

/// Hair in layers across the light: many fragments of a pixel have the same depth.
StrandSet layers() {
  StrandSet hair = headOfHair(2000, 20);
  for (std::size_t s = 0; s < hair.strandCount(); ++s)
    for (glm::vec3& p : hair.strand(s)) p.x = 4e-3f * static_cast<float>(s % 7);
  return hair;
}

using Row = std::tuple<std::size_t, float, float>;  // pixel, depth, optical depth

std::vector<Row> rows(const FragmentLists& lists, const LightImage& image) {
  std::vector<Row> all;
  for (std::size_t p = 0; p < image.pixelCount(); ++p)
    for (const PixelFragment& f : lists.pixel(p)) all.push_back({p, f.depth, f.opticalDepth});
  return all;
}

TEST(FragmentLists, AreAllFragmentsSortedByPixelDepthAndOpticalDepth) {
  const Fibre fibre;
  FragmentLists lists;
  for (const StrandSet& hair : {layers(), headOfHair(500, 20), StrandSet(), headOfHair(900, 10)}) {
    const LightImage image = makeLightImage(hair, alongX(), 3e-3f);
    std::vector<Row> expected;
    for (std::size_t s = 0; s < hair.strandCount(); ++s)
      forFragments(hair.strand(s), fibre, Extinction::Published, image, [&](const Fragment& f) {
        if (f.opticalDepth > 0) expected.push_back({f.pixel, f.depth, f.opticalDepth});
      });
    std::sort(expected.begin(), expected.end());
    for (int threads : {1, 2, 7}) {
      const ThreadLimit limit(threads);
      buildFragmentLists(hair, fibre, Extinction::Published, image, lists);
      EXPECT_EQ(rows(lists, image), expected) << threads << " threads";
    }
  }
}

TEST(FragmentLists, LeaveOutWhatTakesNoLight) {
  // Along the light a fibre has no extent across it.
  const StrandSet hair = test::oneStrand({{0, 0, 0}, {0.05f, 0, 0}, {0.05f, 1e-3f, 0}});
  const LightImage image = makeLightImage(hair, alongX(), 3e-3f);
  FragmentLists lists;
  buildFragmentLists(hair, {}, Extinction::Unbiased, image, lists);
  EXPECT_EQ(rows(lists, image).size(), 1u);
}

}  // namespace
}  // namespace hair
