// hair simulate: runs that are cut in two.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <tests/apps/outcome.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

std::string lastLine(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

TEST(Simulate, ARunThatIsSavedAndLoadedHasTheHashOfOneInOneGo) {
  const TemporaryFolder folder;
  const std::string state = (folder / "at.state").string();
  const std::string scene = "simulate --strands 200 --settle 0.05 --wind 1,0,0 --no-shadow ";
  const Outcome whole = run(scene + "--frames 11 --hash");
  ASSERT_EQ(whole.code, 0) << whole.out;
  ASSERT_TRUE(lastLine(whole.out).starts_with("hash ")) << whole.out;
  const Outcome first = run(scene + "--frames 6 --save-state " + state);
  ASSERT_EQ(first.code, 0) << first.out;
  const Outcome second = run(scene + "--frames 5 --hash --load-state " + state);
  ASSERT_EQ(second.code, 0) << second.out;
  EXPECT_EQ(lastLine(second.out), lastLine(whole.out));

  const Outcome other = run("simulate --style long --frames 1 --load-state " + state);
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.out.find(state + ": saved state: of another groom"), std::string::npos)
      << other.out;
  std::ofstream(state, std::ios::binary) << "HAIR";
  const Outcome cut = run(scene + "--frames 1 --load-state " + state);
  EXPECT_EQ(cut.code, 1);
  EXPECT_NE(cut.out.find("truncated"), std::string::npos) << cut.out;
}

}  // namespace
}  // namespace hair
