#include <libhair/shadow/density_map.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/density/grid_cells.h>
#include <libhair/shadow/extinction.h>

namespace hair {

namespace {

/// Optical depth of one point of Deposit::Points: f · ds.
float depthOfPoint(StrandView strands, std::uint32_t stride, const Fibre& fibre,
                   const DensityMapSettings& settings) {
  const float ds = settings.cellSize;
  if (settings.pointExtinction > 0) return settings.pointExtinction * ds;
  // Mean sine of the angle to the light over all directions: pi / 4.
  constexpr float kMeanSine = 0.785398163f;
  return metresPerPoint(strands, stride) * kMeanSine * fibre.width * fibre.hairsPerStrand *
         fibre.opacity / (ds * ds);
}

}  // namespace

void deposit(const DrawnHair& hair, DensityMap& map, std::uint32_t strandStride) {
  const Fibre& fibre = hair.fibre;
  require(map.grid.cells->bricks.valid(), "deposit: clear() the density map first");
  require(fibre.width >= 0 && fibre.opacity >= 0 && fibre.hairsPerStrand >= 0 &&
              std::isfinite(fibre.width * fibre.opacity * fibre.hairsPerStrand),
          "deposit: fibre width ", fibre.width, " m, opacity ", fibre.opacity, " or ",
          fibre.hairsPerStrand, " hairs a strand is negative or not finite");
  const DensityMapSettings& settings = map.settings;
  // Deviation: extinctionOf, not -ln(1 - opacity).
  const float extinction = extinctionOf(fibre, settings.cellSize);
  const auto ds = static_cast<double>(settings.cellSize);
  SegmentMeasure measure;
  measure.of = SegmentMeasure::Of::AcrossX;
  measure.perMetre =
      static_cast<double>(fibre.width * fibre.hairsPerStrand * extinction) / (ds * ds);
  if (settings.deposit == Deposit::Points && map.empty() && strandStride > 0)
    measure.perPoint = depthOfPoint(hair.strands, strandStride, fibre, settings);
  map.lit = false;
  deposit(hair.strands, measure, map.grid, strandStride, hair.weights);
  if (hair.strands.pointCount() > 0)
    map.fibreShadow = std::max(map.fibreShadow, fibre.width * extinction * hair.ownFibres);
}

}  // namespace hair
