#include <libhair/wisps/wisps.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/wisps/guide_curves.h>
#include <libhair/wisps/obstacles.h>

namespace hair {

namespace {

void check(const Groom& groom, const WispSettings& settings) {
  validateFields(settings, "wisp settings");
  validateStrands(groom);
}

std::uint32_t longestStrand(const Groom& groom) {
  std::uint32_t n = 2;
  for (std::size_t s = 0; s + 1 < groom.first.size(); ++s)
    n = std::max(n, groom.first[s + 1] - groom.first[s]);
  return n;
}

// See Wisps::sampleTable.
void fillSampleTable(Wisps& wisps) {
  const std::vector<std::uint32_t>& first = wisps.groom->first;
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  wisps.tableOf.assign(longestStrand(*wisps.groom) + 1, kNone);
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    const std::uint32_t n = first[s + 1] - first[s];
    if (wisps.tableOf[n] != kNone) continue;
    wisps.tableOf[n] = static_cast<std::uint32_t>(wisps.sampleTable.size());
    for (std::uint32_t k = 0; k < n; ++k)
      wisps.sampleTable.push_back(static_cast<std::int32_t>(wisps.sampleOf(k, n)));
  }
  wisps.sampleTable.resize(wisps.sampleTable.size() + kLanes);
}

}  // namespace

Wisps::Wisps(const Groom& groom_, const GuideStrands& guidesAtRest, const WispSettings& settings_,
             const MeshSdf* head)
    : groom((check(groom_, settings_), &groom_)),
      settings(settings_),
      points(groom_.pointCount()),
      curves(std::make_unique<GuideCurves>(guidesAtRest, longestStrand(groom_))),
      obstacles(std::make_unique<WispObstacles>()) {
  fillSampleTable(*this);
  rootOffsets.resize(groom->strandCount());
  clearance.resize(groom->strandCount(), settings.clearance);
  interpolateWisps(guidesAtRest, {}, *this);
  const RigidTransform headFromWorld = inverse(guidesAtRest.worldFromHead);
  for (std::size_t s = 0; s < groom->strandCount(); ++s) {
    const std::uint32_t begin = groom->first[s], end = groom->first[s + 1];
    const std::uint32_t main = groom->parents[s].x;
    const GuideCurves::Frame frame = curves->frame(main, 0);
    rootOffsets[s] = frame.fromWorld(points[begin] - curves->point(main, 0));
    if (!groom->offsets.empty()) rootOffsets[s] -= groom->offsets[begin];
    for (std::uint32_t p = begin + 1; head && p < end; ++p)
      clearance[s] = std::min(clearance[s], head->distance(headFromWorld.point(points[p])));
  }
}

Wisps::~Wisps() = default;
Wisps::Wisps(Wisps&&) noexcept = default;
Wisps& Wisps::operator=(Wisps&&) noexcept = default;

std::uint32_t Wisps::sampleOf(std::uint32_t k, std::uint32_t n) const {
  const std::uint64_t last = n - 1;
  return static_cast<std::uint32_t>((2 * std::uint64_t{k} * (curves->samples - 1) + last) /
                                    (2 * last));
}

void prepareWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps) {
  sampleGuides(guides, *wisps.curves);
  findObstacles(wisps.settings.avoidColliders ? colliders : ColliderState{},
                wisps.settings.clearance, *wisps.curves, *wisps.obstacles);
}

void interpolateWisps(const GuideStrands& guides, const ColliderState& colliders, Wisps& wisps) {
  prepareWisps(guides, colliders, wisps);
  parallelFor(wisps.groom->strandCount(), 32,
              [&](std::size_t begin, std::size_t end) { drawWisps(begin, end, wisps); });
}

}  // namespace hair
