#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

/// What can be drawn of the inside of a hair, to see what a stage does.
enum class Inside {
  Guides,       ///< the links of all guides
  Tension,      ///< the same, blue where a link is pushed, grey at rest, red where it is pulled
  GuideFrames,  ///< at every guide point normal (red), binormal (green) and tangent (blue), 5 mm
  Contacts,     ///< where a guide point touches a collider: the collider's normal there, 1 cm
  Push,         ///< what self-collision pushes guide points with: 1 mm for 1 m/s²
  Colliders,    ///< capsules, planes, and contour lines of head and meshes
  Bricks,       ///< occupied bricks of the first light's map, as of the last frame
};
/// How many there are.
inline constexpr std::size_t kInsideCount = 7;

/// Its name, as programs show it: "guides", "tension", ...
std::string_view insideName(Inside inside);
/// What its lines mean, in a few words.
std::string insideMeaning(Inside inside);

/// One end of a line.
struct LineVertex {
  glm::vec3 position;    ///< metres, world space
  std::uint32_t colour;  ///< sRGB, bytes in memory R, G, B, A
};

/// Adds the lines of `what`, two vertices each, as the hair and its colliders stand now. Nothing is
/// computed for it in a frame. `settings`: those of the last frame; their skin tells contacts.
void addLines(Inside what, const Hair& hair, const GuideSettings& settings,
              std::vector<LineVertex>& lines);

}  // namespace hair
