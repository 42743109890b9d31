#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace HAIR_API hair {

/// Reads a hair mesh from an OBJ file that polygon modellers can open and save: one object per
/// layer, `o layer_0` the scalp, metres, +Y up. Such programs preserve the order of objects' faces
/// and corners and little else, so bundles are encoded by order alone: they are sorted by
/// descending n_j, the m_k faces of layer k belong to the first m_k bundles, and corner i of a face
/// continues as corner i of the face of the same number in the next layer. (docs/formats.md)
///
/// Objects whose names all begin with `layer_` and a number are layers in the order of these
/// numbers, whatever follows (`layer_2.001`); others in the order of the file. Groups (`g`) are the
/// objects of a file without `o`. Objects without faces, vertices without faces, normals, texture
/// coordinates, materials and unknown lines are ignored. Pins are not in the file.
///
/// Throws Error (file, line or layer, cause) if the file is not a hair mesh.
HairMesh readHairMesh(const std::filesystem::path& file);

/// The same from bytes in memory; `name` names the file in messages.
HairMesh parseHairMesh(std::string_view bytes, std::string_view name);

/// Bundles in the order of the file: by descending n_j, otherwise as they are. [bundleCount]
std::vector<std::uint32_t> fileOrder(const HairMesh& mesh);

/// Writes the whole file or nothing: reading it gives the same mesh, its bundles in `fileOrder`,
/// coordinates bit for bit. Returns that order. Throws Error.
std::vector<std::uint32_t> writeHairMesh(const std::filesystem::path& file, const HairMesh& mesh);

/// The bytes that writeHairMesh writes.
std::string hairMeshBytes(const HairMesh& mesh);

/// Reads all faces of an OBJ file as one polygon mesh, such as a scalp. Keeps vertices that no face
/// uses. Throws Error (file, line, cause).
PolygonMesh parsePolygons(std::string_view bytes, std::string_view name);

}  // namespace hair
