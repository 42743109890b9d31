#pragma once

#include <libhair/guides/step.h>

namespace hair {

/// Seconds that a substep of this frame lasts at most: settings.substep, or what the hair asks for
/// at rest (GuideStrands::longestSubstep), or what moves it in this frame does:
///   - what pulls on uneven links: gravity, wind and drag, and the head's spin;
///   - roots that leave the way they went: by half of the shortest link a substep at most, or its
///     predicted direction says nothing. Let down to 1/20000 s, as a jump of the head may ask for
///     anything.
/// Throws Error as GuideStrands::longestSubstep.
float longestSubstep(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                     const GuideStrands& guides);

}  // namespace hair
