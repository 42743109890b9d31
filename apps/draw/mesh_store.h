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
  /// Sends what is new or has changed (by hashes of its content, so that a mesh may be edited,
  /// moved or freed between pictures without telling): of a body that bends, its vertices alone.
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
    gl::Buffer vertices, colours, triangles;
    std::uint64_t positions = 0, normals = 0, topology = 0, tints = 0;  // hashes of what was sent
    std::size_t tinted = 0;                                             // vertices with a colour
    GLsizei indexCount = 0;
    Bounds bounds;
    bool used = true;
  };
  std::map<const TriangleMesh*, Entry> entries;
  std::vector<glm::vec3> scratch;
  gl::Program lit = makeLit(), depth = makeDepth();

  void updateVertices(Entry& entry, const TriangleMesh& mesh);
  void updateColours(Entry& entry, const MeshLayer& layer);
  static gl::Program makeLit();
  static gl::Program makeDepth();
};

}  // namespace hair::draw
