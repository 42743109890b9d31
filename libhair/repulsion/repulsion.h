#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/lanes.h>
#include <libhair/density/density_grid.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/motion/wind.h>

namespace HAIR_API hair {

/// Which way over-full cells push.
enum class RepulsionKind {
  CellCentre,  ///< away from the centre of the point's cell (Bertails et al. 2005, section 4.1)
  Gradient,    ///< down the density's gradient (SIGGRAPH 2010 course, "Hair-hair interactions")
};

/// Self-collision: hair that is denser than it was groomed spreads out.
struct RepulsionSettings {
  RepulsionKind kind = RepulsionKind::Gradient;  ///< which way it pushes
  float cellSize = 0.02f;  ///< metres; of the grid of density that guides feel
  int cells = 64;          ///< along each axis; cells · cellSize as DensityGridSettings says
  std::uint32_t strandStride = 32;  ///< every so many drawn strands are counted, for all
  float threshold = 1.5e6f;         ///< metres of hair per m³ that never push
  float tolerance = 1.3f;           ///< nor does less than the groom's own density times this, >= 1
  float strength = 20;              ///< m/s² on a point where density is twice what it may be
  float limit = 20;                 ///< m/s², the most
  float interval = 1.0f / 60;       ///< seconds from call to call of repel (repelPasses), (0, 1]
};

/// Throws Error that names the field and its range.
void validate(const RepulsionSettings& settings);

/// A number for the settings that decide what density is allowed at rest (all but strength, limit
/// and interval): equal where they are, never 0.
std::uint32_t restDensityKey(const RepulsionSettings& settings);

/// What a groom at rest has of density at each guide point, and the push of the last frame.
struct Repulsion {
  DensityGrid density;         ///< metres of hair per m³
  std::vector<Lanes> allowed;  ///< [groupCount · pointsPerGuide], metres of hair per m³
  /// restDensityKey of what `allowed` was learnt with; 0: unknown, that of the next frame.
  std::uint32_t learntWith = 0;
  std::vector<LaneVec3> push;    ///< the same, m/s²; what stepGuides takes
  std::vector<Lanes> windShare;  ///< the same: of the wind that gets there; empty: all of it
  std::size_t turn = 0;          ///< which half of the groups repel looks at next
  float waiting = 0;             ///< seconds since repel was due
};

/// How often repel is due, 0 to 2 times, after `seconds` more: once an interval, so that hair feels
/// the same whatever the length of frames.
int repelPasses(float seconds, const RepulsionSettings& settings, Repulsion& repulsion);

/// Every so many of the drawn strands are counted for all; all of `strands` where they are few.
std::uint32_t strideCounted(std::size_t strands, const RepulsionSettings& settings);

/// Fills the grid with the drawn hair's length. The grid's axes are the world's: a lamp that moves
/// must not move the hair.
void measureDensity(StrandView drawn, const Fibre& fibre, const RepulsionSettings& settings,
                    DensityGrid& density);

/// Learns from guides and drawn hair at rest what density is allowed where. Throws Error for
/// settings out of range.
void allowRestDensity(StrandView drawn, const Fibre& fibre, const GuideStrands& guides,
                      const RepulsionSettings& settings, Repulsion& repulsion);

/// Pushes on guide points from the density in the grid: on every other group of guides, the others
/// at the next call, as density changes little in a frame. No more density than at rest is no push,
/// so repulsion cannot keep a groom from coming to rest. Threads over groups.
void repel(const GuideStrands& guides, const RepulsionSettings& settings, Repulsion& repulsion);

/// How much of the wind gets to each guide point past the hair upwind of it in the grid, as
/// Wind::shelter says. Counts hair from one cell to five away: a point's own cell does not count,
/// so that a lone strand across the wind is in all of it. Threads over points. Throws Error for a
/// wind that is not valid.
void shelter(const GuideStrands& guides, const Wind& wind, Repulsion& repulsion);

}  // namespace hair
