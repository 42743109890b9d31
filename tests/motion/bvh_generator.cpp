#include "bvh_generator.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>

namespace hair::test {
namespace {

using glm::dquat;
using glm::dvec3;

struct Bone {
  int parent;
  dvec3 offset, tip;  // metres, in the T pose
};

const std::array<Bone, kParts>& bones() {
  static const std::array<Bone, kParts> kBones = {{
      {-1, {0, 0, 0}, {}},
      {kHips, {0, .12, -.01}, {}},
      {kSpine, {0, .18, 0}, {}},
      {kChest, {0, .22, 0}, {}},
      {kNeck, {0, .09, .01}, {0, .22, 0}},
      {kChest, {.03, .17, .01}, {}},
      {kLeftCollar, {.13, .01, -.01}, {}},
      {kLeftShoulder, {.27, 0, 0}, {}},
      {kLeftElbow, {.25, 0, .01}, {.16, 0, 0}},
      {kChest, {-.03, .17, .01}, {}},
      {kRightCollar, {-.13, .01, -.01}, {}},
      {kRightShoulder, {-.27, 0, 0}, {}},
      {kRightElbow, {-.25, 0, .01}, {-.16, 0, 0}},
      {kHips, {.09, -.04, 0}, {}},
      {kLeftHip, {0, -.41, .005}, {}},
      {kLeftKnee, {0, -.41, -.025}, {0, -.07, .16}},
      {kHips, {-.09, -.04, 0}, {}},
      {kRightHip, {0, -.41, .005}, {}},
      {kRightKnee, {0, -.41, -.025}, {0, -.07, .16}},
  }};
  return kBones;
}

dquat about(dvec3 axis, double degrees) {
  return glm::angleAxis(glm::radians(degrees), glm::normalize(axis));
}
const dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

struct Locals {
  std::array<dquat, kParts> turn;
  dvec3 root;
};

Locals localsOf(Act act, int frame) {
  Locals l;
  l.turn.fill(dquat(1, 0, 0, 0));
  const double s = frame / double(kFrames - 1), swing = std::sin(2 * glm::pi<double>() * s);
  const double part = s * s * (3 - 2 * s);
  l.root = {0.02 * swing, 0.95, 0.6 * s};
  l.turn[kHead] = about(kX, 10 + 5 * swing) * about(kY, 12 * swing);
  for (int side : {0, 1}) {
    const double x = side == 0 ? 1 : -1;
    const int arm = side == 0 ? kLeftShoulder : kRightShoulder,
              leg = side == 0 ? kLeftHip : kRightHip;
    l.turn[arm] = about(kZ, x * (-70 + 8 * swing)) * about(kY, -x * 10 * swing);
    l.turn[arm + 1] = about(kY, -x * (25 + 10 * swing));
    l.turn[leg] = about(kX, x * 20 * swing - 5);
    l.turn[leg + 1] = about(kX, 15 - x * 10 * swing);
  }
  switch (act) {
    case Act::Walk:
      l.turn[kSpine] = about(kY, 6 * swing);
      break;
    case Act::Bow:
      l.turn[kSpine] = about(kX, 35 * part);
      l.turn[kChest] = about(kX, 30 * part);
      l.turn[kNeck] = about(kX, 20 * part);
      l.root.z = 0;
      break;
    case Act::LieDown:  // on the back, heels forward
      l.turn[kHips] = about(kX, -88 * part);
      l.root = {0, 0.95 - 0.83 * part, 0};
      break;
    case Act::Crawl:
      l.turn[kHips] = about(kX, 80);
      l.root = {0, 0.5, 0.4 * s};
      for (int leg : {kLeftHip, kRightHip}) {
        const double x = leg == kLeftHip ? 1 : -1;
        l.turn[leg] = about(kX, -80 + x * 15 * swing);
        l.turn[leg + 1] = about(kX, 85);
        l.turn[leg + 2] = about(kX, 60);
      }
      for (int arm : {kLeftShoulder, kRightShoulder}) {
        const double x = arm == kLeftShoulder ? 1 : -1;
        l.turn[arm] = about(kY, -x * 80) * about(kZ, x * 15 * swing);
        l.turn[arm + 1] = about(kY, -x * 10);
      }
      l.turn[kNeck] = about(kX, -35);
      l.turn[kHead] = about(kX, -25 + 5 * swing);
      break;
  }
  return l;
}

double random(std::uint32_t seed, std::uint32_t use) {
  std::uint32_t h = seed * 747796405u + use * 2891336453u + 12345u;
  h = ((h >> ((h >> 28) + 4)) ^ h) * 277803737u;
  return ((h >> 22) ^ h) / 4294967296.0;
}

dquat fromAxes(dvec3 x, dvec3 y) {
  return glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))));
}

