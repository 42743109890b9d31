#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/hair_mesh.h>
#include <libhair/model/groom.h>
#include <libhair/model/styles.h>

namespace HAIR_API hair {

/// The chains of a hair mesh: from each vertex of a tip face, down the edges between layers to the
/// scalp (Yuksel et al. 2009, section 4: "an articulated rigid body chain directly from the edges
/// of the hair mesh that connect the vertices of one layer to the next").
///
/// Chains that separate share the vertices below. A vertex that is a corner both of a tip and of a
/// longer neighbouring bundle ends one chain and is an inner vertex of another.
struct HairMeshChains {
  std::vector<std::uint32_t> vertices;     ///< [first.back()], of layer k at first[c] + k
  std::vector<std::uint32_t> first = {0};  ///< [chainCount + 1]
  /// [cornerCount] of the mesh: the chain that ends at this corner of the bundle's tip face;
  /// kNoVertex for bundles without length.
  std::vector<std::uint32_t> chainOfCorner;

  /// Number of chains.
  std::size_t chainCount() const { return first.size() - 1; }
  /// Number of edges between layers, of all chains.
  std::size_t linkCount() const { return vertices.size() - chainCount(); }
  /// Vertices of chain c, one of each layer, from the scalp on.
  std::span<const std::uint32_t> chain(std::size_t c) const {
    return std::span(vertices).subspan(first[c], first[c + 1] - first[c]);
  }
};

/// Extracts the chains, ordered by the corners at which they end. `mesh` must be valid.
HairMeshChains chainsOf(const HairMesh& mesh);

/// Moves the vertices of a mesh with the guides of its chains (makeGroom): each to the point of its
/// guide at the same fraction of the chain's length as on `rest`; a vertex of several chains to
/// their mean. `guidePoints`: [chainCount · pointsPerGuide], root first. `moved` has the topology
/// of `rest`. Throws Error where counts differ.
void followGuides(const HairMesh& rest, const HairMeshChains& chains,
                  std::span<const glm::vec3> guidePoints, std::uint32_t pointsPerGuide,
                  HairMesh& moved);

/// Settings of the conversion of a hair mesh to a groom.
struct MeshGroomSettings {
  /// 3 to kMaxGuidePoints; 0: the number of layers, so that links are about as long as the mesh's
  /// edges, but at least 16.
  std::uint32_t pointsPerGuide = 0;
  float hairs = 100'000;  ///< that the drawn strands represent together
  /// [bundleCount], or empty: chains at the corners of a bundle keep their places on the head up to
  /// this layer (Groom::tied); 0: only their roots do. Of several bundles' the highest counts.
  std::vector<std::uint32_t> tied = {};
};

/// Converts a hair mesh to a groom for simulation (Yuksel et al. 2009, section 4): its chains are
/// the guides, with links of equal length along the same spline as strands, and every strand
/// follows the chains at the corners of its face.
///
/// `roots` and `strands` are those of the groups, one after the other: as many roots as strands,
/// the strands styled or not (head space). Deviation: a strand follows the three corners of most
/// weight, as a Groom has three parents; its offsets hold the difference, so that at rest the
/// strands are reproduced to rounding. Throws Error for no strands, counts or bundles that do not
/// fit, a chain shorter than 1 mm, and settings out of range.
Groom makeGroom(const HairMesh& mesh, std::span<const HairMeshRoots> roots, StrandView strands,
                const MeshGroomSettings& settings = {});

/// Strands of a mesh as the curves of wisps (Yuksel et al. 2009, section 3.4 and figure 9).
struct WispCurveSettings {
  /// The curves, and their styling. `points` are the guides'.
  StrandGroup curves{.strands = 200, .points = 16};
  /// How strands fill them: its strands, points, seed, hairs, and what fills a wisp, from `clumpBy`
  /// on. The rest is about the built-in head and says nothing here; a wisp has one curve, so that
  /// `spread` says how far its strands come together and `clump` says nothing.
  StyleSettings fill{.spread = 0.15f};
};

/// A groom whose guides are the wisp curves, with links of equal length, and whose drawn strands
/// have roots of their own on the scalp: each follows the curve whose root is nearest, of its own
/// bundle if that has one, and keeps its position in the wisp (as Choe and Ko 2005: a master
/// strand, and what distinguishes others from it). Throws Error as growHair and for fewer than 3
/// points of a curve, fewer than 2 of a strand, or no curves or strands.
Groom wispGroom(const HairMesh& mesh, const WispCurveSettings& settings = {},
                const ScalpDensity& density = {});

}  // namespace hair
