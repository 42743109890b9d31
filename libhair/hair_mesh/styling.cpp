#include <libhair/hair_mesh/grow.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/mean_value.h>
#include <libhair/model/guide_curve.h>

namespace hair {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

enum Use : std::uint32_t {
  Length = 0x600,
  CurlPhase,
  CurlPitch,
  NoiseX,
  NoiseY,
  FrizzX,
  FrizzY,
  Frizzy
};

bool moves(const StylingSettings& s) {
  return s.curlRadius > 0 || s.noise > 0 || (s.frizz > 0 && s.frizzShare > 0);
}

void validate(const StylingSettings& s) {
  require(s.lengthCut >= 0 && s.lengthVariation >= 0 && s.lengthCut + s.lengthVariation < 1,
          "styling: lengthCut ", s.lengthCut, " and lengthVariation ", s.lengthVariation,
          "; take 0 or more, and less than 1 together");
  const auto share = [](float x) { return x >= 0 && x <= 1; };
  require(share(s.clump) && share(s.frizzShare) && share(s.curlFromRoot) && s.curlFromRoot < 1,
          "styling: clump ", s.clump, ", frizzShare ", s.frizzShare, " and curlFromRoot ",
          s.curlFromRoot, " are shares; take 0 to 1 (curlFromRoot less)");
  require(s.clumpSize >= 1, "styling: clumpSize 0; a clump has 1 strand or more");
  const auto size = [](float x) { return x >= 0 && x < 1e3f; };
  require(size(s.curlRadius) && size(s.noise) && size(s.frizz), "styling: curlRadius ",
          s.curlRadius, ", noise ", s.noise, " and frizz ", s.frizz, " are metres; take 0 or more");
  const auto pitch = [](float x) { return x >= 1e-4f && x < 1e3f; };
  require(pitch(s.curlPitch) && pitch(s.noiseLength) && pitch(s.frizzLength), "styling: curlPitch ",
          s.curlPitch, ", noiseLength ", s.noiseLength, " and frizzLength ", s.frizzLength,
          " are metres; take 1e-4 or more");
}

// Shortens a strand to this share from its root, by resampling its curve.
void cut(float share, std::span<glm::vec3> strand, std::vector<glm::vec3>& whole) {
  whole.assign(strand.begin(), strand.end());
  for (std::size_t k = 1; k < strand.size(); ++k) {
    const float u = share * static_cast<float>(k);
    const std::size_t i = std::min(static_cast<std::size_t>(u), whole.size() - 2);
    strand[k] = catmullRom(whole, i, u - static_cast<float>(i));
  }
}

// The root that is the centre of each root's clump.
std::vector<std::uint32_t> clumpCentres(const HairMeshRoots& roots, std::uint32_t clumpSize) {
  std::vector<std::uint32_t> centres(roots.rootCount());
  parallelFor(roots.rootCount(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const std::uint32_t first = roots.firstRoot[roots.bundle[r]];
      const std::uint32_t count = roots.firstRoot[roots.bundle[r] + 1] - first;
      // Take the first roots: they are as evenly spread over the bundle as all of them.
      const std::uint32_t clumps = (count - 1) / clumpSize + 1;
      float best = INFINITY;
      for (std::uint32_t c = first; c < first + clumps; ++c) {
        const glm::vec3 d = roots.positions[c] - roots.positions[r];
        if (glm::dot(d, d) < best) best = glm::dot(d, d), centres[r] = c;
      }
    }
  });
  return centres;
}

// Value noise in [-1, 1], with a continuous derivative: interpolates random values at whole x.
float smoothNoise(std::uint32_t key, Use use, std::uint32_t seed, float x) {
  const float cell = std::floor(x), t = x - cell;
  const auto value = [&](std::uint32_t i) { return 2 * uniform(key + hashWord(i), use, seed) - 1; };
  const auto i = static_cast<std::uint32_t>(cell);
  return glm::mix(value(i), value(i + 1), t * t * (3 - 2 * t));
}

/// Offsets of one strand's points across it.
class Deviation {
 public:
  Deviation(const StylingSettings& settings, std::uint32_t seed, std::uint32_t strandKey,
            std::uint32_t lockKey)
      : s_(settings), seed_(seed), strand_(strandKey) {
    phase_ = uniform(lockKey, CurlPhase, seed);
    pitch_ = s_.curlPitch * (1 + 0.2f * (2 * uniform(lockKey, CurlPitch, seed) - 1));
    frizzy_ = s_.frizz > 0 && uniform(strandKey, Frizzy, seed) < s_.frizzShare;
  }

  /// At `along` metres from the root of a strand of `length`, in its frame.
  glm::vec2 at(float along, float length) const {
    glm::vec2 d(0);
    if (s_.curlRadius > 0) {
      // Widens to a full helix over the first turn, so that the strand has no jump where curls
      // begin.
      const float wound = along - s_.curlFromRoot * length;
      const float angle = kTurn * (phase_ + wound / pitch_);
      d += s_.curlRadius * glm::smoothstep(0.0f, pitch_, wound) *
           glm::vec2(std::cos(angle), std::sin(angle));
    }
    constexpr float kPlane = 0.70710678f;  // of a plane's two directions, together at most 1
    if (s_.noise > 0)
      d += kPlane * s_.noise * along / length * noise(NoiseX, NoiseY, along / s_.noiseLength);
    if (frizzy_)
      d += kPlane * s_.frizz * glm::smoothstep(0.0f, 2 * s_.frizzLength, along) *
           noise(FrizzX, FrizzY, along / s_.frizzLength);
    return d;
  }

