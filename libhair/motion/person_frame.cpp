#include <libhair/motion/person_frame.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/motion/rest_stance.h>
#include <libhair/motion/rig_structure.h>

namespace hair {
namespace {

constexpr float kDancerHeight = 1.68f,
                kDancerLength = 1.41f;  ///< of one person: metres, bodyLength

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// Unit of a length and the heights of people in metres for which it is believed: the usual ones
/// for children too.
struct Unit {
  float metres, shortest, tallest;
};
constexpr Unit kUnits[] = {
    {1.0f, 0.9f, 2.4f},    {0.01f, 0.9f, 2.4f}, {0.001f, 0.9f, 2.4f},     {0.0254f, 1.4f, 2.1f},
    {0.3048f, 1.4f, 2.1f}, {0.1f, 1.4f, 2.1f},  {0.0564444f, 1.4f, 2.1f},  // 0.0254 / 0.45
};
constexpr float kUnitOfMost = 0.01f, kPerson = 1.7f;

/// The longest way through a skeleton along its bones.
float spanOf(const Skeleton& skeleton) {
  std::vector<float> reach(skeleton.jointCount());
  float longest = 0;
  for (std::size_t j = reach.size(); j-- > 0;) {
    const float tip = glm::length(skeleton.tips[j]);
    longest = std::max(longest, reach[j] + tip);
    reach[j] = std::max(reach[j], tip);
    if (skeleton.parents[j] < 0) continue;
    float& above = reach[index(skeleton.parents[j])];
    const float here = reach[j] + glm::length(skeleton.offsets[j]);
    longest = std::max(longest, above + here);
    above = std::max(above, here);
  }
  return longest;
}

glm::vec3 axisOf(ClipUp up) {
  glm::vec3 axis(0);
  const int a = (static_cast<int>(up) - 1) % 3;
  axis[a] = up >= ClipUp::XDown ? -1.0f : 1.0f;
  return axis;
}

constexpr std::array kAxes = {ClipUp::Y,     ClipUp::Z,     ClipUp::X,
                              ClipUp::YDown, ClipUp::ZDown, ClipUp::XDown};

/// What a clip shows of one axis.
struct Evidence {
  float upright = 0;      ///< share of the frames in which the body is upright along it
  float startsSo = 0;     ///< the first of them
  bool floor = false;     ///< the lowest joints keep to a floor at zero
  bool zeroPose = false;  ///< the skeleton's zero pose stands along it
};

Evidence evidenceFor(glm::vec3 up, const Clip& clip, const BodyMap& map, float stature) {
  Evidence e;
  std::vector<RigidTransform> pose(clip.skeleton.jointCount());
  const auto at = [&](int j) { return pose[index(j)].translation; };
  std::vector<float> lowest;
  const std::size_t step = clip.frameCount() / 200 + 1;
  // A pose for calibration may open the clip.
  const std::size_t first = std::min(leadInFrames(clip), clip.frameCount() - 1);
  for (std::size_t f = first; f < clip.frameCount(); f += step) {
    poseAtFrame(clip, f, pose);
    const glm::vec3 feet = 0.5f * (at(map.foot[0]) + at(map.foot[1]));
    const auto along = [&](glm::vec3 d) { return glm::dot(d, up) / glm::length(d); };
    const bool upright =
        along(at(map.neck) - at(map.hips)) > 0.7f && along(at(map.head) - feet) > 0.6f;
    // Thighs at a right angle to the trunk: who sits, or crawls along the axis.
    const glm::vec3 thighs =
        at(map.thigh[0]) - at(map.shin[0]) + at(map.thigh[1]) - at(map.shin[1]);
    const float counts = !upright ? 0.0f : (along(thighs) > 0.5f ? 1.0f : 0.6f);
    e.upright += counts;
    if (f == first) e.startsSo = counts;
    lowest.push_back(INFINITY);
    for (int j : {map.head, map.hips, map.hand[0], map.hand[1], map.shin[0], map.shin[1],
                  map.foot[0], map.foot[1]})
      lowest.back() = std::min(lowest.back(), glm::dot(at(j), up));
  }
  e.upright /= static_cast<float>(lowest.size());
  std::sort(lowest.begin(), lowest.end());
  const float low = lowest[lowest.size() / 10] / stature, mid = lowest[lowest.size() / 2] / stature;
  e.floor = low > -0.05f && low < 0.15f && mid - low < 0.08f;
  e.zeroPose = standsAlong(map, zeroPose(clip.skeleton), up);
  return e;
}

}  // namespace

ClipUp clipUpFromText(std::string_view text) {
  std::string word;
  for (char c : text) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  bool down = word.ends_with("-down");
  if (down) word.resize(word.size() - 5);
  if (word == "z-back") word = "z";
  if (word.size() == 2 && (word[0] == '+' || word[0] == '-')) {
    down = down != (word[0] == '-');
    word.erase(0, 1);
  }
  require(word.size() == 1 && word[0] >= 'x' && word[0] <= 'z', "'", text,
          "' is no axis: x, y, z, x-down, y-down or z-down");
  return static_cast<ClipUp>(word[0] - 'x' + 1 + (down ? 3 : 0));
}

std::string_view clipUpText(ClipUp up) {
  static constexpr std::string_view kTexts[] = {"recognised", "+X", "+Y", "+Z", "-X", "-Y", "-Z"};
  return kTexts[static_cast<std::size_t>(up)];
}

glm::quat uprightFromClip(ClipUp up) {
  const float half = std::sqrt(0.5f);
  switch (up) {
    case ClipUp::X:
      return {half, 0, 0, half};  // X to Y
    case ClipUp::XDown:
      return {half, 0, 0, -half};
    case ClipUp::Z:
      return {half, -half, 0, 0};  // Z to Y, -Y to Z
    case ClipUp::ZDown:
      return {half, half, 0, 0};
    case ClipUp::YDown:
      return {0, 0, 0, 1};  // half a turn about Z
    default:
      return {1, 0, 0, 0};
  }
}

float sizeOf(const Skeleton& skeleton, const BodyMap& map) {
  if (!map.complete()) return 0;
  // Ankle to head along the bones: does not depend on the pose.
  const auto thigh = [&](std::size_t s) { return boneLength(skeleton, map.thigh[s], map.shin[s]); };
  const auto shin = [&](std::size_t s) { return boneLength(skeleton, map.shin[s], map.foot[s]); };
  float length = 0.5f * (thigh(0) + thigh(1) + shin(0) + shin(1));
  for (int j = map.head; j >= 0 && j != map.hips; j = skeleton.parents[index(j)])
    length += glm::length(skeleton.offsets[index(j)]);
  return length / kDancerLength;
}

float statureOf(const Skeleton& skeleton, const BodyMap& map) {
  return kDancerHeight * sizeOf(skeleton, map);
}

float unitOf(const Skeleton& skeleton, const BodyMap& map) {
  const float stature = statureOf(skeleton, map);
  if (stature > 1e-6f && stature < 1e9f) {
    for (const Unit& unit : kUnits) {
      const float height = unit.metres * stature;
      if (height >= unit.shortest && height <= unit.tallest) return unit.metres;
    }
    return kPerson / stature;
  }
  // Whatever moves there: centimetres, unless it were a giant's or a toy's.
  const float span = spanOf(skeleton);
  if (!(span > 1e-6f && span < 1e9f) || (span > 20 && span < 500)) return kUnitOfMost;
  for (const float unit : {1.0f, 0.001f})
    if (unit * span > 0.2f && unit * span < 5) return unit;
  return kUnitOfMost;
}

ClipUp upOf(const Clip& clip, const BodyMap& map) {
  const float stature = statureOf(clip.skeleton, map);
  if (!(stature > 1e-6f && stature < 1e9f)) return ClipUp::Y;
  ClipUp best = ClipUp::Y;
  float most = 0;
  for (const ClipUp up : kAxes) {
    const Evidence e = evidenceFor(axisOf(up), clip, map, stature);
    const float score = 0.85f * e.upright + 0.2f * e.startsSo + (e.floor ? 0.9f : 0.0f) +
                        (e.zeroPose ? 0.5f : 0.0f) + (up == ClipUp::Y ? 0.3f : 0.0f);
    // A floor and a zero pose prove nothing where nobody ever stands.
    if (up != ClipUp::Y && e.upright < 0.2f) continue;
    if (score > most) {
      most = score;
      best = up;
    }
  }
  return best;
}

void makeUpright(Clip& clip, ClipUp up) {
  const glm::quat turn = uprightFromClip(up);
  if (up == ClipUp::Y || up == ClipUp::Recognised) return;
  const std::size_t joints = clip.skeleton.jointCount();
  for (std::size_t j = 0; j < joints; ++j) {
    if (clip.skeleton.parents[j] >= 0) continue;
    clip.skeleton.offsets[j] = turn * clip.skeleton.offsets[j];
    for (std::size_t i = j; i < clip.rotations.size(); i += joints) {
      clip.rotations[i] = glm::normalize(turn * clip.rotations[i]);
      clip.positions[i] = turn * clip.positions[i];
    }
  }
}

}  // namespace hair
