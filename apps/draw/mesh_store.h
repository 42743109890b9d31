#pragma once

// Inside hair_draw only: triangle meshes on the graphics card.

#include <map>

#include <apps/draw/frame_block.h>
#include <apps/draw/gl_objects.h>
#include <apps/draw/scene.h>

namespace hair::draw {

/// Keeps the meshes that the scene shows on the card; forgets those it no longer shows.
class MeshStore {
 public:
  /// Sends what is new or has changed (by a hash of its content, so that a mesh may be edited,
  /// moved or freed between pictures without telling).
  void update(const Scene& scene);

  /// Box around all meshes of the scene, world space; empty when there is none.
  Bounds worldBounds(const Scene& scene) const;

  /// Draws every mesh with the "mesh" program, lit.
  void draw(const Scene& scene) const;

  /// Draws every mesh's depth through `clipFromWorld`.
  void drawDepth(const Scene& scene, const glm::mat4& clipFromWorld) const;

 private:
  struct Entry {
    gl::VertexArray array;
    gl::Buffer vertices, triangles;
    std::uint64_t hash = 0;
    GLsizei indexCount = 0;
    Bounds bounds;
    bool used = true;
  };
  std::map<const TriangleMesh*, Entry> entries;
  gl::Program lit = makeLit(), depth = makeDepth();

  static gl::Program makeLit();
  static gl::Program makeDepth();
};

}  // namespace hair::draw
