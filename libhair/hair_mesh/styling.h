#pragma once

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/hair_mesh/roots.h>

namespace HAIR_API hair {

/// Styling of strands that come out of a hair mesh (Yuksel et al. 2009, section 3.4), in the order
/// of the fields. Everything random is keyed by the strand's root (bundle and number in it), never
/// by places: an edit of the mesh does not reshuffle hair. Lengths in metres; {} changes nothing.
///
/// Curls and deviations move a point across its strand, in the frame that parallel transport
/// carries along the strand from the face it starts in (its normal and first edge): they turn with
/// the mesh. They want points: some eight for a turn or between two bends, fewer draw something
/// coarser.
struct StylingSettings {
  float lengthCut = 0;        ///< share of the length that is cut off, [0, 1)
  float lengthVariation = 0;  ///< up to this share more, from strand to strand, [0, 1 - lengthCut)
  float clump = 0;            ///< how far strands come together at the tip, [0, 1]
  std::uint32_t clumpSize = 40;  ///< strands that come together, and curl alike, >= 1
  float curlRadius = 0;          ///< helix around the strand, >= 0
  float curlPitch = 0.03f;       ///< along the strand, a turn; a fifth more or less by clump, > 0
  float curlFromRoot = 0.1f;     ///< share of the length where curls begin, [0, 1)
  float noise = 0;               ///< slow deviation, grows up to this towards the tip, >= 0
  float noiseLength = 0.08f;     ///< along the strand, between its bends, > 0
  float frizz = 0;               ///< quick deviation, up to this, >= 0
  float frizzLength = 0.008f;    ///< along the strand, between its bends, > 0
  float frizzShare = 1;          ///< of strands that are frizzy, [0, 1]
};

/// Styles strand r as that of root r, in place; roots do not move. A strand keeps its number of
/// points. Clumps are of strands of one bundle: its first roots are their centres, each strand goes
/// to the nearest (when they were placed), and its point at a share u of its length by
/// clump·u^(3/2) of the way to the centre's point at that share. The same bits for any number of
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

/// Traces and styles again from the roots there are: after an edit of places. Throws Error as
/// traceStrands does where the edit was one of topology, and leaves the hair as it was.
void regrow(const HairMesh& mesh, std::span<const StrandGroup> groups, GrownHair& hair);

}  // namespace hair
