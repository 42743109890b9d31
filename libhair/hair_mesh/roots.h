#pragma once

#include <functional>

#include <libhair/core/api.h>
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

}  // namespace hair
