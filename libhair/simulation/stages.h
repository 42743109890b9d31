#pragma once

#include <libhair/simulation/frame.h>

namespace hair {

/// What stages keep from frame to frame in a hair, lest a frame allocates memory.
struct HairScratch {
  static GuideWorkspace& guides(Hair& hair) { return hair.workspace_; }
  static const GuideWorkspace& guides(const Hair& hair) { return hair.workspace_; }
  static StrandSet& counted(Hair& hair) { return hair.counted_; }
};

/// Copies a span that may be of the vector itself, or of a part of it.
template <class T>
void assignSpan(std::span<const T> from, std::vector<T>& to) {
  if (from.data() == to.data() && from.size() == to.size()) return;
  if (!from.empty() && from.data() >= to.data() && from.data() < to.data() + to.size()) {
    std::vector<T> part(from.begin(), from.end());
    return to.swap(part);
  }
  to.assign(from.begin(), from.end());
}

// The stages of a frame, in their order. Each calls one room of the library with what the hair
// holds, and fills that room's field of the profile.

/// Takes over Hair::level where it has changed. Throws Error without Hair::detail.
void applyLevel(Hair& hair);

/// Learns what density the groom has at rest where self-collision needs it and does not know it
/// under these settings; forgets what pushed while self-collision is off.
void learnRestDensity(const FrameSettings& settings, Hair& hair);

/// guides/: moves the guide strands to where the body is after `seconds`.
void moveGuides(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
                FrameProfile& profile);

/// wisps/: draws the strands that follow the guides.
void drawStrands(const BodyState& body, Hair& hair, FrameProfile& profile);

/// repulsion/: measures the density of the drawn hair, and what it pushes in the next frame.
void repelFromDensity(const FrameSettings& settings, float seconds, Hair& hair,
                      FrameProfile& profile);

/// density/, shadow/: what of each light arrives at each point.
void shadow(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

/// shade/: the radiance of all points, and their colours.
void shade(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

}  // namespace hair
