#include <libhair/simulation/insides.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/grid_cells.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/wisps/guide_curves.h>

namespace hair {

namespace {

constexpr std::uint32_t rgba(std::uint32_t r, std::uint32_t g, std::uint32_t b,
                             std::uint32_t a = 230) {
  return r | g << 8 | b << 16 | a << 24;
}

constexpr std::uint32_t kYellow = rgba(255, 217, 51), kRed = rgba(255, 60, 40),
                        kGreen = rgba(70, 220, 90), kBlue = rgba(60, 120, 255),
                        kCyan = rgba(51, 178, 255), kOrange = rgba(255, 140, 30),
                        kGrey = rgba(150, 150, 150, 150);

class Lines {
 public:
  explicit Lines(std::vector<LineVertex>& out) : out_(out) {}
  void add(glm::vec3 a, glm::vec3 b, std::uint32_t colour) {
    out_.push_back({a, colour});
    out_.push_back({b, colour});
  }

 private:
  std::vector<LineVertex>& out_;
};

// Calls visit(guide, i) for every guide point except roots.
template <class Visit>
void forPoints(const GuideStrands& guides, Visit&& visit) {
  for (std::size_t g = 0; g < guides.guideCount(); ++g)
    for (std::uint32_t i = 1; i < guides.pointsPerGuide(); ++i) visit(g, i);
}

void addGuides(const GuideStrands& guides, Lines& lines) {
  forPoints(guides, [&](std::size_t g, std::uint32_t i) {
    lines.add(guides.point(g, i - 1), guides.point(g, i), kYellow);
  });
}

// Blue to grey to red; saturated at twice the largest rest tension.
void addTension(const GuideStrands& guides, Lines& lines) {
  float most = 1e-6f;
  for (const Lanes& t : guides.restTension)
    for (std::size_t l = 0; l < kLanes; ++l) most = std::max(most, std::abs(t[l]));
  const glm::vec3 pushed(0.15f, 0.4f, 1), rest(0.6f), pulled(1, 0.2f, 0.1f);
  forPoints(guides, [&](std::size_t g, std::uint32_t i) {
    const std::size_t link = g / kLanes * guides.linksPerGuide() + i - 1;
    const float t = guides.tension[link][g % kLanes] / (2 * most);
    const glm::vec3 c =
        255.0f * glm::mix(rest, t < 0 ? pushed : pulled, std::min(std::abs(t), 1.0f));
    lines.add(guides.point(g, i - 1), guides.point(g, i),
              rgba(static_cast<std::uint32_t>(c.x), static_cast<std::uint32_t>(c.y),
                   static_cast<std::uint32_t>(c.z)));
  });
}

void addFrames(const GuideStrands& guides, Lines& lines) {
  constexpr float kLength = 5e-3f;
  // One sample a guide point.
  GuideCurves curves(guides, guides.pointsPerGuide());
  sampleGuides(guides, curves);
  for (std::size_t g = 0; g < guides.guideCount(); ++g)
    for (std::uint32_t i = 0; i < guides.pointsPerGuide(); ++i) {
      const GuideCurves::Frame frame = curves.frame(g, i);
      const glm::vec3 at = curves.point(g, i);
      lines.add(at, at + kLength * frame.normal, kRed);
      lines.add(at, at + kLength * frame.binormal, kGreen);
      lines.add(at, at + kLength * frame.tangent, kBlue);
    }
}

void addContacts(const Hair& hair, const GuideSettings& settings, Lines& lines) {
  constexpr float kLength = 0.01f, kTouching = 2e-4f;
  const GuideStrands& guides = hair.guides;
  const RigidTransform headFromWorld = inverse(hair.worldFromHead);
  forPoints(guides, [&](std::size_t g, std::uint32_t i) {
    const glm::vec3 p = guides.point(g, i);
    const std::size_t at = g / kLanes * guides.pointsPerGuide() + i;
    const auto contact = [&](glm::vec4 surface, float clearance) {
      if (surface.w < clearance + kTouching)
        lines.add(p, p + kLength * glm::vec3(surface), kOrange);
    };
    if (hair.head) {
      const glm::vec4 s = hair.head->distanceAndGradient(headFromWorld.point(p));
      contact(glm::vec4(hair.worldFromHead.vector(glm::vec3(s)), s.w),
              guides.clearance[at][g % kLanes]);
    }
    for (const Capsule& c : hair.capsules) contact(distanceAndGradient(c, p), settings.skin);
    for (const Plane& c : hair.planes) contact(distanceAndGradient(c, p), settings.skin);
    for (const MeshCollider& c : hair.meshes) contact(distanceAndGradient(c, p), settings.skin);
  });
}

void addPush(const Hair& hair, Lines& lines) {
  constexpr float kMetresPerAcceleration = 1e-3f;
  const GuideStrands& guides = hair.guides;
  if (hair.repulsion.push.size() != guides.position.size()) return;
  forPoints(guides, [&](std::size_t g, std::uint32_t i) {
    const std::size_t at = g / kLanes * guides.pointsPerGuide() + i;
    const glm::vec3 push = lane(hair.repulsion.push[at], g % kLanes), p = guides.point(g, i);
    if (push != glm::vec3(0)) lines.add(p, p + kMetresPerAcceleration * push, kRed);
  });
}

// A ring at each end, four lines between them, and two half circles over each cap.
void addCapsule(const Capsule& c, Lines& lines) {
  constexpr int kSides = 24;
  const glm::vec3 along = c.b - c.a;
  const float length = glm::length(along);
  const glm::vec3 axis = length > 0 ? along / length : glm::vec3(0, 1, 0);
  const glm::vec3 u = anyNormal(axis), v = glm::cross(axis, u);
  glm::vec3 before = u;
  float sineBefore = 0, cosineBefore = 1;
  for (int i = 1; i <= kSides; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / kSides;
    const float cosine = std::cos(angle), sine = std::sin(angle);
    const glm::vec3 now = cosine * u + sine * v;
    lines.add(c.a + c.radius * before, c.a + c.radius * now, kCyan);
    if (length > 0) lines.add(c.b + c.radius * before, c.b + c.radius * now, kCyan);
    if (i % (kSides / 4) == 0) lines.add(c.a + c.radius * now, c.b + c.radius * now, kCyan);
    const glm::vec3& end = sine + sineBefore > 0 ? c.b : c.a;
    for (const glm::vec3& side : {u, v})
      lines.add(end + c.radius * (cosineBefore * side + sineBefore * axis),
                end + c.radius * (cosine * side + sine * axis), kCyan);
    before = now, sineBefore = sine, cosineBefore = cosine;
  }
}

// A grid of 1 m × 1 m about the projection of `near`, and the normal.
void addPlane(const Plane& plane, glm::vec3 near, Lines& lines) {
  constexpr int kCells = 8;
  constexpr float kHalf = 0.5f;
  const glm::vec3 foot = near - distanceAndGradient(plane, near).w * plane.normal;
  const glm::vec3 u = anyNormal(plane.normal), v = glm::cross(plane.normal, u);
  for (int i = 0; i <= kCells; ++i) {
    const float t = (2.0f * static_cast<float>(i) / kCells - 1) * kHalf;
    lines.add(foot + t * u - kHalf * v, foot + t * u + kHalf * v, kCyan);
    lines.add(foot + t * v - kHalf * u, foot + t * v + kHalf * u, kCyan);
  }
  lines.add(foot, foot + 0.1f * plane.normal, kGreen);
}

// Calls line(a, b) for the segments of the zero contour in one cell of a square grid (marching
// squares). `d`: distances at its corners (x, y), (x+1, y), (x+1, y+1) and (x, y+1).
template <class Line>
void cutCell(glm::vec2 corner, const std::array<float, 4>& d, Line&& line) {
  constexpr glm::vec2 kCorners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::array<glm::vec2, 4> crossing;
  std::size_t count = 0;
  for (std::size_t e = 0; e < 4; ++e) {
    const float a = d[e], b = d[(e + 1) % 4];
    if ((a < 0) == (b < 0)) continue;
    crossing[count++] = corner + glm::mix(kCorners[e], kCorners[(e + 1) % 4], a / (a - b));
  }
  for (std::size_t k = 0; k + 1 < count; k += 2) line(crossing[k], crossing[k + 1]);
}

// The surface of a distance field as contour lines: its zero contours in nine slices along each
// axis of its box.
template <class ToWorld>
void addContours(const MeshSdf& sdf, ToWorld&& toWorld, Lines& lines) {
  constexpr int kLevels = 9, kCells = 40;
  const Bounds box = sdf.box();
  for (int axis = 0; axis < 3; ++axis)
    for (int level = 1; level <= kLevels; ++level) {
      const auto at = [&](glm::vec2 cell) {
        glm::vec3 share;
        share[axis] = static_cast<float>(level) / (kLevels + 1);
        share[(axis + 1) % 3] = cell.x / kCells, share[(axis + 2) % 3] = cell.y / kCells;
        return box.lower + share * box.size();
      };
      const auto distance = [&](glm::vec2 cell) { return sdf.distance(at(cell)); };
      for (int i = 0; i < kCells * kCells; ++i) {
        const glm::vec2 c(i % kCells, i / kCells);
        const std::array<float, 4> d = {distance(c), distance(c + glm::vec2(1, 0)),
                                        distance(c + glm::vec2(1)), distance(c + glm::vec2(0, 1))};
        cutCell(c, d, [&](glm::vec2 a, glm::vec2 b) {
          lines.add(toWorld(at(a)), toWorld(at(b)), kCyan);
        });
      }
    }
}

void addColliders(const Hair& hair, Lines& lines) {
  for (const Capsule& c : hair.capsules) addCapsule(c, lines);
  for (const Plane& plane : hair.planes) addPlane(plane, hair.pivot(), lines);
  if (hair.head)
    addContours(*hair.head, [&](glm::vec3 p) { return hair.worldFromHead.point(p); }, lines);
  for (const MeshCollider& mesh : hair.meshes)
    addContours(
        *mesh.sdf, [&](glm::vec3 p) { return mesh.worldFromMesh.point(mesh.scale * p); }, lines);
}

// Along one axis: the first unwrapped cell of the brick's copy that lies within the hair's bounds.
int unwrapped(int wrapped, int base, int cells, int size, int lower) {
  int cell = wrapped - base;
  while (cell + size <= lower) cell += cells;
  while (cell - cells + size > lower) cell -= cells;
  return cell;
}

void addBricks(const DensityGrid& grid, Lines& lines) {
  if (grid.empty()) return;
  const glm::ivec3 perAxis = grid.cells->bricks.perAxis(), size(brick::kX, brick::kY, brick::kZ);
  for (const std::uint32_t place : grid.cells->bricks.places()) {
    const int y = static_cast<int>(place) % perAxis.y, rest = static_cast<int>(place) / perAxis.y;
    const glm::ivec3 first = glm::ivec3(rest / perAxis.z, y, rest % perAxis.z) * size;
    glm::vec3 from, to;
    for (int c = 0; c < 3; ++c) {
      const int cell = unwrapped(first[c], grid.cells->frame.base[c], grid.settings.cells, size[c],
                                 grid.lower[c]);
      from[c] = static_cast<float>(cell);
      to[c] = static_cast<float>(cell + std::min(size[c], grid.settings.cells - first[c]));
    }
    const auto corner = [&](int i) {
      return grid.cells->frame.point(
          {i & 1 ? to.x : from.x, i & 2 ? to.y : from.y, i & 4 ? to.z : from.z});
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if (!(i & bit)) lines.add(corner(i), corner(i | bit), kGrey);
  }
}

}  // namespace

namespace {

struct Words {
  std::string_view name, meaning;
};
constexpr std::array<Words, kInsideCount> kWords = {{
    {"guides", "links of the simulated strands"},
    {"tension", "links of the guides: red where pulled, blue where pushed"},
    {"guide frames", "normal, binormal and tangent at guide points, 5 mm"},
    {"contacts", "the collider's normal where a guide point touches it, 1 cm"},
    {"push", "of self-collision on guide points, 1 mm for 1 m/s^2"},
    {"colliders", "capsules, planes, contour lines of head and meshes"},
    {"bricks", "occupied bricks of the first light's map"},
}};

const Words& wordsOf(Inside inside) {
  const auto i = static_cast<std::size_t>(inside);
  require(i < kInsideCount, "inside: there is no number ", i);
  return kWords[i];
}

}  // namespace

std::string_view insideName(Inside inside) {
  return wordsOf(inside).name;
}

std::string insideMeaning(Inside inside) {
  return std::string(wordsOf(inside).meaning);
}

void addLines(Inside what, const Hair& hair, const GuideSettings& settings,
              std::vector<LineVertex>& out) {
  Lines lines(out);
  switch (what) {
    case Inside::Guides:
      return addGuides(hair.guides, lines);
    case Inside::Tension:
      return addTension(hair.guides, lines);
    case Inside::GuideFrames:
      return addFrames(hair.guides, lines);
    case Inside::Contacts:
      return addContacts(hair, settings, lines);
    case Inside::Push:
      return addPush(hair, lines);
    case Inside::Colliders:
      return addColliders(hair, lines);
    case Inside::Bricks:
      if (!hair.maps.empty()) addBricks(hair.maps.front().grid, lines);
      return;
  }
}

}  // namespace hair
