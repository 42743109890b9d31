#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/shadow/cell_lists.h>
#include <libhair/measure/shadow/ribbon.h>
#include <libhair/measure/shadow/truth.h>

// The law of ribbons (ribbon.h) is asked, in double, of every segment that a ray may cross; what is
// here only finds these, in float, and may find some too many but never one too few: whatever is
// compared in float is given `slack`, which is five times what the comparison can be wrong by.
//
// Rays that are all parallel (light at infinity) need no walk: across the light each is a point,
// and one cell of a flat grid has all that it can cross. That is about three times as fast.

namespace hair {

namespace {

/// Whether (x, y) is no farther than `radius` from the segment.
bool near(glm::vec2 p, glm::vec2 a, glm::vec2 b, float radiusSquare) {
  const glm::vec2 way = b - a, from = p - a;
  const float square = way.x * way.x + way.y * way.y;
  const float along = from.x * way.x + from.y * way.y;
  const float t = std::clamp(along / std::max(square, 1e-30f), 0.0f, 1.0f);
  const glm::vec2 d = from - t * way;
  return d.x * d.x + d.y * d.y <= radiusSquare;
}

struct Scene {
  RibbonPoints ribbons;
  std::vector<std::uint32_t> segments;
  glm::dvec3 centre{0};  ///< float coordinates count from here
  double meanLength = 0;
  double radius = 0;  ///< half the width, and slack
  double slack = 0;
};

/// All that parallel light sees, projected across it.
class FlatGrid {
 public:
  FlatGrid(const Scene& scene, glm::vec3 toLight)
      : scene_(scene),
        toLight_(toLight),
        frame_({glm::vec3(0), toLight, INFINITY, kNoStrand}),
        radiusSquare_(static_cast<float>(scene.radius * scene.radius)) {
    frame_.origin = scene.centre;
    const std::size_t count = scene.ribbons.points.size();
    seen_.resize(count);
    std::vector<glm::vec3> flat(count);
    parallelFor(count, 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        seen_[i] = glm::vec3(frame_.see(scene.ribbons.points[i]));
        flat[i] = {seen_[i].x, seen_[i].y, 0};
      }
    });
    grid_ = makeCellLists(flat, scene.segments, scene.radius, 4 * scene.radius, 2);
  }

  glm::vec3 toLight() const { return toLight_; }

  std::uint32_t count(const ShadowRay& ray) const {
    const glm::dvec3 at = frame_.see(ray.origin);
    const glm::dvec3 c = glm::floor((at - grid_.lower) / grid_.cell);
    if (!(c.x >= 0 && c.y >= 0 && c.x < grid_.size.x && c.y < grid_.size.y)) return 0;
    const RayFrame exact(ray);
    const glm::vec2 p(at);
    const float behind = static_cast<float>(at.z - scene_.slack);
    std::uint32_t crossings = 0;
    for (const std::uint32_t i : grid_.list({static_cast<int>(c.x), static_cast<int>(c.y), 0})) {
      const glm::vec3 a = seen_[i], b = seen_[i + 1];
      if (std::max(a.z, b.z) < behind || !near(p, glm::vec2(a), glm::vec2(b), radiusSquare_))
        continue;
      if (scene_.ribbons.strand[i] != ray.strand && crossingBegins(scene_.ribbons, i, exact))
        ++crossings;
    }
    return crossings;
  }

 private:
  const Scene& scene_;
  glm::vec3 toLight_;
  RayFrame frame_;
  float radiusSquare_;
  std::vector<glm::vec3> seen_;
  CellLists grid_;
};

/// Any rays, walked cell by cell.
class DeepGrid {
 public:
  explicit DeepGrid(const Scene& scene)
      : scene_(scene), radiusSquare_(static_cast<float>(scene.radius * scene.radius)) {
    from_.reserve(scene.ribbons.points.size());
    for (const glm::vec3 p : scene.ribbons.points) from_.emplace_back(glm::dvec3(p) - scene.centre);
    // Where segments are much longer than they are wide, thin cells hold few that are not crossed.
    const double cell = std::max(4 * scene.radius, 0.15 * scene.meanLength);
    grid_ = makeCellLists(from_, scene.segments, scene.radius, cell);
  }

  /// What a thread keeps between rays: in which ray each segment was looked at last.
  struct Marks {
    std::vector<std::uint32_t> last;
    std::uint32_t ray = 0;
  };
  Marks marks() const { return {std::vector<std::uint32_t>(from_.size(), 0), 0}; }

