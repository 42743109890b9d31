#include <gtest/gtest.h>

#include <libhair/files/data_file.h>
#include <libhair/files/tfx_file.h>

#include "samples.h"

namespace hair {
namespace {

TEST(TfxFile, HoldsPointsPinsAndPlacesOnTheSkin) {
  const TfxFile tfx = parseTfx(sampleTfx(), "a.tfx");
  EXPECT_EQ(tfx.strands.first, (std::vector<std::uint32_t>{0, 4, 8}));
  EXPECT_EQ(tfx.strands.points[6], glm::vec3(1, 0.2f, -1));
  EXPECT_EQ(tfx.pinned, (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(tfx.strandUv, (std::vector<glm::vec2>{{0.1f, 0.2f}, {0.3f, 0.4f}}));
  EXPECT_TRUE(parseTfx(withBytes(sampleTfx(), 16, 0u), "a.tfx").strandUv.empty());
}

TEST(TfxFile, ErrorsNameFileByteAndCause) {
  const std::string good = sampleTfx();
  const auto error = [](const std::string& bytes) {
    return errorOf([&] { parseTfx(bytes, "a.tfx"); });
  };
  EXPECT_NE(error(withBytes(good, 0, 3.0f)).find("a.tfx: byte 0: version 4.0 expected, found 3"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 4, 0u)).find("a.tfx: byte 4: the file holds no strands"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 4, 0xffffffffu)).find("a.tfx: byte 160: positions: 17179869180"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 8, 65u)).find("a.tfx: byte 8: strands of 65 points"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 12, 12u)).find("inside the header"), std::string::npos);
  EXPECT_NE(error(withBytes(good, 12, 1u << 31)).find("past the end of the file"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 28, 1u << 31)).find("vertex colours at byte 2147483648"),
            std::string::npos);
  EXPECT_EQ(error(withBytes(good, 160 + 3 * 16 + 4, INFINITY)),
            "a.tfx: byte 212: positions 3 of 8 is inf, not finite");
}

TEST(DataFile, StrandsOfNoAndOnePointAreKept) {
  const StrandSet strands = parseData(sampleData(), "a.data");
  EXPECT_EQ(strands.first, (std::vector<std::uint32_t>{0, 2, 2, 3}));
  EXPECT_EQ(strands.points, (std::vector<glm::vec3>{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}));
}

TEST(DataFile, ErrorsNameFileByteAndCause) {
  const std::string good = sampleData();
  const auto error = [](const std::string& bytes) {
    return errorOf([&] { parseData(bytes, "a.data"); });
  };
  EXPECT_NE(error(withBytes(good, 0, -1)).find("a.data: byte 4: count of strands is -1"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 0, 0x7fffffff)).find("byte 4: strands: 2147483647 times 4"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 4, -7)).find("strand 0 has -7 points"), std::string::npos);
  EXPECT_NE(error(withBytes(good, 4, 0x7fffffff)).find("strand 0: 2147483647 times 12"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 0, 2)).find("16 bytes are left over after 2 strands"),
            std::string::npos);
  EXPECT_NE(error(withBytes(good, 12, NAN)).find("byte 12: strand 0 0 of 2 is nan"),
            std::string::npos);
}

}  // namespace
}  // namespace hair
