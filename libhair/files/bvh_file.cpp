#include <libhair/files/bvh_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include <libhair/files/byte_reader.h>
#include <libhair/files/text_reader.h>

namespace hair {

namespace {

bool equal(std::string_view a, std::string_view b, bool ignoreCase) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](unsigned char x, unsigned char y) {
    return ignoreCase ? std::tolower(x) == std::tolower(y) : x == y;
  });
}

/// Keywords have any case.
bool is(std::string_view word, std::string_view keyword) {
  return equal(word, keyword, true);
}

/// Whether what is left of the line is a comment: no number or keyword starts like one.
bool startsComment(const TextReader& in) {
  return in.front() == '#' || in.front() == ';' || in.front() == '/';
}

/// Goes on to the next line that holds more than a comment.
bool nextLine(TextReader& in) {
  while (in.nextLine())
    if (!startsComment(in)) return true;
  return false;
}

bool lineDone(const TextReader& in) {
  return in.lineDone() || startsComment(in);
}

void expectLineDone(const TextReader& in) {
  in.expect(lineDone(in), "unexpected '", TextReader::shown(in.restOfLine()), "'");
}

Bvh::Channel channelOf(const TextReader& in, std::string_view word) {
  static constexpr std::array<std::string_view, 6> kNames = {"Xposition", "Yposition", "Zposition",
                                                             "Xrotation", "Yrotation", "Zrotation"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (is(word, kNames[i])) return static_cast<Bvh::Channel>(i);
  in.fail("'", TextReader::shown(word), "' is no channel (Xposition ... Zrotation)");
}

/// HIERARCHY: joints nest by braces. Ends after MOTION.
class HierarchyParser {
 public:
  HierarchyParser(TextReader& in, Bvh& bvh) : in_(in), bvh_(bvh) {}

  void parse() {
    while (nextLine(in_))
      while (!lineDone(in_))
        if (!take(in_.word())) return;
    in_.fail("the file ends inside HIERARCHY: no MOTION (truncated)");
  }

 private:
  Bvh::Joint& open() { return bvh_.joints[static_cast<std::size_t>(open_)]; }

  /// False at MOTION.
  bool take(std::string_view word) {
    // A brace needs no blank after it.
    if (word.size() > 1 && (word.front() == '{' || word.front() == '}'))
      return take(word.substr(0, 1)) && take(word.substr(1));
    if (word == "{") {
      in_.expect(pending_, "a '{' that no joint asks for");
      pending_ = false;
      open_ = static_cast<int>(bvh_.joints.size()) - 1;
      return true;
    }
    in_.expect(!pending_, "'{' expected after joint '", pending_ ? bvh_.joints.back().name : "",
               "'");
    if (is(word, "ROOT") || is(word, "JOINT")) {
      takeJoint(is(word, "ROOT"));
    } else if (is(word, "End") || is(word, "EndSite")) {
      takeEndSite(is(word, "EndSite"));
    } else if (is(word, "MOTION")) {
      in_.expect(open_ < 0, "MOTION before joint '", open_ < 0 ? "" : open().name,
                 "' is closed with '}'");
      in_.expect(!bvh_.joints.empty(), "MOTION without any ROOT before it");
      expectLineDone(in_);
      return false;
    } else {
      in_.expect(open_ >= 0, "unexpected '", TextReader::shown(word), "' outside of any joint");
      if (word == "}") {
        open_ = open().parent;
      } else if (is(word, "OFFSET")) {
        for (int c = 0; c < 3; ++c) open().offset[c] = in_.number("OFFSET");
      } else if (is(word, "CHANNELS")) {
        takeChannels();
      } else {
        in_.fail("unexpected '", TextReader::shown(word), "' in joint '", open().name, "'");
      }
    }
    return true;
  }

  /// The rest of the line as a name, which may hold spaces; and a brace behind it.
  std::string takeName(bool& brace) {
    std::string_view name = in_.restOfLine();
    const std::size_t stop = name.find('{');
    brace = stop != std::string_view::npos;
    name = name.substr(0, stop);
    while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
    std::string kept(name);
    if (!brace) {
      while (!in_.lineDone()) in_.word();
      return kept;
    }
    // Goes on behind the brace: words of the name, the last of which may have the brace in it.
    for (std::string_view word = in_.word();; word = in_.word()) {
      const std::size_t at = word.find('{');
      if (at == std::string_view::npos) continue;
      behindBrace_ = word.substr(at + 1);
      return kept;
    }
  }

  void add(Bvh::Joint joint, bool brace) {
    in_.expect(joint.name.size() <= 256, "a joint's name of ", joint.name.size(),
               " bytes (at most 256)");
    joint.parent = open_;
    joint.firstChannel = static_cast<std::uint32_t>(bvh_.channelCount);
    bvh_.joints.push_back(std::move(joint));
    pending_ = true;
    if (!brace) return;
    take("{");
    const std::string_view more = std::exchange(behindBrace_, {});
    if (!more.empty()) take(more);
  }

  void takeJoint(bool root) {
    in_.expect(root == (open_ < 0),
               root ? "ROOT inside another joint" : "a joint outside of any ROOT");
    in_.expect(open_ < 0 || !open().endSite, "an end site has no children");
    bool brace = false;
    Bvh::Joint joint;
    joint.name = takeName(brace);
    in_.expect(!joint.name.empty(), "a joint without a name");
    add(std::move(joint), brace);
  }

  void takeEndSite(bool oneWord) {
    in_.expect(open_ >= 0, "a joint outside of any ROOT");
    in_.expect(!open().endSite, "an end site has no children");
    bool brace = false;
    const std::string name = takeName(brace);
    in_.expect(
        oneWord || (name.size() >= 4 && is(name.substr(0, 4), "Site") &&
                    (name.size() == 4 || !std::isalnum(static_cast<unsigned char>(name[4])))),
        "'End ", TextReader::shown(name), "': 'End Site' expected");
    Bvh::Joint joint;
    joint.name = open().name.substr(0, 252) + " end";
    joint.endSite = true;
    add(std::move(joint), brace);
  }

  void takeChannels() {
    Bvh::Joint& joint = open();
    in_.expect(joint.channels.empty(), "joint '", joint.name, "' has a second CHANNELS");
    // Values are stored joint by joint as CHANNELS lines come: children's follow the parent's.
    joint.firstChannel = static_cast<std::uint32_t>(bvh_.channelCount);
    const std::string_view countWord = in_.word();
    const long long count = in_.toInteger(countWord, "count of channels");
    // The names are in the same line, so a bad count runs out of words and cannot allocate.
    in_.expect(count >= 0, "count of channels is ", count);
    for (long long c = 0; c < count; ++c) {
      const std::string_view word = in_.word();
      in_.expect(!word.empty(), "joint '", joint.name, "' announces ", count, " channels, names ",
                 c);
      joint.channels.push_back(channelOf(in_, word));
    }
    bvh_.channelCount += joint.channels.size();
  }

  TextReader& in_;
  Bvh& bvh_;
  int open_ = -1;         // the joint whose braces we are in
  bool pending_ = false;  // a joint was named and its brace has still to come
  std::string_view behindBrace_;
};

/// Whether the next words are those of `keyword`, with its colon, which stands alone or is glued
/// to what is before or behind it. Goes on to the value.
bool takeLabel(TextReader& in, std::string_view keyword, std::string_view& value) {
  const std::string_view line = in.restOfLine();
  std::size_t at = 0;
  for (char c : keyword) {
    if (c == ' ') {
      while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) ++at;
      continue;
    }
    if (at >= line.size() || std::tolower(static_cast<unsigned char>(line[at])) != c) return false;
    ++at;
  }
  const auto skip = [&](std::string_view these) {
    while (at < line.size() && these.find(line[at]) != std::string_view::npos) ++at;
  };
  skip(" \t");
  if (at >= line.size() || line[at] != ':') return false;
  ++at;
  skip(" \t");
  const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
  value = line.substr(at, end - at);
  // Leave behind the value what is behind it.
  while (!in.lineDone() && in.restOfLine().data() < line.data() + end) in.word();
  return true;
}

