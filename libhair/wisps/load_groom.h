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
  Groom groom;
  LoadedHead head;                 ///< the given one, or the built-in one scaled under the roots
  std::vector<std::string> notes;  ///< what was assumed, dropped or repaired; head.notes too
};

/// From a file of strands to what a simulation takes: loadStrands, the head under the roots
/// (loadedHead, or fitHeadToRoots where `heads` is empty), bindGroom. `heads` are in the hair's
/// space: metres, +Y up, +Z face. Throws Error (file, place, cause).
LoadedGroom loadGroom(const std::filesystem::path& file, const LoadOptions& options = {},
                      std::vector<TriangleMesh> heads = {}, const BindSettings& bind = {});

/// First points of strands that have at least one.
std::vector<glm::vec3> rootsOf(StrandView strands);

}  // namespace hair
