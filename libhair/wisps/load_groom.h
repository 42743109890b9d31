#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/geometry/triangle_mesh.h>
#include <libhair/model/load_strands.h>
#include <libhair/model/loaded_head.h>
#include <libhair/wisps/bind.h>

namespace HAIR_API hair {

/// Hair of a file, and the head under it.
struct LoadedGroom {
  Groom groom;                     ///< bound to guides
  LoadedHead head;                 ///< the given one, or the built-in one scaled under the roots
  std::vector<std::string> notes;  ///< what was assumed, dropped or repaired; head.notes too
};

/// A head, and what moves with it, as files hold them.
struct HeadFiles {
  std::vector<TriangleMesh> meshes;  ///< first the head; in units of the files; empty: built-in
  ReadOptions read{};                ///< their units and axes, as loadedHead takes them
};

/// From a file of strands to what a simulation takes: loadStrands, the head under the roots
/// (loadedHead, or fitHeadToRoots where there is none), bindGroom. Throws Error (file, place,
/// cause).
LoadedGroom loadGroom(const std::filesystem::path& file, const LoadOptions& options = {},
                      HeadFiles heads = {}, const BindSettings& bind = {},
                      float hairs = kHairsOnHead);

/// First points of strands that have at least one.
std::vector<glm::vec3> rootsOf(StrandView strands);

}  // namespace hair
