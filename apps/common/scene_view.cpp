#include <apps/common/scene_view.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <libhair/core/parallel.h>
#include <libhair/shade/appearance.h>
#include <libhair/shadow/density_map.h>

namespace hair {

namespace {

constexpr glm::vec3 kDress(0.16f, 0.18f, 0.22f);  // albedo, linear

// Drawn wider than a hair, as each strand stands for many; but never so wide that it looks it.
float drawnWidth(const Groom& groom) {
  return std::clamp(1.25f * groom.fibre.width * std::sqrt(groom.fibre.hairsPerStrand), 1e-4f,
                    6e-4f);
}

// The middle of the head's upper part, head space.
glm::vec3 skull(const Character& character) {
  const Bounds box = bounds(character.head.mesh.positions);
  return {0, box.upper.y - 0.11f, 0};
}

// How bare the head is of hair: 0 where roots are close, 1 away from them.
std::vector<float> bareness(const Player& player) {
  const TriangleMesh& mesh = player.character.head.mesh;
  const StrandView strands = player.hair.strands();
  const RigidTransform headFromWorld = inverse(player.pose.worldFromHead);
  std::vector<glm::vec3> roots;
  const std::size_t stride = std::max<std::size_t>(1, strands.strandCount() / 4000);
  for (std::size_t s = 0; s < strands.strandCount(); s += stride)
    if (!strands.strand(s).empty()) roots.push_back(headFromWorld.point(strands.strand(s).front()));
  std::vector<float> bare(mesh.positions.size());
  parallelFor(bare.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      float nearest2 = 1;
      for (glm::vec3 root : roots) {
        const glm::vec3 d = mesh.positions[v] - root;
        nearest2 = std::min(nearest2, glm::dot(d, d));
      }
      bare[v] = glm::smoothstep(0.004f, 0.010f, std::sqrt(nearest2));
    }
  });
  return bare;
}

}  // namespace

glm::mat4 matrixOf(const RigidTransform& t) {
  glm::mat4 m = glm::mat4_cast(t.rotation);
  m[3] = glm::vec4(t.translation, 1);
  return m;
}

SceneView::SceneView(Player& player) : player_(player), bare_(bareness(player)) {
  const Character& character = player.character;
  player.settings.shade = false;
  scene.lights = player.settings.lights;
  headBefore_ = player.pose.worldFromHead.point(skull(character));
  scene.ground.height = character.motion.floorHeight();
  scene.meshes.resize(2);
  scene.meshes[0].mesh = &character.head.mesh;
  scene.meshes[1].mesh = &body_;
  scene.meshes[1].colour = kDress;
  scene.meshes[1].roughness = 0.8f;
  for (const TriangleMesh& eye : character.eyes)
    scene.meshes.push_back({&eye, glm::mat4(1), glm::vec3(0.75f), {}, 0.2f});
  scene.hair.resize(1);
  frameHead(0.5f, 0.05f, 0.95f);
}

void SceneView::frameHead(float yaw, float pitch, float distance) {
  const glm::vec3 facing = player_.pose.worldFromHead.vector({0, 0, 1});
  scene.camera.target = headBefore_ = player_.pose.worldFromHead.point(skull(player_.character));
  scene.camera.target.y -= 0.08f;  // the hair hangs below the skull
  scene.camera.distance = distance;
  scene.camera.yaw = std::atan2(facing.x, facing.z) + yaw;
  scene.camera.pitch = pitch;
}

// The scalp has the hair's own colour, so that no skin shows between the few strands that are
// drawn, and the neck that of the body, which it sinks into.
void SceneView::dyeScalp() {
  const glm::vec3 dye =
      std::visit([](const auto& look) { return look.rootColour; }, player_.settings.appearance);
  if (dye == dye_ && !scalp_.empty()) return;
  dye_ = dye;
  scalp_.resize(bare_.size());
  // Factors of the skin's colour (MeshLayer).
  const glm::vec3 dyed = 0.8f * dye / draw::MeshLayer{}.colour;
  const glm::vec3 collar = kDress / draw::MeshLayer{}.colour;
  const auto& positions = player_.character.head.mesh.positions;
  for (std::size_t v = 0; v < bare_.size(); ++v) {
    const glm::vec3 skin =
        glm::mix(collar, glm::vec3(1), glm::smoothstep(-0.03f, -0.02f, positions[v].y));
    scalp_[v] = glm::mix(dyed, skin, bare_[v]);
  }
  scene.meshes[0].vertexColours = scalp_;
}

void SceneView::updateMeshes() {
  dyeScalp();
  const Character& character = player_.character;
  for (draw::MeshLayer& layer : scene.meshes)
    if (layer.mesh != &body_ && layer.mesh != &hairSurface_)
      layer.worldFromMesh = matrixOf(player_.pose.worldFromHead);
  character.body.skin(player_.pose.worldFromJoint, body_);
}

