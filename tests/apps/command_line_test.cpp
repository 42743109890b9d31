// The program as scripts see it: exit codes, streams, files.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include <libhair/files/strand_file.h>
#include <tests/apps/outcome.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

TEST(CommandLine, ExitCodesTellDoneFromBadInputFromBadUsage) {
  const TemporaryFolder folder;
  const std::string good = folder.write("a.tfx", sampleTfx()).string();
  const std::string bad = folder.write("b.tfx", sampleTfx().substr(0, 200)).string();
  const std::string out = (folder / "out.hair").string();
  const std::pair<std::string, int> cases[] = {
      {"--help", 0},
      {"--version", 0},
      {"info --help", 0},
      {"convert --help", 0},
      {"info " + good, 0},
      {"convert " + good + ' ' + out, 0},
      {"info " + bad, 1},
      {"info " + good + "x", 1},
      {"convert " + bad + ' ' + out, 1},
      {"convert " + good + " /nowhere/out.hair", 1},
      {"convert " + good + ' ' + out + " --min-length 100", 1},
      {"info " + good + " >/dev/full", 1},
      {"", 2},
      {"comb", 2},
      {"info", 2},
      {"info " + good + " --up sideways", 2},
      {"info " + good + " --scale 0", 2},
      {"info " + good + " --scale x", 2},
      {"convert " + good + " out.txt", 2},
      {"convert " + good + ' ' + out + " --points 1", 2},
      {"convert " + good + ' ' + out + " --strands 0", 2},
      {"simulate --frames 1 --light 1,2", 2},
      {"simulate --frames 1 --light 1,2,x", 2},
      {"simulate --frames 1 --point 1,2,3,", 2},
      {"simulate --frames 1 --point 1,2,3,0.5", 2},
      {"simulate --frames 1 --point 1,2,3,1,1,1,1", 2},
      {"simulate --frames 1 --light 1,2,3,1,1,-1", 2},
      {"simulate --frames 1 --strands 300 --settle 0 --light 0,0,0", 1},
  };
  for (const auto& [arguments, code] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << "hair " << arguments << '\n' << outcome.out;
  }
}

TEST(CommandLine, BadInputIsOneLineThatNamesTheFile) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("b.tfx", sampleTfx().substr(0, 200)).string();
  const std::string out = run("info " + bad).out;
  EXPECT_TRUE(out.starts_with("hair: " + bad + ": byte 12: strand UV at byte 288")) << out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 1);
}

TEST(CommandLine, ConvertWritesWhatInfoReads) {
  const TemporaryFolder folder;
  const std::string in = folder.write("a.tfx", sampleTfx()).string();
  const std::string out = (folder / "out.hair").string();
  ASSERT_EQ(run("convert " + in + ' ' + out + " --scale 0.01 --up z --strands 1 --points 7").code,
            0);
  const StrandFile file = readStrands(out);
  EXPECT_EQ(file.strands.strandCount(), 1u);
  EXPECT_EQ(file.strands.pointCount(), 7u);
  EXPECT_EQ(file.scale, 1.0f);
  // Of the sample: roots at (0 or 1, 0, -1), strands of 0.3 along +y, in hundredths; z is up.
  EXPECT_FLOAT_EQ(file.strands.points[0].y, -0.01f);
  EXPECT_NEAR(file.strands.points[6].z, 0.003f, 1e-8f);
  const std::string said = run("info " + out).out;
  EXPECT_NE(said.find("strands       1\n"), std::string::npos) << said;
  EXPECT_NE(said.find("1 m per unit, +Y up, +Z face"), std::string::npos) << said;
}

TEST(CommandLine, ConvertingTwiceGivesTheSameBytes) {
  const TemporaryFolder folder;
  HairFile sample = sampleHair();
  const std::string in = (folder / "in.hair").string();
  writeHair(in, sample);
  const std::string a = (folder / "a.hair").string(), b = (folder / "b.hair").string();
  ASSERT_EQ(run("convert " + in + ' ' + a).code, 0);
  ASSERT_EQ(run("convert " + a + ' ' + b).code, 0);
  const HairFile first = readHair(a), second = readHair(b);
  EXPECT_EQ(hairBytes(first), hairBytes(second));
  EXPECT_EQ(first.strands.strandCount(), 2u);  // one of the sample's has a single point
  EXPECT_EQ(first.colours.size(), 5u);
}

}  // namespace
}  // namespace hair
