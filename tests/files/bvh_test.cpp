#include <cctype>
#include <cmath>

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
      {replaced(good, "OFFSET 0 -1 0\n", "JOINT x\n"), "line 11: an end site has no children"},
      {replaced(good, "JOINT fixed", "ROOT fixed"), "line 14: ROOT inside another joint"},
      {replaced(good, "JOINT fixed", "JOINT"), "line 14: a joint without a name"},
      {replaced(good, "JOINT fixed\n  {", "JOINT fixed\n"), "'{' expected after joint 'fixed'"},
      {replaced(good, "}\n\nMOTION", "MOTION"), "MOTION before joint 'hip' is closed"},
      {replaced(good, "Frames:\t2", "Frames:\t4") + std::string(20, '\n'),
       "the file ends after 2 of 4 frames (truncated)"},
      {replaced(good, "Frames:\t2", "Frames:\t-2"), "line 27: Frames: -2"},
      {replaced(good, "Frames:\t2", "Frames:\t9223372036854775807"),
       "line 28: Frames: 9223372036854775807 of 10 numbers do not fit"},
      {replaced(good, "Frames:\t2", "Frames:\t9223372036854775808"), "line 27: Frames:"},
      {replaced(good, "0.00833333", "-1"), "line 28: Frame Time: -1 is not above zero"},
      {replaced(good, "9 10 ", "x 10 "), "line 29: channel: 'x' is no finite number"},
      {replaced(good, "-8 -9", "-8"), "line 31: frame 1 has 9 of 10 numbers"},
      {replaced(good, "CHANNELS 0", "CHANNELS 0 # none\n}"),
       "line 25: unexpected '}' outside of any joint"},
      {"\xFF\xFEH", "UTF-16"},
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

/// What a dialect says must be what the plain spelling says.
void expectSame(const Bvh& got, const Bvh& want, const std::string& what) {
  EXPECT_EQ(got.values, want.values) << what;
  EXPECT_EQ(got.channelCount, want.channelCount) << what;
  ASSERT_EQ(got.joints.size(), want.joints.size()) << what;
  for (std::size_t j = 0; j < want.joints.size(); ++j) {
    EXPECT_EQ(got.joints[j].name, want.joints[j].name) << what;
    EXPECT_EQ(got.joints[j].parent, want.joints[j].parent) << what;
    EXPECT_EQ(got.joints[j].offset, want.joints[j].offset) << what;
    EXPECT_EQ(got.joints[j].channels, want.joints[j].channels) << what;
  }
}

TEST(Bvh, DialectsSayTheSame) {
  const std::string good = sampleBvh();
  const Bvh want = parseBvh(good, "a.bvh");
  EXPECT_TRUE(want.notes.empty());
  const auto lowered = [](std::string s, const std::string& word) {
    for (std::size_t at = 0; (at = s.find(word, at)) != std::string::npos; ++at)
      for (std::size_t i = 0; i < word.size(); ++i)
        s[at + i] = static_cast<char>(std::tolower(static_cast<unsigned char>(s[at + i])));
    return s;
  };
  std::string lower = good;
  for (const char* word : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "JOINT", "End Site", "MOTION",
                           "Frames", "Frame Time", "Xposition", "Yrotation"})
    lower = lowered(lower, word);
  const std::pair<std::string, std::size_t> cases[] = {
      // and how many notes
      {lower, 0},
      {replaced(good, "Frames:\t2", "FRAMES :2"), 0},
      {replaced(good, "Frame Time: ", "Frame  Time:"), 0},
      {replaced(good, "End Site", "End Site Tip"), 0},
      {replaced(good, "End Site", "EndSite"), 0},
      {replaced(good, "OFFSET 0 5 0\n    CHANNELS 0\n", "OFFSET 0 5 0 CHANNELS 0 "), 0},
      {replaced(good, "    }\n  }\n}\n", "}}} // done\n"), 0},
      {replaced(good, "ROOT hip\n{\r\n", "ROOT hip{"), 0},
      {replaced(good, "MOTION", "# by hand\nMOTION ; rows"), 0},
      {replaced(good, "OFFSET 0 5 0", "OFFSET 0 5 0 // up"), 0},
      {replaced(good, "\n\n-1\t", "\n# second\n-1\t"), 0},
      {replaced(good, "4 5 6", "4\n5\n6"), 1},
      {good + "\x1a", 1},
      {good + "# end\n", 0},
      {good + "end of motion", 1},
      {good + std::string(3, '\0'), 1},
      {replaced(good, "Frames:\t2", "Frames:\t1"), 1},
      {replaced(good, "Frames:\t2", "Frames:\t3"), 1},
  };
  for (const auto& [bytes, notes] : cases) {
    SCOPED_TRACE(bytes.substr(0, 900));
    const Bvh got = parseBvh(bytes, "a.bvh");
    expectSame(got, want, "");
    EXPECT_EQ(got.frameTime, want.frameTime);
    EXPECT_EQ(got.notes.size(), notes);
  }
}

TEST(Bvh, AnEndSiteMayHaveChannelsWhichTakeTheirPlaceInTheRow) {
  const Bvh bvh = parseBvh(
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\nEnd Site\n{\nOFFSET 0 1 0\n"
      "CHANNELS 1 Yrotation\n}\nJOINT b\n{\nOFFSET 0 2 0\nCHANNELS 1 Zrotation\n}\n}\nMOTION\n"
      "Frames: 1\nFrame Time: 0.1\n1 2 3\n",
      "a.bvh");
  EXPECT_EQ(bvh.channelCount, 3u);
  EXPECT_EQ(bvh.joints[2].name, "b");
  EXPECT_EQ(bvh.joints[2].firstChannel, 2u);
}

TEST(Bvh, AFrameTimeThatCannotBeIsARateOrMilliseconds) {
  EXPECT_EQ(frameTimeMeant(0.0166667), 0.0166667);
  EXPECT_EQ(frameTimeMeant(0.5), 0.5);
  // As a writer of seven decimals has it: the same clip moves the same.
  for (double rate : {24.0, 25.0, 30.0, 60.0, 100.0, 120.0, 240.0})
    for (double stated : {rate, 1000 / rate, std::round(1e6 / rate)})
      EXPECT_NEAR(frameTimeMeant(stated), 1 / rate, 6e-8) << stated;
  EXPECT_EQ(frameTimeMeant(60), 0.0166667);
  EXPECT_EQ(frameTimeMeant(0), 0.0166667);
  EXPECT_NEAR(frameTimeMeant(59.94), 1 / 59.94, 6e-8);
  const Bvh bvh = parseBvh(replaced(sampleBvh(), "0.00833333", "120"), "a.bvh");
  ASSERT_EQ(bvh.notes.size(), 1u);
  EXPECT_NE(bvh.notes[0].find("120 frames a second"), std::string::npos) << bvh.notes[0];
}

}  // namespace
}  // namespace hair
