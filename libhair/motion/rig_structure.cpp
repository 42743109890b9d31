#include <libhair/motion/rig_structure.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hair {
namespace {

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

int parentOf(const Skeleton& skeleton, int joint) {
  return joint < 0 ? -1 : skeleton.parents[index(joint)];
}

/// From a joint up to its root, itself first.
std::vector<int> ancestry(const Skeleton& skeleton, int joint) {
  std::vector<int> path;
  for (; joint >= 0; joint = parentOf(skeleton, joint)) path.push_back(joint);
  return path;
}

int deepestCommon(const Skeleton& skeleton, int a, int b) {
  const std::vector<int> pathA = ancestry(skeleton, a), pathB = ancestry(skeleton, b);
  for (int j : pathA)
    if (std::find(pathB.begin(), pathB.end(), j) != pathB.end()) return j;
  return -1;
}

bool within(float a, float b, float part) {
  return std::abs(a - b) <= part * std::max(a, b);
}

/// A limb or neck: joints from below a branch to the end of the longest way down.
struct Chain {
  int branch = -1;
  std::vector<int> joints;
  std::vector<float> bones;  ///< [joints + 1]: into each joint; the last, from the end to its tip
  float length = 0;
};

class Structure {
 public:
  Structure(const Clip& clip, std::span<const JointName> names)
      : clip_(clip), skeleton_(clip.skeleton), names_(names) {
    const std::size_t count = skeleton_.jointCount();
    children_.resize(count);
    reach_.assign(count, 0);
    for (std::size_t j = count; j-- > 0;) {
      reach_[j] = std::max(reach_[j], glm::length(skeleton_.tips[j]));
      const int parent = skeleton_.parents[j];
      if (parent < 0) continue;
      children_[index(parent)].push_back(static_cast<int>(j));
      reach_[index(parent)] =
          std::max(reach_[index(parent)], bone(static_cast<int>(j)) + reach_[j]);
    }
    for (std::vector<int>& siblings : children_) std::reverse(siblings.begin(), siblings.end());
  }

  BodyMap find() {
    BodyMap map;
    const std::vector<std::pair<Chain, Chain>> pairs = limbPairs();
    const auto [legs, arms] = legsAndArms(pairs);
    if (!legs || !arms) return map;
    for (std::size_t s = 0; s < 2; ++s) {
      const Chain& leg = s == 0 ? legs->first : legs->second;
      const Chain& arm = s == 0 ? arms->first : arms->second;
      map.foot[s] = endOfLimb(leg);
      map.hand[s] = endOfLimb(arm);
    }
    map.head = headAbove(*arms, boneLength(skeleton_, arms->first.branch, map.hand[0]));
    if (map.head < 0 || map.hand[0] < 0 || map.hand[1] < 0 || map.foot[0] < 0 || map.foot[1] < 0)
      return map;
    mapBetween(skeleton_, names_, map);
    if (map.complete()) nameSides(map);
    return map;
  }

 private:
  float bone(int joint) const { return glm::length(skeleton_.offsets[index(joint)]); }

  Chain chainFrom(int first) const {
    Chain chain;
    chain.branch = parentOf(skeleton_, first);
    for (int j = first; j >= 0;) {
      if (chain.joints.empty() || !isTwist(names_[index(j)], names_[index(chain.joints.back())])) {
        chain.joints.push_back(j);
        chain.bones.push_back(bone(j));
      } else {
        chain.bones.back() += bone(j);
      }
      int next = -1;
      for (int c : children_[index(j)])
        if (next < 0 || bone(c) + reach_[index(c)] > bone(next) + reach_[index(next)]) next = c;
      if (next < 0) chain.bones.push_back(glm::length(skeleton_.tips[index(j)]));
      j = next;
    }
    for (float b : chain.bones) chain.length += b;
    return chain;
  }

  /// Chains from the same joint with the same bones.
  std::vector<std::pair<Chain, Chain>> limbPairs() const {
    std::vector<std::pair<Chain, Chain>> pairs;
    for (std::vector<int> siblings : children_) {
      if (siblings.size() < 2) continue;
      // The longest are enough, whatever else hangs there.
      constexpr std::size_t kMost = 12;
      std::stable_sort(siblings.begin(), siblings.end(), [&](int a, int b) {
        return bone(a) + reach_[index(a)] > bone(b) + reach_[index(b)];
      });
      siblings.resize(std::min(siblings.size(), kMost));
      std::vector<Chain> chains;
      for (int c : siblings) chains.push_back(chainFrom(c));
      for (std::size_t a = 0; a < chains.size(); ++a)
        for (std::size_t b = a + 1; b < chains.size(); ++b)
          if (alike(chains[a], chains[b])) pairs.emplace_back(chains[a], chains[b]);
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& p, const auto& q) { return p.first.length > q.first.length; });
    constexpr std::size_t kMostPairs = 24;
    if (pairs.size() > kMostPairs) pairs.erase(pairs.begin() + kMostPairs, pairs.end());
    return pairs;
  }

