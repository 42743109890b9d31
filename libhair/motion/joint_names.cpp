#include <libhair/motion/joint_names.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

namespace hair {
namespace {

bool isUpper(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}
bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool contains(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

/// Letters and digits in lower case.
std::string plain(std::string_view name) {
  std::string out;
  for (char c : name)
    if (isLetter(c) || isDigit(c)) out += lower(c);
  return out;
}

/// Words in lower case: between punctuation, digits and changes of case (LHipJoint: l, hip, joint).
std::vector<std::string> words(std::string_view name) {
  std::vector<std::string> out(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!isLetter(c)) {
      out.emplace_back();
      continue;
    }
    const bool afterLower = i > 0 && isLetter(name[i - 1]) && !isUpper(name[i - 1]);
    const bool beforeLower = i + 1 < name.size() && isLetter(name[i + 1]) && !isUpper(name[i + 1]);
    const bool startsWord = isUpper(c) && (afterLower || (beforeLower && i > 0));
    if (startsWord) out.emplace_back();
    out.back() += lower(c);
  }
  std::erase(out, "");
  return out;
}

/// How long a beginning all names have in common, up to the end of a word.
std::size_t commonPrefix(const std::vector<std::string_view>& names) {
  if (names.size() < 3) return 0;
  std::size_t common = names[0].size();
  for (const std::string_view name : names) {
    std::size_t same = 0;
    while (same < std::min(common, name.size()) && name[same] == names[0][same]) ++same;
    common = same;
  }
  const auto endsWord = [&](std::string_view name) {
    return common >= name.size() || !isLetter(name[common]) || isUpper(name[common]) ||
           !isLetter(name[common - 1]);
  };
  while (common > 0 && !std::all_of(names.begin(), names.end(), endsWord)) --common;
  return common;
}

/// Words for left and right that may stand anywhere in a name; parts of words, lower case.
constexpr std::array<std::array<std::string_view, 2>, 8> kSides = {{{"left", "right"},
                                                                    {"links", "rechts"},
                                                                    {"gauche", "droite"},
                                                                    {"izquierd", "derech"},
                                                                    {"esquerd", "direit"},
                                                                    {"sinistr", "destr"},
                                                                    {"hidari", "migi"},
                                                                    {"左", "右"}}};

/// The side that a name says in words, which are cut out of `part`.
int sideInWords(std::string_view name, std::string& part) {
  for (const auto& pair : kSides) {
    const bool ascii = static_cast<unsigned char>(pair[0].front()) < 128;
    const std::string_view in = ascii ? std::string_view(part) : name;
    if (contains(in, pair[0]) == contains(in, pair[1])) continue;
    const int side = contains(in, pair[0]) ? 0 : 1;
    const std::string_view word = pair[static_cast<std::size_t>(side)];
    if (ascii) part.erase(part.find(word), word.size());
    return side;
  }
  // Words of a letter or two: there must be one only.
  static constexpr std::string_view kShort[2][3] = {{"l", "lt", "lft"}, {"r", "rt", "rgt"}};
  int side = -1, count = 0;
  std::string without;
  for (const std::string& word : words(name)) {
    const auto is = [&](const auto& all) {
      return std::find(std::begin(all), std::end(all), word) != std::end(all);
    };
    if (is(kShort[0]) || is(kShort[1])) {
      side = is(kShort[0]) ? 0 : 1;
      ++count;
    } else {
      without += word;
    }
  }
  if (count != 1) return -1;
  for (char c : name)  // words() has no digits
    if (isDigit(c)) without += c;
  part = without;
  return side;
}

/// Sides of names that differ in one letter, l and r.
void sidesOfPairs(std::vector<JointName>& joints) {
  std::map<std::string, std::size_t> byPart;
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].side < 0) byPart.emplace(joints[j].part, j);
  for (const auto& [part, left] : byPart) {
    for (std::size_t at = 0; at < part.size(); ++at) {
      if (part[at] != 'l') continue;
      std::string other = part;
      other[at] = 'r';
      const auto right = byPart.find(other);
      if (right == byPart.end()) continue;
      other.erase(at, 1);
      joints[left] = {other, 0};
      joints[right->second] = {other, 1};
      break;
    }
  }
}

std::string_view withoutNumber(std::string_view part) {
  while (!part.empty() && isDigit(part.back())) part.remove_suffix(1);
  return part;
}

struct Words {
  std::vector<std::string_view> are;   ///< that mean the part
  std::vector<std::string_view> not_;  ///< that, besides, mean something else
};

const Words& wordsFor(NamedPart part) {
  static const Words kHead = {
      {"head", "skull"}, {"top",    "end",   "nub",    "tip",   "eye",    "jaw",  "hair", "hat",
                          "fore",   "front", "target", "look",  "aim",    "ik",   "ctrl", "control",
                          "helper", "prop",  "attach", "twist", "socket", "mouth"}};
  static const Words kHand = {
      {"hand", "wrist"},
      {"thumb",  "index",  "middle", "ring",   "pinky", "little", "finger", "mid",   "end",
       "nub",    "tip",    "ik",     "target", "prop",  "roll",   "twist",  "ctrl",  "control",
       "helper", "attach", "weapon", "socket", "pole",  "palm",   "meta",   "carpal"}};
  static const Words kFoot = {{"foot", "ankle"},
                              {"toe", "ball", "heel", "ik", "roll", "end", "nub", "tip", "target",
                               "pole", "ctrl", "control", "helper", "bank", "pivot", "twist"}};
  static const Words kEye = {{"eye"},
                             {"brow", "lid", "lash", "end", "nub", "target", "ik", "ctrl"}};
  switch (part) {
    case NamedPart::Head:
      return kHead;
    case NamedPart::Hand:
      return kHand;
    case NamedPart::Foot:
      return kFoot;
    default:
      return kEye;
  }
}

}  // namespace

std::vector<JointName> jointNames(std::span<const std::string> names) {
  std::vector<std::string_view> own;
  for (const std::string& name : names) {
    const std::size_t space = name.find_last_of(":|");  // of namespaces and paths
    own.push_back(std::string_view(name).substr(space == std::string::npos ? 0 : space + 1));
  }
  const std::size_t prefix = commonPrefix(own);
  std::vector<JointName> joints;
  for (std::string_view name : own) {
    name.remove_prefix(prefix);
    JointName joint;
    joint.part = plain(name);
    joint.side = sideInWords(name, joint.part);
    joints.push_back(std::move(joint));
  }
  sidesOfPairs(joints);
  return joints;
}

int likeness(const JointName& name, NamedPart part) {
  const Words& words = wordsFor(part);
  const std::string_view bare = withoutNumber(name.part);
  for (const std::string_view word : words.are) {
    const std::size_t at = bare.rfind(word);
    if (at == std::string_view::npos) continue;
    std::string rest(bare);
    rest.erase(at, word.size());
    if (rest.empty()) return 3;
    const auto means = [&](std::string_view other) { return contains(rest, other); };
    if (std::any_of(words.not_.begin(), words.not_.end(), means)) continue;
    return bare.ends_with(word) ? 2 : 1;
  }
  return 0;
}

bool isTwist(const JointName& name, const JointName& parent) {
  if (contains(name.part, "twist") || contains(name.part, "roll")) return true;
  const std::string_view bare = withoutNumber(name.part);
  return !bare.empty() && name.side >= 0 && name.side == parent.side &&
         bare == withoutNumber(parent.part);
}

}  // namespace hair
