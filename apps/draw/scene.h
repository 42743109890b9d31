#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <apps/draw/camera.h>
#include <libhair/core/strands.h>
#include <libhair/geometry/colliders.h>
#include <libhair/geometry/triangle_mesh.h>
#include <libhair/light/light.h>
#include <libhair/simulation/insides.h>

namespace hair::draw {

/// How a strand is turned into pixels.
enum class HairPrimitive {
  Lines,   ///< one pixel wide; what is thinner than a pixel is drawn fainter
  Ribbons  ///< facing the camera, as wide as the strand and at least a pixel, with soft edges
};

/// Strands to draw. All spans are read during `Renderer::draw` only.
struct HairLayer {
  StrandView strands;

  /// [pointCount] shaded colour, all light and shadow already in it: bytes R, G, B, A from the
  /// lowest, sRGB; A / 255 multiplies the opacity.
  std::span<const std::uint32_t> colours;

  /// [pointCount] or empty: the colours of the left half when `Scene::sideBySide` is set (say,
  /// without self-shadow).
  std::span<const std::uint32_t> leftColours;

  /// [pointCount] linear radiance, of which `colours` are the bytes, and of the left half (or
  /// empty). Read, and needed, by a renderer of linear pictures alone, which takes the opacity from
  /// `colours`.
  std::span<const glm::vec3> radiance, leftRadiance;

  float width = 1.5e-4f;   ///< of a strand, metres
  float opacity = 0.8f;    ///< of a strand seen full on, (0, 1]
  float tipWidth = 0.25f;  ///< width at the tip as a share of `width`, [0, 1]
  /// Width that a strand takes out of the light on meshes, metres; 0: width times opacity. A drawn
  /// strand that stands for many hairs casts the shadow of all of them.
  float shadowWidth = 0;
  HairPrimitive primitive = HairPrimitive::Lines;
};

/// A surface to draw and to cast shadows with. The mesh is read during `Renderer::draw`, and sent
/// to the graphics card again only when its content has changed.
struct MeshLayer {
  const TriangleMesh* mesh = nullptr;
  glm::mat4 worldFromMesh{1};
  glm::vec3 colour{0.50f, 0.33f, 0.25f};  ///< albedo, linear, [0, 1]
  /// [vertexCount] factors of the colour, or empty: all ones. (A darker scalp, say.)
  std::span<const glm::vec3> vertexColours;
  float roughness = 0.55f;  ///< [0.05, 1]
};

/// Coloured lines and dots for what is usually hidden. Colours as in HairLayer, A = opacity.
struct DebugLayer {
  using Vertex = LineVertex;
  std::vector<Vertex> lines;   ///< [2·lineCount]
  std::vector<Vertex> points;  ///< [dotCount]
  float pointSize = 3;         ///< pixels
  bool onTop = true;           ///< through everything, or hidden by hair's and meshes' depth

  void clear() { lines.clear(), points.clear(); }
  void line(glm::vec3 a, glm::vec3 b, std::uint32_t colour);
};

/// Bytes of a colour from components in [0, 1], as HairLayer::colours wants them.
std::uint32_t packColour(glm::vec4 srgb);

/// So many lights shine on meshes and floor, and cast shadows there: the first of the scene.
/// Hair, whose colours come ready shaded, may be lit by more.
inline constexpr std::size_t kMeshLights = 4;

/// What lights that are made for hair are to meshes and floor, and the sky that fills shadows.
struct MeshLighting {
  glm::vec3 tint{1.0f, 0.96f, 0.90f};  ///< factor of every light's colour, linear
  float intensity = 2.2f;              ///< factor of every light, >= 0
  float ambient = 0.55f;               ///< of the sky, >= 0
};

/// A floor that fades into the background at some distance.
struct Ground {
  bool visible = true;
  float height = 0;                       ///< metres
  float radius = 6;                       ///< where it has faded, metres from below the target
  glm::vec3 colour{0.46f, 0.47f, 0.49f};  ///< albedo, linear
};

struct Background {
  glm::vec3 middle{0.70f, 0.72f, 0.75f};  ///< sRGB, behind the subject
  glm::vec3 edge{0.30f, 0.32f, 0.36f};    ///< sRGB, in the corners
};

/// Everything of one picture.
struct Scene {
  Camera camera;
  /// Lights at points shadow meshes and floor within 75 degrees of the way to the pivot, and hair
  /// within 75 degrees of the way to its middle; beyond, they shine and cast no shadow.
  std::vector<Light> lights{Light::parallel({-0.5f, -0.8f, -0.45f})};
  glm::vec3 pivot{0};  ///< where the colours of lights at points are given (lightSpaceOf), metres
  MeshLighting meshLighting;
  Ground ground;
  Background background;
  std::vector<HairLayer> hair;
  std::vector<MeshLayer> meshes;
  DebugLayer debug;
  /// The picture in two halves, the left one with `HairLayer::leftColours`.
  bool sideBySide = false;
};

}  // namespace hair::draw