void SceneView::updateHair(draw::Renderer& renderer) {
  Hair& hair = player_.hair;
  const Groom& groom = *hair.groom;
  FrameSettings& settings = player_.settings;
  const std::size_t points = hair.wisps.points.size();
  settings.eye = scene.camera.eye();
  scene.pivot = hair.pivot();
  hair.visibility.resize(headShadowsHair ? scene.lights.size() * points : 0);
  draw::HairLayer& layer = scene.hair[0];
  layer.strands = hair.strands();
  layer.width = drawnWidth(groom) * hair.wisps.drawn.wider;
  layer.opacity = 0.9f;
  // What casts shadows on meshes is as wide whether it is on its way out or not.
  layer.shadowWidth = groom.fibre.width * groom.fibre.opacity * hair.wisps.fibre().hairsPerStrand *
                      hair.wisps.drawn.solid;
  if (headShadowsHair) renderer.meshVisibility(scene, hair.wisps.points, hair.visibility);
  if (scene.lights != settings.lights) {
    settings.lights = scene.lights;
    player_.relight();
  }
  const StageTimer timer(player_.profile, Stage::Shade, static_cast<std::int64_t>(points));
  const auto shadeBy = [&](const Illumination& illumination, std::vector<glm::vec3>& radiance,
                           std::vector<std::uint32_t>& colours) {
    const DrawnHair drawn = hair.wisps.drawnHair();
    radiance.resize(renderer.linear() ? points : 0);
    colours.resize(points);
    shade(drawn.strands, illumination, settings.appearance, radiance, colours);
    fadeColours(drawn.strands.first, drawn.weights, colours);
  };
  Illumination illumination = hair.illumination(settings);
  shadeBy(illumination, hair.radiance, hair.colours);
  if (scene.sideBySide) {
    illumination.transmittance = {};
    shadeBy(illumination, unshadowedRadiance_, unshadowed_);
  }
  layer.colours = hair.colours, layer.leftColours = unshadowed_;
  layer.radiance = hair.radiance, layer.leftRadiance = unshadowedRadiance_;
}

void SceneView::updateInternals() {
  scene.debug.clear();
  const Hair& hair = player_.hair;
  for (std::size_t i = 0; i < kInsideCount; ++i)
    if (shown.insides[i])
      addLines(static_cast<Inside>(i), hair, player_.settings.guides, scene.debug.lines);
  if (shown.cells && !hair.maps.empty() && !hair.maps.front().empty()) {
    const DensityMap& map = hair.maps.front();
    const DensityGrid& grid = map.grid;
    for (int i = grid.lower.x; i <= grid.upper.x; ++i)
      for (int k = grid.lower.z; k <= grid.upper.z; ++k)
        for (int j = grid.lower.y; j <= grid.upper.y; ++j) {
          const glm::ivec3 cell(i, j, k);
          if (grid.density(cell) <= 0) continue;
          const glm::vec3 centre = grid.cellCentre(cell);
          float t = 0;
          sampleTransmittance(map, {&centre, 1}, {&t, 1});
          scene.debug.points.push_back(
              {centre, draw::packColour({t, 0.25f + 0.5f * t, 1 - t, 0.8f})});
        }
  }
}

// Made when it is asked for: a topology is shown for long.
void SceneView::updateHairMesh() {
  const bool asked = shown.mesh || shown.meshInside || shown.meshSurface;
  const bool surface = shown.meshSurface && player_.character.mesh;
  scene.meshes.resize(2 + player_.character.eyes.size());
  if (!asked || !player_.character.mesh) return;
  if (!hairMesh_) hairMesh_.emplace(player_.character.mesh->mesh);
  if (edited) hairMesh_->place(*edited, player_.pose.worldFromHead);
  if (!editing) hairMesh_->follow(player_.hair);
  if (shown.mesh || shown.meshInside) hairMesh_->drawLines(shown.meshInside, scene.debug);
  if (!surface) return;
  hairSurface_ = hairMesh_->surface();
  scene.meshes.push_back({&hairSurface_, glm::mat4(1), glm::vec3(0.35f, 0.42f, 0.5f), {}, 0.7f});
  draw::HairLayer& layer = scene.hair[0];
  layer.strands = {};
  layer.colours = layer.leftColours = {};
  layer.radiance = layer.leftRadiance = {};
}

const draw::Scene& SceneView::update(draw::Renderer& renderer) {
  // A frame that stands still is drawn more than once.
  stageTime(Stage::Shade) = stageTime(Stage::Draw) = {};
  const glm::vec3 head = player_.pose.worldFromHead.point(skull(player_.character));
  if (follow) scene.camera.target += head - headBefore_;
  headBefore_ = head;
  updateMeshes();
  updateHair(renderer);
  updateInternals();
  updateHairMesh();
  return scene;
}

void SceneView::drawTimed(draw::Renderer& renderer, int width, int height) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  renderer.draw(update(renderer), width, height);
  renderer.finish();
  const std::chrono::nanoseconds whole = Clock::now() - start;
  stageTime(Stage::Draw) = {whole.count() - stageTime(Stage::Shade).nanoseconds,
                            static_cast<std::int64_t>(scene.hair[0].strands.pointCount())};
}

}  // namespace hair
