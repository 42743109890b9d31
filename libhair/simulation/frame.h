#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/profile.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/guides/settings.h>
#include <libhair/light/light.h>
#include <libhair/model/groom.h>
#include <libhair/repulsion/repulsion.h>
#include <libhair/shade/appearance.h>
#include <libhair/shadow/density_map.h>
#include <libhair/wisps/wisps.h>

namespace HAIR_API hair {

/// Stages of a frame and their parameters. A stage that is off from the start takes neither time
/// nor memory.
struct FrameSettings {
  GuideSettings guides;  ///< of the guide solver
  /// Off: no repulsion, and no density is measured. The first frame with it measures the rest
  /// density of the groom; so does a frame whose grid or limits differ (restDensityKey).
  bool selfCollision = true;
  RepulsionSettings repulsion;  ///< of self-collision
  Wind wind;                    ///< still air by default

  std::vector<Light> lights = std::vector<Light>(1);  ///< none: ambient colour only
  bool shadow = true;                                 ///< off: no maps, transmittance 1
  DensityMapSettings map;                             ///< of every light's map
  /// Rasterises head and body into every light's map, at its cell size (occlude). Renderers with
  /// shadow maps of their own get sharper body shadows by filling Hair::visibility.
  bool bodyShadow = false;
  bool shade = true;       ///< off: neither radiance nor colours are computed
  bool encode = true;      ///< writes Hair::colours, sRGB bytes
  bool radiance = false;   ///< stores Hair::radiance, 12 bytes a point
  Appearance appearance;   ///< reflectance model, colours and highlights
  glm::vec3 eye{0, 0, 1};  ///< camera position, metres; highlights depend on it
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const FrameSettings*) {
  using S = FrameSettings;
  return std::tuple(Field("guides", &S::guides), Field("selfCollision", &S::selfCollision),
                    Field("repulsion", &S::repulsion), Field("wind", &S::wind),
                    Field("lights", &S::lights), Field("shadow", &S::shadow), Field("map", &S::map),
                    Field("bodyShadow", &S::bodyShadow), Field("shade", &S::shade),
                    Field("encode", &S::encode), Field("radiance", &S::radiance),
                    Field("appearance", &S::appearance), Field("eye", &S::eye, "[0, 1e15) m"));
}

/// Throws Error that names the field and its range, for every stage of a frame.
void validate(const FrameSettings& settings);

/// Fits the map's extent to the groom (mapExtentNeeded): changes the cell size, keeps the number of
/// cells. `headSize`: the head's largest dimension, metres.
DensityMapSettings fitMap(const DensityMapSettings& settings, const Groom& groom,
                          float headSize = 0.3f);

/// Pose of head, body and scenery at the end of a frame.
struct BodyState {
  RigidTransform worldFromHead;       ///< head space to world
  std::span<const Capsule> capsules;  ///< of the body, at most kMaxCapsules
  Scenery scenery{};                  ///< planes and meshes around it; none by default

  /// Whether each kind has as many colliders as `other`. If so, they move from their old poses; if
  /// not, frame() calls changeColliders.
  bool sameCounts(const BodyState& other) const {
    return capsules.size() == other.capsules.size() &&
           scenery.planes.size() == other.scenery.planes.size() &&
           scenery.meshes.size() == other.scenery.meshes.size();
  }
};

/// `body` at rest: the poses before and after the frame are equal.
ColliderState collidersOf(const BodyState& body, const MeshSdf* head);

/// State of one head of hair: the data that stages pass to each other and to the next frame.
struct Hair {
  /// At rest on `body`. `head`: collider in head space, null for none; it and the groom must
  /// outlive this. Settings that determine the rest state (guides, repulsion, clearances) are read
  /// here only.
  Hair(const Groom& groom, const FrameSettings& settings, const BodyState& body,
       const MeshSdf* head = nullptr, const WispSettings& wisps = {});

  const Groom* groom;   ///< as given; not owned
  const MeshSdf* head;  ///< collider in head space, not owned; null: none
  /// Level of detail of the next frame (levelFor); strands() is unchanged until then. Any frame may
  /// change it: the simulation of guides does not depend on it. Needs `detail`.
  LevelOfDetail level;
  const GroomDetail* detail = nullptr;  ///< of the groom, not owned; null: only level {} is allowed
  GuideStrands guides;                  ///< simulated strands
  Wisps wisps;                          ///< drawn strands
  Repulsion repulsion;                  ///< density of the drawn hair, and the acceleration from it
  std::vector<DensityMap> maps;         ///< [lights]; empty while shadows are off
  std::vector<float> transmittance;     ///< [lights · pointCount]; empty while shadows are off
  std::vector<float> visibility;        ///< [lights · pointCount], [0, 1], of lights past head and
                                        ///< body, filled by the caller; empty: 1
  std::vector<glm::vec3> radiance;      ///< [pointCount] linear RGB (shade); or empty
  std::vector<std::uint32_t> colours;   ///< [pointCount] sRGB bytes (encodeSrgb); or empty
  RigidTransform worldFromHead;         ///< at the end of the last frame
  std::vector<Capsule> capsules;        ///< body at the end of the last frame
  std::vector<Plane> planes;            ///< scenery at the end of the last frame
  std::vector<MeshCollider> meshes;     ///< scenery at the end of the last frame
  double time = 0;                      ///< simulated seconds

