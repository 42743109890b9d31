#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <apps/common/player.h>
#include <benchmarks/floor.h>

namespace hair::bench {

/// Hair of the smooth style that dances with head and body; zero: as the style has it.
struct SceneOptions {
  std::string name;
  std::uint32_t strands = 0;  ///< drawn
  std::uint32_t points = 0;   ///< a drawn strand
  std::uint32_t wisps = 0;    ///< of three guides each
  int cells = 128;            ///< of the light's map, along each axis
  float settle = 1;           ///< seconds in the first pose
  int frames = 30;            ///< danced before anything is measured

  bool operator==(const SceneOptions&) const = default;
};

SceneOptions smoothScene();   ///< 3,350 strands, 100 K segments
SceneOptions millionScene();  ///< the same, 1 M segments
SceneOptions manyScene();     ///< 100 K strands of 16 segments on 10 K guides

/// A player under way.
struct Scene {
  explicit Scene(const SceneOptions& options);

  /// Drawn segments.
  std::size_t segmentCount() const;
  Counts counts() const;

  SceneOptions options;
  std::unique_ptr<Character> character;
  Player player;
  /// The hair after options.frames frames: guides, drawn points, transmittance, colours. Equal on
  /// every machine, for any number of threads and every instruction set.
  std::string hash;
  StrandSet strands;  ///< the drawn strands then
};

/// Makes scenes and keeps the last one: benchmarks of one scene follow each other.
class Scenes {
 public:
  Scene& of(const SceneOptions& options);

 private:
  std::unique_ptr<Scene> last_;
};

}  // namespace hair::bench
