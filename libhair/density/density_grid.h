#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>

namespace HAIR_API hair {

struct GridCells;

/// How strands are splatted into a grid.
enum class Deposit {
  Points,  ///< every point adds one count to its cell (Bertails et al. 2005, section 3.1)
  /// Clips every segment to columns of cells along X and splits each piece between the two slices
  /// nearest to its middle. Sums along a column are as accurate as with Segments, at a quarter of
  /// the cost.
  Columns,
  Segments,  ///< clips every segment to the cells that it crosses
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(Deposit) {
  return std::array{Word("points", Deposit::Points), Word("columns", Deposit::Columns),
                    Word("segments", Deposit::Segments)};
}

/// Resolution of a grid, and how strands are splatted.
struct DensityGridSettings {
  int cells = 128;                     ///< along each axis (the paper's NCELLS), 2 to 1024
  float cellSize = 7.5e-3f;            ///< metres (the paper's ds), 1e-6 to 1e6
  Deposit deposit = Deposit::Columns;  ///< how strands are splatted

  /// Edge length of the grid, metres; cells wrap beyond it.
  float extent() const { return static_cast<float>(cells) * cellSize; }
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const DensityGridSettings*) {
  using S = DensityGridSettings;
  return std::tuple(Field("cells", &S::cells, "[2, 1024]"),
                    Field("cellSize", &S::cellSize, "[1e-6, 1e6] m"),
                    Field("deposit", &S::deposit));
}
/// Throws Error that names the setting out of range.
void validate(const DensityGridSettings& settings);

/// Axes and origin of a grid of cells. {}: those of the world.
///
/// Points are floats relative to `origin` (world = origin + point), which is double: cells 10 km
/// from the world's origin are as exact as there.
struct GridSpace {
  glm::mat3 gridFromWorld{1};  ///< rotation; its rows are the grid's X, Y and Z
  glm::dvec3 origin{0};        ///< metres
  glm::vec3 pivot{0};          ///< curved grids: point where cells have their nominal size
  /// 1 / (distance of pivot and focus), 1/metre: columns of cells along X converge at the focus, on
  /// the -X side of the pivot. 0: columns are parallel, and the grid is straight.
  float curvature = 0;
};

/// Hair density as integer counts on a sparse grid (Bertails et al. 2005, section 2). deposit()
/// sets the unit of a count: metres of hair, or any other additive quantity.
///
/// Use per frame: clear() -> deposit() -> density(), sampleDensity(). shadow/density_map.h computes
/// shadows from a grid whose X axis runs along a light; repulsion/ pushes hair out of dense cells.
///
/// Only bricks of cells that hold hair are allocated: memory and clearing time
/// scale with the hair, not with the volume.
///
/// The paper's modulo only selects where a cell is stored. The grid also keeps the bounds of
/// deposited hair in unwrapped cells (CellFrame), so that look-ups outside them (another body, the
/// ground) do not read wrapped cells of the hair.
struct DensityGrid {
  DensityGrid();
  ~DensityGrid();
  DensityGrid(DensityGrid&&) noexcept;             ///< moves all of it
  DensityGrid& operator=(DensityGrid&&) noexcept;  ///< moves all of it

  DensityGridSettings settings;  ///< as passed to clear()
  GridSpace space;               ///< as passed to clear()
  float quantum = 0;             ///< amount per count; 0 before the first deposit

  // Bounds of the hair in unwrapped cells.
  glm::ivec3 lower{INT_MAX},  ///< first cell along each axis; > upper: no hair
      upper{INT_MIN};         ///< last cell along each axis

  std::unique_ptr<GridCells> cells;  ///< counts, and the mapping from points to them; never null
  std::uint32_t saturatedCells = 0;  ///< cells clamped to 2^32 - 1

  /// Whether nothing was deposited.
  bool empty() const { return lower.x > upper.x; }
  /// Slices along X between the first and the last that hold hair, at most `cells`.
  int depth() const;
  /// Whether the hair is larger than the grid, so that its ends share cells. Use more or larger
  /// cells.
  bool aliased() const;
  /// Memory of its contents. Spare capacity adds at most four times as much, and as much again for
  /// each other thread.
  std::size_t bytes() const;
  /// Bricks of 4 × 16 × 4 cells that are allocated.
  std::size_t brickCount() const;

