#include <apps/draw/image.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include <apps/draw/video.h>
#include <gtest/gtest.h>

#include <libhair/core/error.h>

using namespace hair;
using namespace hair::draw;
namespace fs = std::filesystem;

namespace {

Picture ramp(int width, int height) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = picture.pixel(x, y);
      p[0] = std::uint8_t(255 * x / width), p[1] = std::uint8_t(255 * y / height);
      p[2] = std::uint8_t((x * 7 + y * 13) % 256);
    }
  }
  return picture;
}

class Images : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("hair_image_test_" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::size_t filesInFolder() const {
    return std::size_t(std::distance(fs::directory_iterator(folder), {}));
  }
  fs::path folder;
};

TEST_F(Images, PngReturnsTheSameBytes) {
  const Picture picture = ramp(37, 23);
  writeImage(picture, folder / "a.png");
  EXPECT_EQ(readImage(folder / "a.png"), picture);
}

TEST_F(Images, ExrReturnsTheSameLight) {
  LinearPicture picture(37, 23);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    picture.rgb[i] = 1e-3f * float(i) * float(i) / 37;  // to far above 1
  picture.rgb.back() = 1e9f;
  writeImage(picture, folder / "a.exr");
  const LinearPicture back = readLinearImage(folder / "a.exr");
  ASSERT_EQ(back.rgb.size(), picture.rgb.size());
  for (std::size_t i = 0; i + 1 < back.rgb.size(); ++i)
    EXPECT_NEAR(back.rgb[i], picture.rgb[i], 5e-4f * picture.rgb[i] + 1e-7f);
  EXPECT_EQ(back.rgb.back(), 65504) << "the largest half float, not infinity";
  // Bytes are made of it in the same way whether it is written as bytes or read as such.
  writeImage(picture, folder / "a.png");
  EXPECT_EQ(readImage(folder / "a.png"), encoded(picture));
  const Picture read = readImage(folder / "a.exr"), made = encoded(picture);
  for (std::size_t i = 0; i < read.rgb.size(); ++i) EXPECT_NEAR(read.rgb[i], made.rgb[i], 1);
  EXPECT_EQ(made.rgb.back(), 255);
  EXPECT_EQ(encoded(LinearPicture(1, 1)).rgb, std::vector<std::uint8_t>(3, 0));
}

TEST_F(Images, BytesAreNoLinearPicture) {
  EXPECT_TRUE(isLinear("a.exr") && isLinear("B.EXR"));
  EXPECT_FALSE(isLinear("a.png"));
  EXPECT_THROW(writeImage(ramp(4, 4), folder / "a.exr"), Error);
  writeImage(ramp(4, 4), folder / "a.png");
  EXPECT_THROW(readLinearImage(folder / "a.png"), Error);
}

TEST_F(Images, MasksAreGreyAsTheFileHasThem) {
  std::ofstream(folder / "grey.pgm", std::ios::binary) << "P5\n3 2\n255\n"
                                                       << std::string("\0\x33\xff\x66\x99\xcc", 6);
  const Mask grey = readMask(folder / "grey.pgm");
  EXPECT_EQ(grey.width, 3);
  EXPECT_EQ(grey.height, 2);
  ASSERT_EQ(grey.values.size(), 6u);
  const float expected[] = {0, 0.2f, 1, 0.4f, 0.6f, 0.8f};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(grey.values[i], expected[i], 1e-6f);
  writeImage(ramp(5, 4), folder / "colours.png");
  const Mask mean = readMask(folder / "colours.png");
  ASSERT_EQ(mean.values.size(), 20u);
  EXPECT_NEAR(mean.values[5 * 2 + 3], (153 + 127 + 47) / 765.0f, 1e-5f);
  EXPECT_THROW(readMask(folder / "absent.png"), Error);
}