  std::uint32_t count(const ShadowRay& ray, Marks& marks) const {
    const RayFrame exact(ray);
    const glm::dvec3 origin = exact.origin - scene_.centre, way = exact.along;

    // The part of the ray that is inside the grid.
    double enter = 0, leave = exact.length;
    for (int c = 0; c < 3; ++c) {
      const double low = grid_.lower[c] - origin[c];
      const double high = low + grid_.size[c] * grid_.cell;
      if (way[c] == 0) {
        if (low > 0 || high < 0) return 0;
        continue;
      }
      enter = std::max(enter, std::min(low / way[c], high / way[c]));
      leave = std::min(leave, std::max(low / way[c], high / way[c]));
    }
    if (!(enter <= leave)) return 0;

    const glm::dvec3 entry = origin + enter * way;
    glm::ivec3 cell, step;
    glm::dvec3 next, apart;  // where the ray goes through the next wall, and all that follow
    for (int c = 0; c < 3; ++c) {
      cell[c] = std::clamp(static_cast<int>(std::floor((entry[c] - grid_.lower[c]) / grid_.cell)),
                           0, grid_.size[c] - 1);
      step[c] = way[c] < 0 ? -1 : 1;
      apart[c] = way[c] == 0 ? INFINITY : grid_.cell / std::abs(way[c]);
      const double wall = grid_.lower[c] + (cell[c] + (way[c] < 0 ? 0 : 1)) * grid_.cell;
      next[c] = way[c] == 0 ? INFINITY : (wall - origin[c]) / way[c];
    }

    if (++marks.ray == 0) {  // after 2^32 rays
      std::fill(marks.last.begin(), marks.last.end(), 0);
      marks.ray = 1;
    }
    const glm::vec3 near0(entry), right(exact.right), up(exact.up);
    std::uint32_t crossings = 0;
    for (;;) {
      for (const std::uint32_t i : grid_.list(cell)) {
        if (std::exchange(marks.last[i], marks.ray) == marks.ray) continue;
        const glm::vec3 a = from_[i] - near0, b = from_[i + 1] - near0;
        if (!near({0, 0}, {glm::dot(a, right), glm::dot(a, up)},
                  {glm::dot(b, right), glm::dot(b, up)}, radiusSquare_))
          continue;
        if (scene_.ribbons.strand[i] != ray.strand && crossingBegins(scene_.ribbons, i, exact))
          ++crossings;
      }
      const int c = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
      if (next[c] > leave) return crossings;
      cell[c] += step[c];
      if (cell[c] < 0 || cell[c] >= grid_.size[c]) return crossings;
      next[c] += apart[c];
    }
  }

 private:
  const Scene& scene_;
  float radiusSquare_;
  std::vector<glm::vec3> from_;  // points, from the centre
  CellLists grid_;
};

class GridTracer final : public FibreTracer {
 public:
  GridTracer(StrandView strands, const Fibre& fibre)
      : scene_(makeScene(strands, fibre)), deep_(scene_) {}

  void countCrossings(std::span<const ShadowRay> rays,
                      std::span<std::uint32_t> out) const override {
    checkRays(rays, out.size());
    if (scene_.segments.empty()) {
      std::fill(out.begin(), out.end(), 0);
      return;
    }
    if (const auto flat = flatGrid(rays)) {
      parallelFor(rays.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) out[r] = flat->count(rays[r]);
      });
      return;
    }
    parallelFor(rays.size(), 256, [&](std::size_t begin, std::size_t end) {
      DeepGrid::Marks marks = deep_.marks();
      for (std::size_t r = begin; r < end; ++r) out[r] = deep_.count(rays[r], marks);
    });
  }

 private:
  static Scene makeScene(StrandView strands, const Fibre& fibre) {
    Scene scene;
    scene.ribbons = makeRibbonPoints(strands, fibre);
    const auto& points = scene.ribbons.points;
    glm::dvec3 lower(INFINITY), upper(-INFINITY);
    for (std::size_t i = 0; i < points.size(); ++i) {
      lower = glm::min(lower, glm::dvec3(points[i])),
      upper = glm::max(upper, glm::dvec3(points[i]));
      if (!scene.ribbons.isSegment(i)) continue;
      scene.segments.push_back(static_cast<std::uint32_t>(i));
      scene.meanLength += glm::distance(glm::dvec3(points[i]), glm::dvec3(points[i + 1]));
    }
    if (scene.segments.empty()) return scene;
    scene.meanLength /= static_cast<double>(scene.segments.size());
    scene.centre = 0.5 * (lower + upper);
    scene.slack = 2e-6 * (glm::distance(lower, upper) + scene.ribbons.halfWidth);
    scene.radius = scene.ribbons.halfWidth + scene.slack;
    return scene;
  }

  /// The grid across the rays, if they are many and parallel; that of the last call is kept.
  std::shared_ptr<const FlatGrid> flatGrid(std::span<const ShadowRay> rays) const {
    if (rays.empty()) return nullptr;
    const glm::vec3 way = rays.front().toLight;
    for (const ShadowRay& ray : rays)
      if (ray.toLight != way) return nullptr;
    const std::lock_guard lock(mutex_);
    if (flat_ && flat_->toLight() == way) return flat_;
    if (rays.size() < scene_.segments.size() / 8) return nullptr;
    return flat_ = std::make_shared<const FlatGrid>(scene_, way);
  }

  Scene scene_;
  DeepGrid deep_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const FlatGrid> flat_;
};

}  // namespace

std::unique_ptr<FibreTracer> makeGridTracer(StrandView strands, const Fibre& fibre) {
  return std::make_unique<GridTracer>(strands, fibre);
}

}  // namespace hair