/// The frame of a part's joint in the T pose of the person.
dquat restFrame(const Spelling& s, int part) {
  const double x = part >= kRightCollar && part <= kRightWrist ? -1 : 1;
  const bool arm = part >= kLeftShoulder && part <= kRightWrist && part != kRightCollar;
  switch (s.rig) {
    case Rig::A:
      return arm ? about(kZ, x * 45) : dquat(1, 0, 0, 0);
    case Rig::ArmsDown:
      return arm ? about(kZ, x * 88) : dquat(1, 0, 0, 0);
    case Rig::XBones:
      if (part <= kHead) return fromAxes(kY, kZ);
      if (part <= kRightWrist) return fromAxes(x * kX, kZ);
      return fromAxes(-kY, kZ);
    case Rig::Turned:
      return about(kZ, 90 * std::floor(4 * random(s.seed, 3 * part))) *
             about(kX, 90 * std::floor(4 * random(s.seed, 3 * part + 1)));
    case Rig::Lying:
      return about(kX, 90);
    case Rig::Tilted:
      return about({1, 2, 3}, 77);
    default:
      return {1, 0, 0, 0};
  }
}

/// World of the file from +Y up.
dquat fileFromWorld(const Spelling& s) {
  static const dquat kTurns[] = {about(kZ, -90), about(kY, 0),   about(kX, 90),
                                 about(kZ, 90),  about(kX, 180), about(kX, -90)};
  return kTurns[s.up] * about(kY, s.yaw);
}

/// Angles, degrees, of turns about axes a, b, c one after another, the first outermost.
dvec3 angles(dquat q, std::array<int, 3> axes) {
  const glm::dmat3 m = glm::mat3_cast(q);
  const auto at = [&](int row, int column) { return m[column][row]; };
  const auto [i, j, k] = axes;
  const double e = (j - i + 3) % 3 == 1 ? 1 : -1;
  const double sine = std::clamp(e * at(i, k), -1.0, 1.0);
  if (std::abs(sine) > 1 - 1e-12)
    return glm::degrees(dvec3(std::atan2(e * at(k, j), at(j, j)), std::asin(sine), 0));
  return glm::degrees(dvec3(std::atan2(-e * at(j, k), at(k, k)), std::asin(sine),
                            std::atan2(-e * at(i, j), at(i, i))));
}

constexpr std::array<std::array<int, 3>, 6> kOrders = {
    {{2, 0, 1}, {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 1, 0}}};

/// A joint of the file: of the person, or one more.
struct Node {
  std::string name;
  int parent;
  int part;           // whose rotation it has; -1: none
  dvec3 offset, tip;  // metres, in the frames of the rig
  dquat frame;
};

class Writer {
 public:
  explicit Writer(const Spelling& spelling) : s_(spelling) { build(); }

  std::string write() {
    using Text = Spelling::Text;
    line("HIERARCHY");
    hierarchy(0, 0);
    if (s_.text == Text::Comments) line("# by hand");
    line("MOTION");
    const int announced = kFrames - (s_.text == Text::OneMoreRow ? 1 : 0);
    line(std::string("Frames: ").append(std::to_string(announced)));
    line(s_.text == Text::Rate           ? "Frame Time: 30.0"
         : s_.text == Text::Milliseconds ? "Frame Time: 33.3333"
                                         : "Frame Time: 0.0333333");
    for (int f = 0; f < kFrames; ++f) row(f);
    if (s_.text == Text::TextAfter) line("end of file");
    if (s_.text == Text::ControlZ) out_ += "\x1a";
    return finished();
  }

