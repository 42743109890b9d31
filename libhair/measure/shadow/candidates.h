#pragma once

#include <span>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace HAIR_API hair {

/// One row of a table that compares ways to shadow hair.
struct ShadowCandidate {
  std::string method;  ///< methodName, or "auto": the density map that automaticMapSettings chose
  std::string label;   ///< "density map 3 mm ...", or "auto"; differs within a list, no commas
  ShadowSettings settings;  ///< what makeShadowMethod takes
};

/// How much of the space of settings is tried.
enum class CandidateSet {
  Quick,  ///< each method once, as it is best at this footprint without thought, and `auto`
  All,    ///< each at several resolutions and layer counts, among them those of its own paper
};

/// What is worth trying for shadows averaged over a disc of radius `footprint` (metres, > 0).
/// Reads the strands' extent under that light. `auto` comes first.
std::vector<ShadowCandidate> shadowCandidates(StrandView strands, const LightSpace& light,
                                              float footprint, CandidateSet set);

/// The names that ShadowCandidate::method takes, in the order of shadowCandidates.
std::span<const std::string> candidateMethods();

}  // namespace hair