TEST_F(Images, NothingIsLeftWhereWritingFails) {
  EXPECT_THROW(writeImage(ramp(4, 4), folder / "a.xyz"), Error);
  EXPECT_THROW(writeImage(Picture(), folder / "a.png"), Error);
  EXPECT_THROW(writeImage(ramp(4, 4), folder / "none" / "a.png"), Error);
  fs::create_directories(folder / "taken.png" / "full");
  EXPECT_THROW(writeImage(ramp(4, 4), folder / "taken.png"), Error);
  EXPECT_EQ(filesInFolder(), 1u);
  EXPECT_THROW(readImage(folder / "absent.png"), Error);
  std::ofstream(folder / "broken.png") << "no picture";
  EXPECT_THROW(readImage(folder / "broken.png"), Error);
}

TEST_F(Images, SmallerPicturesKeepTheirLight) {
  Picture board(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      for (int c = 0; c < 3; ++c) board.pixel(x, y)[c] = (x + y) % 2 ? 255 : 0;
    }
  }
  const Picture half = downscaled(board, 4, 4);
  // Half the light of white is byte 188, not 128.
  for (std::uint8_t byte : half.rgb) EXPECT_EQ(byte, 188);
  const Picture same = ramp(9, 5);
  EXPECT_EQ(downscaled(same, 9, 5), same);
  EXPECT_THROW(downscaled(same, 10, 5), Error);
  EXPECT_THROW(downscaled(same, 0, 5), Error);
}

TEST_F(Images, ContactSheetsKeepEveryPicture) {
  std::vector<Picture> pictures;
  for (int i = 0; i < 5; ++i) {
    pictures.push_back(ramp(6, 4));
    pictures.back().pixel(0, 0)[0] = std::uint8_t(100 + i);
  }
  const Picture sheet = contactSheet(pictures, 3, 2);
  EXPECT_EQ(sheet.width, 3 * 8 + 2);
  EXPECT_EQ(sheet.height, 2 * 6 + 2);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(sheet.pixel(2 + (i % 3) * 8, 2 + (i / 3) * 6)[0], 100 + i) << "picture " << i;
  }
  pictures.push_back(ramp(7, 4));
  EXPECT_THROW(contactSheet(pictures, 3), Error);
  EXPECT_THROW(contactSheet({}, 3), Error);
}

TEST_F(Images, VideosAppearWholeOrNotAtAll) {
  if (!videoAvailable()) GTEST_SKIP() << "the program ffmpeg is not installed";
  {
    VideoWriter video(folder / "a.mp4", 64, 48, 30);
    for (int i = 0; i < 10; ++i) video.add(ramp(64, 48));
    EXPECT_FALSE(fs::exists(folder / "a.mp4"));
    EXPECT_THROW(video.add(ramp(64, 50)), Error);
    video.finish();
    EXPECT_THROW(video.finish(), Error);
  }
  EXPECT_GT(fs::file_size(folder / "a.mp4"), 500u);
  {
    VideoWriter video(folder / "b.mp4", 64, 48, 30);
    video.add(ramp(64, 48));
  }
  EXPECT_EQ(filesInFolder(), 1u) << "an unfinished video, or a log, stayed";
  EXPECT_THROW(VideoWriter(folder / "c.mp4", 63, 48, 30), Error);
  EXPECT_THROW(VideoWriter(folder / "none" / "c.mp4", 64, 48, 30), Error);
}

TEST_F(Images, AMissingOrFailingFfmpegIsReported) {
  const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
  ::setenv("PATH", folder.c_str(), 1);
  EXPECT_FALSE(videoAvailable());
  EXPECT_THROW(VideoWriter(folder / "a.mp4", 64, 48, 30), Error);
  std::ofstream(folder / "ffmpeg") << "#!/bin/sh\necho no such codec >&2\nexit 3\n";
  fs::permissions(folder / "ffmpeg", fs::perms::all);
  try {
    VideoWriter video(folder / "a.mp4", 640, 480, 30);
    for (int i = 0; i < 20; ++i) video.add(ramp(640, 480));
    video.finish();
    ADD_FAILURE() << "a failed video was reported as written";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no such codec"), std::string::npos) << error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(filesInFolder(), 1u);
}

}  // namespace
