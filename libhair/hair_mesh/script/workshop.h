#pragma once

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <libhair/hair_mesh/script/script.h>
#include <libhair/hair_mesh/script/words.h>
#include <libhair/model/scalp_roots.h>

// Internal state and helpers of script operations, which are implemented in selection.cpp,
// topology.cpp, geometry.cpp, growth.cpp and sweep.cpp.
namespace hair {

/// A set of bundles: [bundleCount], 1 for those in it.
using BundleSet = std::vector<std::uint8_t>;

struct Workshop {
  ScriptFiles files;
  ScriptLimits limits;

  Hairstyle style;
  std::map<std::string, BundleSet, std::less<>> selections;
  std::vector<std::uint32_t> ring, sector;   ///< [bundleCount] or empty: a scalp from a file
  std::uint32_t sectors = 0;                 ///< of that scalp
  std::function<float(glm::vec3)> obstacle;  ///< distance to the head, metres
  bool onHead = false;                       ///< the built-in one
  Parting parting;
  glm::vec3 whorl{NAN};  ///< where it ends on the scalp; NaN for scalps without one
  bool autoPlace = true;
  std::uint32_t included = 0;  ///< scripts inside of which the line stands
  std::size_t lines = 0;       ///< that were applied
  std::size_t work = 0;        ///< corners that passes over the mesh have seen

  HairMesh& mesh() { return style.mesh; }
  const HairMesh& mesh() const { return style.mesh; }

  /// "all" or a name; throws Error for an unknown name.
  BundleSet selected(std::string_view name) const;
  /// The same as numbers, ascending; Error for none.
  std::vector<std::uint32_t> bundles(std::string_view name) const;

  /// Throws Error if the mesh had more corners than allowed after `corners` more in use and
  /// `layers` more layers.
  void requireRoom(std::size_t corners, std::size_t layers) const;

  /// Call before each pass over the mesh; throws Error when the work limit is exceeded.
  void spend();

  /// Remaps all per-bundle data: the new bundle b was, or is part of, from[b].
  void renumber(std::span<const std::uint32_t> from);

  /// Interior vertices, with no more iterations than the script has work left for.
  void place();
  /// The same, unless the script places them itself.
  void afterGeometry();
};

/// Corners of faces in all layers.
std::size_t usedCorners(const HairMesh& mesh);

/// Outward direction of a distance field.
glm::vec3 outwards(const std::function<float(glm::vec3)>& distance, glm::vec3 p);

/// The vertices that a geometric operation moves, never the scalp's: `SEL [at tip | K | A..B]
/// [ramp]`.
struct Target {
  std::string selection;
  std::uint32_t lowest = 1, highest = 0xfffffffe;  ///< layers
  bool tip = false;
  bool ramp = false;
};

Target readTarget(ScriptWords& words);

struct TargetVertex {
  std::uint32_t layer, vertex;
  float weight;  ///< 1, or with `ramp` what grows from layer to layer up to 1
};

/// By layer, then vertex. Throws Error for none.
std::vector<TargetVertex> verticesOf(const Workshop& workshop, const Target& target);

using ScriptStep = std::function<void(Workshop&)>;

/// An operation: the first word of its lines, and the function that reads the rest of one.
struct ScriptCommand {
  std::string_view name;
  ScriptStep (*read)(ScriptWords& words);
};

std::span<const ScriptCommand> selectionCommands();
std::span<const ScriptCommand> topologyCommands();
std::span<const ScriptCommand> geometryCommands();
std::span<const ScriptCommand> growthCommands();
std::span<const ScriptCommand> sweepCommands();

}  // namespace hair
