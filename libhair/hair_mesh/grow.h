#pragma once

#include <functional>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace HAIR_API hair {

/// Relative hair density at a point of the scalp, clamped to [0, 1].
using ScalpDensity = std::function<float(glm::vec3)>;

/// A ScalpDensity from an image of the scalp, from above, with the face at the bottom.
struct DensityImage {
  std::uint32_t width = 0,        ///< pixels
      height = 0;                 ///< pixels
  std::vector<float> values;      ///< [height·width], rows from the back of the head to the face
  glm::vec2 lower{-0.1f, -0.1f};  ///< (x, z) of the picture's upper left corner, metres
  glm::vec2 upper{0.1f, 0.1f};    ///< (x, z) of its lower right corner

  /// Bilinear between pixel centres, clamped at the border. Size and values must fit.
  float operator()(glm::vec3 p) const;
};

/// How many roots, and which.
struct RootSettings {
  std::uint32_t strands = 10'000;  ///< in all
  std::uint32_t seed = 1;          ///< of everything random
  /// > 0: as many roots a square metre where density is 1, whatever `strands` says. What one bundle
  /// has then depends on its own face alone.
  float perSquareMetre = 0;
};

/// Root positions on the root layer, sorted by bundle.
struct HairMeshRoots {
  std::vector<std::uint32_t> firstRoot = {0};  ///< [bundleCount + 1]
  std::vector<std::uint32_t> bundle;           ///< [rootCount]
  std::vector<std::uint32_t> number;  ///< [rootCount], names a root in its bundle; ascending
  std::vector<std::uint32_t> firstWeight = {0};  ///< [rootCount + 1]
  std::vector<float> weights;        ///< [firstWeight.back()], of the corners of the root's face
  std::vector<glm::vec3> positions;  ///< [rootCount], metres, when they were placed

  /// Number of roots.
  std::size_t rootCount() const { return bundle.size(); }
  /// Weights of the corners of a root's face, as many as it has sides; sum 1.
  std::span<const float> weightsOf(std::size_t root) const {
    return std::span(weights).subspan(firstWeight[root], firstWeight[root + 1] - firstWeight[root]);
  }
  /// Key of this root's random numbers: the same in every mesh that has the root.
  std::uint32_t key(std::size_t root) const;
};

/// Spreads roots over the faces of F^0, evenly by area (of FlatPolygon) times `density` (none: 1).
/// Bundles without length have none.
///
/// Each bundle has an infinite sequence of roots, which depends on the seed, the bundle's number
/// and the shape of its face: a jittered R2 sequence (Roberts 2018) over a box around the face, of
/// which points outside are rejected, and points inside at random according to density. The i-th
/// root of bundle j has time (i + u_j) / m_j, where m_j is area times mean density and u_j in [0,
/// 1) is random for each bundle; the `strands` earliest of all are taken. So the count is exact;
/// roots of a smaller count are a subset of those of a larger one; and a growing face only removes
/// the last roots of other bundles (none with perSquareMetre).
///
/// The mean density is sampled at 256 points of a face. Fewer roots result where density is zero at
/// all of those, or where less than 1/4096 of the box has hair. The same bits for any number of
/// threads; `density` is called concurrently. Throws Error if no face has area
/// (and density), or for settings out of range.
HairMeshRoots placeRoots(const HairMesh& mesh, const RootSettings& settings = {},
                         const ScalpDensity& density = {});

/// Throws Error unless the roots fit the mesh's bundles.
void validate(const HairMeshRoots& roots, const HairMesh& mesh);

