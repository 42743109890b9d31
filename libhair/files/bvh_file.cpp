#include <libhair/files/bvh_file.h>

#include <algorithm>
#include <array>
#include <cctype>

#include <libhair/files/byte_reader.h>
#include <libhair/files/text_reader.h>

namespace hair {

namespace {

bool equal(std::string_view a, std::string_view b, bool ignoreCase) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](unsigned char x, unsigned char y) {
    return ignoreCase ? std::tolower(x) == std::tolower(y) : x == y;
  });
}

Bvh::Channel channelOf(const TextReader& in, std::string_view word) {
  static constexpr std::array<std::string_view, 6> kNames = {"Xposition", "Yposition", "Zposition",
                                                             "Xrotation", "Yrotation", "Zrotation"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (equal(word, kNames[i], true)) return static_cast<Bvh::Channel>(i);
  in.fail("'", TextReader::shown(word), "' is no channel (Xposition ... Zrotation)");
}

void expectLineDone(const TextReader& in) {
  in.expect(in.lineDone(), "unexpected '", TextReader::shown(in.restOfLine()), "'");
}

void parseChannels(TextReader& in, Bvh& bvh, Bvh::Joint& joint) {
  in.expect(!joint.endSite, "an end site has no channels");
  in.expect(joint.channels.empty(), "joint '", joint.name, "' has a second CHANNELS");
  const std::string_view countWord = in.word();
  const long long count = in.toInteger(countWord, "count of channels");
  // The names are in the same line, so a bad count runs out of words and cannot allocate.
  in.expect(count >= 0, "count of channels is ", count);
  for (long long c = 0; c < count; ++c) {
    const std::string_view word = in.word();
    in.expect(!word.empty(), "joint '", joint.name, "' announces ", count, " channels, names ", c);
    joint.channels.push_back(channelOf(in, word));
  }
  bvh.channelCount += joint.channels.size();
}

// HIERARCHY: joints nest by braces, one word of the grammar a line, but a brace may stand at the
// end of the line before. Ends at MOTION.
void parseHierarchy(TextReader& in, Bvh& bvh) {
  int open = -1;         // the joint whose braces we are in
  bool pending = false;  // a joint was named and its brace has still to come
  const auto openBrace = [&] {
    in.expect(pending, "a '{' that no joint asks for");
    pending = false;
    open = static_cast<int>(bvh.joints.size()) - 1;
  };
  while (in.nextLine()) {
    const std::string_view word = in.word();
    if (word == "{") {
      openBrace();
      expectLineDone(in);
      continue;
    }
    in.expect(!pending, "'{' expected after joint '", pending ? bvh.joints.back().name : "", "'");
    if (word == "ROOT" || word == "JOINT" || equal(word, "End", true)) {
      const bool end = word != "ROOT" && word != "JOINT";
      in.expect((word == "ROOT") == (open < 0),
                word == "ROOT" ? "ROOT inside another joint" : "a joint outside of any ROOT");
      in.expect(open < 0 || !bvh.joints[static_cast<std::size_t>(open)].endSite,
                "an end site has no children");
      std::string_view name = in.restOfLine();  // names may hold spaces
      const bool brace = name.ends_with('{');
      if (brace) name.remove_suffix(1);
      while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
      Bvh::Joint joint;
      joint.name = end ? bvh.joints[static_cast<std::size_t>(open)].name + " end" : name;
      in.expect(end || !name.empty(), "a joint without a name");
      in.expect(name.size() <= 256, "a joint's name of ", name.size(), " bytes (at most 256)");
      in.expect(!end || equal(name, "Site", true), "'End ", TextReader::shown(name),
                "': 'End Site' expected");
      joint.parent = open;
      joint.endSite = end;
      joint.firstChannel = static_cast<std::uint32_t>(bvh.channelCount);
      bvh.joints.push_back(std::move(joint));
      pending = true;
      if (brace) openBrace();
      continue;
    }
    if (word == "MOTION") {
      in.expect(open < 0, "MOTION before joint '", open < 0 ? "" : bvh.joints[open].name,
                "' is closed with '}'");
      in.expect(!bvh.joints.empty(), "MOTION without any ROOT before it");
      expectLineDone(in);
      return;
    }
    in.expect(open >= 0, "unexpected '", TextReader::shown(word), "' outside of any joint");
    Bvh::Joint& joint = bvh.joints[static_cast<std::size_t>(open)];
    if (word == "}") {
      open = joint.parent;
    } else if (word == "OFFSET") {
      for (int c = 0; c < 3; ++c) joint.offset[c] = in.number("OFFSET");
    } else if (word == "CHANNELS") {
      // Values are stored joint by joint as CHANNELS lines come: children's follow the parent's.
      joint.firstChannel = static_cast<std::uint32_t>(bvh.channelCount);
      parseChannels(in, bvh, joint);
    } else {
      in.fail("unexpected '", TextReader::shown(word), "' in joint '", joint.name, "'");
    }
    expectLineDone(in);
  }
  in.fail("the file ends inside HIERARCHY: no MOTION (truncated)");
}

void parseMotion(TextReader& in, Bvh& bvh) {
  in.expect(in.nextLine() && in.word() == "Frames:", "'Frames:' expected");
  const std::string_view countWord = in.word();
  const long long frames = in.toInteger(countWord, "Frames:");
  in.expect(frames >= 0, "Frames: ", frames);
  expectLineDone(in);
  in.expect(in.nextLine() && in.word() == "Frame" && in.word() == "Time:",
            "'Frame Time:' expected");
  const std::string_view timeWord = in.word();
  in.expect(!timeWord.empty(), "Frame Time: has no number");
  bvh.frameTime = in.toDouble(timeWord, "Frame Time:");
  in.expect(bvh.frameTime > 0, "Frame Time: ", bvh.frameTime, " is not above zero");
  expectLineDone(in);

  // A number and its separator take at least two bytes.
  const auto frameCount = static_cast<std::size_t>(frames);
  const std::size_t room = (in.left() + 1) / 2;
  in.expect(bvh.channelCount == 0 || frameCount <= room / bvh.channelCount, "Frames: ", frames,
            " of ", bvh.channelCount, " numbers do not fit in the ", in.left(),
            " bytes that are left (truncated, or a bad count)");
  if (bvh.channelCount == 0) return;  // nothing moves: rows are empty lines
  bvh.values.reserve(frameCount * bvh.channelCount);
  for (std::size_t f = 0; f < frameCount; ++f) {
    in.expect(in.nextLine(), "the file ends after ", f, " of ", frames, " frames (truncated)");
    for (std::size_t c = 0; c < bvh.channelCount; ++c) {
      in.expect(!in.lineDone(), "frame ", f, " has ", c, " of ", bvh.channelCount, " numbers");
      bvh.values.push_back(in.number("channel"));
    }
    in.expect(in.lineDone(), "frame ", f, " has more than ", bvh.channelCount, " numbers");
  }
  in.expect(!in.nextLine(), "text after the ", frames, " frames announced");
}

}  // namespace

int Bvh::find(std::string_view name, bool ignoreCase) const {
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (equal(joints[j].name, name, ignoreCase)) return static_cast<int>(j);
  return -1;
}

Bvh parseBvh(std::string_view bytes, std::string_view name) {
  TextReader in(bytes, name);
  in.expect(in.nextLine(), "the file is empty");
  in.expect(in.word() == "HIERARCHY", "'HIERARCHY' expected: this is no BVH file");
  Bvh bvh;
  parseHierarchy(in, bvh);
  parseMotion(in, bvh);
  return bvh;
}

Bvh readBvh(const std::filesystem::path& file) {
  return parseBvh(readWholeFile(file), file.string());
}

}  // namespace hair
