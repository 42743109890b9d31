#include <libhair/hair_mesh/grow.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/hair_mesh/mean_value.h>

namespace hair {
namespace {

enum Use : std::uint32_t {
  BundleTime = 0x500,
  BundleTimeLow,
  StartX,
  StartY,
  JitterX,
  JitterY,
  Keep
};

constexpr std::uint32_t kDensitySamples = 256;
constexpr std::uint32_t kTriesPerRoot = 4096;

std::uint32_t keyOf(std::uint32_t bundle, std::uint32_t number) {
  return hashWord(bundle ^ hashWord(number));
}

/// The infinite sequence of candidates over one face.
class Candidates {
 public:
  Candidates(std::span<const glm::vec3> face, std::uint32_t bundle, std::uint32_t seed)
      : face_(face),
        flat_(face),
        bundle_(bundle),
        seed_(seed),
        lower_(INFINITY),
        upper_(-INFINITY) {
    for (const glm::dvec2 c : flat_.corners)
      lower_ = glm::min(lower_, c), upper_ = glm::max(upper_, c);
    start_ = {static_cast<double>(uniform(bundle, StartX, seed)),
              static_cast<double>(uniform(bundle, StartY, seed))};
  }

  double area() const { return flat_.area; }

  /// False for a candidate outside of the face; else sets its weights and its position.
  bool at(std::uint32_t number, std::span<float> weights, glm::vec3& place) const {
    // Jitter by the spacing of the candidates so far, which hides rows without leaving gaps.
    const double i = number, jitter = 0.7 / std::sqrt(i + 1);
    const std::uint32_t key = keyOf(bundle_, number);
    const glm::dvec2 offset(uniform(key, JitterX, seed_) - 0.5f,
                            uniform(key, JitterY, seed_) - 0.5f);
    const glm::dvec2 box = glm::fract(
        start_ + i * glm::dvec2(0.7548776662466927, 0.5698402909980532) + jitter * offset);
    const glm::dvec2 p = lower_ + box * (upper_ - lower_);
    if (!flat_.contains(p)) return false;
    meanValueCoordinates(flat_.corners, p, weights);
    place = glm::vec3(0);
    for (std::size_t c = 0; c < face_.size(); ++c) place += weights[c] * face_[c];
    return true;
  }

  /// In [0, 1): the candidate is accepted where density over its maximum is above this.
  float threshold(std::uint32_t number) const {
    return uniform(keyOf(bundle_, number), Keep, seed_);
  }

