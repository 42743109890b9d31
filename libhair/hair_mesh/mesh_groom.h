#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/chains.h>
#include <libhair/hair_mesh/roots.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

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

}  // namespace hair
