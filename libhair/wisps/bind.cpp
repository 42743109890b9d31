#include <libhair/wisps/bind.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/model/resample.h>
#include <libhair/wisps/guide_curves.h>
#include <libhair/wisps/wisps.h>

namespace hair {

namespace {

// Similarity of strands: by root, and by the vector from the root to the rest of the strand.
struct Feature {
  glm::vec3 root, reach;
};

float difference(const Feature& a, const Feature& b) {
  const glm::vec3 root = a.root - b.root, reach = a.reach - b.reach;
  return glm::dot(root, root) + glm::dot(reach, reach);
}

std::vector<Feature> featuresOf(StrandView strands, float shapeWeight) {
  std::vector<Feature> features;
  features.reserve(strands.strandCount());
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto p = strands.strand(s);
    // Use the mean of middle and tip, so that a loop does not count as a short strand.
    const glm::vec3 reach = 0.5f * (p[p.size() / 2] + p.back()) - p.front();
    features.push_back({p.front(), shapeWeight * reach});
  }
  return features;
}

// Farthest-point sampling, starting with the strand nearest to the mean root.
std::vector<std::uint32_t> chooseGuides(const std::vector<Feature>& features, std::size_t count) {
  glm::vec3 mean(0);
  for (const Feature& f : features) mean += f.root / static_cast<float>(features.size());
  std::vector<float> distance(features.size(), std::numeric_limits<float>::max());
  std::size_t next = 0;
  for (std::size_t s = 1; s < features.size(); ++s)
    if (glm::distance(features[s].root, mean) < glm::distance(features[next].root, mean)) next = s;
  std::vector<std::uint32_t> chosen;
  while (chosen.size() < std::min(count, features.size())) {
    chosen.push_back(static_cast<std::uint32_t>(next));
    for (std::size_t s = 0; s < features.size(); ++s)
      distance[s] = std::min(distance[s], difference(features[s], features[next]));
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) -
                                    distance.begin());
  }
  return chosen;
}

}  // namespace

void keepShape(StrandView strands, Groom& groom) {
  require(strands.points.size() == groom.pointCount(), "keepShape: ", strands.points.size(),
          " points for a groom of ", groom.pointCount());
  groom.offsets.assign(groom.pointCount(), glm::vec3(0));
  const GuideStrands rest(groom, {});
  const Wisps wisps(groom, rest);
  parallelFor(groom.strandCount(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const std::uint32_t n = groom.first[s + 1] - groom.first[s];
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::size_t at = groom.first[s] + k;
        const auto frame = wisps.curves->frame(groom.parents[s].x, wisps.sampleOf(k, n));
        groom.offsets[at] = frame.fromWorld(strands.points[at] - wisps.points[at]);
      }
    }
  });
}

Groom bindGroom(StrandView strands, const BindSettings& settings, float hairs) {
  validate(strands, "bindGroom", 2);
  require(strands.strandCount() > 0, "bindGroom: no strands");
  static_assert(rangeOf(&BindSettings::pointsPerGuide).most() == kMaxGuidePoints);
  validateFields(settings, "bindGroom");
  const auto features = featuresOf(strands, settings.shapeWeight);
  const auto guides = chooseGuides(features, settings.guides);

  Groom groom;
  groom.pointsPerGuide = settings.pointsPerGuide;
  groom.guidePoints = resample(planResampling(strands, guides, settings.pointsPerGuide),
                               std::vector(strands.points.begin(), strands.points.end()));
  groom.first.assign(strands.first.begin(), strands.first.end());
  groom.parents.resize(strands.strandCount());
  groom.weights.resize(strands.strandCount());
  groom.fibre.hairsPerStrand = hairsEach(strands.strandCount(), hairs);

  // Let each strand follow its three nearest guides.
  parallelFor(strands.strandCount(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<float> distance(guides.size());
    std::vector<std::uint32_t> order(guides.size());
    for (std::size_t s = begin; s < end; ++s) {
      for (std::size_t g = 0; g < guides.size(); ++g)
        distance[g] = difference(features[s], features[guides[g]]);
      std::iota(order.begin(), order.end(), 0u);
      const auto three = static_cast<std::ptrdiff_t>(std::min<std::size_t>(3, guides.size()));
      std::partial_sort(order.begin(), order.begin() + three, order.end(), [&](auto a, auto b) {
        return distance[a] != distance[b] ? distance[a] < distance[b] : a < b;
      });
      glm::vec3 weights(0);
      for (int j = 0; j < 3; ++j) {
        groom.parents[s][j] = j < three ? order[static_cast<std::size_t>(j)] : order[0];
        // Weigh by the inverse squared distance: the main guide dominates, the others smooth the
        // transitions.
        if (j < three) weights[j] = 1.0f / (distance[order[static_cast<std::size_t>(j)]] + 1e-8f);
      }
      groom.weights[s] = weights / (weights.x + weights.y + weights.z);
    }
  });

  keepShape(strands, groom);
  return groom;
}

}  // namespace hair
