#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/shadow/light_space.h>

namespace hair {

/// How strands are written into the map.
enum class Deposit {
  Points,     ///< the paper: every point adds one count to its cell
  Segments,   ///< every segment adds to each cell that it crosses what lies inside
  Trilinear,  ///< samples of every segment, spread over the eight nearest cells
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

struct DensityMapSettings {
  int cells = 128;           ///< along each axis (the paper's NCELLS), 2 to 1024
  float cellSize = 7.5e-3f;  ///< metres (the paper's ds), > 0; as large as the shadow's footprint
  Deposit deposit = Deposit::Segments;
  Filter filter = Filter::Centred;
  /// Metres, Filter::Footprint only: 0 to 10 cells; below one cell it is as Centred.
  float footprint = 0;
  Quantity quantity = Quantity::OpticalDepth;
  /// Extinction of one point (the paper's f), 1/metre, Deposit::Points only. 0: chosen so that
  /// points at the strands' mean spacing and all directions alike darken as segments would.
  float pointExtinction = 0;

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

/// A zeroed array whose untouched pages cost neither time nor memory.
template <class T>
class ZeroedArray {
 public:
  ZeroedArray() = default;
  explicit ZeroedArray(std::size_t count);
  T* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T, Free> data_;
};

/// Hair density and transmittance on a light-oriented grid (Bertails et al. 2005, section 2).
///
/// Life of a frame: clear() -> deposit() -> computeTransmittance() -> sampleTransmittance(). A map
/// for self-collision stops after deposit() and is read with density() and sampleDensity().
///
///            light  →  →  →                cell (i, j, k), wrapped to [0, n)³, is at
///         i = first                        index (i·n + k)·n + j:
///           +-----+-----+-----+
///        k  | row | row | row |            j, across the light, is contiguous: a *row*;
///        ↓  +-----+-----+-----+            k, across the light too, steps from row to row;
///           | row |  -  | row |            i, along the light, steps from slice to slice.
///           +-----+-----+-----+
///            slice → slice                 Transmittance walks slice by slice with whole rows at
///                                          a time: no strides, no shuffles, rows are lanes.
///
/// Rows that no hair touches (most of them) are neither cleared nor written: `rowOf` says for each
/// slice, counted from the light, and each k, where the transmittance of that row stands: its own,
/// or that of the nearest touched row towards the light, or the row of ones at the end.
///
/// The modulo of the paper only decides where a cell is stored. The map remembers the bounds of
/// what was deposited in unwrapped cells, so that the slice nearest to the light is known, and a
/// point outside (another body, the ground) never reads a cell that belongs to the other end.
struct DensityMap {
  DensityMapSettings settings;
  LightSpace light;
  CellFrame frame;
  float quantum = 0;      ///< what one count means: optical depth or metres, 0 before any deposit
  float fibreShadow = 0;  ///< width · extinctionOf of one fibre deposited, metres (the largest)

  // Unwrapped cells that hold hair; lower > upper while there is none.
  glm::ivec3 lower{INT_MAX}, upper{INT_MIN};

  ZeroedArray<std::uint32_t> counts;      ///< [cells³], fixed-point density
  ZeroedArray<std::uint8_t> touched;      ///< [cells²], row i·n + k holds something
  ZeroedArray<std::uint32_t> saturation;  ///< [cells³ / 32] bits: the count did not fit
  std::uint32_t saturatedCells = 0;       ///< set bits; their counts stand at 2^32 - 1
  ZeroedArray<float> transmittance;       ///< [cells³ + cells]; the last row is all ones
  std::vector<std::uint32_t> rowOf;       ///< [(cells + 1) · cells], slice 0 is before all hair

  bool empty() const { return lower.x > upper.x; }
  /// Slices between the first and the last that hold hair, at most `cells`.
  int depth() const;
  /// The hair is larger than the map: its ends share cells, shadows are wrong there. Take more or
  /// larger cells (mapExtentNeeded).
  bool aliased() const;
  /// Memory in use: rows that hold something (others were never touched), and the tables.
  std::size_t bytes() const;

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
  /// Where an unwrapped cell is stored.
  std::size_t index(glm::ivec3 cell) const {
    const auto n = static_cast<std::size_t>(settings.cells);
    const auto i = static_cast<std::size_t>(wrap(frame.base.x + cell.x));
    const auto j = static_cast<std::size_t>(wrap(frame.base.y + cell.y));
    const auto k = static_cast<std::size_t>(wrap(frame.base.z + cell.z));
    return (i * n + k) * n + j;
  }

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

/// Forgets what was deposited (touched rows only), and sets light and settings for what comes.
/// Allocates only when the number of cells changes. Throws Error for settings out of range.
void clear(DensityMap& map, const DensityMapSettings& settings, const LightSpace& light);

/// Density at a point, trilinear between cell centres, and its gradient.
struct DensitySample {
  float density = 0;      ///< as DensityMap::density
  glm::vec3 gradient{0};  ///< per metre, in world axes
};
DensitySample sampleDensity(const DensityMap& map, glm::vec3 p);

}  // namespace hair