  /// The drawn strands of the last frame, world space.
  StrandView strands() const { return wisps.strands(); }
  /// Pose of head, body and scenery at the end of the last frame.
  BodyState body() const { return {worldFromHead, capsules, {planes, meshes}}; }
  /// Stores the colliders that the next frame starts from.
  void remember(const BodyState& body);
  /// Target of point lights: the origin of head space, the joint that the head turns on. It does
  /// not depend on the hair, so neither cells nor brightness change with the hair's motion.
  glm::vec3 pivot() const { return worldFromHead.translation; }
  /// Input of shade: the settings' lights, with this hair's transmittance and visibility. Refers to
  /// both: change neither the settings nor this while it is in use.
  Illumination illumination(const FrameSettings& settings) const {
    return {settings.lights, pivot(), settings.eye, transmittance, visibility};
  }

 private:
  friend struct HairScratch;
  GuideWorkspace workspace_;  // of stepGuides
  StrandSet counted_;         // strands that self-collision splats, where LOD draws fewer
};

/// 64 bits over guides and drawn points: equal on every machine, with any number of threads and any
/// instruction set.
std::uint64_t stateHash(const Hair& hair);
/// stateHash over the transmittance and colours as well.
std::uint64_t pictureHash(const Hair& hair);

/// Advances the hair by `seconds` to the new pose of the body, shadows and shades it. This is the
/// whole pipeline, one line a stage; each fills its field of the profile. Throws Error as its
/// stages do. Repulsion uses the density of the hair drawn in the previous frame.
void frame(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair,
           FrameProfile& profile);

/// The second half of a frame: shadows and shades the hair without moving it (a still picture, or a
/// light or camera that moves while the hair is paused). Time and memory grow with the number of
/// lights, one map each; maps of removed lights are freed.
void light(const FrameSettings& settings, Hair& hair, FrameProfile& profile);

/// Draws the current hair at `hair.level`, without a frame; call `light` next to shadow and shade
/// it. (For hair that is paused while the camera moves; `frame` does this itself.) The distance
/// fields of scenery in the last frame must still exist.
void redraw(Hair& hair);

/// Map settings at a level of detail: larger cells, fewer of them over the same extent, and a
/// footprint scaled with the cell size.
DensityMapSettings mapAt(const LevelOfDetail& level, const DensityMapSettings& settings);

/// Resets the hair to rest on the body and settles it for `seconds`, [0, 3600], while colliders
/// grow to full size (ColliderFadeIn): hair groomed through a shoulder moves out of it smoothly
/// instead of being ejected.
void restart(const BodyState& body, const FrameSettings& settings, float seconds, Hair& hair);

// Changes of the scene between two frames. Each preserves the hair's motion as far as possible.
// Call light() afterwards to recompute transmittance and colours without a frame.

/// Teleports hair and head to `worldFromHead`: applies the head's rigid motion to guides, drawn
/// points, capsules, velocities and repulsion, so that the hair keeps its shape and gets no
/// impulse. Forgets planes and meshes: the next frame takes its own as at rest. Gravity and wind
/// stay in world axes. Throws Error for a head that is not finite, or where floats are too coarse
/// (requirePrecision).
void teleport(const RigidTransform& worldFromHead, Hair& hair);

/// Rebases the world to `origin`: later input is relative to it. Hair keeps its shape, velocity and
/// place. Positions are floats, most precise near the origin: programs that travel far should
/// rebase before requirePrecision (guides/validate.h) rejects a frame. Wind gusts and map cells
/// shift with the origin. Throws Error for an origin that is not finite, or too far from the head.
void moveOrigin(glm::vec3 origin, Hair& hair);

/// Replaces the colliders: the next frame treats those of `body` as having been at rest. Guides
/// inside one are moved out without advancing time or changing velocities; guides clear of all keep
/// every bit. frame() does this itself where the number of colliders changes; call it where the
/// number stays and the colliders differ.
/// Throws Error for more than kMaxCapsules capsules, and for colliders that are not valid.
void changeColliders(const BodyState& body, const FrameSettings& settings, Hair& hair);

/// Replaces the groom; it must outlive the hair. If the numbers of guides and of points a guide
/// match, link directions and point velocities are kept with the new link lengths (a trim, or other
/// stiffness, curls or drawn strands, during motion), and it returns true. Otherwise the new guides
/// start at rest on the head. In both cases guides are moved out of colliders as by
/// changeColliders. Time continues.
/// Throws Error as Hair's constructor does; the hair is then unchanged.
bool changeGroom(const Groom& groom, const FrameSettings& settings, Hair& hair);

/// Writes the state that a frame passes to the next: guides, self-collision with its rest density,
/// colliders, time, drawn points, and the clearances measured at construction. Settings and groom
/// are not included. Layout: hair_state.cpp. Throws Error where the stream fails.
void saveState(const Hair& hair, std::ostream& out);

/// Restores a saved state: with the settings and motion of the saved run, every later frame is
/// bit-identical to it, on any machine and number of threads. Reads exactly the bytes written.
/// Transmittance and colours are recomputed by the next frame, or light(). Throws Error for a state
/// of another groom or of guide settings with another rest shape, and for a truncated or damaged
/// one; the hair is then unchanged.
void restoreState(std::istream& in, Hair& hair);

}  // namespace hair
