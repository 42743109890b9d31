// The window of `dance` on a display of its own, which nobody sees.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include <tests/apps/outcome.h>

namespace hair {
namespace {

std::string lastLine(const std::string& out) {
  const std::size_t end = out.find_last_not_of('\n');
  const std::size_t begin = out.rfind('\n', end);
  return out.substr(begin + 1, end - begin);
}

const std::string kSmall = " --strands 300 --settle 0.1 --hash ";

TEST(Window, ClosesAfterItsFramesInTheStateThatTheSimulationReachesWithoutIt) {
  if (runCommand("command -v xvfb-run && command -v Xvfb").code != 0)
    GTEST_SKIP() << "no xvfb-run here: the window was not opened";
  const Outcome window =
      runCommand("timeout 120 xvfb-run -a -s '-screen 0 400x300x24' " DANCE_PROGRAM + kSmall +
                 "--frames 12 --width 320 --height 240");
  ASSERT_EQ(window.code, 0) << window.out;
  EXPECT_NE(window.out.find("300 strands"), std::string::npos) << window.out;
  EXPECT_NE(window.out.find("frames a second without drawing"), std::string::npos) << window.out;
  const Outcome without = runCommand(HAIR_PROGRAM " simulate" + kSmall + "--frames 12");
  ASSERT_EQ(without.code, 0) << without.out;
  EXPECT_EQ(lastLine(window.out).substr(0, 5), "hash ") << window.out;
  EXPECT_EQ(lastLine(window.out), lastLine(without.out));
}

TEST(Window, IsNotAskedForWhereNoDisplayAnswers) {
  const std::string folder = testing::TempDir();
  for (const std::string display : {"env -u DISPLAY ", "env DISPLAY=:9999 "}) {
    const Outcome outcome =
        runCommand(display + DANCE_PROGRAM + kSmall + "--frames 2 --width 64 --height 48 --out " +
                   folder + "no_display.mp4");
    if (outcome.out.find("EGL") != std::string::npos && outcome.code == 1)
      GTEST_SKIP() << "neither a display nor EGL here: " << outcome.out;
    EXPECT_EQ(outcome.code, 0) << display << outcome.out;
    EXPECT_NE(outcome.out.find("no_display.mp4"), std::string::npos) << display << outcome.out;
    EXPECT_NE(outcome.out.find("frames a second without drawing"), std::string::npos)
        << display << outcome.out;
  }
  for (const char* name : {"no_display.mp4", "no_display.png"})
    std::remove((folder + name).c_str());
}

}  // namespace
}  // namespace hair
