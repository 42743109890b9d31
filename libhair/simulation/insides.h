#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

/// Debug views of a hair's internal state, as lines.
enum class Inside {
  Guides,       ///< the links of all guides
  Tension,      ///< the same links: blue in compression, grey at rest, red in tension
  GuideFrames,  ///< normal (red), binormal (green) and tangent (blue) at guide points, 5 mm
  Contacts,     ///< collider normal at guide points in contact, 1 cm
  Push,         ///< acceleration from self-collision at guide points, 1 mm for 1 m/s²
  Colliders,    ///< capsules, planes, and contour lines of head and meshes
  Bricks,       ///< occupied bricks of the first light's map, as of the last frame
};
/// Number of enumerators of Inside.
inline constexpr std::size_t kInsideCount = 7;

/// Display name: "guides", "tension", ...
std::string_view insideName(Inside inside);
/// One-line description of its lines.
std::string insideMeaning(Inside inside);

/// One end of a line.
struct LineVertex {
  glm::vec3 position;    ///< metres, world space
  std::uint32_t colour;  ///< sRGB, bytes in memory R, G, B, A
};

/// Appends the lines of `what`, two vertices each, for the current state of hair and colliders.
/// Frames do no work for it. `settings`: those of the last frame; contacts depend on their skin.
void addLines(Inside what, const Hair& hair, const GuideSettings& settings,
              std::vector<LineVertex>& lines);

}  // namespace hair
