#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/guides/measure.h>
#include <libhair/model/level_of_detail.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

/// What somebody else keeps, and keeps longer: a groom or a head that is not shared.
template <class T>
std::shared_ptr<const T> borrowed(const T& kept) {
  return {std::shared_ptr<void>{}, &kept};
}

template <class T>
std::shared_ptr<const T> borrowed(const T&& temporary) = delete;  ///< nobody keeps it

/// One head of hair over its frames, with all that it needs: the owner that programs keep. Hair and
/// frame() are the layer below, for who keeps groom, head and settings elsewhere.
///
///   Simulation simulation(groom, settings, {pose.worldFromHead, pose.capsules}, head);
///   simulation.restart(simulation.body());                              // settle on the body
///   simulation.step({pose.worldFromHead, pose.capsules}, 1.0f / 60);    // a frame
///   draw(simulation.strands(), simulation.hair().colours);
///
/// A call that throws Error because of its arguments changes nothing. Calls are not thread-safe; a
/// call uses all threads itself (ThreadLimit).
class Simulation {
 public:
  /// At rest on `body`, with transmittance and colours made. `head`: collider in head space, null
  /// for none. Distance fields of `body`'s meshes are not owned: they must live until a call names
  /// other meshes. Throws Error for a groom, settings or a body that is not valid.
  explicit Simulation(std::shared_ptr<const Groom> groom, const FrameSettings& settings = {},
                      const BodyState& body = {}, std::shared_ptr<const MeshSdf> head = nullptr,
                      const WispSettings& wisps = {});
  /// The same with a groom of its own.
  explicit Simulation(Groom groom, const FrameSettings& settings = {}, const BodyState& body = {},
                      std::shared_ptr<const MeshSdf> head = nullptr, const WispSettings& wisps = {})
      : Simulation(std::make_shared<const Groom>(std::move(groom)), settings, body, std::move(head),
                   wisps) {}
  Simulation(const Simulation&) = delete;  // its hair refers to what it owns
  Simulation& operator=(const Simulation&) = delete;

  /// One frame: moves the hair by `seconds`, [1e-6, 1], to where the body is then, shadows and
  /// shades it. Returns what it cost, by stage.
  const FrameProfile& step(const BodyState& body, float seconds);
  /// Shadows and shades the hair as it stands, at its level: after a change of settings, light or
  /// camera while the hair is paused.
  const FrameProfile& relight();
  /// Back to rest on the body, then `settle` seconds, [0, 3600], without motion, in which colliders
  /// grow to their size; lit again.
  void restart(const BodyState& body, float settle = 1);
  /// To another place with its head (hair::teleport); lit again.
  void teleport(const RigidTransform& worldFromHead);
  /// The world's origin moves there (hair::moveOrigin).
  void moveOrigin(glm::vec3 origin);
  /// Other colliders take the place of those there were (hair::changeColliders).
  void changeColliders(const BodyState& body);

  /// Of the frames to come. What shapes the rest state (GuideSettings' stiffness, mass, gravity and
  /// skin) is what it was at the start. Throws Error, and keeps the old ones, where one is out of
  /// range.
  void setSettings(const FrameSettings& settings);
  /// Another hairstyle (hair::changeGroom), all of which is drawn until setLevel; true where the
  /// motion goes on in it. Lit again.
  bool setGroom(std::shared_ptr<const Groom> groom);
  /// How much of the groom the next frame, restart or relight() draws (levelFor).
  void setLevel(const LevelOfDetail& level);
  /// Measured by somebody else, of this groom; null: measured when a level first needs it.
  void setDetail(std::shared_ptr<const GroomDetail> detail);
  /// The detail, measured now where nobody has.
  const std::shared_ptr<const GroomDetail>& detail();
  /// The same where somebody has, else null.
  const std::shared_ptr<const GroomDetail>& knownDetail() const { return detail_; }

  /// stateHash(const Hair&).
  std::uint64_t stateHash() const { return hair::stateHash(hair_); }
  /// All that the next frame starts from (saveState).
  void save(std::ostream& out) const;
  /// Goes on from a saved state (restoreState); lit again.
  void restore(std::istream& in);

  StrandView strands() const { return hair_.strands(); }  ///< drawn last, world space, metres
  /// [lights · pointCount], [0, 1]: what of each light arrives; empty while shadows are off.
  std::span<const float> transmittance() const { return hair_.transmittance; }
  /// [pointCount] linear RGB; empty unless FrameSettings::radiance keeps it.
  std::span<const glm::vec3> radiance() const { return hair_.radiance; }
  /// [pointCount] sRGB bytes R, G, B, A in memory; empty while shading or its encoding is off.
  std::span<const std::uint32_t> colours() const { return hair_.colours; }
  double time() const { return hair_.time; }  ///< simulated seconds
  /// The body as it was last given. Valid until the next call.
  BodyState body() const { return body_.state(); }
  /// How the guides keep lengths and distances.
  GuideStats stats() const;

  const FrameSettings& settings() const { return settings_; }  ///< of the next frame
  /// Of the last frame, or of the last light on hair that stood still.
  const FrameProfile& profile() const { return profile_; }
  const std::shared_ptr<const Groom>& groom() const { return groom_; }  ///< never null
  const std::shared_ptr<const MeshSdf>& head() const { return head_; }  ///< or null
  /// The hair itself: what the stages hand to each other.
  const Hair& hair() const { return hair_; }
  /// The same, for who fills Hair::visibility or looks into a stage. Its groom, head and detail
  /// stay what they are.
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
  void requireFrame(const BodyState& body) const;

  std::shared_ptr<const Groom> groom_;
  std::shared_ptr<const MeshSdf> head_;
  std::shared_ptr<const GroomDetail> detail_;
  FrameSettings settings_;
  Hair hair_;
  OwnedBody body_;  // as the last call gave it
  FrameProfile profile_{};
};

}  // namespace hair
