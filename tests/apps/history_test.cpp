// What the window remembers of the last frames.
#include <vector>

#include <gtest/gtest.h>

#include <apps/dance/history.h>

namespace hair {
namespace {

TEST(Recent, HoldsTheLastItemsOldestFirst) {
  Recent<float> recent(3);
  EXPECT_EQ(medianOf(recent, [](float x) { return x; }), 0);
  std::vector<float> all;
  for (const float x : {5.0f, 1.0f, 9.0f, 2.0f, 7.0f}) {
    recent.add(x);
    all.push_back(x);
    ASSERT_LE(recent.size(), 3u);
    for (std::size_t i = 0; i < recent.size(); ++i)
      EXPECT_EQ(recent[i], all[all.size() - recent.size() + i]);
    EXPECT_EQ(recent.last(), x);
  }
  EXPECT_EQ(medianOf(recent, [](float x) { return x; }), 7);  // of 9, 2, 7
}

}  // namespace
}  // namespace hair
