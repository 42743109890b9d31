#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <libhair/files/strand_file.h>

#include "samples.h"

namespace hair {
namespace {

constexpr UpAxis kAllUps[] = {UpAxis::Y, UpAxis::Z, UpAxis::ZBack, UpAxis::X, UpAxis::YDown};

glm::vec3 converted(glm::vec3 p, float scale, UpAxis up) {
  convertUnits({&p, 1}, scale, up);
  return p;
}

StrandSet randomStrands() {
  StrandSet strands;
  for (std::uint32_t s = 0; s < 20; ++s) {
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < 1 + s % 5; ++i)
      points.emplace_back(uniform(s, 3 * i), uniform(s, 3 * i + 1) - 0.5f, -uniform(s, 3 * i + 2));
    strands.append(points);
  }
  return strands;
}

TEST(ConvertUnits, IsARotationForEveryAxisAndNeverMirrors) {
  for (UpAxis up : kAllUps) {
    SCOPED_TRACE(wordOf(up));
    const glm::mat3 m(converted({1, 0, 0}, 1, up), converted({0, 1, 0}, 1, up),
                      converted({0, 0, 1}, 1, up));
    EXPECT_EQ(glm::determinant(m), 1.0f);
    EXPECT_EQ(glm::transpose(m) * m, glm::mat3(1));
  }
}

TEST(ConvertUnits, BringsUpToYAndTheFaceToZ) {
  const std::tuple<UpAxis, glm::vec3, glm::vec3> cases[] = {
      {UpAxis::Y, {0, 1, 0}, {0, 0, 1}},      {UpAxis::Z, {0, 0, 1}, {0, 1, 0}},
      {UpAxis::ZBack, {0, 0, 1}, {0, -1, 0}}, {UpAxis::X, {1, 0, 0}, {0, 0, 1}},
      {UpAxis::YDown, {0, -1, 0}, {0, 0, 1}},
  };
  for (const auto& [up, upward, face] : cases) {
    SCOPED_TRACE(wordOf(up));
    EXPECT_EQ(converted(upward, 2, up), glm::vec3(0, 2, 0));
    EXPECT_EQ(converted(face, 2, up), glm::vec3(0, 0, 2));
    EXPECT_EQ(upAxisFromText(wordOf(up)), up);
  }
  EXPECT_NE(errorOf([] { upAxisFromText("up"); }).find("z-back"), std::string::npos);
}

TEST(ConvertUnits, TheWayBackUndoesIt) {
  for (UpAxis up : kAllUps) {
    std::vector<glm::vec3> points = randomStrands().points;
    const std::vector<glm::vec3> before = points;
    convertUnits(points, 0.25f, up);
    convertUnitsBack(points, 0.25f, up);
    EXPECT_EQ(points, before);
  }
}

TEST(StrandFile, WritingThenReadingGivesTheSameBits) {
  const TemporaryFolder folder;
  const StrandSet strands = randomStrands();
  writeStrands(folder / "a.hair", strands);
  const StrandFile read = readStrands(folder / "a.hair");
  EXPECT_EQ(read.strands.points, strands.points);
  EXPECT_EQ(read.strands.first, strands.first);
  EXPECT_EQ(read.scale, 1.0f);
  EXPECT_EQ(read.up, UpAxis::Y);
}

TEST(StrandFile, EveryFormatHasItsDefaultAndOptionsOverrideIt) {
  const TemporaryFolder folder;
  writeHair(folder / "a.HAIR", sampleHair());
  const StrandFile hair = readStrands(folder / "a.HAIR");
  EXPECT_EQ(hair.format, "hair");
  EXPECT_EQ(hair.scale, 0.00465f);
  EXPECT_EQ(hair.up, UpAxis::Z);
  EXPECT_EQ(hair.arrays, "points, thickness, transparency, colours");
  EXPECT_EQ(hair.strands.points[3], 0.00465f * glm::vec3(1, 3, 2));

  const StrandFile scaled = readStrands(folder / "a.HAIR", {.scale = 0.5f, .up = UpAxis::Y});
  EXPECT_EQ(scaled.scale, 0.5f);
  EXPECT_EQ(scaled.strands.points[3], 0.5f * glm::vec3(-1, 2, 3));

  const StrandFile tfx = readStrands(folder.write("a.tfx", sampleTfx()));
  EXPECT_EQ(tfx.strands.points[6], glm::vec3(1, 0.2f, -1));
  EXPECT_EQ(tfx.arrays, "points, pinned, strand UV");
  const StrandFile data = readStrands(folder.write("a.data", sampleData()), {.up = UpAxis::Z});
  EXPECT_EQ(data.strands.points[2], glm::vec3(-6, 8, 7));
  EXPECT_EQ(data.strands.strandCount(), 3u);
}

TEST(StrandFile, EveryArrayOfAHairFileComesAlongInMetres) {
  const TemporaryFolder folder;
  const HairFile sample = sampleHair();
  writeHair(folder / "a.hair", sample);
  StrandFile read = readStrands(folder / "a.hair", {.scale = 0.5f});
  EXPECT_EQ(read.thickness[3], 0.5f * sample.thickness[3]);
  EXPECT_EQ(read.defaultThickness, 0.5f * sample.defaultThickness);
  EXPECT_EQ(read.transparency, sample.transparency);
  EXPECT_EQ(read.colours, sample.colours);

  writeStrands(folder / "b.hair", read);
  const StrandFile again = readStrands(folder / "b.hair");
  EXPECT_EQ(again.strands.points, read.strands.points);
  EXPECT_EQ(again.thickness, read.thickness);
  EXPECT_EQ(again.transparency, read.transparency);
  EXPECT_EQ(again.colours, read.colours);
  EXPECT_EQ(again.defaultThickness, read.defaultThickness);
  EXPECT_EQ(again.defaultTransparency, read.defaultTransparency);
  EXPECT_EQ(again.defaultColour, read.defaultColour);

  // The middle strand has one point only; what belongs to the others stays with them.
  EXPECT_EQ(dropDegenerate(read), 1u);
  EXPECT_EQ(read.strands.first, (std::vector<std::uint32_t>{0, 3, 5}));
  EXPECT_EQ(read.thickness, (std::vector<float>{0.5f, 1, 1.5f, 2.5f, 3}));
  EXPECT_EQ(read.transparency, (std::vector<float>{0, 0.1f, 0.2f, 0.4f, 0.5f}));
  EXPECT_EQ(read.colours.size(), 5u);
}

TEST(StrandFile, ErrorsNameFileAndCause) {
  const TemporaryFolder folder;
  const auto error = [](const std::filesystem::path& file, ReadOptions options = {}) {
    return errorOf([&] { readStrands(file, options); });
  };
  EXPECT_NE(error(folder.write("a.abc", "x")).find("unknown format '.abc'"), std::string::npos);
  EXPECT_NE(error(folder / "none.hair").find("no such file"), std::string::npos);
  EXPECT_NE(error(folder.write("a.tfx", sampleTfx()), {.scale = -1}).find("scale of -1"),
            std::string::npos);
  EXPECT_NE(error(folder / "a.tfx", {.scale = NAN}).find("scale of nan"), std::string::npos);
  EXPECT_NE(error(folder / "a.tfx", {.scale = 1e9f}).find("check the scale"), std::string::npos);
}

TEST(DropDegenerate, RemovesShortStrandsAndKeepsTheRestInOrder) {
  StrandSet strands = randomStrands();
  const StrandSet all = strands;
  const std::size_t dropped = dropDegenerate(strands, 0.8f, 3);
  std::size_t kept = 0;
  for (std::size_t s = 0; s < all.strandCount(); ++s) {
    const auto points = all.strand(s);
    if (points.size() < 3 || arcLength(points) < 0.8f) continue;
    ASSERT_LT(kept, strands.strandCount());
    const auto got = strands.strand(kept++);
    EXPECT_TRUE(std::equal(got.begin(), got.end(), points.begin(), points.end())) << s;
  }
  EXPECT_EQ(kept, strands.strandCount());
  EXPECT_GT(kept, 0u);
  EXPECT_GT(dropped, 0u);
  EXPECT_EQ(dropped, all.strandCount() - kept);
  EXPECT_EQ(strands.first.back(), strands.pointCount());
  EXPECT_EQ(dropDegenerate(strands, 0, 0), 0u);
}

}  // namespace
}  // namespace hair
