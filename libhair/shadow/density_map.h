#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/core/transform.h>
#include <libhair/density/density_grid.h>
#include <libhair/geometry/colliders.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/light/light.h>

namespace HAIR_API hair {

struct LitBricks;

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
/// Time and memory scale with the hair, not with the volume.
struct DensityMap {
  DensityMap();
  ~DensityMap();
  DensityMap(DensityMap&&) noexcept;             ///< moves all of it
  DensityMap& operator=(DensityMap&&) noexcept;  ///< moves all of it

  DensityMapSettings settings;  ///< as passed to clear(); the grid has a copy of its part
  LightSpace light;             ///< as passed to clear()
  DensityGrid grid;             ///< optical depth, dimensionless; X runs along the light
  float fibreShadow = 0;        ///< largest width · extinctionOf of the deposited fibres, metres

  bool lit = false;                   ///< `bricks` is up to date with the grid
  std::unique_ptr<LitBricks> bricks;  ///< transmittance of the grid's cells; never null

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

/// Splats the optical depth of hair into a cleared map (Bertails et al. 2005, section 3.1), by
/// deposit into its grid.
///
/// A segment of length l at angle theta to the light, of width w and opacity alpha, adds
///
///   l · sin(theta) · w · hairsPerStrand · extinctionOf(fibre, ds) / ds²
///
/// to the optical depth of its column (Columns, Segments). Deposit::Points adds one count per point
/// instead, of optical depth f · ds (DensityMapSettings::pointExtinction).
///
/// May be called again to add more. Throws Error for a map that was never cleared, and for fibres
/// and arguments out of range.
void deposit(const DrawnHair& hair, DensityMap& map, std::uint32_t strandStride = 1);

/// All strands at full width, without level of detail.
inline void deposit(StrandView strands, const Fibre& fibre, DensityMap& map,
                    std::uint32_t strandStride = 1) {
  deposit(DrawnHair{strands, fibre}, map, strandStride);
}

/// Computes transmittance from optical depth (Bertails et al. 2005, section 3.2, equation 3):
///
///   Trans(i, j, k) = prod over i' from i_min to i of exp(-(optical depth of cell i', j, k))
///
/// the transmittance at the back face of cell (i, j, k); i_min is the hair's slice nearest to the
/// light. Threads over columns.
void computeTransmittance(DensityMap& map);

/// Transmittance at points (Bertails et al. 2005, section 3.3), with map.settings.filter. Works for
/// any points, such as a head or the ground. Exactly 1 in front of all hair and beside it, beyond
/// the support of deposit and filter (one or two cells, or the footprint), and everywhere in an
/// empty map.
/// `out`: [points.size()], in [0, 1].
void sampleTransmittance(const DensityMap& map, std::span<const glm::vec3> points,
                         std::span<float> out);

/// Transmittance at the points of the deposited strands, without self-shadowing of a strand: on
/// average half of it is in front of each of its points, in any direction, with an optical depth of
/// width · extinction / (2 · mean width of the filter's kernel). Not for curls narrower than the
/// filter, which occlude themselves more often. `out`: [pointCount], in [0, 1].
void sampleStrandTransmittance(const DensityMap& map, StrandView strands, std::span<float> out);

/// Transmittance for callers with their own loops and threads: samples any subset of the points,
/// while they are in the cache. Do not change the map meanwhile.
class TransmittanceSampler {
 public:
  /// Kind of the points.
  enum class Of {
    Points,   ///< as sampleTransmittance
    Strands,  ///< as sampleStrandTransmittance
  };
  /// Throws Error if hair was deposited and computeTransmittance() was not called since.
  TransmittanceSampler(const DensityMap& map, Of what);

  /// Thread-safe. `out`: [points.size()]. Bits do not depend on how points are divided.
  void sample(std::span<const glm::vec3> points, std::span<float> out) const;

 private:
  const DensityMap& map_;
  float scale_;  // factor before clamping to 1
};

/// Rasterises an opaque object into the map of the hair (Bertails et al. 2005, section 6); all
/// behind it is in shadow. Call after deposit() and before computeTransmittance().
///
/// Fills one cell of each column: the first whose front face's centre is at least half a cell
/// inside the object, so that skin does not shadow the hair that lies on it. The shadow starts up
/// to two cells below the surface and is about half a cell smaller all around: objects thinner than
/// two cells cast none, and finer contact shadows need a finer map. Shadow edges are as soft as the
/// map's filter is wide.
///
/// Sphere-traces each column through the object's bounds.
void occlude(const MeshSdf& mesh, const RigidTransform& worldFromMesh, DensityMap& map);
/// The same for the capsules of a body.
void occlude(std::span<const Capsule> capsules, DensityMap& map);

/// Longest side of the hair's bounding box in the axes of a map of that light, metres (at the pivot
/// of a point light). 0 for no hair.
float extentSeen(StrandView strands, const LightSpace& light);

/// Density map settings for shadows averaged over a disc of radius `footprint` (metres, > 0),
/// fitted to the strands' extent under that light. Chosen by measurement (docs/measurements.md).
DensityMapSettings automaticMapSettings(StrandView strands, const LightSpace& light,
                                        float footprint);

}  // namespace hair
