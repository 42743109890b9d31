#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/lanes.h>
#include <libhair/density/density_grid.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/motion/wind.h>

namespace HAIR_API hair {

/// Direction of the push from over-full cells.
enum class RepulsionKind {
  CellCentre,  ///< away from the centre of the point's cell (Bertails et al. 2005, section 4.1)
  Gradient,    ///< down the density gradient (SIGGRAPH 2010 course, "Hair-hair interactions")
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(RepulsionKind) {
  return std::array{Word("cell centre", RepulsionKind::CellCentre),
                    Word("gradient", RepulsionKind::Gradient)};
}

/// Self-collision: hair denser than at rest is pushed apart.
struct RepulsionSettings {
  RepulsionKind kind = RepulsionKind::Gradient;  ///< direction of the push
  float cellSize = 0.02f;                        ///< metres; of the density grid
  int cells = 64;                   ///< along each axis; extent as in DensityGridSettings
  std::uint32_t strandStride = 32;  ///< splat every Nth drawn strand, weighted by N
  float threshold = 1.5e6f;         ///< metres of hair per m³; below it nothing is pushed
  float tolerance = 1.3f;           ///< push starts at this multiple of the rest density, >= 1
  float strength = 20;              ///< m/s² where density is twice the allowed density
  float limit = 20;                 ///< m/s², upper bound of the push
  float interval = 1.0f / 60;       ///< seconds between calls of repel (repelPasses), (0, 1]
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const RepulsionSettings*) {
  using S = RepulsionSettings;
  return std::tuple(
      Field("kind", &S::kind), Field("cellSize", &S::cellSize, "[1e-6, 1e6] m"),
      Field("cells", &S::cells, "[2, 1024]"), Field("strandStride", &S::strandStride, "[1, inf)"),
      Field("threshold", &S::threshold, "[0, 1e30) m/m^3"),
      Field("tolerance", &S::tolerance, "[1, 1e6)"),
      Field("strength", &S::strength, "[0, 1e6) m/s^2"),
      Field("limit", &S::limit, "[0, 1e12) m/s^2"), Field("interval", &S::interval, "(0, 1] s"));
}

/// Throws Error that names the field and its range.
void validate(const RepulsionSettings& settings);

/// Hash of the settings that the allowed density depends on (all but strength, limit and interval).
/// Never 0.
std::uint32_t restDensityKey(const RepulsionSettings& settings);

/// State of self-collision: allowed density at each guide point, and the push of the last frame.
struct Repulsion {
  DensityGrid density;         ///< metres of hair per m³
  std::vector<Lanes> allowed;  ///< [groupCount · pointsPerGuide], metres of hair per m³
  /// restDensityKey of the settings of `allowed`; 0: unknown, set by the next frame.
  std::uint32_t learntWith = 0;
  std::vector<LaneVec3> push;    ///< same shape, m/s²; input of stepGuides
  std::vector<Lanes> windShare;  ///< same shape, attenuation of the wind, [0, 1]; empty: 1
  std::size_t turn = 0;          ///< half of the groups that repel updates next, 0 or 1
  float waiting = 0;             ///< seconds since repel was last due
};

/// Advances the clock by `seconds` and returns how often to call repel, 0 to 2: once an interval,
/// so that the push does not depend on the frame rate.
int repelPasses(float seconds, const RepulsionSettings& settings, Repulsion& repulsion);

/// Stride N of the splatted strands: strandStride, less for fewer than 30 · strandStride strands.
std::uint32_t strideCounted(std::size_t strands, const RepulsionSettings& settings);

/// Splats the drawn hair's length into the grid. Its axes are the world's, so that moving a light
/// does not move the hair.
void measureDensity(StrandView drawn, const Fibre& fibre, const RepulsionSettings& settings,
                    DensityGrid& density);

/// Sets the allowed density at each guide point from guides and drawn hair at rest. Throws Error
/// for settings out of range.
void allowRestDensity(StrandView drawn, const Fibre& fibre, const GuideStrands& guides,
                      const RepulsionSettings& settings, Repulsion& repulsion);

/// Updates the push on guide points from the density grid. Each call updates every other group of
/// guides, the next call the rest, because density changes little in a frame. Rest density causes
/// no push, so repulsion cannot keep a groom from settling. Threads over groups.
void repel(const GuideStrands& guides, const RepulsionSettings& settings, Repulsion& repulsion);

/// Attenuation of the wind at each guide point by the hair upwind of it (Wind::occlusion).
/// Integrates density from one to five cells away; excludes the point's own cell, so that a lone
/// strand across the wind is not attenuated. Threads over points. Throws Error for a wind that is
/// not valid.
void occludeWind(const GuideStrands& guides, const Wind& wind, Repulsion& repulsion);

}  // namespace hair