 private:
  glm::vec2 noise(Use x, Use y, float at) const {
    return {smoothNoise(strand_, x, seed_, at), smoothNoise(strand_, y, seed_, at)};
  }

  const StylingSettings& s_;
  std::uint32_t seed_, strand_;
  float phase_, pitch_;
  bool frizzy_;
};

}  // namespace

void style(const HairMesh& mesh, const HairMeshRoots& roots, const StylingSettings& settings,
           std::uint32_t seed, StrandSet& strands) {
  validate(settings);
  validate(roots, mesh);
  const std::size_t count = strands.strandCount();
  require(count == roots.rootCount(), "styling: ", count, " strands of ", roots.rootCount(),
          " roots");
  for (std::size_t s = 0; s < count; ++s)
    require(strands.strand(s).size() >= 2, "styling: strand ", s, " has fewer than 2 points");

  if (settings.lengthCut + settings.lengthVariation > 0)
    parallelFor(count, 256, [&](std::size_t begin, std::size_t end) {
      std::vector<glm::vec3> whole;
      for (std::size_t r = begin; r < end; ++r) {
        const float more = settings.lengthVariation * uniform(roots.key(r), Length, seed);
        cut(1 - settings.lengthCut - more, strands.strand(r), whole);
      }
    });

  const bool clumps = settings.clump > 0;
  std::vector<std::uint32_t> centres;
  if (clumps || settings.curlRadius > 0) centres = clumpCentres(roots, settings.clumpSize);
  if (clumps) {
    parallelFor(count, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        if (centres[r] == r) continue;  // centres stay: others read them meanwhile
        const auto strand = strands.strand(r);
        // Strands of the caller may differ in their numbers of points.
        const auto centre = strands.view().strand(centres[r]);
        const float last = static_cast<float>(strand.size() - 1);
        for (std::size_t k = 1; k < strand.size(); ++k) {
          const float u = static_cast<float>(k) / last;
          const float at = u * static_cast<float>(centre.size() - 1);
          const std::size_t i = std::min(static_cast<std::size_t>(at), centre.size() - 2);
          strand[k] = glm::mix(strand[k], catmullRom(centre, i, at - static_cast<float>(i)),
                               settings.clump * u * std::sqrt(u));
        }
      }
    });
  }

  if (!moves(settings)) return;
  parallelFor(count, 256, [&](std::size_t begin, std::size_t end) {
    std::vector<glm::vec3> corners;
    std::vector<glm::mat3> frames;
    glm::vec3 normal(0, 1, 0), edge(1, 0, 0);  // of the bundle's face
    std::uint32_t bundle = kNoVertex;
    for (std::size_t r = begin; r < end; ++r) {
      if (roots.bundle[r] != bundle) {
        bundle = roots.bundle[r];
        corners.clear();
        for (const std::uint32_t v : mesh.face(0, bundle))
          corners.push_back(mesh.layers[0].positions[v]);
        const FlatPolygon face(corners);
        if (face.area > 0) normal = face.normal, edge = face.u;
      }
      const auto strand = strands.strand(r);
      const float length = arcLength(strand);
      if (length == 0) continue;
      frames.resize(strand.size());
      transportFrames(normal, edge, strand, frames);
      const Deviation deviation(settings, seed, roots.key(r),
                                centres.empty() ? 0 : roots.key(centres[r]));
      float along = 0;
      glm::vec3 before = strand[0];
      for (std::size_t k = 1; k < strand.size(); ++k) {
        along += glm::distance(before, strand[k]);
        before = strand[k];
        const glm::vec2 d = deviation.at(along, length);
        strand[k] += d.x * frames[k][0] + d.y * frames[k][1];
      }
    }
  });
}

void regrow(const HairMesh& mesh, std::span<const StrandGroup> groups, GrownHair& hair) {
  require(groups.size() == hair.roots.size(), "hair of ", hair.roots.size(), " groups, not ",
          groups.size(), "; grow it anew");
  StrandSet grown;
  std::vector<std::uint32_t> group;
  StrandSet strands;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    traceStrands(mesh, hair.roots[g], groups[g].points, strands);
    style(mesh, hair.roots[g], groups[g].styling, groups[g].seed, strands);
    require(grown.points.size() + strands.points.size() <= 0xffffffffu, "hair of ", groups.size(),
            " groups has more points than 32 bits count; grow fewer");
    const auto offset = static_cast<std::uint32_t>(grown.points.size());
    grown.points.insert(grown.points.end(), strands.points.begin(), strands.points.end());
    for (std::size_t s = 1; s < strands.first.size(); ++s)
      grown.first.push_back(offset + strands.first[s]);
    group.insert(group.end(), strands.strandCount(), static_cast<std::uint32_t>(g));
  }
  hair.strands = std::move(grown);
  hair.group = std::move(group);
}

GrownHair growHair(const HairMesh& mesh, std::span<const StrandGroup> groups,
                   const ScalpDensity& density) {
  GrownHair hair;
  for (const StrandGroup& group : groups)
    hair.roots.push_back(placeRoots(
        mesh,
        {.strands = group.strands, .seed = group.seed, .perSquareMetre = group.perSquareMetre},
        density));
  regrow(mesh, groups, hair);
  return hair;
}

}  // namespace hair
