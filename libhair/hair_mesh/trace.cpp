#include <libhair/hair_mesh/grow.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {
namespace {

constexpr std::size_t kChords = 8;  // that measure the length of one span of the spline

/// One strand's spline. Kept from strand to strand for its memory.
class Spline {
 public:
  void clear() { knots_.clear(); }
  void add(glm::vec3 p) {
    // Points closer than this have no direction in single precision.
    if (!knots_.empty() && glm::distance(knots_.back().p, p) < 1e-7f) {
      // Keep the newer point, so that the tip is exact, but never replace the root.
      if (knots_.size() > 1) knots_.back().p = p;
      return;
    }
    knots_.push_back({p, {}, 0, {}, {}, {}});
  }

  void sample(std::span<glm::vec3> points) {
    const std::size_t n = knots_.size();
    std::ranges::fill(points, knots_[0].p);
    if (n == 1) return;
    findVelocities();
    findCubics();
    // Lengths up to the ends of short chords.
    chords_.assign(1, {knots_[0].p, 0});
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t c = 1; c <= kChords; ++c) {
        const glm::vec3 p = at(i, static_cast<float>(c) / kChords);
        chords_.push_back({p, chords_.back().length + glm::distance(chords_.back().end, p)});
      }
    // Interpolate the parameter of a point linearly along its chord, then correct it by the length
    // that this reaches, as the speed changes along the chord.
    std::size_t c = 0;
    const auto last = static_cast<float>(points.size() - 1);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const float wanted = chords_.back().length * static_cast<float>(k) / last;
      while (c + 2 < chords_.size() && chords_[c + 1].length < wanted) ++c;
      const float rest = wanted - chords_[c].length;
      const auto along = [&](float share) {
        return at(c / kChords, (static_cast<float>(c % kChords) + std::min(share, 1.0f)) / kChords);
      };
      float share = rest / (chords_[c + 1].length - chords_[c].length);
      for (int correction = 0; correction < 2; ++correction) {
        const float came = glm::distance(chords_[c].end, along(share));
        if (came > 0) share *= rest / came;
      }
      points[k] = along(share);
    }
    points.front() = knots_.front().p;
    points.back() = knots_.back().p;
  }

 private:
  struct Knot {
    glm::vec3 p, velocity;
    float span;                      // to the next, in the spline's parameter
    glm::vec3 linear, square, cube;  // from p, for a parameter from 0 to 1 along the span
  };

  // The derivative at a knot is that of the parabola through it and its neighbours, which is
  // Catmull and Rom's for any knots (Barry and Goldman 1988).
  void findVelocities() {
    const std::size_t n = knots_.size();
    for (std::size_t i = 0; i + 1 < n; ++i)
      knots_[i].span = std::sqrt(glm::distance(knots_[i].p, knots_[i + 1].p));
    const auto slope = [&](std::size_t i) {
      return (knots_[i + 1].p - knots_[i].p) / knots_[i].span;
    };
    knots_[0].velocity = slope(0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const float a = knots_[i - 1].span, b = knots_[i].span;
      knots_[i].velocity = (b * slope(i - 1) + a * slope(i)) / (a + b);
    }
    knots_[n - 1].velocity = slope(n - 2);
  }

  // Each span's cubic has the places and velocities of its ends.
  void findCubics() {
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
      Knot& k = knots_[i];
      const glm::vec3 chord = knots_[i + 1].p - k.p;
      const glm::vec3 va = k.span * k.velocity, vb = k.span * knots_[i + 1].velocity;
      k.linear = va;
      k.square = 3.0f * chord - 2.0f * va - vb;
      k.cube = va + vb - 2.0f * chord;
    }
  }

  glm::vec3 at(std::size_t i, float t) const {
    const Knot& k = knots_[i];
    return k.p + t * (k.linear + t * (k.square + t * k.cube));
  }

  std::vector<Knot> knots_;
  struct ChordEnd {
    glm::vec3 end;
    float length;  // from the root to there
  };
  std::vector<ChordEnd> chords_;  // [(knots - 1) kChords + 1]
};

}  // namespace

void traceStrands(const HairMesh& mesh, const HairMeshRoots& roots, std::uint32_t points,
                  StrandSet& strands) {
  require(points >= 2, "strands of a hair mesh need at least 2 points, not ", points);
  validate(roots, mesh);
  const std::size_t count = roots.rootCount();
  require(count * points <= 0xffffffffu, "strands of a hair mesh: ", count, " of ", points,
          " points are more than 32 bits count; take fewer of either");
  strands.points.resize(count * points);
  strands.first.resize(count + 1);
  for (std::size_t s = 0; s <= count; ++s)
    strands.first[s] = static_cast<std::uint32_t>(s * points);
  parallelFor(count, 256, [&](std::size_t begin, std::size_t end) {
    Spline spline;
    for (std::size_t r = begin; r < end; ++r) {
      const std::uint32_t j = roots.bundle[r];
      const auto weights = roots.weightsOf(r);
      spline.clear();
      for (std::uint32_t k = 0; k <= mesh.lastLayer[j]; ++k) {
        const auto face = mesh.face(k, j);
        glm::vec3 p(0);
        for (std::size_t i = 0; i < face.size(); ++i)
          p += weights[i] * mesh.layers[k].positions[face[i]];
        spline.add(p);
      }
      spline.sample(strands.strand(r));
    }
  });
}

}  // namespace hair
