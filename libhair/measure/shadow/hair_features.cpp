#include <libhair/density/cell_frame.h>
#include <libhair/measure/shadow/hair_features.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hair {

namespace {

constexpr int kFinest = 128;               // boxes along an axis
constexpr std::uint32_t kRemembered = 64;  // strands that caches hold, roughly
constexpr double kMostSteps = 4e6;         // of the walk; beyond that strands are left out

/// Which boxes of a grid of n^3 or n^2 hold something.
class Marks {
 public:
  Marks(int n, int dimensions) : n_(n), dimensions_(dimensions) {
    std::size_t size = 1;
    for (int d = 0; d < dimensions; ++d) size *= static_cast<std::size_t>(n);
    marked_.resize(size);
  }
  void mark(int a, int b, int c) { marked_[index(a, b, c)] = 1; }
  double count() const {
    return static_cast<double>(std::count(marked_.begin(), marked_.end(), 1));
  }
  /// Of boxes twice as large.
  Marks halved() const {
    Marks half(n_ / 2, dimensions_);
    const int third = dimensions_ == 3 ? n_ : 1;
    for (int c = 0; c < third; ++c)
      for (int b = 0; b < n_; ++b)
        for (int a = 0; a < n_; ++a)
          if (marked_[index(a, b, c)]) half.mark(a / 2, b / 2, c / 2);
    return half;
  }
  int n() const { return n_; }

 private:
  std::size_t index(int a, int b, int c) const {
    const auto n = static_cast<std::size_t>(n_);
    return (static_cast<std::size_t>(c) * n + static_cast<std::size_t>(b)) * n +
           static_cast<std::size_t>(a);
  }
  int n_, dimensions_;
  std::vector<std::uint8_t> marked_;
};

HairFeatures::Occupied occupied(Marks marks, double extent) {
  HairFeatures::Occupied result;
  while (true) {
    result.count.push_back(std::max(marks.count(), 1.0));
    if (marks.n() <= 4) break;
    marks = marks.halved();
  }
  std::reverse(result.count.begin(), result.count.end());
  result.coarsest = extent / marks.n();
  return result;
}

}  // namespace

double HairFeatures::Occupied::at(double side) const {
  if (count.empty()) return 1;
  const double level = std::log2(coarsest / side);
  const auto last = static_cast<double>(count.size() - 1);
  if (level <= 0) return std::max(1.0, count.front() * std::exp2(2 * level));
  const auto below = static_cast<std::size_t>(std::clamp(std::floor(level), 0.0, last - 1));
  const double low = std::log2(count[below]), high = std::log2(count[below + 1]);
  return std::exp2(low + (level - static_cast<double>(below)) * (high - low));
}

HairFeatures hairFeatures(StrandView strands, const LightSpace& light) {
  HairFeatures hair;
  hair.strands = static_cast<double>(strands.strandCount());
  hair.points = static_cast<double>(strands.pointCount());
  if (strands.pointCount() == 0) return hair;
  const CellFrame frame = makeCellFrame(light, glm::vec3(0), 1.0f, 2);
  std::vector<glm::vec3> at(strands.pointCount());
  Bounds box;
  for (std::size_t p = 0; p < at.size(); ++p)
    box.extend(at[p] = frame.cellCoordinates(strands.points[p]));
  hair.size = box.size();
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    for (std::size_t p = strands.first[s] + 1; p < strands.first[s + 1]; ++p) {
      const glm::dvec3 d = glm::abs(glm::dvec3(at[p] - at[p - 1]));
      hair.segments += 1;
      hair.way += d;
      hair.longestWay += std::max({d.x, d.y, d.z});
    }
  const double extent = std::max({hair.size.x, hair.size.y, hair.size.z, 1e-4}) * 1.0001;
  const double side = extent / kFinest;
  const double steps = hair.segments + hair.longestWay / side;
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(steps / kMostSteps)));
  Marks boxes(kFinest, 3), pixels(kFinest, 2);
  // The last strand that went through a box, counted from 1, and how many boxes strands entered.
  std::vector<std::uint32_t> last(std::size_t{kFinest} * kFinest * kFinest);
  double entered = 0, cold = 0;
  std::uint32_t walked = 0;
  const auto place = [&](float u) {
    return std::clamp(static_cast<int>(static_cast<double>(u) / side), 0, kFinest - 1);
  };
  for (std::size_t s = 0; s < strands.strandCount(); s += stride) {
    ++walked;
    for (std::size_t p = strands.first[s]; p + 1 < strands.first[s + 1]; ++p) {
      const glm::vec3 a = at[p] - box.lower, d = at[p + 1] - at[p];
      const double longest =
          static_cast<double>(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
      const int parts = 1 + static_cast<int>(longest / side);
      for (int k = 0; k < parts; ++k) {
        const glm::vec3 u = a + d * ((static_cast<float>(k) + 0.5f) / static_cast<float>(parts));
        const int x = place(u.x), y = place(u.y), z = place(u.z);
        boxes.mark(y, z, x);
        pixels.mark(y, z, 0);
        std::uint32_t& stamp =
            last[(static_cast<std::size_t>(x) * kFinest + static_cast<std::size_t>(z)) * kFinest +
                 static_cast<std::size_t>(y)];
        if (stamp != walked) {
          entered += 1;
          cold += stamp == 0 || walked - stamp > kRemembered / stride ? 1 : 0;
          stamp = walked;
        }
      }
    }
  }
  hair.coldShare = entered > 0 ? cold / entered : 0;
  hair.boxes = occupied(std::move(boxes), extent);
  hair.pixels = occupied(std::move(pixels), extent);
  return hair;
}

}  // namespace hair