class MotionParser {
 public:
  MotionParser(TextReader& in, Bvh& bvh) : in_(in), bvh_(bvh), width_(bvh.channelCount) {}

  void parse() {
    parseHead();
    if (width_ == 0) return;  // nothing moves: rows are empty lines
    bvh_.values.reserve(announced_ * width_);
    parseRows();
    judgeRows();
  }

 private:
  void parseHead() {
    std::string_view word;
    in_.expect(nextLine(in_) && takeLabel(in_, "frames", word), "'Frames:' expected");
    const long long frames = in_.toInteger(word, "Frames:");
    in_.expect(frames >= 0, "Frames: ", frames);
    expectLineDone(in_);
    in_.expect(nextLine(in_) && takeLabel(in_, "frame time", word), "'Frame Time:' expected");
    in_.expect(!word.empty(), "Frame Time: has no number");
    const double stated = in_.toDouble(word, "Frame Time:");
    in_.expect(stated >= 0, "Frame Time: ", stated, " is not above zero");
    bvh_.frameTime = frameTimeMeant(stated);
    if (bvh_.frameTime != stated)
      bvh_.notes.push_back(text("a frame time of ", stated, " s cannot be: taken as ",
                                bvh_.frameTime, " s, ", std::round(100 / bvh_.frameTime) / 100,
                                " frames a second"));
    expectLineDone(in_);

    // A number and its separator take at least two bytes.
    announced_ = static_cast<std::size_t>(frames);
    const std::size_t room = (in_.left() + 1) / 2;
    in_.expect(width_ == 0 || announced_ <= room / width_ + 1, "Frames: ", frames, " of ", width_,
               " numbers do not fit in the ", in_.left(),
               " bytes that are left (truncated, or a bad count)");
  }

