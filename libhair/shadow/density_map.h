#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/density/density_grid.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/transmittances.h>

namespace HAIR_API hair {

/// How transmittance is filtered at a point.
enum class Filter {
  None,     ///< the point's own cell
  Paper,    ///< section 3.3: weights lambda towards the cells i-1, j-1, k-1
  Centred,  ///< the same along the light; across it linear between cell centres
  /// The mean over a disc across the light, of radius DensityMapSettings::footprint: the light on
  /// an object of that size. Accurate, with cells of half the footprint.
  Footprint,
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(Filter) {
  return std::array{Word("none", Filter::None), Word("paper", Filter::Paper),
                    Word("centred", Filter::Centred), Word("footprint", Filter::Footprint)};
}

/// Resolution of a map, splatting (DensityGridSettings; cells as large as the shadow's footprint),
/// and filter.
struct DensityMapSettings : DensityGridSettings {
  Filter filter = Filter::Centred;  ///< at points
  /// Metres, Filter::Footprint only: 0 to 10 cells; below one cell equivalent to Centred.
  float footprint = 0;
  /// Extinction of one point (the paper's f), 1/metre, Deposit::Points only. 0: chosen to match the
  /// optical depth of segments, for the strands' mean spacing and uniformly distributed directions.
  float pointExtinction = 0;
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const DensityMapSettings*) {
  using S = DensityMapSettings;
  return std::tuple_cat(
      fieldsOf(static_cast<const DensityGridSettings*>(nullptr)),
      std::tuple(Field("filter", &S::filter), Field("footprint", &S::footprint, "[0, inf) m"),
                 Field("pointExtinction", &S::pointExtinction, "[0, inf) 1/m")));
}
/// Throws Error that names the setting out of range.
void validate(const DensityMapSettings& settings);

/// The extent (metres) at which a map cannot wrap two ends of the hair to one cell: 2 l_max +
/// h_max, for strands of length l_max on a head of largest dimension h_max (section 2.2).
inline float mapExtentNeeded(float longestStrand, float headSize) {
  return 2.0f * longestStrand + headSize;
}

/// Fast settings: cells as large as the footprint (metres) over which shadows should be averaged,
/// as many as the extent needs; larger cells where that exceeds `mostCells`. With the centred
/// filter finer cells only add noise, which an average over the footprint does not have. Accurate
/// settings: automaticMapSettings.
DensityMapSettings settingsForFootprint(float footprint, float extentNeeded, int mostCells = 256);

/// Optical depth and transmittance on a light-oriented grid (Bertails et al. 2005, section 2).
///
/// Use per frame: clear() -> deposit() -> computeTransmittance() -> sampleTransmittance().
///
///      light → → →    a column of bricks: 4 slices deep, 4 × 16 cells across
///     +----+----+----+----+----+
///     |    | B0 |    |    | B1 |      `lightIn` locates the transmittance of each
///     +----+----+----+----+----+      brick of the column: in itself (B0, B1), or,
///      ones  B0   B0'  B0'  B1        if not allocated, in the last slice of the
///                                     previous brick towards the light (B0'), or
///                                     in the brick of ones.
///
/// Time and memory scale with the hair, not with the volume.
struct DensityMap {
  DensityMapSettings settings;  ///< as passed to clear(); the grid has a copy of its part
  LightSpace light;             ///< as passed to clear()
  DensityGrid grid;             ///< optical depth, dimensionless; X runs along the light
  float fibreShadow = 0;        ///< largest width · extinctionOf of the deposited fibres, metres

  bool lit = false;               ///< transmittances are up to date with the grid
  Transmittances transmittances;  ///< of the bricks
  /// [runs][across] codes, see Transmittances; written where a filter may read them (bricksToRead)
  std::vector<std::uint32_t> lightIn;
  /// [0]: in front of the hair; [1 + s]: slice s of the hair.
  std::vector<std::int32_t> sliceRun,  ///< offset in lightIn of the codes of its run
      sliceInBrick;                    ///< same shape: slice within the bricks of its run

  /// Whether nothing was deposited.
  bool empty() const { return grid.empty(); }
  /// Whether the hair is larger than the map: its ends share cells, and shadows are wrong there.
  /// Use more or larger cells (mapExtentNeeded).
  bool aliased() const { return grid.aliased(); }
  /// Memory of its contents; as DensityGrid::bytes.
  std::size_t bytes() const;
};

/// Empties the map, and sets its light and settings. Keeps its memory if the number of cells is
/// unchanged. Throws Error for settings out of range.
void clear(DensityMap& map, const DensityMapSettings& settings, const LightSpace& light);

}  // namespace hair
