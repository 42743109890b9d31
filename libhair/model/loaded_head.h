#pragma once

#include <span>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/transform.h>
#include <libhair/files/strand_file.h>
#include <libhair/model/head.h>

namespace HAIR_API hair {

/// A head of somebody's own, in head space.
struct LoadedHead {
  Head head;                         ///< what hair collides with
  std::vector<TriangleMesh> others;  ///< what is drawn with it, such as eyes
  RigidTransform headFromHair;       ///< where the hair comes to lie; translation only
  ReadOptions read{1, UpAxis::Y};    ///< units and axes that the meshes were found to have
  std::vector<std::string> notes;    ///< what was assumed and left out, a sentence each
};

/// The hair that a head is to be put under.
struct HairOnHead {
  std::span<const glm::vec3> roots;     ///< metres, +Y up, +Z face
  ReadOptions read{1, UpAxis::AsFile};  ///< units and axes its file was read with
};

/// Puts a head under its hair. `meshes`, in units of their files: first the head or bust, then what
/// moves with it.
///
/// - Units and axes are those of `read`; what it leaves open are the hair's, or metres and +Y up
///   where these fit and the hair's do not. A head fits whose surface is within 2 cm of the roots
///   (their median); where another unit or axis would fit, that is the error.
/// - Of a mesh of many parts the one that hair grows on is the head, and what lies around it: a
///   floor, a room or a vertex far away is left out.
/// - The head is moved by placeHead, and shoulders are left out, which do not move with it.
///
/// Throws Error for no mesh, and for one that cannot be the head of this hair.
LoadedHead loadedHead(std::vector<TriangleMesh> meshes, const HairOnHead& hair,
                      const ReadOptions& read = {});

}  // namespace hair
