// hair simulate: runs that are cut in two.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <apps/common/performance.h>
#include <libhair/core/state_hash.h>
#include <libhair/files/strand_sequence.h>
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

std::uint64_t hashOf(std::span<const glm::vec3> points) {
  StateHash hash;
  hash.add(points);
  return hash.value();
}

TEST(Simulate, ACacheHoldsEveryFrameBitForBit) {
  const TemporaryFolder folder;
  const std::string scene = "simulate --strands 200 --settle 0.05 --no-shadow --frames 5 --fps 24 ";
  for (const char* name : {"one.usda", "many.##.ply", "plain.hair"}) {
    const Outcome outcome = run(scene + "--cache " + (folder / name).string());
    ASSERT_EQ(outcome.code, 0) << outcome.out;
  }

  SubjectOptions hair;
  hair.strands = 200;
  const Subject subject(hair);
  PerformanceOptions options;
  options.settle = 0.05f;
  options.fps = 24;
  options.shadow = false;
  Performance performance(subject, options);
  performance.settings.shade = false;
  for (std::size_t f = 0; f < 5; ++f) {
    performance.step();
    const std::uint64_t hash = hashOf(performance.hair.strands().points);
    for (const char* name : {"one.usda", "many.##.ply", "plain.####.hair"}) {
      StrandSequenceReader reader(folder / name);
      ASSERT_EQ(reader.frameCount(), 5u) << name;
      StrandFile read;
      reader.read(f, read);
      EXPECT_EQ(hashOf(read.strands.points), hash) << name << ' ' << f;
    }
  }
}

TEST(Convert, TakesSequencesApartAndTogether) {
  const TemporaryFolder folder;
  const std::string shot = (folder / "shot.usda").string();
  StrandFile strands;
  strands.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.25f, 0}});
  strands.strands.append(std::vector<glm::vec3>{{1, 0, 0}, {1, 0.25f, 0}, {1, 0.25f, 0.5f}});
  strands.defaultThickness = 1e-4f;
  StrandSequenceWriter writer(shot, {.fps = 25});
  for (int f = 0; f < 3; ++f) {
    strands.strands.points[4].z = static_cast<float>(1 + f);
    writer.add(strands);
  }
  writer.close();
  EXPECT_NE(run("info " + shot).out.find("3, 0.08 s"), std::string::npos);

  const std::string plys = (folder / "shot.#.ply").string(), back = (folder / "b.usda").string();
  const Outcome apart = run("convert " + shot + ' ' + plys + " --out-scale 0.5 --out-up z-back");
  EXPECT_NE(apart.out.find("3 frames"), std::string::npos) << apart.out;
  EXPECT_EQ(run("convert " + plys + ' ' + back).code, 0);
  StrandSequenceReader reader(back);
  ASSERT_EQ(reader.frameCount(), 3u);
  StrandFile read;
  reader.read(2, read);
  EXPECT_EQ(read.strands.points, strands.strands.points);

  const std::string tfx = (folder / "a.tfx").string();
  const Outcome unequal = run("convert " + shot + ' ' + tfx);
  EXPECT_EQ(unequal.code, 1);
  EXPECT_NE(unequal.out.find("resample"), std::string::npos) << unequal.out;
  const Outcome one = run("convert " + shot + ' ' + tfx + " --points 8 --frame 1");
  EXPECT_EQ(one.code, 0) << one.out;
  EXPECT_NE(one.out.find(".tfx has no room for: thickness"), std::string::npos) << one.out;
  EXPECT_EQ(readStrands(tfx).strands.points[15].z, 2.0f);
  EXPECT_NE(run("convert " + shot + ' ' + tfx + " --frame 3").out.find("there are 3"),
            std::string::npos);
}

}  // namespace
}  // namespace hair
