#include <libhair/measure/shadow/candidates.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/shadow/automatic.h>

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

void addOpacityMaps(float footprint, CandidateSet set, List& list) {
  OpacityMapSettings settings;
  settings.pixelSize = footprint;
  settings.slices = 64;
  list.add(settings);
  if (set == CandidateSet::Quick) return;
  for (const int slices : {16, 128}) {
    settings.slices = slices;
    list.add(settings);
  }
  settings.pixelSize = footprint * 2 / 3;
  for (const int slices : {16, 64, 128}) {
    settings.slices = slices;
    list.add(settings);
  }
  settings.pixelSize = footprint * 1.5f;
  settings.slices = 64;
  list.add(settings);
  list.add(OpacityMapSettings{footprint, 16, Extinction::Published, LateralFilter::Nearest});
}

void addDeepOpacityMaps(float footprint, CandidateSet set, List& list) {
  using Growth = DeepOpacityMapSettings::Growth;
  DeepOpacityMapSettings settings;
  settings.pixelSize = footprint;
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
  settings.pixelSize = footprint * 2 / 3;
  list.add(settings);
  settings.pixelSize = footprint;
  settings.depth *= 2;
  list.add(settings);
  settings.pixelSize = footprint * 1.5f;
  list.add(settings);
  settings.pixelSize = footprint;
  settings.beyond = DeepOpacityMapSettings::Beyond::LargerLayers;
  list.add(settings);
  // Add the paper's own: three layers, one fetch.
  DeepOpacityMapSettings paper;
  paper.pixelSize = footprint;
  paper.layers = 3;
  paper.extinction = Extinction::Published;
  paper.filter = LateralFilter::Nearest;
  list.add(paper);
}

void addDensityClusterings(float footprint, CandidateSet set, List& list) {
  DensityClusteringSettings settings;
  settings.pixelSize = footprint;
  settings.clusters = 4;
  list.add(settings);
  if (set == CandidateSet::Quick) return;
  settings.clusters = 8;
  list.add(settings);
  settings.pixelSize = footprint * 2 / 3;
  for (const int clusters : {4, 8}) {
    settings.clusters = clusters;
    list.add(settings);
  }
  settings.pixelSize = footprint * 1.5f;
  list.add(settings);
  settings.pixelSize = footprint;
  settings.start = DensityClusteringSettings::Start::TowardsLight;
  list.add(settings);
  DensityClusteringSettings paper;  // section 3: four clusters, one fetch
  paper.pixelSize = footprint;
  paper.extinction = Extinction::Published;
  paper.filter = LateralFilter::Nearest;
  list.add(paper);
}

void addDeepShadowMaps(float footprint, CandidateSet set, List& list) {
  DeepShadowMapSettings settings;
  settings.pixelSize = footprint;
  settings.tolerance = 0.01f;
  list.add(settings);
  if (set == CandidateSet::Quick) return;
  settings.tolerance = 0.05f;
  list.add(settings);
  settings.pixelSize = footprint * 2 / 3;
  for (const float tolerance : {0.01f, 0.05f}) {
    settings.tolerance = tolerance;
    list.add(settings);
  }
  settings.pixelSize = footprint * 1.5f;
  settings.tolerance = 0.01f;
  list.add(settings);
  settings.pixelSize = footprint;
  settings.tolerance = 0;
  list.add(settings);
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
  addOpacityMaps(footprint, set, list);
  addDeepOpacityMaps(footprint, set, list);
  addDensityClusterings(footprint, set, list);
  addDeepShadowMaps(footprint, set, list);
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
