#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/roots.h>

namespace HAIR_API hair {

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
