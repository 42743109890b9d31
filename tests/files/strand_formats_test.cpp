// Every format of strands out and in again, through readStrands and writeStrands.
#include <fstream>

#include <gtest/gtest.h>

#include <libhair/files/strand_file.h>

#include "samples.h"
#include "strand_samples.h"

namespace hair {
namespace {

struct Format {
  const char* extension;
  Holds holds;
  bool statesUnits;
};

const Format kFormats[] = {{"hair", {1, 9, true}, true},   {"tfx", {5, 5, false}, false},
                           {"data", {0, 9, false}, false}, {"ply", {1, 9, true}, true},
                           {"obj", {1, 9, false}, true},   {"usda", {2, 9, true}, true}};

// The largest distance that a rounding or two may move a number.
void expectNear(float got, float want, float roundings) {
  EXPECT_NEAR(got, want, roundings * 1.2e-7f * std::abs(want) + 1e-37f);
}

TEST(StrandFormats, AnyStrandsComeBackBitForBitInEveryFormat) {
  const TemporaryFolder folder;
  for (const Format& format : kFormats)
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
      SCOPED_TRACE(text(format.extension, ' ', seed));
      const StrandFile strands = anyStrands(seed, format.holds);
      if (strands.strands.pointCount() == 0) continue;  // .data may have none
      const auto file = folder / text("a.", format.extension);
      writeStrands(file, strands);
      const StrandFile read = readStrands(file);
      EXPECT_EQ(read.format, format.extension);
      EXPECT_EQ(read.scale, 1.0f);
      EXPECT_EQ(read.up, UpAxis::Y);
      EXPECT_EQ(read.strands.first, strands.strands.first);
      ASSERT_TRUE(sameBits(read.strands.points, strands.strands.points));
      EXPECT_TRUE(sameBits(read.thickness, strands.thickness));
      EXPECT_TRUE(sameBits(read.colours, strands.colours));
      // USD holds opacity, 1 - transparency, which rounds twice.
      ASSERT_EQ(read.transparency.size(), strands.transparency.size());
      for (std::size_t i = 0; i < read.transparency.size(); ++i)
        EXPECT_NEAR(read.transparency[i], strands.transparency[i],
                    format.extension == std::string("usda") ? 1.2e-7f : 0.0f);
    }
}

TEST(StrandFormats, ConstantsComeBackAsConstantsOrAsAValueAPoint) {
  const TemporaryFolder folder;
  StrandFile strands = anyStrands(3, {2, 4, false});
  strands.defaultThickness = 3e-4f;
  strands.defaultColour = {0.5f, 0.25f, 0.125f};
  strands.defaultTransparency = 0.25f;
  for (const char* extension : {"hair", "usda", "ply"}) {
    SCOPED_TRACE(extension);
    writeStrands(folder / text("a.", extension), strands);
    StrandFile read = readStrands(folder / text("a.", extension));
    if (extension == std::string("ply")) {
      ASSERT_EQ(read.thickness.size(), read.strands.pointCount());
      read.defaultThickness = read.thickness.back();
      read.defaultColour = read.colours.back();
      read.defaultTransparency = read.transparency.back();
    } else {
      EXPECT_TRUE(read.thickness.empty() && read.colours.empty() && read.transparency.empty());
    }
    EXPECT_EQ(read.defaultThickness, strands.defaultThickness);
    EXPECT_EQ(read.defaultColour, strands.defaultColour);
    EXPECT_EQ(read.defaultTransparency, strands.defaultTransparency);
  }
}

TEST(StrandFormats, OtherUnitsAndAxesComeBackWithinTwoRoundings) {
  const TemporaryFolder folder;
  for (const Format& format : kFormats)
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::ZBack, UpAxis::X, UpAxis::YDown}) {
      SCOPED_TRACE(text(format.extension, ' ', wordOf(up)));
      StrandFile strands = anyStrands(7, {5, 5, format.holds.arrays});
      for (glm::vec3& p : strands.strands.points) p = glm::clamp(p, -1e5f, 1e5f);
      const auto file = folder / text("a.", format.extension);
      const WriteOptions write{.scale = 0.01f, .up = up};
      if (format.extension == std::string("usda") && up != UpAxis::Y && up != UpAxis::ZBack) {
        EXPECT_NE(errorOf([&] { writeStrands(file, strands, write); }).find("z-back"),
                  std::string::npos);
        continue;
      }
      writeStrands(file, strands, write);
      const StrandFile read = format.statesUnits
                                  ? readStrands(file)
                                  : readStrands(file, {.scale = write.scale, .up = up});
      EXPECT_EQ(read.scale, 0.01f);
      EXPECT_EQ(read.up, up);
      ASSERT_EQ(read.strands.pointCount(), strands.strands.pointCount());
      for (std::size_t i = 0; i < read.strands.pointCount(); ++i)
        for (int c = 0; c < 3; ++c)
          expectNear(read.strands.points[i][c], strands.strands.points[i][c], 2);
      for (std::size_t i = 0; i < read.thickness.size(); ++i)
        expectNear(read.thickness[i], strands.thickness[i], 2);
    }
}

