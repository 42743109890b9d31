#pragma once

#include <span>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/model/head.h>

namespace HAIR_API hair {

/// A head of somebody's own, in head space.
struct LoadedHead {
  Head head;                         ///< what hair collides with
  std::vector<TriangleMesh> others;  ///< what is drawn with it, such as eyes
  RigidTransform headFromFile;       ///< where hair of the same coordinates comes to lie
  std::vector<std::string> notes;    ///< what was left out, a sentence each
};

/// Puts a head under its hair. `meshes`: first the head or bust, then what moves with it; metres,
/// +Y up, +Z face, in one space with `hairRoots`. It is moved by placeHead, and shoulders are left
/// out, which do not move with a head. Throws Error for no mesh.
LoadedHead loadedHead(std::vector<TriangleMesh> meshes, std::span<const glm::vec3> hairRoots);

}  // namespace hair
