#pragma once

#include <array>
#include <optional>
#include <vector>

#include <apps/common/mesh_overlay.h>
#include <apps/common/player.h>
#include <apps/draw/renderer.h>
#include <apps/draw/scene.h>

namespace hair {

/// What of the simulation's inside is drawn over the picture.
struct InternalsShown {
  std::array<bool, kInsideCount> insides{};  ///< by Inside
  bool cells = false;        ///< occupied cells of the first light's map, coloured by transmittance
  bool mesh = false;         ///< lines and vertices of the hair mesh that the hair was grown in
  bool meshInside = false;   ///< those of its interior too
  bool meshSurface = false;  ///< its surface, in place of the hair
};

glm::mat4 matrixOf(const RigidTransform& transform);

/// What is seen of a player: head, body and hair as layers of a scene, the hair shaded for the
/// scene's camera and lights, with the meshes' shadow on it. The player's own frames are no
/// longer shaded then: nobody would see it.
class SceneView {
 public:
  explicit SceneView(Player& player);
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Sees the head from `yaw`, `pitch` (radians, 0: from in front of the first pose) at `distance`
  /// metres; the camera then goes with the head (`follow`), but does not turn with it.
  void frameHead(float yaw, float pitch, float distance);

  /// Brings the scene up to date with the player and shades it; the frame's profile says what
  /// the shading took. `renderer` makes the shadow of head and body on the hair; where its pictures
  /// are linear, the hair's radiance is made too.
  const draw::Scene& update(draw::Renderer& renderer);

  /// Updates, draws, and waits for the picture of so many pixels. What that took beside the shading
  /// is Stage::Draw of the frame's profile: the head's shadow on the hair, sorting, sending,
  /// rasterising.
  void drawTimed(draw::Renderer& renderer, int width, int height);

  draw::Scene scene;  ///< camera, lights and ground may be changed between updates
  InternalsShown shown;
  /// The hair mesh as it was edited, head space; null: as it was grown. While `editing` it is shown
  /// where it stands, else where its chains are.
  const HairMesh* edited = nullptr;
  bool editing = false;
  bool follow = true;
  bool headShadowsHair = true;

 private:
  void dyeScalp();
  void updateMeshes();
  void updateHair(draw::Renderer& renderer);
  void updateInternals();
  void updateHairMesh();
  StageTime& stageTime(Stage stage) { return player_.profile[static_cast<std::size_t>(stage)]; }

  Player& player_;
  TriangleMesh body_;
  std::optional<MeshOverlay> hairMesh_;
  TriangleMesh hairSurface_;
  std::vector<float> bare_;                ///< [head vertexCount], 0 under the hair
  std::vector<glm::vec3> scalp_;           ///< [head vertexCount], of the hair's colour there
  glm::vec3 dye_{0};                       ///< that colour
  std::vector<std::uint32_t> unshadowed_;  ///< colours of the left half, side by side
  std::vector<glm::vec3> unshadowedRadiance_;
  glm::vec3 headBefore_;
};

}  // namespace hair
