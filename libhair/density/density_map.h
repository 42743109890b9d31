#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/density/brick_store.h>
#include <libhair/light/light_space.h>

namespace HAIR_API hair {

/// How strands are written into the map.
enum class Deposit {
  Points,  ///< the paper: every point adds one count to its cell
  /// Every segment cut where it leaves a column of cells, each piece shared between the two slices
  /// that are nearest to its middle: as accurate as Segments for a quarter of its cost.
  Columns,
  Segments,  ///< every segment adds to each cell that it crosses what lies inside
};

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

/// What the map sums up.
enum class Quantity {
  OpticalDepth,  ///< dimensionless, per cell; what transmittance needs
  Length,        ///< metres of hair per cell; what self-collision needs
};

/// What a map is made of, how it is filled and how it is read.
struct DensityMapSettings {
  int cells = 128;  ///< along each axis (the paper's NCELLS), 2 to 1024
  /// Metres (the paper's ds), 1e-6 to 1e6; as large as the shadow's footprint.
  float cellSize = 7.5e-3f;
  Deposit deposit = Deposit::Columns;  ///< how strands are written
  Filter filter = Filter::Centred;     ///< how points are read
  /// Metres, Filter::Footprint only: 0 to 10 cells; below one cell it is as Centred.
  float footprint = 0;
  Quantity quantity = Quantity::OpticalDepth;  ///< what is summed up
  /// Extinction of one point (the paper's f), 1/metre, Deposit::Points only. 0: chosen so that
  /// points at the strands' mean spacing and all directions alike darken as segments would.
  float pointExtinction = 0;

  /// Length of an edge of the map, metres: beyond it cells repeat.
  float extent() const { return static_cast<float>(cells) * cellSize; }
};

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

/// Hair density and transmittance on a light-oriented grid (Bertails et al. 2005, section 2).
///
/// Life of a frame: clear() -> deposit() -> computeTransmittance() -> sampleTransmittance(). A map
/// for self-collision stops after deposit() and is read with density() and sampleDensity().
///
/// Cells stand in bricks (brick_store.h), and only those that hold hair: memory, clearing and the
/// walk along the light cost what the hair costs, not what the volume does.
///
///      light → → →    a column of bricks: 4 slices deep, 4 × 16 cells across
///     +----+----+----+----+----+
///     |    | B0 |    |    | B1 |      `lightIn` says where the transmittance
///     +----+----+----+----+----+      of each brick of the column stands: in
///      ones  B0   B0'  B0'  B1        itself (B0, B1), or, where none is, in the
///                                     last slice of the last one towards the
///                                     light (B0'), or in the brick of ones.
///
/// The modulo of the paper only decides where a cell is stored. The map remembers the bounds of
/// what was deposited in unwrapped cells, so that the slice nearest to the light is known, and a
/// point outside (another body, the ground) never reads a cell that belongs to the other end.
struct DensityMap {
  DensityMapSettings settings;  ///< as clear() was given them
  LightSpace light;             ///< as clear() was given it
  CellFrame frame;              ///< from points to cells
  float quantum = 0;      ///< what one count means: optical depth or metres, 0 before any deposit
  float fibreShadow = 0;  ///< width · extinctionOf of one fibre deposited, metres (the largest)

  // Unwrapped cells that hold hair; lower > upper while there is none.
  glm::ivec3 lower{INT_MAX},  ///< the first cell along each axis; > upper: none holds hair
      upper{INT_MIN};         ///< the last cell along each axis

  BrickStore bricks;                 ///< counts: fixed-point density
  std::vector<BrickStore> workers;   ///< what other threads deposited, before it was added up
  std::uint32_t saturatedCells = 0;  ///< whose sum did not fit; they stand at 2^32 - 1
  bool lit = false;                  ///< transmittances are of what was deposited
  Transmittances transmittances;     ///< of the bricks
  /// [runs][across] codes, see Transmittances; written where a filter may read them (bricksToRead)
  std::vector<std::uint32_t> lightIn;
  /// [0]: what is before the hair; [1 + s]: slice s of the hair.
  std::vector<std::int32_t> sliceRun,  ///< where the codes of its run stand in lightIn
      sliceInBrick;                    ///< likewise: which slice of its run's bricks it is

  /// Nothing was deposited.
  bool empty() const { return lower.x > upper.x; }
  /// Slices between the first and the last that hold hair, at most `cells`.
  int depth() const;
  /// The hair is larger than the map: its ends share cells, shadows are wrong there. Take more or
  /// larger cells (mapExtentNeeded).
  bool aliased() const;
  /// Memory of what it holds. Room for more of it, and for what other threads write, is kept beside
  /// that: at most four times as much again, and as much a thread.
  std::size_t bytes() const;

  /// An index folded into [0, cells).
  int wrap(int i) const {
    const int n = settings.cells;
    // The hair is hardly ever farther than one map from its anchor: no division then.
    i += i < 0 ? n : 0;
    i -= i >= n ? n : 0;
    if (static_cast<unsigned>(i) < static_cast<unsigned>(n)) return i;
    // One turn off is the common case, and a division is slow.
    if (static_cast<unsigned>(i - n) < static_cast<unsigned>(n)) return i - n;
    if (static_cast<unsigned>(i + n) < static_cast<unsigned>(n)) return i + n;
    i %= n;
    return i < 0 ? i + n : i;
  }
  /// The paper's Psi: where an unwrapped cell is stored, [0, cells) an axis.
  glm::ivec3 wrap(glm::ivec3 cell) const {
    return {wrap(frame.base.x + cell.x), wrap(frame.base.y + cell.y), wrap(frame.base.z + cell.z)};
  }
  /// What was deposited in an unwrapped cell, times `quantum`.
  std::uint32_t count(glm::ivec3 cell) const { return bricks.count(wrap(cell)); }

  /// The unwrapped cell of a point.
  glm::ivec3 cellOf(glm::vec3 p) const {
    const glm::vec3 u = frame.cellCoordinates(p);
    return {floorToInt(u.x), floorToInt(u.y), floorToInt(u.z)};
  }
  /// The point at the middle of an unwrapped cell.
  glm::vec3 cellCentre(glm::ivec3 cell) const { return frame.point(glm::vec3(cell) + 0.5f); }
  /// Density of an unwrapped cell: per m³, metres of hair for Quantity::Length. 0 off the hair.
  float density(glm::ivec3 cell) const;
};

/// Forgets what was deposited, and sets light and settings for what comes. Keeps its memory as long
/// as the number of cells stays. Throws Error for settings out of range.
void clear(DensityMap& map, const DensityMapSettings& settings, const LightSpace& light);

/// Density at a point, trilinear between cell centres, and its gradient.
struct DensitySample {
  float density = 0;      ///< as DensityMap::density
  glm::vec3 gradient{0};  ///< per metre, in world axes
};
/// At a point in metres; 0 off the hair.
DensitySample sampleDensity(const DensityMap& map, glm::vec3 p);

}  // namespace hair
