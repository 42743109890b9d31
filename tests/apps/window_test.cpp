// The window of `dance` on a display of its own, which nobody sees.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/wait.h>

#include <gtest/gtest.h>

namespace hair {
namespace {

struct Outcome {
  int code;
  std::string out;  // both streams
};

Outcome run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string out;
  std::array<char, 4096> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), pipe))
    out.append(block.data(), size);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out};
}

std::string lastLine(const std::string& out) {
  const std::size_t end = out.find_last_not_of('\n');
  const std::size_t begin = out.rfind('\n', end);
  return out.substr(begin + 1, end - begin);
}

const std::string kSmall = " --strands 300 --settle 0.1 --hash ";

TEST(Window, ClosesAfterItsFramesInTheStateThatTheSimulationReachesWithoutIt) {
  if (run("command -v xvfb-run && command -v Xvfb").code != 0)
    GTEST_SKIP() << "no xvfb-run here: the window was not opened";
  const Outcome window = run("timeout 120 xvfb-run -a -s '-screen 0 400x300x24' " DANCE_PROGRAM +
                             kSmall + "--frames 12 --width 320 --height 240");
  ASSERT_EQ(window.code, 0) << window.out;
  EXPECT_NE(window.out.find("300 strands"), std::string::npos) << window.out;
  const Outcome without = run(HAIR_PROGRAM " simulate" + kSmall + "--frames 12");
  ASSERT_EQ(without.code, 0) << without.out;
  EXPECT_EQ(lastLine(window.out).substr(0, 5), "hash ") << window.out;
  EXPECT_EQ(lastLine(window.out), lastLine(without.out));
}

TEST(Window, IsNotAskedForWhereNoDisplayAnswers) {
  const std::string folder = testing::TempDir();
  for (const std::string display : {"env -u DISPLAY ", "env DISPLAY=:9999 "}) {
    const Outcome outcome =
        run(display + DANCE_PROGRAM + kSmall + "--frames 2 --width 64 --height 48 --out " + folder +
            "no_display.mp4");
    if (outcome.out.find("EGL") != std::string::npos && outcome.code == 1)
      GTEST_SKIP() << "neither a display nor EGL here: " << outcome.out;
    EXPECT_EQ(outcome.code, 0) << display << outcome.out;
    EXPECT_NE(outcome.out.find("no_display.mp4"), std::string::npos) << display << outcome.out;
  }
  for (const char* name : {"no_display.mp4", "no_display.png"})
    std::remove((folder + name).c_str());
}

}  // namespace
}  // namespace hair
