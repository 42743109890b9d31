#include <libhair/simulation/frame.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/core/state_hash.h>
#include <libhair/files/byte_reader.h>
#include <libhair/guides/validate.h>
#include <libhair/simulation/saved_state.h>

namespace hair {

namespace {

constexpr std::array<char, 8> kMagic = {'H', 'A', 'I', 'R', 'S', 'T', 'A', 'T'};
constexpr std::uint32_t kVersion = 1;
constexpr std::string_view kName = "saved state";

// File layout: little-endian, no padding; guides interleaved in groups of sixteen, as in
// GuideStrands. With g groups of guides of n points:
//
//   Header
//   f32[7] each                 pose of the head, then of the guides' roots: rotation w, x, y, z,
//                               translation
//   f32[7] each                 capsules: a, b, radius
//   f32[6] each                 planes: point, normal
//   f32[8] each                 meshes: rotation w, x, y, z, translation, scale
//   f32[3·16·g·n] each          guide positions, velocities
//   f32[16·g·(n - 1)]           tension of links
//   f32[16·g·n], f32[3·16·g·n]  with self-collision: density allowed, push
//   f32[16·g·n]                 with occlusion of the wind: attenuation of the wind
//   f32[3] a point              drawn points
//   f32[3], f32 a strand        offsets of drawn roots, clearance of drawn strands
//   u64                         StateHash of all bytes before
struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t turn;       // Repulsion::turn
  std::uint64_t restShape;  // restShapeOf
  double time;
  float waiting;         // Repulsion::waiting
  std::uint32_t points;  // guide points / 16
  std::uint32_t pushes;  // equal to points, or 0 without self-collision
  std::uint32_t capsules, drawn, strands;
  std::uint32_t planes, meshes;
  std::uint32_t windShares;  // equal to points, or 0 without its occlusion
  std::uint32_t learntWith;  // Repulsion::learntWith
};
static_assert(sizeof(Header) == 72, "without gaps");

// Rotation w, x, y, z, then translation.
using Pose = std::array<float, 7>;

Pose poseOf(const RigidTransform& t) {
  const glm::quat& q = t.rotation;
  return {q.w, q.x, q.y, q.z, t.translation.x, t.translation.y, t.translation.z};
}

RigidTransform transformOf(const Pose& p) {
  return {{p[0], p[1], p[2], p[3]}, {p[4], p[5], p[6]}};
}

// Pose of a mesh collider. Its distance field is not saved.
struct Placement {
  Pose pose;
  float scale;
};

// Hash of what must match for a state to be restored: the guides' rest shape, and the weights and
// offsets of drawn strands.
std::uint64_t restShapeOf(const Hair& hair) {
  StateHash hash;
  const auto add = [&]<class T>(const std::vector<T>& values) { hash.add(std::span(values)); };
  const GuideStrands& g = hair.guides;
  add(g.restPosition), add(g.linkLength), add(g.restTension), add(g.curvature);
  add(g.jointStiffness), add(g.pointMass), add(g.clearance);
  if (std::any_of(g.tied.begin(), g.tied.end(), [](auto tied) { return tied > 1; }))
    add(g.inverseMass);
  const Groom& groom = *hair.groom;
  add(groom.first), add(groom.parents), add(groom.weights), add(groom.offsets);
  return hash.value();
}

Header headerOf(const Hair& hair) {
  const auto count = [](const auto& values) { return static_cast<std::uint32_t>(values.size()); };
  Header header;
  header.turn = static_cast<std::uint32_t>(hair.repulsion.turn);
  header.restShape = restShapeOf(hair);
  header.time = hair.time;
  header.waiting = hair.repulsion.waiting;
  header.points = count(hair.guides.position);
  header.learntWith = hair.repulsion.learntWith;
  header.pushes = count(hair.repulsion.allowed);
  header.capsules = count(hair.capsules);
  header.planes = count(hair.planes);
  header.meshes = count(hair.meshes);
  header.windShares = count(hair.repulsion.windShare);
  header.drawn = count(hair.wisps.points);
  header.strands = count(hair.wisps.rootOffsets);
  return header;
}

std::uint64_t checkSum(std::string_view bytes) {
  StateHash hash;
  hash.add(std::span(bytes));
  return hash.value();
}

template <class T>
void append(std::string& bytes, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

// Appends `count` bytes of the stream.
void take(std::istream& in, std::size_t count, std::string& bytes) {
  const std::size_t old = bytes.size();
  bytes.resize(old + count);
  in.read(bytes.data() + old, static_cast<std::streamsize>(count));
  const auto got = static_cast<std::size_t>(in.gcount());
  require(got == count, kName, ": byte ", old + got, ": it ends here (truncated)");
}

// Throws Error unless the header belongs to this hair and its counts are in range.
void check(const Header& header, const Hair& hair) {
  require(header.magic == kMagic, kName, ": does not begin with HAIRSTAT");
  require(header.version == kVersion, kName, ": version ", header.version, "; this reads version ",
          kVersion);
  const Header own = headerOf(hair);
  require(header.restShape == own.restShape && header.points == own.points &&
              header.drawn == own.drawn && header.strands == own.strands,
          kName,
          ": of another groom, or of guide settings that shape another rest; load it into "
          "the hair that it was saved of");
  require(std::isfinite(header.time) && (header.pushes == 0 || header.pushes == own.points) &&
              header.turn <= 1 && header.waiting >= 0 && header.waiting <= 1 &&
              header.capsules <= kMaxCapsules && header.planes <= kMaxPlanes &&
              header.meshes <= kMaxMeshes &&
              (header.windShares == 0 || header.windShares == own.points),
          kName, ": ", header.time, " s, ", header.pushes, " pushes, ", header.windShares,
          " shares of wind, turn ", header.turn, ", ", header.capsules, " capsules, ",
          header.planes, " planes and ", header.meshes, " meshes cannot be (damaged)");
}

std::size_t bodySize(const Header& h, std::size_t links) {
  return 2 * sizeof(Pose) + h.capsules * sizeof(Capsule) + h.planes * sizeof(Plane) +
         h.meshes * sizeof(Placement) + std::size_t{h.windShares} * sizeof(Lanes) +
         std::size_t{h.points} * 2 * sizeof(LaneVec3) + links * sizeof(Lanes) +
         std::size_t{h.pushes} * (sizeof(Lanes) + sizeof(LaneVec3)) +
         std::size_t{h.drawn} * sizeof(glm::vec3) +
         std::size_t{h.strands} * (sizeof(glm::vec3) + sizeof(float));
}

// Rejects finite numbers that no frame produces and that would overflow in the next. Limits: a
// frame moves hair by at most the world's width, 2e8 m in a microsecond; offsets and weights place
// drawn points at most 1e10 m from their guides.
template <class T>
void requireWithin(const std::vector<T>& values, float least, float most, const char* what) {
  const auto* numbers = reinterpret_cast<const float*>(values.data());
  const std::size_t count = std::span(values).size_bytes() / sizeof(float);
  for (std::size_t i = 0; i < count; ++i)
    require(numbers[i] >= least && numbers[i] <= most, kName, ": ", what, ' ', numbers[i],
            " is not in ", least, " to ", most, " (damaged)");
}

// Applies the input validation of a frame, and keeps its messages.
template <class... Parts>
void requireGood(const Parts&... parts) {
  try {
    (validate(parts), ...);
  } catch (const Error& e) {
    throw Error(text(kName, ": ", e.what(), " (damaged)"));
  }
}

}  // namespace

void saveState(const Hair& hair, std::ostream& out) {
  const Header header = headerOf(hair);
  std::string bytes;
  bytes.reserve(sizeof(Header) + bodySize(header, hair.guides.tension.size()) +
                sizeof(std::uint64_t));
  const auto add = [&]<class T>(const std::vector<T>& values) {
    append(bytes, std::span<const T>(values));
  };
  append(bytes, std::span(&header, 1));
  const std::array<Pose, 2> poses = {poseOf(hair.worldFromHead), poseOf(hair.guides.worldFromHead)};
  append(bytes, std::span<const Pose>(poses));
  add(hair.capsules), add(hair.planes);
  std::vector<Placement> placements;
  placements.reserve(hair.meshes.size());
  for (const MeshCollider& mesh : hair.meshes)
    placements.push_back({poseOf(mesh.worldFromMesh), mesh.scale});
  add(placements);
  add(hair.guides.position), add(hair.guides.velocity), add(hair.guides.tension);
  add(hair.repulsion.allowed), add(hair.repulsion.push), add(hair.repulsion.windShare);
  add(hair.wisps.points), add(hair.wisps.rootOffsets), add(hair.wisps.clearance);
  const std::uint64_t sum = checkSum(bytes);
  append(bytes, std::span(&sum, 1));
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(out.good(), kName, ": cannot write");
}

SavedState readState(std::istream& in, const Hair& hair) {
  std::string bytes;
  take(in, sizeof(Header), bytes);
  const auto header = ByteReader(bytes, kName).read<Header>("header");
  check(header, hair);
  take(in, bodySize(header, hair.guides.tension.size()) + sizeof(std::uint64_t), bytes);
  const std::string_view summed(bytes.data(), bytes.size() - sizeof(std::uint64_t));
  ByteReader end(bytes, kName);
  end.seek(summed.size(), "check sum");
  end.expect(end.read<std::uint64_t>("check sum") == checkSum(summed),
             "the check sum is of other bytes (damaged)");

  ByteReader reader(summed, kName);
  reader.seek(sizeof(Header), "poses");
  const auto read = [&]<class T>(std::vector<T>& values, std::size_t count, const char* what) {
    reader.appendFinite(values, count, what);
  };
  std::vector<Pose> poses;
  std::vector<Placement> placements;
  SavedState state;
  read(poses, 2, "pose");
  read(state.capsules, header.capsules, "capsule");
  read(state.planes, header.planes, "plane");
  read(placements, header.meshes, "placement of a mesh");
  read(state.position, header.points, "guide position");
  read(state.velocity, header.points, "guide velocity");
  read(state.tension, hair.guides.tension.size(), "guide tension");
  read(state.allowed, header.pushes, "allowed density");
  read(state.push, header.pushes, "push");
  read(state.windShare, header.windShares, "share of the wind");
  read(state.points, header.drawn, "drawn point");
  read(state.rootOffsets, header.strands, "root offset");
  read(state.clearance, header.strands, "clearance");
  state.worldFromHead = transformOf(poses[0]);
  state.worldFromRoots = transformOf(poses[1]);
  state.time = header.time;
  state.turn = header.turn;
  state.waiting = header.waiting;
  state.learntWith = header.learntWith;
  if (header.pushes == 0) {  // saved without self-collision: keep this hair's rest density
    state.allowed = hair.repulsion.allowed;
    state.learntWith = hair.repulsion.learntWith;
    state.push.resize(state.allowed.size());
  }

  // Keep this hair's distance fields if the number of meshes matches; otherwise the next frame
  // takes its meshes as at rest.
  if (hair.meshes.size() == placements.size())
    for (std::size_t m = 0; m < placements.size(); ++m)
      state.meshes.push_back(
          {hair.meshes[m].sdf, transformOf(placements[m].pose), placements[m].scale});

  constexpr float kFarthest = 1e10f, kFastest = 1e15f;
  requireWithin(state.position, -kFarthest, kFarthest, "guide position");
  requireWithin(state.velocity, -kFastest, kFastest, "guide velocity");
  requireWithin(state.allowed, 0, INFINITY, "allowed density");
  requireWithin(state.push, -1e6f, 1e6f, "push");
  requireWithin(state.windShare, 0, 1, "share of the wind");
  requireWithin(state.points, -kFarthest, kFarthest, "drawn point");
  requireWithin(state.rootOffsets, -kFarthest, kFarthest, "root offset");
  requireWithin(state.clearance, -kFarthest, kFarthest, "clearance");
  requireGood(state.worldFromHead, state.worldFromRoots, std::span<const Capsule>(state.capsules),
              Scenery{state.planes, state.meshes});
  return state;
}

void assignState(SavedState&& state, Hair& hair) noexcept {
  hair.worldFromHead = state.worldFromHead;
  hair.capsules = std::move(state.capsules);
  hair.planes = std::move(state.planes);
  hair.meshes = std::move(state.meshes);
  hair.time = state.time;
  hair.guides.worldFromHead = state.worldFromRoots;
  hair.guides.position = std::move(state.position);
  hair.guides.velocity = std::move(state.velocity);
  hair.guides.tension = std::move(state.tension);
  hair.repulsion.allowed = std::move(state.allowed);
  hair.repulsion.push = std::move(state.push);
  hair.repulsion.windShare = std::move(state.windShare);
  hair.repulsion.learntWith = state.learntWith;
  hair.repulsion.turn = state.turn;
  hair.repulsion.waiting = state.waiting;
  hair.wisps.points = std::move(state.points);
  hair.wisps.rootOffsets = std::move(state.rootOffsets);
  hair.wisps.clearance = std::move(state.clearance);
}

void restoreState(std::istream& in, Hair& hair) {
  assignState(readState(in, hair), hair);
}

}  // namespace hair
