#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <libhair/core/profile.h>
#include <libhair/guides/settings.h>
#include <libhair/guides/step.h>
#include <libhair/model/groom.h>
#include <libhair/model/mesh_sdf.h>
#include <libhair/repulsion/repulsion.h>
#include <libhair/shade/kajiya_kay.h>
#include <libhair/shadow/density_map.h>
#include <libhair/wisps/wisps.h>

namespace hair {

/// What a frame computes. A stage that is off from the start costs nothing, neither time nor
/// memory.
struct FrameSettings {
  GuideSettings guides;
  bool selfCollision = true;
  RepulsionSettings repulsion;
  Wind wind;

  bool shadow = true;
  DensityMapSettings map;
  bool shade = true;
  KajiyaKaySettings look;
  ShadeLight light;
};

/// Where head and body are at the end of a frame.
struct BodyState {
  RigidTransform worldFromHead;
  std::span<const Capsule> capsules;  ///< same count and order in every frame
};

/// One head of hair over its frames: what the stages hand to each other.
struct Hair {
  /// At rest on `body`. `head`: collider in head space, null for none; it and the groom must
  /// outlive this. Settings that shape the rest state (guides, repulsion, clearances) are taken
  /// here.
  Hair(const Groom& groom, const FrameSettings& settings, const BodyState& body,
       const MeshSdf* head = nullptr, const WispSettings& wisps = {});

  const Groom* groom;
  const MeshSdf* head;
  GuideStrands guides;
  Wisps wisps;
  Repulsion repulsion;
  DensityMap map;
  std::vector<float> transmittance;    ///< [pointCount]; empty while shadows are off
  std::vector<float> visibility;       ///< [pointCount], what head and body leave of the light; the
                                       ///< caller's to fill, empty: all of it
  std::vector<std::uint32_t> colours;  ///< [pointCount] sRGB bytes (shadeKajiyaKay); or empty
  std::vector<Capsule> capsules;       ///< body at the end of the last frame
  double time = 0;                     ///< simulated seconds
  GuideWorkspace workspace;

  StrandView strands() const { return wisps.strands(); }
};

/// Moves the hair by `seconds`, to where the body is then, shadows and shades it. This is the whole
/// pipeline: each line is a folder of the library, and fills its field of the profile.
/// Throws Error as its stages do. The guides feel the density of the hair drawn last.
void frame(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
           FrameProfile& profile);

/// The second half of a frame: shadows and shades the hair as it stands (a still picture, or a
/// light or camera that moves while the hair is paused).
void light(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

/// Back to rest on the body, then `seconds` without motion, while the body grows from nothing to
/// its size: hair groomed through a shoulder finds its way out instead of being thrown out.
void restart(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair);

}  // namespace hair
