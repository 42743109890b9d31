#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/density/brick_store.h>
#include <libhair/density/cell_frame.h>

namespace HAIR_API hair {

/// How strands are written into a grid.
enum class Deposit {
  Points,  ///< every point adds one count to its cell (Bertails et al. 2005, section 3.1)
  /// Every segment cut where it leaves a column of cells along X, each piece shared between the two
  /// slices that are nearest to its middle: what is summed up along a column is as accurate as that
  /// of Segments for a quarter of its cost.
  Columns,
  Segments,  ///< every segment adds to each cell that it crosses what lies inside
};

/// What a grid is made of and how it is filled.
struct DensityGridSettings {
  int cells = 128;                     ///< along each axis (the paper's NCELLS), 2 to 1024
  float cellSize = 7.5e-3f;            ///< metres (the paper's ds), 1e-6 to 1e6
  Deposit deposit = Deposit::Columns;  ///< how strands are written

  /// Length of an edge of the grid, metres: beyond it cells repeat.
  float extent() const { return static_cast<float>(cells) * cellSize; }
};
/// Throws Error that names the setting which is out of range.
void validate(const DensityGridSettings& settings);

/// How much hair is where: integer counts on a sparse grid (Bertails et al. 2005, section 2).
/// Of what amount a count stands for, metres of hair or anything else that can be added up,
/// deposit() decides (deposit.h).
///
/// Life of a frame: clear() -> deposit() -> density(), sampleDensity(). shadow/density_map.h makes
/// a shadow of one whose X axis runs along a light; repulsion/ pushes hair out of its dense places.
///
/// Cells stand in bricks (brick_store.h), and only those that hold hair: memory and clearing cost
/// what the hair costs, not what the volume does.
///
/// The modulo of the paper only decides where a cell is stored. The grid remembers the bounds of
/// what was deposited in unwrapped cells (CellFrame), so that a place beside the hair (another
/// body, the ground) never reads a cell that belongs to the hair's other end.
struct DensityGrid {
  DensityGridSettings settings;  ///< as clear() was given them
  GridSpace space;               ///< as clear() was given it
  CellFrame frame;               ///< from points to cells
  float quantum = 0;             ///< the amount that one count means, 0 before any deposit

  // Unwrapped cells that hold hair; lower > upper while there is none.
  glm::ivec3 lower{INT_MAX},  ///< the first cell along each axis; > upper: none holds hair
      upper{INT_MIN};         ///< the last cell along each axis

  BrickStore bricks;                 ///< counts: fixed-point amounts
  std::vector<BrickStore> workers;   ///< what other threads deposited, before it was added up
  std::uint32_t saturatedCells = 0;  ///< whose sum did not fit; they stand at 2^32 - 1

  /// Nothing was deposited.
  bool empty() const { return lower.x > upper.x; }
  /// Slices along X between the first and the last that hold hair, at most `cells`.
  int depth() const;
  /// The hair is larger than the grid: its ends share cells. Take more or larger cells.
  bool aliased() const;
  /// Memory of what it holds. Room for more of it, and for what other threads write, is kept beside
  /// that: at most four times as much again, and as much a thread.
  std::size_t bytes() const { return bricks.bytes(); }

  /// An index folded into [0, cells).
  int wrap(int i) const {
    const int n = settings.cells;
    // The hair is hardly ever farther than one grid from its anchor: no division then.
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
  /// Density of an unwrapped cell, amount per m³: metres of hair per m³ where length was deposited.
  /// 0 off the hair. In a curved grid all cells count as large as at the pivot.
  float density(glm::ivec3 cell) const;
};

/// Forgets what was deposited, and sets axes and settings for what comes. Keeps its memory as long
/// as the number of cells stays. Throws Error for settings out of range.
void clear(DensityGrid& grid, const DensityGridSettings& settings, const GridSpace& space = {});

/// Density at a point, trilinear between cell centres, and its gradient.
struct DensitySample {
  float density = 0;      ///< as DensityGrid::density
  glm::vec3 gradient{0};  ///< per metre, in world axes; in a curved grid, as if it were straight
};
/// At a point in metres; 0 off the hair.
DensitySample sampleDensity(const DensityGrid& grid, glm::vec3 p);

}  // namespace hair