  static bool alike(const Chain& a, const Chain& b) {
    if (a.joints.size() < 2 || a.joints.size() != b.joints.size() || !(a.length > 0)) return false;
    for (std::size_t i = 0; i + 1 < a.bones.size(); ++i)
      if (std::abs(a.bones[i] - b.bones[i]) > 0.05f * a.length) return false;
    return within(a.length, b.length, 0.15f);
  }

  bool isBelow(int joint, int above) const {
    for (; joint >= 0; joint = parentOf(skeleton_, joint))
      if (joint == above) return true;
    return false;
  }

  using Pair = const std::pair<Chain, Chain>*;
  /// Legs: the longest pair of which another, the arms, is not a part, and is farther from the
  /// root.
  std::pair<Pair, Pair> legsAndArms(const std::vector<std::pair<Chain, Chain>>& pairs) const {
    const auto depth = [&](int joint) { return ancestry(skeleton_, joint).size(); };
    const auto partOf = [&](const auto& a, const auto& b) {
      return isBelow(a.first.branch, b.first.joints[0]) ||
             isBelow(a.first.branch, b.second.joints[0]);
    };
    float best = 0;
    std::pair<Pair, Pair> found{nullptr, nullptr};
    for (const auto& legs : pairs)
      for (const auto& arms : pairs) {
        const int below = legs.first.branch, above = arms.first.branch;
        if (below == above || depth(below) > depth(above) || partOf(legs, arms) ||
            partOf(arms, legs))
          continue;
        if (arms.first.length < 0.35f * legs.first.length || endOfLimb(legs.first) < 0 ||
            endOfLimb(arms.first) < 0 || headAbove(arms, arms.first.length) < 0)
          continue;
        // Tails of hair hang on the head, which is farther from the root than arms are.
        const float score = (legs.first.length + arms.first.length) *
                            (1.0f - 0.05f * static_cast<float>(depth(above) - depth(below)));
        if (score > best) {
          best = score;
          found = {&legs, &arms};
        }
      }
    return found;
  }

  /// The wrist or ankle: the joint after the one between the two longest bones.
  static int endOfLimb(const Chain& chain) {
    float best = 0;
    int end = -1;
    for (std::size_t i = 1; i + 1 < chain.joints.size(); ++i) {
      const float shorter = std::min(chain.bones[i], chain.bones[i + 1]);
      if (shorter < 1.001f * best) continue;
      best = shorter;
      end = chain.joints[i + 1];
    }
    return end;
  }

  /// The middle way up from where the arms are: on along the spine.
  int headAbove(const std::pair<Chain, Chain>& arms, float armLength) const {
    const int chest = arms.first.branch;
    const glm::vec3 spine = skeleton_.offsets[index(chest)];
    int neck = -1;
    float best = -INFINITY;
    for (int c : children_[index(chest)]) {
      if (c == arms.first.joints[0] || c == arms.second.joints[0]) continue;
      const Chain chain = chainFrom(c);
      if (chain.length < 0.1f * armLength) continue;
      const glm::vec3 offset = skeleton_.offsets[index(c)];
      const float scale = glm::length(offset) * glm::length(spine);
      const float along = scale > 0 ? glm::dot(offset, spine) / scale : 0.0f;
      if (along > best) {
        best = along;
        neck = c;
      }
    }
    if (neck < 0) return -1;
    // A head has eyes, jaw or hair; or it is the last joint, or the one before where that is its
    // top.
    int joint = neck;
    while (children_[index(joint)].size() == 1) joint = children_[index(joint)][0];
    const bool isTop = children_[index(joint)].empty() && joint != neck &&
                       glm::length(skeleton_.tips[index(joint)]) < 0.35f * bone(joint) &&
                       bone(joint) > 0.22f * armLength;
    return isTop ? parentOf(skeleton_, joint) : joint;
  }

  /// Exchanges sides where the first limbs found are the right ones.
  void nameSides(BodyMap& map) const {
    float left = 0, same = 0;  // how surely: hip 0 is left; shoulder 0 is on the side of hip 0
    std::vector<RigidTransform> pose(skeleton_.jointCount());
    const std::size_t step = clip_.frameCount() / 100 + 1;
    const auto at = [&](int j) { return pose[index(j)].translation; };
    for (std::size_t f = 0; f < clip_.frameCount(); f += step) {
      poseAtFrame(clip_, f, pose);
      const glm::vec3 hips = at(map.thigh[0]) - at(map.thigh[1]);
      same += glm::dot(hips, at(map.upperArm[0]) - at(map.upperArm[1]));
      const glm::vec3 up = at(map.neck) - 0.5f * (at(map.thigh[0]) + at(map.thigh[1]));
      for (std::size_t s = 0; s < 2; ++s) {
        const glm::vec3 shin = at(map.shin[s]) - at(map.foot[s]);
        glm::vec3 toes = pose[index(map.foot[s])].vector(skeleton_.tips[index(map.foot[s])]);
        for (int c : children_[index(map.foot[s])]) toes += at(c) - at(map.foot[s]);
        left += glm::dot(glm::cross(shin, toes), hips);
        // Knees go to the front of the line from hip to ankle, elbows behind that of the arm.
        const glm::vec3 knee = at(map.shin[s]) - 0.5f * (at(map.thigh[s]) + at(map.foot[s]));
        const glm::vec3 elbow = at(map.foreArm[s]) - 0.5f * (at(map.upperArm[s]) + at(map.hand[s]));
        left += glm::dot(glm::cross(up, knee - elbow), hips);
      }
    }
    const auto named = [&](const std::array<int, 2>& pair) {
      const int a = names_[index(pair[0])].side, b = names_[index(pair[1])].side;
      return a == 0 && b == 1 ? 1 : (a == 1 && b == 0 ? -1 : 0);
    };
    int legs = named(map.foot), arms = named(map.hand);
    if (legs == 0 && arms == 0) legs = left < 0 ? -1 : 1;
    if (legs == 0) legs = same < 0 ? -arms : arms;
    if (arms == 0) arms = same < 0 ? -legs : legs;
    if (legs < 0)
      for (auto* pair : {&map.thigh, &map.shin, &map.foot}) std::swap((*pair)[0], (*pair)[1]);
    if (arms < 0)
      for (auto* pair : {&map.collar, &map.upperArm, &map.foreArm, &map.hand})
        std::swap((*pair)[0], (*pair)[1]);
  }