 private:
  int add(const std::string& name, int parent, int part, dvec3 offset, dvec3 tip) {
    const dquat above = parent < 0 ? dquat(1, 0, 0, 0) : nodes_[std::size_t(parent)].frame;
    // Joints of no part are turned as what they hang on.
    dquat frame = part >= 0 ? restFrame(s_, part) : above;
    if (part >= 0 && s_.rigStandsSo && s_.rig != Rig::XBones && s_.rig != Rig::Turned)
      frame = glm::inverse(fileFromWorld(s_)) * frame;
    nodes_.push_back(
        {name, parent, part, glm::inverse(above) * offset, glm::inverse(frame) * tip, frame});
    return int(nodes_.size()) - 1;
  }

  void build() {
    int root = -1;
    if (s_.rootAbove) root = add(extra("Root"), -1, -1, {}, {});
    std::array<int, kParts> at{};
    for (int part = 0; part < kParts; ++part) {
      const Bone& bone = bones()[std::size_t(part)];
      int parent = bone.parent < 0 ? root : at[std::size_t(bone.parent)];
      dvec3 offset = bone.offset;
      if (s_.moreSpine && (part == kChest || part == kHead)) {
        parent = add(extra(part == kChest ? "SpineB" : "NeckB"), parent, -1, 0.4 * offset, {});
        offset *= 0.6;
      }
      if (s_.noNeck && part == kNeck) {  // the head hangs on the chest
        at[kNeck] = parent;
        neck_ = offset;
        continue;
      }
      if (s_.noNeck && part == kHead) offset += neck_;
      const int node = add(nameOf(s_, Part(part)), parent, part, offset,
                           s_.noTips ? dvec3(0, 1e-6, 0) : bone.tip);
      at[std::size_t(part)] = node;
      const double x = part >= kRightCollar && part <= kRightWrist ? -1 : 1;
      const char* side =
          part == kRightWrist || part == kRightElbow || part == kRightAnkle ? "Right" : "Left";
      if (s_.fingers && (part == kLeftWrist || part == kRightWrist))
        for (int f = 0; f < 3; ++f) {
          const int knuckle = add(extra(std::string(side) + "Finger" + char('A' + f)), node, -1,
                                  {x * .08, 0, .02 * (f - 1)}, {});
          add(extra(std::string(side) + "FingerTip" + char('A' + f)), knuckle, -1, {x * .04, 0, 0},
              {x * .03, 0, 0});
        }
      if (s_.twists && (part == kLeftElbow || part == kRightElbow))
        add(extra(std::string(side) + "ForeArmTwist"), node, -1, {x * .12, 0, 0}, {x * .01, 0, 0});
      if (s_.toes && (part == kLeftAnkle || part == kRightAnkle))
        add(extra(std::string(side) + "Toe"), node, -1, {0, -.06, .12}, {0, 0, .06});
      if (s_.eyes && part == kHead)
        for (double e : {1.0, -1.0})
          add(extra(e > 0 ? "LeftEye" : "RightEye"), node, -1, {e * .032, .07, .08}, {0, 0, .01});
      if (s_.hairBones && part == kHead) {
        const int lock = add(extra("HairBack"), node, -1, {0, .15, -.09}, {});
        add(extra("HairBackB"), lock, -1, {0, -.2, -.03}, {0, -.2, 0});
      }
    }
    if (s_.targets) {
      const int above = s_.rootAbove ? root : 0;
      for (const char* side : {"Left", "Right"}) {
        const double x = side[0] == 'L' ? 1 : -1;
        add(extra(std::string("ik_") + side + "_foot"), above, -1, {x * .1, .02, 0}, {});
        add(extra(std::string("ik_") + side + "_hand"), above, -1, {x * .3, .9, 0}, {});
      }
    }
  }

  std::string extra(const std::string& name) {
    return s_.names >= kTellingNames ? std::string("n").append(std::to_string(100 + extras_++))
                                     : name;
  }

  bool hasPositions(std::size_t n) const {
    return n == 0 || (s_.rootAbove && n == 1) || s_.positions != Spelling::Positions::Root;
  }

