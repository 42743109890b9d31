#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/profile.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/guides/settings.h>
#include <libhair/guides/step.h>
#include <libhair/light/light.h>
#include <libhair/model/groom.h>
#include <libhair/repulsion/repulsion.h>
#include <libhair/shade/appearance.h>
#include <libhair/shadow/density_map.h>
#include <libhair/wisps/level.h>
#include <libhair/wisps/wisps.h>

namespace HAIR_API hair {

/// What a frame computes. A stage that is off from the start costs nothing, neither time nor
/// memory.
struct FrameSettings {
  GuideSettings guides;  ///< how guides move
  /// Off: nothing pushes hair apart, and no density is measured. The first frame with it learns
  /// the density that the groom has at rest, and so does one with another grid or other limits.
  bool selfCollision = true;
  RepulsionSettings repulsion;  ///< how strongly hair pushes hair apart
  Wind wind;                    ///< still air by default

  std::vector<Light> lights = std::vector<Light>(1);  ///< none: hair in its ambient colour
  bool shadow = true;                                 ///< off: no maps, all light arrives
  DensityMapSettings map;                             ///< of every light's map
  /// Head and body in every light's map, as soft as its cells (occlude). A program that draws has
  /// sharper shadows of them in its own images, and hands those over as Hair::visibility.
  bool bodyShadow = false;
  bool shade = true;       ///< off: neither radiance nor colours are computed
  bool encode = true;      ///< Hair::colours are made; off: no bytes
  bool radiance = false;   ///< Hair::radiance is kept, 12 bytes a point; off: none is stored
  Appearance appearance;   ///< model of how hair looks, its colours and highlights
  glm::vec3 eye{0, 0, 1};  ///< where the picture is taken from, metres; highlights move with it
};

/// Throws Error that names the field and its range: whatever some stage of a frame would refuse.
void validate(const FrameSettings& settings);

/// The same settings with a map that is as large as this hair needs (mapExtentNeeded): cells of
/// another size, as many as before. `headSize`: the head's largest dimension, metres.
DensityMapSettings fitMap(const DensityMapSettings& settings, const Groom& groom,
                          float headSize = 0.3f);

/// Where head, body and scenery are at the end of a frame.
struct BodyState {
  RigidTransform worldFromHead;       ///< head space to world
  std::span<const Capsule> capsules;  ///< of the body, at most kMaxCapsules
  Scenery scenery{};                  ///< planes and meshes around it; none by default

  /// Each kind of collider: as many as before move from there; else changeColliders.
  bool sameCounts(const BodyState& other) const {
    return capsules.size() == other.capsules.size() &&
           scenery.planes.size() == other.scenery.planes.size() &&
           scenery.meshes.size() == other.scenery.meshes.size();
  }
};

/// The same as stages see what stands still.
ColliderState collidersOf(const BodyState& body, const MeshSdf* head);

/// One head of hair over its frames: what the stages hand to each other.
struct Hair {
  /// At rest on `body`. `head`: collider in head space, null for none; it and the groom must
  /// outlive this. Settings that shape the rest state (guides, repulsion, clearances) are taken
  /// here.
  Hair(const Groom& groom, const FrameSettings& settings, const BodyState& body,
       const MeshSdf* head = nullptr, const WispSettings& wisps = {});

  const Groom* groom;   ///< as given; not owned
  const MeshSdf* head;  ///< collider in head space, not owned; null: none
  /// How much of the groom the next frame draws (levelFor); strands() is as it was until then. Any
  /// frame may have another level: guides do not feel it. Needs `detail`.
  LevelOfDetail level;
  const GroomDetail* detail = nullptr;  ///< of the groom, not owned; null: no level but {}
  GuideStrands guides;                  ///< what is simulated
  Wisps wisps;                          ///< what is drawn
  Repulsion repulsion;                  ///< density of the drawn hair, and its push
  std::vector<DensityMap> maps;         ///< [lights]; empty while shadows are off
  std::vector<float> transmittance;     ///< [lights · pointCount]; empty while shadows are off
  std::vector<float> visibility;        ///< [lights · pointCount], what head and body leave of each
                                        ///< light; the caller's to fill, empty: all of it
  std::vector<glm::vec3> radiance;      ///< [pointCount] linear RGB (shade); or empty
  std::vector<std::uint32_t> colours;   ///< [pointCount] sRGB bytes of it (encodeSrgb); or empty
  RigidTransform worldFromHead;         ///< at the end of the last frame
  std::vector<Capsule> capsules;        ///< body then
  std::vector<Plane> planes;            ///< scenery then
  std::vector<MeshCollider> meshes;     ///< scenery then
  double time = 0;                      ///< simulated seconds

  /// The drawn strands of the last frame, world space.
  StrandView strands() const { return wisps.strands(); }
  /// Where head and body were at the end of the last frame.
  BodyState body() const { return {worldFromHead, capsules, {planes, meshes}}; }
  /// What the next frame starts from.
  void remember(const BodyState& body);
  /// What lights at points look at: the joint that the head turns on. Hair that moves does not move
  /// it, so that neither cells nor brightness follow the hair's motion.
  glm::vec3 pivot() const { return worldFromHead.translation; }
  /// What shade is told: all of the settings' lights, as the hair's arrays have them.
  /// The settings and this must stay as they are while it is used.
  Illumination illumination(const FrameSettings& settings) const {
    return {settings.lights, pivot(), settings.eye, transmittance, visibility};
  }

 private:
  friend struct HairScratch;
  GuideWorkspace workspace_;  // of stepGuides
  StrandSet counted_;         // strands that self-collision counts, where fewer are drawn
};

/// 64 bits over guides and drawn points: equal on every machine, with any number of threads and any
/// instruction set.
std::uint64_t stateHash(const Hair& hair);
/// The same with what is seen of them: transmittance and colours.
std::uint64_t pictureHash(const Hair& hair);

/// Moves the hair by `seconds`, to where the body is then, shadows and shades it. This is the whole
/// pipeline: a stage a line, which calls a folder of the library and fills its field of the
/// profile. Throws Error as its stages do. The guides feel the density of the hair drawn last.
void frame(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
           FrameProfile& profile);

/// The second half of a frame: shadows and shades the hair as it stands (a still picture, or a
/// light or camera that moves while the hair is paused). The time grows with the number of lights,
/// and each has a map; that of a light which is no more is freed.
void light(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

/// Draws the hair as it stands at `hair.level`, without a frame; `light` then shadows and shades
/// it. (For hair that is paused while the camera moves; `frame` does it by itself.) The body has to
/// be where the last frame left it, scenery's distance fields included.
void redraw(Hair& hair);

/// Settings of the maps of hair at a level: larger cells, and fewer for the same extent; a
/// footprint grows with its cells.
DensityMapSettings mapAt(const LevelOfDetail& level, const DensityMapSettings& settings);

/// Back to rest on the body, then `seconds` without motion, while body and meshes grow from nothing
/// to their size and planes rise from below all hair: hair groomed through a shoulder finds its way
/// out instead of being thrown out.
void restart(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair);

}  // namespace hair
