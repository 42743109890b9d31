#pragma once

#include <libhair/core/api.h>
#include <libhair/hair_mesh/hair_mesh.h>

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

}  // namespace hair