  void hierarchy(std::size_t n, int depth) {
    using Text = Spelling::Text;
    const Node& node = nodes_[n];
    const std::string in(std::size_t(depth), '\t'), brace = s_.text == Text::OneLine ? " {" : "";
    line(in + (node.parent < 0 ? "ROOT " : "JOINT ") + node.name + brace);
    if (brace.empty()) line(in + "{");
    const bool zero = s_.positions == Spelling::Positions::ZeroOffsets && node.parent >= 0;
    line(in + "\tOFFSET " + numbers(zero ? dvec3(0) : node.offset / s_.unit) +
         (s_.text == Text::Comments ? " # m" : ""));
    std::string channels = hasPositions(n) ? "6 Xposition Yposition Zposition" : "3";
    for (int axis : kOrders[std::size_t(s_.rotationOrder)])
      channels += std::string(" ") + char('X' + axis) + "rotation";
    line(in + "\tCHANNELS " + channels);
    bool leaf = true;
    for (std::size_t c = 0; c < nodes_.size(); ++c)
      if (nodes_[c].parent == int(n)) {
        leaf = false;
        hierarchy(c, depth + 1);
      }
    if (leaf) {
      line(in + "\tEnd Site" + (s_.text == Text::NamedEnds ? " Tip" : ""));
      line(in + "\t{");
      line(in + "\t\tOFFSET " + numbers(node.tip / s_.unit));
      if (s_.text == Text::EndChannels) line(in + "\t\tCHANNELS 1 Yrotation");
      line(in + "\t}");
    }
    line(in + "}");
  }

  void row(int f) {
    const Locals locals = localsOf(s_.act, f);
    std::string words;
    const std::function<void(std::size_t)> visit = [&](std::size_t n) {
      const Node& node = nodes_[n];
      const bool isHips = node.part == kHips;
      const dquat above =
          node.parent < 0 ? dquat(1, 0, 0, 0) : nodes_[std::size_t(node.parent)].frame;
      dquat local = node.part < 0 ? dquat(1, 0, 0, 0) : locals.turn[std::size_t(node.part)];
      if (s_.noNeck && node.part == kHead) local = locals.turn[kNeck] * local;
      local = glm::inverse(above) * local * node.frame;
      dvec3 place = node.offset / s_.unit;
      if (isHips) {  // nothing above it is turned
        local = fileFromWorld(s_) * local;
        place = fileFromWorld(s_) * locals.root / s_.unit;
      }
      if (hasPositions(n))
        words += numbers(s_.positions == Spelling::Positions::Added && node.parent >= 0
                             ? place - node.offset / s_.unit
                             : place) +
                 ' ';
      words += numbers(angles(local, kOrders[std::size_t(s_.rotationOrder)])) + ' ';
      bool leaf = true;
      for (std::size_t c = 0; c < nodes_.size(); ++c)
        if (nodes_[c].parent == int(n)) {
          leaf = false;
          visit(c);
        }
      if (leaf && s_.text == Spelling::Text::EndChannels) words += "33 ";
    };
    visit(0);
    if (s_.text == Spelling::Text::Wrapped)
      for (std::size_t at = words.find(' ', 80); at != std::string::npos;
           at = words.find(' ', at + 80))
        words[at] = '\n';
    line(words);
  }

  static std::string numbers(dvec3 v) {
    char buffer[120];
    std::snprintf(buffer, sizeof buffer, "%.8f %.8f %.8f", v.x, v.y, v.z);
    return buffer;
  }

  void line(const std::string& text) { out_ += text + '\n'; }

  std::string finished() const {
    using Text = Spelling::Text;
    std::string out = s_.text == Text::Bom ? "\xEF\xBB\xBF" : "";
    for (std::size_t i = 0; i < out_.size(); ++i) {
      const char c = out_[i];
      if (s_.text == Text::CrLf && c == '\n') out += '\r';
      out += s_.text == Text::Tabs && c == ' ' && i > out_.find("MOTION") ? '\t' : c;
    }
    if (s_.text == Text::LowerCase)
      for (const std::string word : {"HIERARCHY", "ROOT", "JOINT", "OFFSET", "CHANNELS", "End Site",
                                     "MOTION", "Frames", "Frame Time", "position", "rotation"})
        for (std::size_t at = 0; (at = out.find(word, at)) != std::string::npos; ++at)
          for (std::size_t i = 0; i < word.size(); ++i)
            out[at + i] = char(std::tolower(static_cast<unsigned char>(out[at + i])));
    return out;
  }