TEST(StrandFormats, WhatAFormatCannotHoldIsAnErrorWithAWayOut) {
  const TemporaryFolder folder;
  const auto error = [&](const char* name, const StrandFile& strands, WriteOptions options = {}) {
    const auto file = folder / name;
    const std::string message = errorOf([&] { writeStrands(file, strands, options); });
    EXPECT_FALSE(std::filesystem::exists(file)) << name;
    return message;
  };
  const auto says = [](const std::string& message, const char* words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  StrandFile unequal = anyStrands(1, {5, 5, false});
  unequal.strands.append(std::vector<glm::vec3>(6));
  says(error("a.tfx", unequal), "--points 16");
  StrandFile many;
  many.strands.append(std::vector<glm::vec3>(65));
  says(error("a.tfx", many), "the format has 4 to 64");
  StrandFile point;
  point.strands.append(std::vector<glm::vec3>(2));
  point.strands.append(std::vector<glm::vec3>(1));
  says(error("a.usda", point), "strand 1 has 1 points, a .usda file needs 2: drop short strands");
  StrandFile nothing = point;
  nothing.strands.append({});
  for (const char* name : {"a.ply", "a.obj", "a.hair", "a.usda"})
    says(error(name, nothing), "drop short strands");
  StrandFile none;
  for (const Format& format : kFormats)
    says(error(text("a.", format.extension).c_str(), none), "there are no strands to write");
  StrandFile wrong = point;
  wrong.thickness = {1};
  says(error("a.ply", wrong), "thickness: 1 items for 3 points");
  wrong.thickness.clear();
  wrong.strands.points[0].x = NAN;
  for (const Format& format : kFormats)
    EXPECT_NE(error(text("a.", format.extension).c_str(), wrong), "");
  says(error("a.abc", point), ".hair, .tfx, .data, .ply, .obj, .usda, .npy, .npz and .pbrt");
  says(error("a.hair", point, {.scale = 0}), "scale of 0");
  point.strands.points[0].x = 1e7f;
  says(error("a.obj", point, {.scale = 1e-3f}), "larger units");
  says(error("a.ply", point, {.scale = 1e-35f}), "larger units");
}

TEST(StrandFormats, WhatIsLeftOutIsSaid) {
  StrandFile strands = anyStrands(1, {4, 4, true});
  for (const char* name : {"a.hair", "a.ply", "a.USDA"}) EXPECT_EQ(lossOf(name, strands), "");
  for (const char* name : {"a.tfx", "a.data", "a.obj"})
    EXPECT_EQ(lossOf(name, strands), "thickness, transparency, colours");
  strands.thickness.clear();
  strands.transparency.clear();
  EXPECT_EQ(lossOf("a.obj", strands), "colours");
}

class RealStrands : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  }
  const std::filesystem::path file =
      std::filesystem::path(HAIR_DATA_DIR) / "hair" / std::string(GetParam());
};

TEST_P(RealStrands, GoThroughEveryFormatBitForBit) {
  const TemporaryFolder folder;
  const StrandFile strands = readStrands(file);
  StrandFile current = strands;
  for (const char* extension : {"usda", "ply", "hair", "obj", "tfx", "data", "usda"}) {
    SCOPED_TRACE(extension);
    const auto next = folder / text("a.", extension);
    writeStrands(next, current);
    current = readStrands(next);
    EXPECT_EQ(current.strands.first, strands.strands.first);
    ASSERT_TRUE(sameBits(current.strands.points, strands.strands.points));
    if (extension == std::string("hair")) {
      EXPECT_TRUE(sameBits(current.colours, strands.colours));
    }
  }
}

std::string fileStem(const testing::TestParamInfo<const char*>& info) {
  return std::filesystem::path(info.param).stem().string();
}

INSTANTIATE_TEST_SUITE_P(Files, RealStrands,
                         testing::Values("straight.hair", "sintel.tfx", "sintel_guides.tfx",
                                         "ratboy_mohawk.tfx"),
                         fileStem);

}  // namespace
}  // namespace hair
