#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/model/level_of_detail.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

/// A non-owning shared_ptr to a groom or head; `kept` must outlive it.
template <class T>
std::shared_ptr<const T> borrowed(const T& kept) {
  return {std::shared_ptr<void>{}, &kept};
}

template <class T>
std::shared_ptr<const T> borrowed(const T&& temporary) = delete;  ///< would dangle

/// One simulated head of hair; owns its groom, head, settings and state. Hair and frame() are the
/// layer below, for programs that own those themselves.
///
///   Simulation simulation(groom, settings, {pose.worldFromHead, pose.capsules}, head);
///   simulation.restart(simulation.body());                              // settle on the body
///   simulation.step({pose.worldFromHead, pose.capsules}, 1.0f / 60);    // a frame
///   draw(simulation.strands(), simulation.hair().colours);
///
/// A call that throws Error for its arguments changes nothing. Not thread-safe; each call uses all
/// threads internally (ThreadLimit).
class Simulation {
 public:
  /// At rest on `body`, shadowed and shaded. `head`: collider in head space, null for none.
  /// Distance fields of `body`'s meshes are not owned: keep them until a call passes other meshes.
  /// Throws Error for a groom, settings or a body that is not valid.
  explicit Simulation(std::shared_ptr<const Groom> groom, const FrameSettings& settings = {},
                      const BodyState& body = {}, std::shared_ptr<const MeshSdf> head = nullptr,
                      const WispSettings& wisps = {});
  /// The same; takes ownership of the groom.
  explicit Simulation(Groom groom, const FrameSettings& settings = {}, const BodyState& body = {},
                      std::shared_ptr<const MeshSdf> head = nullptr, const WispSettings& wisps = {})
      : Simulation(std::make_shared<const Groom>(std::move(groom)), settings, body, std::move(head),
                   wisps) {}
  Simulation(const Simulation&) = delete;  // hair_ points to members
  Simulation& operator=(const Simulation&) = delete;

  /// One frame: advances the hair by `seconds`, [1e-6, 1], to the new pose of the body, shadows and
  /// shades it. Returns the time of each stage.
  const FrameProfile& step(const BodyState& body, float seconds);
  /// Shadows and shades the hair without moving it, at the level last set: after a change of
  /// settings, light or camera while the hair is paused.
  const FrameProfile& relight();
  /// Resets to rest on the body and settles for `settle` seconds, [0, 3600], while colliders grow
  /// to full size; relights.
  void restart(const BodyState& body, float settle = 1);
  /// Teleports hair and head (hair::teleport); relights.
  void teleport(const RigidTransform& worldFromHead);
  /// Rebases the world's origin (hair::moveOrigin).
  void moveOrigin(glm::vec3 origin);
  /// Replaces the colliders (hair::changeColliders).
  void changeColliders(const BodyState& body);

  /// Settings of later frames. The rest state keeps the values it was built with (GuideSettings'
  /// stiffness, mass, gravity and skin). Throws Error, and keeps the old settings, where one is out
  /// of range.
  void setSettings(const FrameSettings& settings);
  /// Replaces the groom (hair::changeGroom) and draws all of it until setLevel; relights. Returns
  /// whether the motion continues.
  bool setGroom(std::shared_ptr<const Groom> groom);
  /// Level of detail of the next step, restart or relight() (levelFor).
  void setLevel(const LevelOfDetail& level);
  /// Takes precomputed detail of this groom; null: computed when a level first needs it.
  void setDetail(std::shared_ptr<const GroomDetail> detail);
  /// The groom's detail; computed on first use.
  const std::shared_ptr<const GroomDetail>& detail();
  /// The groom's detail if known, else null.
  const std::shared_ptr<const GroomDetail>& knownDetail() const { return detail_; }

  /// stateHash(const Hair&).
  std::uint64_t stateHash() const { return hair::stateHash(hair_); }
  /// Writes the state that the next frame starts from (saveState).
  void save(std::ostream& out) const;
  /// Restores a saved state (restoreState); relights.
  void restore(std::istream& in);

  StrandView strands() const { return hair_.strands(); }  ///< drawn last, world space, metres
  /// [lights · pointCount], [0, 1]; empty while shadows are off.
  std::span<const float> transmittance() const { return hair_.transmittance; }
  /// [pointCount] linear RGB; empty unless FrameSettings::radiance keeps it.
  std::span<const glm::vec3> radiance() const { return hair_.radiance; }
  /// [pointCount] sRGB bytes R, G, B, A in memory; empty while shading or its encoding is off.
  std::span<const std::uint32_t> colours() const { return hair_.colours; }
  double time() const { return hair_.time; }  ///< simulated seconds
  /// The body of the last call. Valid until the next call.
  BodyState body() const { return body_.state(); }
  /// Length errors and penetration of the guides.
  GuideStats stats() const;

  const FrameSettings& settings() const { return settings_; }  ///< of the next frame
  /// Of the last step() or relight().
  const FrameProfile& profile() const { return profile_; }
  const std::shared_ptr<const Groom>& groom() const { return groom_; }  ///< never null
  const std::shared_ptr<const MeshSdf>& head() const { return head_; }  ///< or null
  /// The state that stages pass to each other.
  const Hair& hair() const { return hair_; }
  /// Mutable access, to fill Hair::visibility or call single stages. Do not change its groom, head
  /// or detail.
  Hair& hair() { return hair_; }

 private:
  struct OwnedBody {
    RigidTransform worldFromHead;
    std::vector<Capsule> capsules;
    std::vector<Plane> planes;
    std::vector<MeshCollider> meshes;

    BodyState state() const { return {worldFromHead, capsules, {planes, meshes}}; }
    void assign(const BodyState& body);
  };
  void requireLight(const RigidTransform& worldFromHead) const;
  void requireHead(const RigidTransform& worldFromHead) const;
  void requireFrame(const BodyState& body) const;

  std::shared_ptr<const Groom> groom_;
  std::shared_ptr<const MeshSdf> head_;
  std::shared_ptr<const GroomDetail> detail_;
  FrameSettings settings_;
  Hair hair_;
  OwnedBody body_;  // of the last call
  FrameProfile profile_{};
};

}  // namespace hair