  const Clip& clip_;
  const Skeleton& skeleton_;
  std::span<const JointName> names_;
  std::vector<std::vector<int>> children_;
  std::vector<float> reach_;  ///< [jointCount], the longest way down from a joint
};

}  // namespace

float boneLength(const Skeleton& skeleton, int from, int to) {
  float sum = 0;
  for (int j = to; j != from; j = skeleton.parents[index(j)]) {
    if (j < 0) return 0;
    sum += glm::length(skeleton.offsets[index(j)]);
  }
  return sum;
}

BodyMap mapByStructure(const Clip& clip, std::span<const JointName> names) {
  constexpr std::size_t kMostJoints = 2000;  // of a person, hair and cloth included
  if (clip.skeleton.jointCount() > kMostJoints) return {};
  return Structure(clip, names).find();
}

void mapBetween(const Skeleton& skeleton, std::span<const JointName> names, BodyMap& map) {
  // The joint that a bone ends on, past those that only twist along it.
  const auto above = [&](int joint) {
    int parent = parentOf(skeleton, joint);
    while (parent >= 0 && parentOf(skeleton, parent) >= 0 &&
           isTwist(names[index(parent)], names[index(parentOf(skeleton, parent))]))
      parent = parentOf(skeleton, parent);
    return parent;
  };
  for (std::size_t s = 0; s < 2; ++s) {
    map.foreArm[s] = above(map.hand[s]);
    map.upperArm[s] = above(map.foreArm[s]);
    map.shin[s] = above(map.foot[s]);
    map.thigh[s] = above(map.shin[s]);
  }
  map.hips = deepestCommon(skeleton, map.thigh[0], map.thigh[1]);
  map.chest = deepestCommon(skeleton, map.upperArm[0], map.upperArm[1]);
  if (map.chest < 0) map.chest = map.hips;
  for (std::size_t s = 0; s < 2; ++s) {
    const int parent = parentOf(skeleton, map.upperArm[s]);
    map.collar[s] = parent != map.chest ? parent : -1;
  }
  // Between chest and head: the neck is the joint next above the chest.
  map.neck = -1;
  for (int j : ancestry(skeleton, parentOf(skeleton, map.head))) {
    if (j == map.chest || j == map.hips) break;
    map.neck = j;
  }
  const int below = parentOf(skeleton, map.head);
  if (map.neck < 0 && below >= 0 && (below == map.chest || below == map.hips)) map.neck = map.head;
  map.spine.clear();
  for (int j = map.chest; j >= 0 && j != map.hips; j = parentOf(skeleton, j))
    map.spine.insert(map.spine.begin(), j);
}

bool mayBePerson(const Skeleton& skeleton, const BodyMap& map) {
  if (!map.complete()) return false;
  std::set<int> different = {map.hips, map.head};
  float lengths[2][4];
  for (std::size_t s = 0; s < 2; ++s) {
    for (int j :
         {map.upperArm[s], map.foreArm[s], map.hand[s], map.thigh[s], map.shin[s], map.foot[s]})
      different.insert(j);
    lengths[s][0] = boneLength(skeleton, map.upperArm[s], map.foreArm[s]);
    lengths[s][1] = boneLength(skeleton, map.foreArm[s], map.hand[s]);
    lengths[s][2] = boneLength(skeleton, map.thigh[s], map.shin[s]);
    lengths[s][3] = boneLength(skeleton, map.shin[s], map.foot[s]);
  }
  if (different.size() != 14 || !(boneLength(skeleton, map.hips, map.head) > 0)) return false;
  for (std::size_t i = 0; i < 4; ++i)
    if (!(lengths[0][i] > 0) || !within(lengths[0][i], lengths[1][i], 0.4f)) return false;
  return within(lengths[0][0], lengths[0][1], 0.75f) && within(lengths[0][2], lengths[0][3], 0.75f);
}

}  // namespace hair
