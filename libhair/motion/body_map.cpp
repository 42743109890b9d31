#include <algorithm>
#include <cctype>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/motion/body.h>
#include <libhair/motion/joint_names.h>
#include <libhair/motion/rig_structure.h>

namespace hair {
namespace {

/// How far each joint is from its root.
std::vector<std::size_t> depths(const Skeleton& skeleton) {
  std::vector<std::size_t> depth(skeleton.jointCount(), 0);
  for (std::size_t j = 0; j < depth.size(); ++j)
    if (skeleton.parents[j] >= 0)
      depth[j] = depth[static_cast<std::size_t>(skeleton.parents[j])] + 1;
  return depth;
}

/// The joint whose name is most like a part's; of two alike that which is nearer the root.
int findNamed(std::span<const std::size_t> depthOf, std::span<const JointName> names,
              NamedPart part, int side) {
  int best = -1, bestLikeness = 0;
  std::size_t bestDepth = 0;
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (names[j].side != side) continue;
    const int like = likeness(names[j], part);
    if (like == 0) continue;
    const std::size_t depth = depthOf[j];
    // L_Hand below L_Wrist: the wrist moves the hand. Of heads the name that is most like one.
    const int rank = part == NamedPart::Head ? like : std::min(like, 2);
    if (best >= 0 && (rank < bestLikeness || (rank == bestLikeness && depth >= bestDepth)))
      continue;
    bestLikeness = rank;
    best = static_cast<int>(j);
    bestDepth = depth;
  }
  return best;
}

int findCalled(const Skeleton& skeleton, std::string_view name) {
  for (const bool exact : {true, false})
    for (std::size_t j = 0; j < skeleton.names.size(); ++j) {
      const std::string& own = skeleton.names[j];
      const bool same = std::equal(own.begin(), own.end(), name.begin(), name.end(),
                                   [&](unsigned char a, unsigned char b) {
                                     return exact ? a == b : std::tolower(a) == std::tolower(b);
                                   });
      if (same) return static_cast<int>(j);
    }
  return -1;
}

BodyMap mapByNames(const Skeleton& skeleton, std::span<const JointName> names) {
  BodyMap map;
  const std::vector<std::size_t> depth = depths(skeleton);
  map.head = findNamed(depth, names, NamedPart::Head, -1);
  for (std::size_t s = 0; s < 2; ++s) {
    map.hand[s] = findNamed(depth, names, NamedPart::Hand, static_cast<int>(s));
    map.foot[s] = findNamed(depth, names, NamedPart::Foot, static_cast<int>(s));
  }
  mapBetween(skeleton, names, map);
  return map;
}

}  // namespace

bool BodyMap::complete() const {
  const auto both = [](const std::array<int, 2>& pair) { return pair[0] >= 0 && pair[1] >= 0; };
  return hips >= 0 && chest >= 0 && neck >= 0 && head >= 0 && both(upperArm) && both(foreArm) &&
         both(hand) && both(thigh) && both(shin) && both(foot);
}

std::string jointList(const Skeleton& skeleton) {
  constexpr std::size_t kMost = 60;
  std::string list;
  for (std::size_t j = 0; j < std::min(kMost, skeleton.names.size()); ++j)
    list += (j ? ", " : "") + skeleton.names[j];
  if (skeleton.names.size() > kMost) list += text(" and ", skeleton.names.size() - kMost, " more");
  return list;
}

BodyMap mapBody(const Skeleton& skeleton) {
  return mapByNames(skeleton, jointNames(skeleton.names));
}

BodyMap mapBody(const Clip& clip, std::string_view headJoint) {
  const Skeleton& skeleton = clip.skeleton;
  const std::vector<JointName> names = jointNames(skeleton.names);
  const int head = headJoint.empty() ? -1 : findCalled(skeleton, headJoint);
  require(headJoint.empty() || head >= 0, "body: no joint is called ", headJoint,
          " (--head-joint); there are ", jointList(skeleton));
  BodyMap map = mapByNames(skeleton, names);
  if (head >= 0) {
    map.head = head;
    mapBetween(skeleton, names, map);
  }
  if (mayBePerson(skeleton, map)) return map;
  BodyMap found = mapByStructure(clip, names);
  if (found.complete() && map.head >= 0) {
    // A name says more than a place.
    const int byPlace = std::exchange(found.head, map.head);
    mapBetween(skeleton, names, found);
    if (!mayBePerson(skeleton, found) && head < 0) {
      found.head = byPlace;
      mapBetween(skeleton, names, found);
    }
  }
  return mayBePerson(skeleton, found) ? found : map;
}

}  // namespace hair
