#include <algorithm>
#include <cctype>
#include <string_view>

#include <libhair/motion/body.h>

namespace hair {
namespace {

/// A joint's name without case, rig prefix, punctuation and side.
struct PlainName {
  std::string part;
  int side = -1;  ///< 0 left, 1 right, -1 neither
};

PlainName plainName(std::string_view name) {
  if (const auto colon = name.rfind(':'); colon != std::string_view::npos)
    name.remove_prefix(colon + 1);
  const auto upper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  PlainName plain;
  for (char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      plain.part += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto cut = [&](std::size_t begin, std::size_t count, int side) {
    plain.part.erase(begin, count);
    plain.side = side;
  };
  if (plain.part.starts_with("left")) {
    cut(0, 4, 0);
  } else if (plain.part.starts_with("right")) {
    cut(0, 5, 1);
  } else if (plain.part.ends_with("left")) {
    cut(plain.part.size() - 4, 4, 0);
  } else if (plain.part.ends_with("right")) {
    cut(plain.part.size() - 5, 5, 1);
  } else if (name.size() > 1) {
    // One letter: lShldr, LHipJoint, L_Hand, hand.L, Hand_R
    const char first = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    const char last = static_cast<char>(std::tolower(static_cast<unsigned char>(name.back())));
    const auto sided = [](char c) { return c == 'l' || c == 'r'; };
    if (sided(first) && (upper(name[1]) || !letter(name[1])))
      cut(0, 1, first == 'l' ? 0 : 1);
    else if (sided(last) && !letter(name[name.size() - 2]))
      cut(plain.part.size() - 1, 1, last == 'l' ? 0 : 1);
  }
  return plain;
}

/// First joint whose plain name is one of `names`, tried in their order.
int find(const std::vector<PlainName>& joints, std::initializer_list<std::string_view> names,
         int side) {
  for (std::string_view name : names)
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (joints[j].side == side && joints[j].part == name) return static_cast<int>(j);
  return -1;
}

int parentOf(const Skeleton& skeleton, int joint) {
  return joint < 0 ? -1 : skeleton.parents[static_cast<std::size_t>(joint)];
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

}  // namespace

bool BodyMap::complete() const {
  const auto both = [](const std::array<int, 2>& pair) { return pair[0] >= 0 && pair[1] >= 0; };
  return hips >= 0 && chest >= 0 && neck >= 0 && head >= 0 && both(upperArm) && both(foreArm) &&
         both(hand) && both(thigh) && both(shin) && both(foot);
}

BodyMap mapBody(const Skeleton& skeleton) {
  std::vector<PlainName> names;
  names.reserve(skeleton.names.size());
  for (const std::string& name : skeleton.names) names.push_back(plainName(name));

  BodyMap map;
  map.head = find(names, {"head", "skull"}, -1);
  for (std::size_t s = 0; s < 2; ++s) {
    const int side = static_cast<int>(s);
    map.hand[s] = find(names, {"hand", "wrist"}, side);
    map.foot[s] = find(names, {"foot", "ankle"}, side);
    map.foreArm[s] = parentOf(skeleton, map.hand[s]);
    map.upperArm[s] = parentOf(skeleton, map.foreArm[s]);
    map.shin[s] = parentOf(skeleton, map.foot[s]);
    map.thigh[s] = parentOf(skeleton, map.shin[s]);
  }
  map.hips = deepestCommon(skeleton, map.thigh[0], map.thigh[1]);
  map.chest = deepestCommon(skeleton, map.upperArm[0], map.upperArm[1]);
  if (map.chest < 0) map.chest = map.hips;
  for (std::size_t s = 0; s < 2; ++s) {
    const int above = parentOf(skeleton, map.upperArm[s]);
    if (above != map.chest) map.collar[s] = above;
  }

  // Between chest and head: the neck is the joint next above the chest.
  for (int j : ancestry(skeleton, parentOf(skeleton, map.head))) {
    if (j == map.chest || j == map.hips) break;
    map.neck = j;
  }
  for (int j = map.chest; j >= 0 && j != map.hips; j = parentOf(skeleton, j))
    map.spine.insert(map.spine.begin(), j);
  return map;
}

}  // namespace hair
