#include <sstream>

#include <gtest/gtest.h>

#include <apps/common/progress.h>

namespace hair {
namespace {

Progress::Clock::time_point testTime;
Progress::Clock::time_point now() {
  return testTime;
}

// A hundred items of a second each (or of what is given).
std::string printed(bool terminal, double secondsAnItem, int items = 100) {
  std::ostringstream out;
  Progress progress("comb", 100, out, terminal, now);
  for (int i = 0; i < items; ++i) {
    testTime += std::chrono::duration_cast<Progress::Clock::duration>(
        std::chrono::duration<double>(secondsAnItem));
    progress.step();
  }
  progress.finish();
  return out.str();
}

TEST(Progress, ALogGetsALineEveryFewSecondsWithTheTimeLeft) {
  const std::string log = printed(false, 1);
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 20);
  EXPECT_EQ(std::count(log.begin(), log.end(), '\r'), 0);
  EXPECT_EQ(log.substr(0, log.find('\n')), "comb 5/100, 1.00/s, 1:35 left");
  EXPECT_NE(log.find("comb 100/100, 1.00/s, 1:40 taken\n"), std::string::npos);
}

TEST(Progress, ALogOfShortWorkIsSilent) {
  EXPECT_EQ(printed(false, 0.04), "");
}

TEST(Progress, ATerminalHasOneLineThatEndsAtTheEnd) {
  const std::string line = printed(true, 72);
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  EXPECT_EQ(line.back(), '\n');
  EXPECT_NE(line.find("[############............] 50/100, 0.01/s, 1:00:00 left"),
            std::string::npos);
  EXPECT_EQ(printed(true, 0.0005), "");
}

TEST(Progress, WorkThatStopsEarlyStillEndsItsLine) {
  const std::string line = printed(true, 1, 3);
  EXPECT_NE(line.find("3/100"), std::string::npos);
  EXPECT_EQ(line.back(), '\n');
}

}  // namespace
}  // namespace hair
