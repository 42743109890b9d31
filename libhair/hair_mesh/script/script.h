#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace hair {
// What a script is applied to: the hairstyle so far, its selections, the head. Not public.
struct Workshop;  // workshop.h
}  // namespace hair

namespace HAIR_API hair {

/// A hairstyle: the volume, and the sets of strands that are grown in it.
struct Hairstyle {
  HairMesh mesh;                    ///< the volume
  std::vector<StrandGroup> groups;  ///< in the order of the script
  /// [bundleCount], or empty: layers up to which the hair is tied to the head (MeshGroomSettings).
  std::vector<std::uint32_t> tied;
};

/// A hairstyle as text (.hairmesh): an operation a line, in order, from a scalp to groups of
/// strands;
/// `#` begins a comment. docs/formats.md lists the operations.
struct HairMeshScript {
  /// A line that holds an operation.
  struct Line {
    std::size_t number;                    ///< in the file, from 1
    std::function<void(Workshop&)> apply;  ///< the operation
  };
  std::string name;         ///< of the file, for messages
  std::vector<Line> lines;  ///< in the order of the file
};

/// The bytes of a file that a script names (`scalp file NAME`, `include NAME`); throws Error where
/// there is none.
using ScriptFiles = std::function<std::string(const std::string& name)>;

/// Files beside the script: names are relative to its folder.
ScriptFiles filesBeside(const std::filesystem::path& script);

/// Resource limits of a script; an error names the one exceeded.
struct ScriptLimits {
  std::size_t lines = 10'000;        ///< with an operation
  std::size_t corners = 1'000'000;   ///< of faces in all layers; as many vertices at the most
  std::size_t work = 1'000'000'000;  ///< corners of faces, summed over passes over the mesh
};

/// Throws Error (file, line, cause) for a line that is no operation.
HairMeshScript parseHairMeshScript(std::string_view text, std::string_view name);
/// The same from a file; throws Error where it cannot be read, too.
HairMeshScript readHairMeshScript(const std::filesystem::path& file);

/// A script that is applied line by line, as an editor does. The same lines give the same bits.
class ScriptRun {
 public:
  /// Without `files` a script that names one is refused.
  explicit ScriptRun(ScriptFiles files = {}, ScriptLimits limits = {});
  ~ScriptRun();

  /// Applies a line, or throws Error (file, line, cause) and changes nothing.
  void apply(const HairMeshScript& script, std::size_t line);

  /// The hairstyle after the lines so far.
  const Hairstyle& style() const;

 private:
  std::unique_ptr<Workshop> workshop_;
};

/// All lines. Throws Error as ScriptRun, and for a script without a scalp.
Hairstyle applyScript(const HairMeshScript& script, ScriptFiles files = {},
                      ScriptLimits limits = {});

}  // namespace hair
