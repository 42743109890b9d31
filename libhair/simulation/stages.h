#pragma once

#include <libhair/simulation/frame.h>

namespace hair {

/// Scratch memory of the stages, kept in a Hair so that frames do not allocate.
struct HairScratch {
  static GuideWorkspace& guides(Hair& hair) { return hair.workspace_; }
  static const GuideWorkspace& guides(const Hair& hair) { return hair.workspace_; }
  static StrandSet& counted(Hair& hair) { return hair.counted_; }
};

/// Copies a span into a vector; the span may alias the vector or a part of it.
template <class T>
void assignSpan(std::span<const T> from, std::vector<T>& to) {
  if (from.data() == to.data() && from.size() == to.size()) return;
  if (!from.empty() && from.data() >= to.data() && from.data() < to.data() + to.size()) {
    std::vector<T> part(from.begin(), from.end());
    return to.swap(part);
  }
  to.assign(from.begin(), from.end());
}

// The stages of a frame, in order. Each calls one folder of the library with the hair's data, and
// fills its field of the profile.

/// Throws Error where applyLevel would.
void requireLevel(const Hair& hair);

/// Applies Hair::level where it has changed. Throws Error without Hair::detail.
void applyLevel(Hair& hair);

/// Measures the groom's rest density if self-collision is on and it is unknown under these
/// settings. Clears push and wind attenuation while self-collision is off.
void learnRestDensity(const FrameSettings& settings, Hair& hair);

/// guides/: advances the guide strands by `seconds` to the new pose of the body.
void moveGuides(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
                FrameProfile& profile);

/// wisps/: interpolates the drawn strands from the guides.
void drawStrands(const BodyState& body, Hair& hair, FrameProfile& profile);

/// repulsion/: measures the density of the drawn hair and the push of the next frame.
void repelFromDensity(const FrameSettings& settings, float seconds, Hair& hair,
                      FrameProfile& profile);

/// density/, shadow/: transmittance of each light at each point.
void shadow(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

/// shade/: radiance and colours of all points.
void shade(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

}  // namespace hair