  const Spelling& s_;
  std::vector<Node> nodes_;
  dvec3 neck_{0};
  int extras_ = 0;
  std::string out_;
};

}  // namespace

PersonPose poseOf(Act act, int frame) {
  const Locals locals = localsOf(act, frame);
  PersonPose pose;
  std::array<dquat, kParts> turn;
  for (int part = 0; part < kParts; ++part) {
    const Bone& bone = bones()[std::size_t(part)];
    const std::size_t p = std::size_t(part), above = std::size_t(std::max(bone.parent, 0));
    turn[p] = bone.parent < 0 ? locals.turn[p] : turn[above] * locals.turn[p];
    pose.places.push_back(bone.parent < 0 ? locals.root
                                          : pose.places[above] + turn[above] * bone.offset);
  }
  pose.turns.assign(turn.begin(), turn.end());
  pose.headUp = turn[kHead] * kY;
  pose.headFront = turn[kHead] * kZ;
  return pose;
}

std::string nameOf(const Spelling& s, Part part) {
  const bool right = (part >= kRightCollar && part <= kRightWrist) || part >= kRightHip;
  const bool sided = part >= kLeftCollar;
  // One spelling of the part each; sides apart.
  static const char* const kOne[] = {"Hips",     "Spine", "Chest", "Neck", "Head", "Collar",
                                     "Shoulder", "Elbow", "Wrist", "Hip",  "Knee", "Ankle"};
  static const char* const kTwo[] = {"Pelvis",   "Spine",   "Spine1", "Neck",  "Head", "Clavicle",
                                     "UpperArm", "Forearm", "Hand",   "Thigh", "Calf", "Foot"};
  static const char* const kThree[] = {"Hips", "Spine",   "Spine2", "Neck",  "Head", "Shoulder",
                                       "Arm",  "ForeArm", "Hand",   "UpLeg", "Leg",  "Foot"};
  static const char* const kOther[] = {"Becken", "Wirbel",     "Brust",   "Hals",
                                       "Kopf",   "Schluessel", "Oberarm", "Unterarm",
                                       "Faust",  "Schenkel",   "Wade",    "Sohle"};
  const int one = part < kLeftCollar    ? int(part)
                  : part < kRightCollar ? int(part)
                  : part < kLeftHip     ? int(part) - 4
                  : part < kRightHip    ? int(part) - 4
                                        : int(part) - 7;
  const auto lower = [](std::string word) {
    for (char& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
    return word;
  };
  const std::string a = kOne[one], b = kTwo[one], c = kThree[one];
  const std::string side = sided ? (right ? "Right" : "Left") : "",
                    letter = sided ? (right ? "R" : "L") : "";
  const auto with = [&](const std::string& before, const std::string& after) {
    return sided ? before + after : std::string();
  };
  switch (s.names) {
    case 0:
      return side + a;
    case 1:
      return "Bip01 " + with(letter, " ") + b;
    case 2:
      return "Bip01_" + with(letter, "_") + b;
    case 3:
      return "mixamorig:" + side + c;
    case 4:
      return "mixamorig" + side + c;
    case 5:
      return "Character1_" + side + c;
    case 6:
      return "CC_Base_" + with(letter, "_") + b;
    case 7:
      return "J_Bip_" + (sided ? letter : "C") + "_" + b;
    case 8:
      return "DEF-" + lower(b) + with(".", letter);
    case 9:
      return "Robot_" + side + c;
    case 10:
      return a + "_" + (sided ? letter : "M");
    case 11:
      return lower(b) +
             (one == 1 || one == 2 ? std::string("_0").append(std::to_string(one)) : "") +
             with("_", lower(letter));
    case 12:
      return lower(letter + b);  // lhand, rhand
    case 13:
      return sided ? a + ' ' + side : a;
    case 14:
      return std::string(kOther[one]) + (sided ? (right ? " rechts" : " links") : "");
    case 15:
      return std::string("joint").append(std::to_string(int(part)));
    default:
      return std::string(1, char('A' + (7 * int(part)) % 23)) + std::to_string(3 * int(part));
  }
}

std::string bvhOf(const Spelling& spelling) {
  return Writer(spelling).write();
}

}  // namespace hair::test
