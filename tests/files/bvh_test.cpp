#include <gtest/gtest.h>

#include <libhair/files/bvh_file.h>

#include "samples.h"

namespace hair {
namespace {

using Channel = Bvh::Channel;

std::string error(const std::string& bytes) {
  return errorOf([&] { parseBvh(bytes, "a.bvh"); });
}

std::string replaced(std::string bytes, const std::string& from, const std::string& to) {
  const std::size_t at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return bytes.replace(at, from.size(), to);
}

TEST(Bvh, TheTreeIsThatOfTheFile) {
  const Bvh bvh = parseBvh(sampleBvh(), "a.bvh");
  ASSERT_EQ(bvh.joints.size(), 5u);
  const auto expectJoint = [&](std::size_t j, const char* name, int parent, glm::vec3 offset,
                               std::vector<Channel> channels, std::uint32_t first) {
    EXPECT_EQ(bvh.joints[j].name, name);
    EXPECT_EQ(bvh.joints[j].parent, parent) << name;
    EXPECT_EQ(bvh.joints[j].offset, offset) << name;
    EXPECT_EQ(bvh.joints[j].channels, channels) << name;
    EXPECT_EQ(bvh.joints[j].firstChannel, first) << name;
  };
  expectJoint(0, "hip", -1, {0, 0, 0},
              {Channel::Xposition, Channel::Yposition, Channel::Zposition, Channel::Zrotation,
               Channel::Yrotation, Channel::Xrotation},
              0);
  expectJoint(1, "left foot", 0, {1, -2, 0.3f}, {Channel::Yrotation}, 6);
  expectJoint(2, "left foot end", 1, {0, -1, 0}, {}, 7);
  expectJoint(3, "fixed", 0, {0, 5, 0}, {}, 7);
  expectJoint(4, "head", 3, {0, 1, 0}, {Channel::Zrotation, Channel::Xrotation, Channel::Yrotation},
              7);
  EXPECT_TRUE(bvh.joints[2].endSite);
  EXPECT_FALSE(bvh.joints[3].endSite);
}

TEST(Bvh, RowsAreThoseOfTheFile) {
  const Bvh bvh = parseBvh(sampleBvh(), "a.bvh");
  EXPECT_EQ(bvh.channelCount, 10u);
  ASSERT_EQ(bvh.frameCount(), 2u);
  EXPECT_DOUBLE_EQ(bvh.frameTime, 0.00833333);
  for (std::size_t c = 0; c < 10; ++c) {
    EXPECT_EQ(bvh.frame(0)[c], static_cast<float>(c + 1));
    EXPECT_EQ(bvh.frame(1)[c], -static_cast<float>(c + 1));
  }
}

TEST(Bvh, LineEndsDoNotMatter) {
  const Bvh want = parseBvh(sampleBvh(), "a.bvh");
  std::string lf = sampleBvh();
  std::erase(lf, '\r');
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string bytes = "\xEF\xBB\xBF";  // as some editors put in front
    for (char c : lf) bytes += c == '\n' ? end : std::string(1, c);
    const Bvh got = parseBvh(bytes, "a.bvh");
    EXPECT_EQ(got.values, want.values);
    EXPECT_EQ(got.joints.size(), want.joints.size());
  }
}

TEST(Bvh, JointsAreFoundByName) {
  const Bvh bvh = parseBvh(sampleBvh(), "a.bvh");
  EXPECT_EQ(bvh.find("head"), 4);
  EXPECT_EQ(bvh.find("Head"), -1);
  EXPECT_EQ(bvh.find("Head", true), 4);
  EXPECT_EQ(bvh.find("hea"), -1);
}

TEST(Bvh, ErrorsNameFileLineAndCause) {
  const std::string good = sampleBvh();
  const std::pair<std::string, std::string> cases[] = {
      {"", "a.bvh: line 0: the file is empty"},
      {"MOTION", "a.bvh: line 1: 'HIERARCHY' expected"},
      {replaced(good, "CHANNELS 1 Yrotation", "CHANNELS 2 Yrotation"),
       "a.bvh: line 8: joint 'left foot' announces 2 channels, names 1"},
      {replaced(good, "CHANNELS 1 Yrotation", "CHANNELS 1 Yrotation Xrotation"),
       "a.bvh: line 8: unexpected 'Xrotation'"},
      {replaced(good, "CHANNELS 1 Yrotation", "CHANNELS 1 Wrotation"),
       "a.bvh: line 8: 'Wrotation' is no channel"},
      {replaced(good, "CHANNELS 1 Yrotation", "CHANNELS -1"), "a.bvh: line 8: count of channels"},
      {replaced(good, "CHANNELS 0", "CHANNELS 0\nCHANNELS 0x"), "line 18: count of channels: '0x'"},
      {replaced(good, "+1 -2 3e-1", "+1 nan 3"),
       "a.bvh: line 7: OFFSET: 'nan' is no finite number"},
      {replaced(good, "+1 -2 3e-1", "+1 -2"), "a.bvh: line 7: OFFSET: a number is missing"},
      {replaced(good, "End Site", "End Effector"), "a.bvh: line 9: 'End Effector'"},
      {replaced(good, "OFFSET 0 -1 0\n", "CHANNELS 0\n"), "line 11: an end site has no channels"},
      {replaced(good, "OFFSET 0 -1 0\n", "JOINT x\n"), "line 11: an end site has no children"},
      {replaced(good, "JOINT fixed", "ROOT fixed"), "line 14: ROOT inside another joint"},
      {replaced(good, "JOINT fixed", "JOINT"), "line 14: a joint without a name"},
      {replaced(good, "JOINT fixed\n  {", "JOINT fixed\n"), "'{' expected after joint 'fixed'"},
      {replaced(good, "}\n\nMOTION", "MOTION"), "MOTION before joint 'hip' is closed"},
      {replaced(good, "Frames:\t2", "Frames:\t3") + std::string(20, '\n'),
       "the file ends after 2 of 3 frames (truncated)"},
      {replaced(good, "Frames:\t2", "Frames:\t1"), "line 31: text after the 1 frames announced"},
      {replaced(good, "Frames:\t2", "Frames:\t-2"), "line 27: Frames: -2"},
      {replaced(good, "Frames:\t2", "Frames:\t9223372036854775807"),
       "line 28: Frames: 9223372036854775807 of 10 numbers do not fit"},
      {replaced(good, "Frames:\t2", "Frames:\t9223372036854775808"), "line 27: Frames:"},
      {replaced(good, "0.00833333", "0"), "line 28: Frame Time: 0 is not above zero"},
      {replaced(good, "9 10", "9"), "line 29: frame 0 has 9 of 10 numbers"},
      {replaced(good, "9 10", "9 10 11"), "line 29: frame 0 has more than 10 numbers"},
      {replaced(good, "9 10", "9 1e39"), "line 29: channel: '1e39' is no finite number"},
      {"HIERARCHY\nMOTION\n", "line 2: MOTION without any ROOT"},
      {"HIERARCHY\nJOINT a\n", "line 2: a joint outside of any ROOT"},
      {"HIERARCHY\n}\n", "line 2: unexpected '}' outside of any joint"},
      {"HIERARCHY\nROOT " + std::string(300, 'x') + "\n", "a joint's name of 300 bytes"},
  };
  for (const auto& [bytes, want] : cases)
    EXPECT_NE(error(bytes).find(want), std::string::npos)
        << "want: " << want << "\ngot:  " << error(bytes);
}

}  // namespace
}  // namespace hair
