#include <gtest/gtest.h>

#include "samples.h"

namespace hair {
namespace {

void expectEqual(const HairFile& a, const HairFile& b) {
  EXPECT_EQ(a.strands.points, b.strands.points);
  EXPECT_EQ(a.strands.first, b.strands.first);
  EXPECT_EQ(a.thickness, b.thickness);
  EXPECT_EQ(a.transparency, b.transparency);
  EXPECT_EQ(a.colours, b.colours);
  EXPECT_EQ(a.defaultThickness, b.defaultThickness);
  EXPECT_EQ(a.defaultTransparency, b.defaultTransparency);
  EXPECT_EQ(a.defaultColour, b.defaultColour);
  EXPECT_EQ(a.info, b.info);
}

TEST(HairFile, WritingThenReadingIsTheIdentityForEverySetOfArrays) {
  for (int arrays = 0; arrays < 16; ++arrays) {
    SCOPED_TRACE(arrays);
    HairFile hair = sampleHair();
    if (arrays & 1) hair.thickness.clear();
    if (arrays & 2) hair.transparency.clear();
    if (arrays & 4) hair.colours.clear();
    if (arrays & 8) {  // equal lengths: the header's default instead of an array
      hair.strands.points.resize(6);
      hair.strands.first = {0, 2, 4, 6};
    }
    expectEqual(parseHair(hairBytes(hair), "sample"), hair);
  }
}

TEST(HairFile, WritingThenReadingAFileIsTheIdentity) {
  const TemporaryFolder folder;
  const HairFile hair = sampleHair();
  writeHair(folder / "a.hair", hair);
  expectEqual(readHair(folder / "a.hair"), hair);
}

TEST(HairFile, TheBytesAreThoseOfTheFormat) {
  HairFile hair;
  hair.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {1, 2, 3}});
  hair.info = std::string(88, 'i');  // fills its field, no zero behind it
  const std::string bytes = hairBytes(hair);
  ASSERT_EQ(bytes.size(), 128u + 24u);
  EXPECT_EQ(bytes.substr(0, 4), "HAIR");
  std::uint32_t words[4];
  std::memcpy(words, bytes.data() + 4, sizeof(words));
  EXPECT_EQ(words[0], 1u);  // strands
  EXPECT_EQ(words[1], 2u);  // points
  EXPECT_EQ(words[2], 2u);  // flags: points only
  EXPECT_EQ(words[3], 1u);  // segments of each strand
  EXPECT_EQ(parseHair(bytes, "sample").info, hair.info);
}

TEST(HairFile, WhatTheFormatCannotHoldIsRefused) {
  const auto refusal = [](auto&& damage) {
    HairFile hair = sampleHair();
    damage(hair);
    return errorOf([&] { hairBytes(hair); });
  };
  EXPECT_NE(refusal([](HairFile& h) { h.colours.pop_back(); }).find("colours"), std::string::npos);
  EXPECT_NE(refusal([](HairFile& h) { h.info = std::string(89, 'x'); }).find("89"),
            std::string::npos);
  EXPECT_NE(refusal([](HairFile& h) { h.strands.append({}); }).find("strand 3"), std::string::npos);
  EXPECT_NE(refusal([](HairFile& h) { h.strands.points[4].y = NAN; }).find("strand 2 point 0"),
            std::string::npos);
  EXPECT_NE(refusal([](HairFile& h) { h = HairFile(); }).find("no strands"), std::string::npos);
  EXPECT_NE(refusal([](HairFile& h) {
              h.strands.append(std::vector<glm::vec3>(65537));
              h.thickness.clear(), h.transparency.clear(), h.colours.clear();
            }).find("strand 3 has 65537"),
            std::string::npos);
}

TEST(HairFile, ErrorsNameFileByteAndCause) {
  const std::string good = hairBytes(sampleHair());
  const auto error = [](const std::string& bytes) {
    return errorOf([&] { parseHair(bytes, "a.hair"); });
  };
  EXPECT_EQ(error("WIG"), "a.hair: byte 0: 'HAIR' expected: this is no .hair file");
  EXPECT_EQ(error(good.substr(0, 100)), "a.hair: byte 0: header: the file ends here (truncated)");
  EXPECT_EQ(error(good.substr(0, good.size() - 1)),
            "a.hair: byte 254: colours: 6 times 12 bytes are announced but 71 bytes are left "
            "(truncated, or a bad count)");
  EXPECT_EQ(error(good + "x"),
            "a.hair: byte 326: 1 bytes are left over: counts or flags in the header (31) do not "
            "fit this file");
  EXPECT_EQ(error(withBytes(good, 128 + 6 + 12 + 4, NAN)),
            "a.hair: byte 150: points 1 of 6 is nan, not finite");
  EXPECT_NE(error(withBytes(good, 8, 0xffffffffu)).find("byte 128: points: 4294967295 times 12"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 4, 7u)).find("7 strands cannot have 6 points"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 4, 0u)).find("no strands"), std::string::npos);
  EXPECT_NE(error(withBytes(good, 12, 1u)).find("no points"), std::string::npos);
  // Without the array every strand has as many segments as the header says: 4294967295.
  EXPECT_NE(error(withBytes(withBytes(good, 12, 2u), 16, 0xffffffffu)).find("strands 0 to 0 need"),
            std::string::npos);
}

}  // namespace
}  // namespace hair
