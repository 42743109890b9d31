#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/density/density_grid.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/transmittances.h>

namespace HAIR_API hair {

/// How transmittance is read at a point.
enum class Filter {
  None,     ///< the point's own cell
  Paper,    ///< section 3.3: weights lambda towards the cells i-1, j-1, k-1
  Centred,  ///< the same along the light; across it linear between cell centres
  /// The mean over a disc across the light, of radius DensityMapSettings::footprint: as much light
  /// as meets what is drawn that large. The accurate one, with cells half as large as the
  /// footprint.
  Footprint,
};

/// What a map is made of, how it is filled (DensityGridSettings; cells as large as the shadow's
/// footprint) and how it is read.
struct DensityMapSettings : DensityGridSettings {
  Filter filter = Filter::Centred;  ///< how points are read
  /// Metres, Filter::Footprint only: 0 to 10 cells; below one cell it is as Centred.
  float footprint = 0;
  /// Extinction of one point (the paper's f), 1/metre, Deposit::Points only. 0: chosen so that
  /// points at the strands' mean spacing and all directions alike darken as segments would.
  float pointExtinction = 0;
};
/// Throws Error that names the setting which is out of range.
void validate(const DensityMapSettings& settings);

/// The extent (metres) that a map needs lest two ends of the hair fall into one cell: 2 l_max +
/// h_max, for strands of length l_max on a head of largest dimension h_max (section 2.2).
inline float mapExtentNeeded(float longestStrand, float headSize) {
  return 2.0f * longestStrand + headSize;
}

/// Fast settings: cells as large as the footprint (metres) over which shadows should be averaged,
/// and as many as the extent needs; where that is more than `mostCells`, larger cells. Finer cells
/// are no better with the centred filter: they add noise that an average over the footprint does
/// not have. Accurate settings: automaticMapSettings.
DensityMapSettings settingsForFootprint(float footprint, float extentNeeded, int mostCells = 256);

/// Hair density and transmittance on a light-oriented grid (Bertails et al. 2005, section 2): a
/// grid of optical depth, and what the light adds to it.
///
/// Life of a frame: clear() -> deposit() -> computeTransmittance() -> sampleTransmittance().
///
///      light → → →    a column of bricks: 4 slices deep, 4 × 16 cells across
///     +----+----+----+----+----+
///     |    | B0 |    |    | B1 |      `lightIn` says where the transmittance
///     +----+----+----+----+----+      of each brick of the column stands: in
///      ones  B0   B0'  B0'  B1        itself (B0, B1), or, where none is, in the
///                                     last slice of the last one towards the
///                                     light (B0'), or in the brick of ones.
///
/// The walk along the light costs what the hair costs, as the grid does.
struct DensityMap {
  DensityMapSettings settings;  ///< as clear() was given them; the grid has its part of them too
  LightSpace light;             ///< as clear() was given it
  DensityGrid grid;             ///< optical depth, which has no unit; X runs along the light
  float fibreShadow = 0;  ///< width · extinctionOf of the fibres deposited, metres (the largest)

  bool lit = false;               ///< transmittances are of what was deposited
  Transmittances transmittances;  ///< of the bricks
  /// [runs][across] codes, see Transmittances; written where a filter may read them (bricksToRead)
  std::vector<std::uint32_t> lightIn;
  /// [0]: what is before the hair; [1 + s]: slice s of the hair.
  std::vector<std::int32_t> sliceRun,  ///< where the codes of its run stand in lightIn
      sliceInBrick;                    ///< likewise: which slice of its run's bricks it is

  /// Nothing was deposited.
  bool empty() const { return grid.empty(); }
  /// The hair is larger than the map: its ends share cells, shadows are wrong there. Take more or
  /// larger cells (mapExtentNeeded).
  bool aliased() const { return grid.aliased(); }
  /// Memory of what it holds; as DensityGrid::bytes.
  std::size_t bytes() const;
};

/// Forgets what was deposited, and sets light and settings for what comes. Keeps its memory as long
/// as the number of cells stays. Throws Error for settings out of range.
void clear(DensityMap& map, const DensityMapSettings& settings, const LightSpace& light);

}  // namespace hair