 private:
  std::span<const glm::vec3> face_;
  FlatPolygon flat_;
  std::uint32_t bundle_, seed_;
  glm::dvec2 lower_, upper_, start_;
};

struct BundleRoots {
  double mass = 0;     // square metres times density
  float greatest = 1;  // density
  double time = 0;     // u_j
  std::uint32_t count = 0;
  std::vector<std::uint32_t> numbers;
  std::vector<float> weights;
  std::vector<glm::vec3> places;
};

float densityAt(const ScalpDensity& density, glm::vec3 p) {
  const float d = density(p);
  return d > 0 ? std::min(d, 1.0f) : 0.0f;  // a NaN counts as 0
}

void weigh(const Candidates& candidates, const ScalpDensity& density, std::span<float> weights,
           BundleRoots& bundle) {
  bundle.mass = candidates.area();
  if (!density || bundle.mass == 0) return;
  double sum = 0;
  std::uint32_t samples = 0;
  bundle.greatest = 0;
  glm::vec3 p;
  for (std::uint32_t i = 0; i < kDensitySamples * 16 && samples < kDensitySamples; ++i) {
    if (!candidates.at(i, weights, p)) continue;
    const float d = densityAt(density, p);
    bundle.greatest = std::max(bundle.greatest, d);
    sum += static_cast<double>(d);
    ++samples;
  }
  bundle.mass *= samples > 0 ? sum / samples : 0;
}

std::uint32_t arrivedBy(const BundleRoots& bundle, double time) {
  return static_cast<std::uint32_t>(std::max(0.0, std::ceil(time * bundle.mass - bundle.time)));
}

// Sets the bundles' counts so that the `strands` earliest roots of all sequences are taken.
void countArrivals(std::uint32_t strands, double mass, std::vector<BundleRoots>& bundles) {
  const auto total = [&](double time) {
    std::uint64_t sum = 0;
    for (const BundleRoots& bundle : bundles) sum += arrivedBy(bundle, time);
    return sum;
  };
  double early = 0, late = (strands + 1.0 + static_cast<double>(bundles.size())) / mass;
  for (int i = 0; i < 200 && total(early) < strands; ++i) {
    const double middle = 0.5 * (early + late);
    (total(middle) <= strands ? early : late) = middle;
  }
  // `late` is the time of the next roots; of several at that time, take those of the first bundles.
  std::uint64_t missing = strands - total(early);
  for (BundleRoots& bundle : bundles) {
    bundle.count = arrivedBy(bundle, early);
    const std::uint64_t more =
        std::min<std::uint64_t>(missing, arrivedBy(bundle, late) - bundle.count);
    bundle.count += static_cast<std::uint32_t>(more);
    missing -= more;
  }
}

void queue(const Candidates& candidates, const ScalpDensity& density, std::span<float> weights,
           BundleRoots& bundle) {
  const std::uint64_t tries =
      std::min<std::uint64_t>(kTriesPerRoot * (std::uint64_t{bundle.count} + 1), 0xffffffffu);
  glm::vec3 p;
  for (std::uint32_t i = 0; i < tries && bundle.numbers.size() < bundle.count; ++i) {
    if (!candidates.at(i, weights, p)) continue;
    if (density && densityAt(density, p) <= candidates.threshold(i) * bundle.greatest) continue;
    bundle.numbers.push_back(i);
    bundle.weights.insert(bundle.weights.end(), weights.begin(), weights.end());
    bundle.places.push_back(p);
  }
}

}  // namespace

float DensityImage::operator()(glm::vec3 p) const {
  const glm::vec2 size(width, height);
  const glm::vec2 at = glm::clamp((glm::vec2(p.x, p.z) - lower) / (upper - lower) * size - 0.5f,
                                  glm::vec2(0), size - 1.0f);
  const glm::uvec2 a(at), b = glm::min(a + 1u, glm::uvec2(width - 1, height - 1));
  const glm::vec2 t = at - glm::vec2(a);
  const auto value = [&](std::uint32_t x, std::uint32_t y) {
    return values[std::size_t{y} * width + x];
  };
  return glm::mix(glm::mix(value(a.x, a.y), value(b.x, a.y), t.x),
                  glm::mix(value(a.x, b.y), value(b.x, b.y), t.x), t.y);
}

std::uint32_t HairMeshRoots::key(std::size_t root) const {
  return keyOf(bundle[root], number[root]);
}

HairMeshRoots placeRoots(const HairMesh& mesh, const RootSettings& settings,
                         const ScalpDensity& density) {
  require(settings.perSquareMetre >= 0 && settings.perSquareMetre < 1e9f,
          "roots: ", settings.perSquareMetre,
          " a square metre; take 0 (as `strands` says) or more");
  const std::size_t bundleCount = mesh.bundleCount();
  std::vector<BundleRoots> bundles(bundleCount);
  const auto forBundles = [&](auto&& body) {
    parallelFor(bundleCount, 1, [&](std::size_t begin, std::size_t end) {
      std::vector<glm::vec3> face;
      std::vector<float> weights;
      for (std::size_t j = begin; j < end; ++j) {
        if (mesh.lastLayer[j] == 0) continue;
        face.clear();
        for (const std::uint32_t v : mesh.face(0, j)) face.push_back(mesh.layers[0].positions[v]);
        weights.resize(face.size());
        body(Candidates(face, static_cast<std::uint32_t>(j), settings.seed), weights, bundles[j]);
      }
    });
  };
  forBundles([&](const Candidates& candidates, std::span<float> weights, BundleRoots& bundle) {
    weigh(candidates, density, weights, bundle);
  });
  double mass = 0;
  for (std::uint32_t j = 0; j < bundleCount; ++j) {
    mass += bundles[j].mass;
    // Use two random words: equal times are then unlikely even in a large mesh.
    bundles[j].time = static_cast<double>(uniform(j, BundleTime, settings.seed)) +
                      static_cast<double>(uniform(j, BundleTimeLow, settings.seed)) * 0x1p-24;
  }
  require(mass > 0, "roots: no bundle with length has a face with area",
          density ? " and density" : "", "; extrude some faces first");
  if (settings.perSquareMetre > 0) {
    const auto time = static_cast<double>(settings.perSquareMetre);
    require(time * mass < 1e8, "roots: ", time * mass, " strands; lower perSquareMetre");
    for (BundleRoots& bundle : bundles) bundle.count = arrivedBy(bundle, time);
  } else {
    countArrivals(settings.strands, mass, bundles);
  }
  forBundles([&](const Candidates& candidates, std::span<float> weights, BundleRoots& bundle) {
    queue(candidates, density, weights, bundle);
  });

  HairMeshRoots roots;
  for (std::uint32_t j = 0; j < bundleCount; ++j) {
    const BundleRoots& b = bundles[j];
    roots.bundle.insert(roots.bundle.end(), b.numbers.size(), j);
    roots.number.insert(roots.number.end(), b.numbers.begin(), b.numbers.end());
    roots.weights.insert(roots.weights.end(), b.weights.begin(), b.weights.end());
    roots.positions.insert(roots.positions.end(), b.places.begin(), b.places.end());
    for (std::size_t i = 0; i < b.numbers.size(); ++i)
      roots.firstWeight.push_back(roots.firstWeight.back() + mesh.sides(j));
    roots.firstRoot.push_back(static_cast<std::uint32_t>(roots.bundle.size()));
  }
  return roots;
}

void validate(const HairMeshRoots& roots, const HairMesh& mesh) {
  const std::size_t count = roots.bundle.size();
  require(roots.number.size() == count && roots.positions.size() == count &&
              roots.firstWeight.size() == count + 1 && !roots.firstRoot.empty() &&
              roots.firstRoot.back() == count && roots.firstWeight.back() == roots.weights.size(),
          "roots: ", count, " roots, but arrays of other sizes");
  const bool bundles = roots.firstRoot.size() == mesh.bundleCount() + 1;
  require(bundles, "roots: placed on ", roots.firstRoot.size() - 1, " bundles, but the mesh has ",
          mesh.bundleCount(), "; place them again");
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    const std::uint32_t begin = roots.firstRoot[j], end = roots.firstRoot[j + 1];
    require(begin == end ||
                (mesh.lastLayer[j] > 0 && roots.firstWeight[end] - roots.firstWeight[begin] ==
                                              (end - begin) * mesh.sides(j)),
            "roots: bundle ", j, " has changed its sides or lost its length; place them again");
  }
}

}  // namespace hair
