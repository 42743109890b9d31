#include <libhair/measure/shadow/shadow_trial.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/shadow/density_map.h>

namespace hair {

namespace {

constexpr int kMostCells = 512;

// A list of candidates with unique labels.
class List {
 public:
  void add(const ShadowSettings& settings) {
    const std::string method = methodName(settings);
    add(method, method + ' ' + settingsText(settings), settings);
  }
  void add(std::string method, std::string label, const ShadowSettings& settings) {
    std::replace(label.begin(), label.end(), ',', ';');
    // Number equal labels: each is a column of a table.
    std::string unique = label;
    for (int n = 2; !labels_.insert(unique).second; ++n) unique = text(label, " (", n, ')');
    candidates.push_back({std::move(method), std::move(unique), settings});
  }

  std::vector<ShadowCandidate> candidates;

 private:
  std::set<std::string> labels_;
};

DensityMapSettings densityMap(float cellSize, float extent, Deposit deposit, Filter filter) {
  // Add a margin of a cell on each side: hair may begin in the middle of one.
  DensityMapSettings settings = settingsForFootprint(cellSize, extent + 2 * cellSize, kMostCells);
  settings.deposit = deposit;
  settings.filter = filter;
  return settings;
}

DensityMapSettings footprintMap(float cellSize, float footprint, float extent) {
  // Add the reach of the filter, so that it does not wrap around to the other side of the hair.
  const float reach = 2 * (footprint + cellSize);
  DensityMapSettings settings =
      densityMap(cellSize, extent + reach, Deposit::Columns, Filter::Footprint);
  settings.footprint = footprint;
  return settings;
}

void addDensityMaps(float footprint, float extent, CandidateSet set, List& list) {
  if (set == CandidateSet::Quick) {
    list.add(footprintMap(footprint * 2 / 3, footprint, extent));
    return;
  }
  // Add the paper's own: 128 cells over the hair and a margin, one count per point (section 4.3).
  DensityMapSettings paper;
  paper.cells = 128;
  paper.cellSize = std::ceil(extent / 126 * 1e5f) * 1e-5f;  // rounded up for a short label
  paper.deposit = Deposit::Points;
  paper.filter = Filter::Paper;
  list.add(paper);
  paper.filter = Filter::Centred;
  list.add(paper);
  paper.cellSize = std::max(paper.cellSize, DensityMapSettings{}.cellSize);
  paper.filter = Filter::Paper;
  list.add(paper);
  list.add(densityMap(footprint, extent, Deposit::Points, Filter::Paper));
  list.add(densityMap(footprint, extent, Deposit::Columns, Filter::None));
  list.add(densityMap(footprint, extent, Deposit::Columns, Filter::Paper));
  for (const float part : {2.0f / 3, 1.0f, 1.5f, 2.0f, 3.0f, 5.0f})
    list.add(densityMap(part * footprint, extent, Deposit::Columns, Filter::Centred));
  list.add(densityMap(footprint, extent, Deposit::Segments, Filter::Centred));
  for (const float part : {1.0f / 3, 0.5f, 2.0f / 3, 1.0f})
    list.add(footprintMap(part * footprint, footprint, extent));
}

void addShadowMaps(float footprint, CandidateSet set, List& list) {
  ShadowMapSettings settings;
  settings.pixelSize = footprint / 3;
  settings.filterRadius = footprint;
  settings.bias = footprint / 3;
  list.add(settings);
  if (set == CandidateSet::Quick) return;
  settings.pixelSize = footprint / 6;
  list.add(settings);
  settings.pixelSize = footprint / 3;
  settings.filterRadius = 2 * footprint;
  list.add(settings);
}

// Sizes of a light image's pixels that are tried, metres.
struct PixelSizes {
  float usual, fine, coarse;
  explicit PixelSizes(float footprint)
      : usual(footprint), fine(footprint * 2 / 3), coarse(footprint * 1.5f) {}
};

// As in the method's own paper: its extinction, and one fetch.
template <class Settings>
Settings published(float pixelSize) {
  Settings settings;
  settings.pixelSize = pixelSize;
  settings.extinction = Extinction::Published;
  settings.filter = LateralFilter::Nearest;
  return settings;
}

void addOpacityMaps(const PixelSizes& pixels, CandidateSet set, List& list) {
  OpacityMapSettings settings;
  const auto add = [&](float pixelSize, int slices) {
    settings.pixelSize = pixelSize;
    settings.slices = slices;
    list.add(settings);
  };
  add(pixels.usual, 64);
  if (set == CandidateSet::Quick) return;
  for (const int slices : {16, 128}) add(pixels.usual, slices);
  for (const int slices : {16, 64, 128}) add(pixels.fine, slices);
  add(pixels.coarse, 64);
  auto paper = published<OpacityMapSettings>(pixels.usual);
  paper.slices = 16;
  list.add(paper);
}

void addDeepOpacityMaps(const PixelSizes& pixels, CandidateSet set, List& list) {
  using Growth = DeepOpacityMapSettings::Growth;
  DeepOpacityMapSettings settings;
  settings.pixelSize = pixels.usual;
  settings.layers = 7;
  list.add(settings);
  if (set == CandidateSet::Quick) return;
  for (const int layers : {3, 7, 15})
    for (const Growth growth : {Growth::Linear, Growth::Doubling}) {
      if (layers == 7 && growth == Growth::Linear) continue;  // above
      settings.layers = layers;
      settings.growth = growth;
      list.add(settings);
    }
  settings.layers = 15;
  settings.growth = Growth::Linear;
  settings.pixelSize = pixels.fine;
  list.add(settings);
  // Deeper layers.
  settings.depth *= 2;
  for (const float pixelSize : {pixels.usual, pixels.coarse}) {
    settings.pixelSize = pixelSize;
    list.add(settings);
  }
  settings.pixelSize = pixels.usual;
  settings.beyond = DeepOpacityMapSettings::Beyond::LargerLayers;
  list.add(settings);
  auto paper = published<DeepOpacityMapSettings>(pixels.usual);
  paper.layers = 3;
  list.add(paper);
}

void addDensityClusterings(const PixelSizes& pixels, CandidateSet set, List& list) {
  DensityClusteringSettings settings;
  const auto add = [&](float pixelSize, int clusters) {
    settings.pixelSize = pixelSize;
    settings.clusters = clusters;
    list.add(settings);
  };
  add(pixels.usual, 4);
  if (set == CandidateSet::Quick) return;
  add(pixels.usual, 8);
  for (const int clusters : {4, 8}) add(pixels.fine, clusters);
  add(pixels.coarse, 8);
  settings.start = DensityClusteringSettings::Start::TowardsLight;
  add(pixels.usual, 8);
  list.add(published<DensityClusteringSettings>(pixels.usual));  // section 3: four clusters
}

void addDeepShadowMaps(const PixelSizes& pixels, CandidateSet set, List& list) {
  DeepShadowMapSettings settings;
  const auto add = [&](float pixelSize, float tolerance) {
    settings.pixelSize = pixelSize;
    settings.tolerance = tolerance;
    list.add(settings);
  };
  add(pixels.usual, 0.01f);
  if (set == CandidateSet::Quick) return;
  add(pixels.usual, 0.05f);
  for (const float tolerance : {0.01f, 0.05f}) add(pixels.fine, tolerance);
  add(pixels.coarse, 0.01f);
  add(pixels.usual, 0);
}

}  // namespace

std::vector<ShadowCandidate> shadowCandidates(StrandView strands, const LightSpace& light,
                                              float footprint, CandidateSet set) {
  require(std::isfinite(footprint) && footprint > 0, "shadow footprint: ", footprint,
          " m is not positive");
  const float extent = std::max(extentSeen(strands, light), 1e-3f);
  List list;
  list.add("auto", "auto", automaticMapSettings(strands, light, footprint));
  addDensityMaps(footprint, extent, set, list);
  addShadowMaps(footprint, set, list);
  const PixelSizes pixels(footprint);
  addOpacityMaps(pixels, set, list);
  addDeepOpacityMaps(pixels, set, list);
  addDensityClusterings(pixels, set, list);
  addDeepShadowMaps(pixels, set, list);
  return std::move(list.candidates);
}

std::span<const std::string> candidateMethods() {
  static const std::vector<std::string> names = {
      "auto",
      methodName(DensityMapSettings{}),
      methodName(ShadowMapSettings{}),
      methodName(OpacityMapSettings{}),
      methodName(DeepOpacityMapSettings{}),
      methodName(DensityClusteringSettings{}),
      methodName(DeepShadowMapSettings{}),
  };
  return names;
}

}  // namespace hair
