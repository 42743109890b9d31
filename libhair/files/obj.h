#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include <libhair/core/api.h>
#include <libhair/files/strand_file.h>
#include <libhair/geometry/triangle_mesh.h>

namespace HAIR_API hair {

/// Statistics of the faces of an OBJ file.
struct ObjReport {
  std::size_t faces = 0;    ///< in the file
  std::size_t split = 0;    ///< got vertices of their own: an edge of theirs has two faces already
  std::size_t dropped = 0;  ///< fewer than three different corners
  float scale = 0;          ///< metres per unit that a comment states; 0: none does
  UpAxis up = UpAxis::AsFile;  ///< and the axes
};

/// Reads the faces of an OBJ file, triangulated, with smooth normals (target hair::model).
/// Vertex v of the file is positions[v]; vertices of split faces follow after them. Groups,
/// materials, texture coordinates and the file's normals are left alone.
/// Coordinates stay the file's; convert them by `convertUnits`.
/// Throws Error (file, line, cause).
TriangleMesh readObj(const std::filesystem::path& file, ObjReport* report = nullptr);
/// The same in metres, +Y up, +Z face: as `options` say, else as the file states, else as it is.
TriangleMesh readObj(const std::filesystem::path& file, const ReadOptions& options,
                     ObjReport* report = nullptr);

/// The same from bytes in memory; `name` names the file in messages.
TriangleMesh parseObj(std::string_view bytes, std::string_view name, ObjReport* report = nullptr);

}  // namespace hair
