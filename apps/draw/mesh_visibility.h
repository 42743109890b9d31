#pragma once

// Inside hair_draw only: the shadow of meshes on points, read on the CPU.

#include <span>
#include <vector>

#include <apps/draw/gl_objects.h>
#include <apps/draw/mesh_store.h>

namespace hair::draw {

/// The meshes' depth as a light sees it, fitted around the points, fetched, and looked up once
/// for every point. (In a vertex shader the same look-ups are done again for both segments that
/// share a point, for both halves of the picture, and on one thread where Mesa's software renderer
/// draws: they took 240 of 380 ms for 150,000 segments; here they take a few.)
class MeshVisibility {
 public:
  MeshVisibility();

  /// `meshes` must be up to date with the scene. Leaves its own framebuffer and viewport bound.
  void compute(const Scene& scene, const Light& light, const MeshStore& meshes,
               std::span<const glm::vec3> points, std::span<float> visibility);

 private:
  gl::Texture depth;
  gl::Framebuffer target;
  std::vector<float> fetched;  // [kSize²]
};

}  // namespace hair::draw