  /// An index modulo cells, in [0, cells).
  int wrap(int i) const {
    const int n = settings.cells;
    // Hair is rarely more than one grid from its anchor: avoid the division.
    i += i < 0 ? n : 0;
    i -= i >= n ? n : 0;
    if (static_cast<unsigned>(i) < static_cast<unsigned>(n)) return i;
    // One more wrap, still without division.
    if (static_cast<unsigned>(i - n) < static_cast<unsigned>(n)) return i - n;
    if (static_cast<unsigned>(i + n) < static_cast<unsigned>(n)) return i + n;
    i %= n;
    return i < 0 ? i + n : i;
  }
  /// The paper's Psi: where an unwrapped cell is stored, [0, cells) an axis.
  glm::ivec3 wrap(glm::ivec3 cell) const;
  /// Count of an unwrapped cell; times `quantum` it is the deposited amount.
  std::uint32_t count(glm::ivec3 cell) const;

  /// The unwrapped cell of a point.
  glm::ivec3 cellOf(glm::vec3 p) const;
  /// Centre of an unwrapped cell.
  glm::vec3 cellCentre(glm::ivec3 cell) const;
  /// Density of an unwrapped cell, amount per m³: metres of hair per m³ where length was deposited.
  /// 0 outside the bounds of the hair. A curved grid uses the cell volume at the pivot.
  float density(glm::ivec3 cell) const;
};

/// Empties the grid, and sets its axes and settings. Keeps its memory if the number of cells is
/// unchanged. Throws Error for settings out of range.
void clear(DensityGrid& grid, const DensityGridSettings& settings, const GridSpace& space = {});

/// Density at a point, trilinear between cell centres, and its gradient.
struct DensitySample {
  float density = 0;      ///< as DensityGrid::density
  glm::vec3 gradient{0};  ///< per metre, in world axes; in a curved grid, as if it were straight
};
/// At a point in metres; 0 away from the hair.
DensitySample sampleDensity(const DensityGrid& grid, glm::vec3 p);

/// The quantity that a grid accumulates, as an amount per metre of a segment.
struct SegmentMeasure {
  /// The length that the amount is proportional to.
  enum class Of : std::uint8_t {
    Length,   ///< the segment's length
    AcrossX,  ///< its projection across the grid's X axis; in a curved grid times the
              ///< magnification (CellFrame), because nearer to the focus it subtends more
  };
  Of of = Of::Length;   ///< see Of
  double perMetre = 1;  ///< amount per metre, any unit, >= 0
  /// Deposit::Points: amount per point, >= 0. 0: that of the strands' mean length per point, for
  /// uniformly distributed directions.
  float perPoint = 0;
};

/// Metres of hair, for strands that represent `hairsPerStrand` hairs: the measure of
/// self-collision.
inline SegmentMeasure metresOfHair(float hairsPerStrand = 1) {
  return {SegmentMeasure::Of::Length, static_cast<double>(hairsPerStrand)};
}

/// Adds strands to a cleared grid (Bertails et al. 2005, section 3.1), on all threads; the counts
/// are integers, so the result has the same bits for any number of threads.
///
/// Splats every strandStride-th strand, weighted by strandStride (1 to 2^30 - 1). `weights`:
/// [strandCount], [0, 1], scales the amount of each strand; empty: 1. Deposit::Points counts whole
/// points and ignores them.
///
/// Reports overflow: grid.saturatedCells counts saturated cells, and grid.aliased() tells whether
/// the hair is larger than the grid. May be called again to add more; Deposit::Points then uses the
/// amount per point of the first call. Throws Error for a grid that was never cleared, and
/// arguments out of range.
void deposit(StrandView strands, const SegmentMeasure& measure, DensityGrid& grid,
             std::uint32_t strandStride = 1, std::span<const float> weights = {});

/// Mean length of strand per point, metres, of at most 256 of every strandStride-th strand. 0 for
/// no points.
float metresPerPoint(StrandView strands, std::uint32_t strandStride = 1);

}  // namespace hair