  std::size_t rows() const { return bvh_.values.size() / width_; }

  void parseRows() {
    while (in_.nextLine()) {
      const std::size_t before = bvh_.values.size();
      if (startsComment(in_)) continue;
      // The rows that were announced are numbers; after them there may be anything.
      if (rows() >= announced_ && before % width_ == 0 && !startsNumber(in_.front())) {
        textAfter_ = true;
        return;
      }
      while (!lineDone(in_)) bvh_.values.push_back(in_.number("channel"));
      const std::size_t here = bvh_.values.size() - before;
      if (before % width_ == 0)
        in_.expect(here < width_ || here % width_ == 0, "frame ", before / width_,
                   " has more than ", width_, " numbers");
      else if (here > width_)
        failAtShortRow();
      if (bvh_.values.size() % width_ != 0 && !shortRow_) {
        shortRow_ = true;
        shortLine_ = in_.lineNumber();
        shortFrame_ = rows();
        shortCount_ = bvh_.values.size() % width_;
      }
    }
  }

  static bool startsNumber(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  }

  [[noreturn]] void failAtShortRow() const {
    in_.failAt(shortLine_, "frame ", shortFrame_, " has ", shortCount_, " of ", width_, " numbers");
  }

  void judgeRows() {
    // Rows that wrap over lines are whole together; a row that lacks numbers is whole nowhere.
    const bool whole = bvh_.values.size() % width_ == 0;
    if (!whole || (shortRow_ && rows() != announced_)) failAtShortRow();
    if (shortRow_) bvh_.notes.emplace_back("rows of numbers wrap over lines: joined");
    if (rows() > announced_) {
      bvh_.notes.push_back(text(rows(), " frames, ", announced_, " were announced: all are read"));
    } else if (rows() < announced_) {
      // Some programs count the intervals' ends otherwise; a torn file mostly tears a row.
      in_.expect(rows() + 1 == announced_ && rows() > 0 && in_.lineEnded(), "the file ends after ",
                 rows(), " of ", announced_, " frames (truncated)");
      bvh_.notes.push_back(
          text(rows(), " frames, ", announced_, " were announced: the last is missing"));
    }
    if (textAfter_) bvh_.notes.emplace_back("text after the last frame: left out");
  }

  TextReader& in_;
  Bvh& bvh_;
  const std::size_t width_;
  std::size_t announced_ = 0;
  bool textAfter_ = false;
  // The first line that ends inside a row.
  bool shortRow_ = false;
  std::size_t shortLine_ = 0, shortFrame_ = 0, shortCount_ = 0;
};

}  // namespace

double frameTimeMeant(double stated) {
  constexpr double kShortestRate = 1;  // a frame a second: nothing moves as slowly
  if (stated > 0 && stated < kShortestRate) return stated;
  static constexpr double kRates[] = {12,  15,  23.976, 24,  25,  29.97,  30,  48,  50,  59.94,
                                      60,  72,  75,     90,  100, 119.88, 120, 144, 150, 180,
                                      200, 240, 250,    300, 360, 400,    480, 500, 960, 1000};
  // The usual rate that is nearest, if one is near.
  const auto usual = [](double rate) {
    const double* nearest = std::min_element(
        std::begin(kRates), std::end(kRates),
        [&](double a, double b) { return std::abs(a - rate) < std::abs(b - rate); });
    return std::abs(*nearest - rate) < 0.002 * rate ? *nearest : 0.0;
  };
  double rate = stated;
  if (stated == 0)
    rate = 60;
  else if (usual(stated) == 0)
    rate = (stated > 1000 ? 1e6 : 1e3) / stated;  // microseconds, milliseconds
  if (const double known = usual(rate); known > 0) rate = known;
  return std::max(1.0, std::round(1e7 / rate)) / 1e7;
}

int Bvh::find(std::string_view name, bool ignoreCase) const {
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (equal(joints[j].name, name, ignoreCase)) return static_cast<int>(j);
  return -1;
}

Bvh parseBvh(std::string_view bytes, std::string_view name) {
  TextReader in(bytes, name);
  in.expect(!bytes.starts_with("\xFF\xFE") && !bytes.starts_with("\xFE\xFF"),
            "text in UTF-16; save it as UTF-8 or ASCII");
  in.expect(nextLine(in), "the file is empty");
  in.expect(is(in.word(), "HIERARCHY"), "'HIERARCHY' expected: this is no BVH file");
  expectLineDone(in);
  Bvh bvh;
  HierarchyParser(in, bvh).parse();
  MotionParser(in, bvh).parse();
  return bvh;
}

Bvh readBvh(const std::filesystem::path& file) {
  return parseBvh(readWholeFile(file), file.string());
}

}  // namespace hair
