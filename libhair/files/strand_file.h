#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>

namespace HAIR_API hair {

/// Which axis of a file points up; the face looks along the axis named second. Each is a rotation
/// (no mirroring) into the library's +Y up, +Z face.
enum class UpAxis : std::uint8_t {
  AsFile,  ///< what the file states, or else the format's default: .hair Z, all others Y
  Y,       ///< +Y up, +Z face: nothing to do
  Z,       ///< +Z up, +Y face (Yuksel's hair models): (x, y, z) -> (-x, z, y)
  ZBack,   ///< +Z up, -Y face (Blender, 3ds Max):     (x, y, z) -> (x, z, -y)
  X,       ///< +X up, +Z face:                        (x, y, z) -> (-y, x, z)
  YDown,   ///< -Y up, +Z face (turned over):          (x, y, z) -> (-x, -y, z)
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(UpAxis) {
  return std::array{Word("file", UpAxis::AsFile), Word("y", UpAxis::Y),
                    Word("z", UpAxis::Z),         Word("z-back", UpAxis::ZBack),
                    Word("x", UpAxis::X),         Word("y-down", UpAxis::YDown)};
}

/// `file`, `y`, `z`, `z-back`, `x`, `y-down`, as `--up` takes them. Throws Error with the choices.
UpAxis upAxisFromText(std::string_view text);
/// For people: "+Z up, +Y face".
std::string_view upAxisMeaning(UpAxis up);

/// Into metres and +Y up, +Z face: rotates, then scales, in place. `scale`: metres per unit.
void convertUnits(std::span<glm::vec3> points, float scale, UpAxis up);
/// The inverse: into units of `scale` metres and axes `up`.
void convertUnitsBack(std::span<glm::vec3> points, float scale, UpAxis up);

/// How to read a file of strands.
struct ReadOptions {
  float scale = 0;             ///< metres per unit of the file; 0: the format's default
  UpAxis up = UpAxis::AsFile;  ///< the file's axes
  /// Of a file of several curves (.usda): a path or a name, of curves or of what they are in;
  /// empty: all, joined.
  std::string prim{};
  /// Of a cloud of points without edges (.ply, .npy): so many make a strand; 0: as their spacing
  /// shows.
  std::uint32_t pointsPerStrand = 0;
};

/// Strands of any format after conversion, with the units and axes of the file.
struct StrandFile {
  StrandSet strands;                 ///< metres, +Y up, +Z face; short strands are kept
  std::string format = "hair";       ///< the extension: "hair", "tfx", "usda" ...
  std::string arrays = "points";     ///< what the file holds: "points, colours"
  float scale = 1;                   ///< metres per unit that was applied
  UpAxis up = UpAxis::Y;             ///< axes that were assumed; never AsFile
  std::vector<float> thickness;      ///< [pointCount] or empty; diameters, metres
  std::vector<float> transparency;   ///< [pointCount] or empty; 0 opaque, 1 invisible
  std::vector<glm::vec3> colours;    ///< [pointCount] or empty; linear RGB
  float defaultThickness = 0;        ///< where there is no array, metres; 0: not stated
  float defaultTransparency = 0;     ///< where there is no array
  glm::vec3 defaultColour{0};        ///< where there is no array; black: not stated
  std::vector<std::string> notes{};  ///< what the reader chose or assumed, a sentence each
};

/// Units and axes of a file to be written.
struct WriteOptions {
  float scale = 1;             ///< metres per unit of the file
  UpAxis up = UpAxis::AsFile;  ///< the file's axes; AsFile: +Y up, +Z face
};

/// Picks the format by the extension (strandFormats; any case), reads, converts into metres and +Y
/// up. Units and axes are those that the file states: .usda always does, .hair, .ply and .obj where
/// writeStrands wrote them. Else .hair has 0.00465 m a unit and Z up (Yuksel's models state no
/// unit; this one gives their head a radius of 9.5 cm), all others metres and Y up. Of an animated
/// .usda the first frame (strand_sequence.h reads all). Throws Error (file, place, cause).
StrandFile readStrands(const std::filesystem::path& file, const ReadOptions& options = {});

/// Picks the format by the extension and writes a whole file or nothing, in metres, +Y up, or as
/// `options` say; .hair, .ply, .obj and .usda state it, and readStrands understands. In metres, +Y
/// up, the points read back are the same bits.
/// Throws Error, with a remedy, for strands that a format cannot hold: unequal numbers of points in
/// .tfx, fewer than two in .usda, none in all but .data; other axes than +Y up and +Z up, -Y face
/// in .usda. Omits arrays that it cannot hold (lossOf).
void writeStrands(const std::filesystem::path& file, StrandView strands,
                  const WriteOptions& options = {});
/// The same with all optional arrays and defaults.
void writeStrands(const std::filesystem::path& file, const StrandFile& strands,
                  const WriteOptions& options = {});

/// ".hair, .tfx, .data, .ply, .obj, .usda, .npy, .npz and .pbrt"
std::string strandFormats();
/// By the extension.
bool isStrandFile(const std::filesystem::path& file);
/// Whether it holds strands: by the extension, and an .obj, which may hold a mesh, if it has lines.
bool holdsStrands(const std::filesystem::path& file);
/// Whether it is an .obj with faces.
bool holdsMesh(const std::filesystem::path& file);
/// By the extension, whether writeStrands writes it too.
bool isWrittenStrandFile(const std::filesystem::path& file);

/// Arrays of these strands that a file of that name omits: "thickness, colours"; empty: none.
std::string lossOf(const std::filesystem::path& file, const StrandFile& strands);

/// Which strands have at least `minPoints` points and `minLength` metres.
std::vector<std::uint32_t> soundStrands(StrandView strands, float minLength = 1e-3f,
                                        std::size_t minPoints = 2);

/// Removes all but the sound strands; returns the number removed. Loaders keep all strands of a
/// file; simulation and drawing need strands with a direction.
std::size_t dropDegenerate(StrandSet& strands, float minLength = 1e-3f, std::size_t minPoints = 2);
/// The same for a file's strands and all of its arrays.
std::size_t dropDegenerate(StrandFile& file, float minLength = 1e-3f, std::size_t minPoints = 2);

}  // namespace hair