/// Traces a strand for each root (Yuksel et al. 2009, section 3.1): applies the root's weights to
/// the corners of its bundle's face in layers 0 ... n_j, and samples the C1 Catmull-Rom spline
/// through the resulting points at `points` (>= 2) points of equal distance along it (to about 1
/// %).
///
/// The spline is the centripetal one, whose knots are sqrt(distance) apart (Yuksel, Schaefer,
/// Keyser 2011, "Parameterization and Applications of Catmull-Rom Curves"): the uniform one has
/// loops where layers are close to each other, as after Layer Insert or a short extrusion. It is
/// extended at its ends by reflection, P[-1] = 2 P[0] - P[1]: hair leaves the scalp towards the
/// first layer. The first and the last point are the weighted sums of the corners of the scalp's
/// and the tip's face, bit for bit. Layers that coincide at a strand count once; segments have no
/// length only where all layers of a strand coincide.
///
/// Roots do not depend on vertex positions: after an edit of positions only this is recomputed.
/// `strands` is overwritten and keeps its memory. The same bits for any number of
/// threads. Throws Error for fewer than 2 points, or roots that do not fit the mesh.
void traceStrands(const HairMesh& mesh, const HairMeshRoots& roots, std::uint32_t points,
                  StrandSet& strands);

/// Styling of strands of a hair mesh (Yuksel et al. 2009, section 3.4), applied in the order of the
/// fields. Random numbers are keyed by the strand's root (bundle and number in it), not by
/// position: an edit of the mesh does not reshuffle hair. Lengths in metres; {} changes nothing.
///
/// Curls and deviations displace points across their strand, in the frame carried by parallel
/// transport from the face of its root (normal and first edge), so that they rotate with the mesh.
/// They need about eight points a turn or bend; fewer undersample them.
struct StylingSettings {
  float lengthCut = 0;           ///< fraction of the length that is cut off, [0, 1)
  float lengthVariation = 0;     ///< random additional cut up to this fraction, [0, 1 - lengthCut)
  float clump = 0;               ///< strength of clumping at the tip, [0, 1]
  std::uint32_t clumpSize = 40;  ///< strands a clump, which also share a curl, >= 1
  float curlRadius = 0;          ///< helix around the strand, >= 0
  float curlPitch = 0.03f;       ///< along the strand, a turn; a fifth more or less by clump, > 0
  float curlFromRoot = 0.1f;     ///< share of the length where curls begin, [0, 1)
  float noise = 0;               ///< low-frequency deviation, grows up to this at the tip, >= 0
  float noiseLength = 0.08f;     ///< along the strand, between its bends, > 0
  float frizz = 0;               ///< high-frequency deviation, up to this, >= 0
  float frizzLength = 0.008f;    ///< along the strand, between its bends, > 0
  float frizzShare = 1;          ///< fraction of strands with frizz, [0, 1]
};

/// Styles strand r, of root r, in place; keeps roots and numbers of points. Clumps are within a
/// bundle: its first roots are their centres, and each strand belongs to the nearest (by placed
/// positions). Its point at a fraction u of its length moves by the fraction clump·u^(3/2) towards
/// the centre strand's point at the same u. The same bits for any number of
/// threads. Throws Error for settings out of range, strands of fewer than 2 points, or roots that
/// fit neither mesh nor strands.
void style(const HairMesh& mesh, const HairMeshRoots& roots, const StylingSettings& settings,
           std::uint32_t seed, StrandSet& strands);

/// One set of strands grown from a mesh; a hairstyle is the union of several (figure 11).
struct StrandGroup {
  std::uint32_t strands = 10'000;  ///< in this group
  std::uint32_t points = 32;       ///< a strand, >= 2
  std::uint32_t seed = 1;          ///< of roots and styling
  StylingSettings styling = {};    ///< what is done to them
  float perSquareMetre = 0;        ///< > 0: instead of `strands` (RootSettings)
};

/// The union of groups of strands, one group after the other.
struct GrownHair {
  StrandSet strands;                 ///< metres, head space, as HairMesh
  std::vector<std::uint32_t> group;  ///< [strandCount]
  std::vector<HairMeshRoots> roots;  ///< one a group
};

/// Places roots, traces and styles strands of every group. `density` is for all groups.
GrownHair growHair(const HairMesh& mesh, std::span<const StrandGroup> groups,
                   const ScalpDensity& density = {});

/// Traces and styles again from the existing roots, after an edit of positions. Throws Error as
/// traceStrands after an edit of topology, and leaves the hair unchanged.
void regrow(const HairMesh& mesh, std::span<const StrandGroup> groups, GrownHair& hair);

}  // namespace hair
