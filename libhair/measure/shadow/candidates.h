#pragma once

#include <span>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// One row of a table that compares shadow methods and their settings.
struct ShadowCandidate {
  std::string method;  ///< methodName, or "auto": the density map that automaticMapSettings chose
  std::string label;   ///< "density map 3 mm ...", or "auto"; unique in a list, without commas
  ShadowSettings settings;  ///< what makeShadowMethod takes
};

/// Extent of a list of candidates.
enum class CandidateSet {
  Quick,  ///< each method once, with good default settings for this footprint, and `auto`
  All,    ///< each at several resolutions and layer counts, among them those of its own paper
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(CandidateSet) {
  return std::array{Word("quick", CandidateSet::Quick), Word("all", CandidateSet::All)};
}

/// Settings to compare for shadows averaged over a disc of radius `footprint` (metres, > 0), sized
/// for the strands' extent under this light. `auto` comes first. Throws Error for a footprint that
/// is not positive.
std::vector<ShadowCandidate> shadowCandidates(StrandView strands, const LightSpace& light,
                                              float footprint, CandidateSet set);

/// All values of ShadowCandidate::method, in the order of shadowCandidates.
std::span<const std::string> candidateMethods();

}  // namespace hair
