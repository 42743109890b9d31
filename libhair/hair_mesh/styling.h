#pragma once

#include <libhair/core/strands.h>

namespace hair {

/// Styling of strands that come out of a hair mesh (Yuksel et al. 2009, section 3.4), in the order
/// of the fields. Everything random is keyed by the strand's root (bundle and number in it), never
/// by places: an edit of the mesh does not reshuffle hair. Lengths in metres; {} changes nothing.
struct StylingSettings {
  float lengthCut = 0;           ///< share of the length that is cut off, [0, 1)
  float lengthVariation = 0;     ///< up to this share more, from strand to strand, [0, 1)
  float clump = 0;               ///< how far strands come together at the tip, [0, 1]
  std::uint32_t clumpSize = 40;  ///< strands that come together, >= 1
  float curlRadius = 0;          ///< helix around the strand, >= 0
  float curlPitch = 0.03f;       ///< along the strand, a turn, > 0
  float curlFromRoot = 0.1f;     ///< share of the length where curls begin, [0, 1)
  float noise = 0;               ///< slow deviation, grows to this at the tip, >= 0
  float noiseLength = 0.08f;     ///< along the strand, between its bends, > 0
  float frizz = 0;               ///< quick deviation, >= 0
  float frizzLength = 0.008f;    ///< along the strand, between its bends, > 0
  float frizzShare = 1;          ///< of strands that are frizzy, [0, 1]
};

/// One set of strands grown from a mesh; a hairstyle is the union of several (figure 11).
struct StrandGroup {
  std::uint32_t strands = 10'000;
  std::uint32_t points = 32;  ///< a strand, >= 2
  std::uint32_t seed = 1;
  StylingSettings styling;
};

}  // namespace hair
