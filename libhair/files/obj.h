#pragma once

#include <filesystem>

#include <libhair/core/triangle_mesh.h>

namespace hair {

/// Reads the faces of an OBJ file, triangulated, with smooth normals (target hair::model).
/// Units and axes are taken as they stand: metres, +Y up; pass others through `convertUnits`.
/// Throws Error (file, cause).
TriangleMesh readObj(const std::filesystem::path& file);

}  // namespace hair
