// hair lod: what it prints, writes and refuses.
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tests/apps/outcome.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

TEST(Lod, PrintsARowOfEverySizeAndWritesTheSameTable) {
  const TemporaryFolder folder;
  const std::string csv = (folder / "lod.csv").string(), sheet = (folder / "lod.png").string();
  const Outcome outcome =
      run("lod --strands 400 --points 12 --settle 0 --sizes 24,6 --frames 1 --csv " + csv +
          " --sheet " + sheet);
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  for (const char* column : {"head", "strands", "wider", "points", "cell", "map", "frame", "of all",
                             "shadow", "bias", "rms", "picture, %", "1 % on, %", "jump", "abrupt"})
    EXPECT_NE(outcome.out.find(column), std::string::npos) << column << '\n' << outcome.out;
  EXPECT_NE(outcome.out.find("\n  24      400"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\n   6 "), std::string::npos) << outcome.out;

  std::ifstream file(csv);
  std::string header, large, small;
  ASSERT_TRUE(std::getline(file, header) && std::getline(file, large) && std::getline(file, small));
  EXPECT_TRUE(header.starts_with("pixels,strands,wider,points,")) << header;
  EXPECT_TRUE(large.starts_with("24,400,")) << large;  // 960 strands would do
  // 240 at full width, and some of 60 more on their way out.
  std::istringstream row(small);
  float pixels = 0, strands = 0, wider = 0;
  char comma = 0;
  row >> pixels >> comma >> strands >> comma >> wider;
  EXPECT_EQ(pixels, 6);
  EXPECT_GT(strands, 240);
  EXPECT_LE(strands, 301);
  EXPECT_GT(wider, 1.2f);
  EXPECT_TRUE(std::ifstream(sheet, std::ios::binary).peek() == 0x89);
}

TEST(Lod, RefusesSizesAndSettingsThatAreNone) {
  for (const std::string option :
       {"--sizes 0", "--sizes nan", "--sizes 50,-3", "--sizes 1e9", "--importance 0",
        "--importance nan", "--pixels-off 0", "--pixels-off nan", "--strands-per-pixel 0",
        "--pixels-per-cell -1", "--fade 0", "--frames 0", "--sheet a.txt", "--csv a.png"}) {
    const Outcome outcome = run("lod --strands 400 " + option);
    EXPECT_NE(outcome.code, 0) << option;
    EXPECT_NE(outcome.out.find(option.substr(0, option.find(' '))), std::string::npos)
        << option << ": " << outcome.out;
  }
}

}  // namespace
}  // namespace hair
