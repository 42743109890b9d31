#include <apps/draw/mesh_store.h>

#include <cstring>

#include <glm/gtc/type_ptr.hpp>

#include <apps/draw/shaders.h>
#include <libhair/core/error.h>

namespace hair::draw {
namespace {

/// Multiply and rotate, eight bytes at a time: only tells apart contents of one program's meshes.
std::uint64_t hashBytes(std::uint64_t hash, const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  for (std::size_t i = 0; i < size; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, std::min<std::size_t>(8, size - i));
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return hash;
}

std::uint64_t contentHash(const TriangleMesh& mesh) {
  std::uint64_t h = mesh.positions.size() * 31 + mesh.triangles.size();
  h = hashBytes(h, mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
  h = hashBytes(h, mesh.normals.data(), mesh.normals.size() * sizeof(glm::vec3));
  return hashBytes(h, mesh.triangles.data(), mesh.triangles.size() * sizeof(glm::uvec3));
}

}  // namespace

gl::Program MeshStore::makeLit() {
  const auto s = shaders::mesh();
  return gl::link("mesh", s.vertex, s.geometry, s.fragment);
}

gl::Program MeshStore::makeDepth() {
  const auto s = shaders::depthOnly();
  return gl::link("mesh depth", s.vertex, s.geometry, s.fragment);
}

void MeshStore::update(const Scene& scene) {
  for (auto& [mesh, entry] : entries) entry.used = false;
  for (const MeshLayer& layer : scene.meshes) {
    require(layer.mesh != nullptr, "a mesh of the scene is null");
    const TriangleMesh& mesh = *layer.mesh;
    require(mesh.normals.size() == mesh.positions.size(), "a mesh of the scene has ",
            mesh.positions.size(), " vertices but ", mesh.normals.size(),
            " normals: call computeNormals");
    Entry& entry = entries[layer.mesh];
    entry.used = true;
    const std::uint64_t hash = contentHash(mesh);
    if (entry.hash == hash && entry.indexCount > 0) continue;
    entry.hash = hash;
    entry.indexCount = GLsizei(3 * mesh.triangles.size());
    entry.bounds = bounds(mesh.positions);
    std::vector<glm::vec3> both;
    both.reserve(2 * mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      both.push_back(mesh.positions[i]);
      both.push_back(mesh.normals[i]);
    }
    glBindVertexArray(entry.array);
    gl::upload<glm::vec3>(GL_ARRAY_BUFFER, entry.vertices, both, GL_STATIC_DRAW);
    gl::upload<glm::uvec3>(GL_ELEMENT_ARRAY_BUFFER, entry.triangles, mesh.triangles,
                           GL_STATIC_DRAW);
    for (GLuint i : {0u, 1u}) {
      glEnableVertexAttribArray(i);
      glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3),
                            reinterpret_cast<const void*>(i * sizeof(glm::vec3)));
    }
  }
  std::erase_if(entries, [](const auto& item) { return !item.second.used; });
}

Bounds MeshStore::worldBounds(const Scene& scene) const {
  Bounds all;
  for (const MeshLayer& layer : scene.meshes) {
    const Bounds& b = entries.at(layer.mesh).bounds;
    if (b.lower.x > b.upper.x) continue;
    for (int i = 0; i < 8; ++i) {
      const glm::vec3 corner(i & 1 ? b.upper.x : b.lower.x, i & 2 ? b.upper.y : b.lower.y,
                             i & 4 ? b.upper.z : b.lower.z);
      all.extend(glm::vec3(layer.worldFromMesh * glm::vec4(corner, 1)));
    }
  }
  return all;
}

void MeshStore::draw(const Scene& scene) const {
  glUseProgram(lit);
  for (const MeshLayer& layer : scene.meshes) {
    const Entry& entry = entries.at(layer.mesh);
    const glm::mat3 worldFromNormal = glm::transpose(glm::inverse(glm::mat3(layer.worldFromMesh)));
    glUniformMatrix4fv(gl::uniform(lit, "worldFromMesh"), 1, GL_FALSE,
                       glm::value_ptr(layer.worldFromMesh));
    glUniformMatrix3fv(gl::uniform(lit, "worldFromNormal"), 1, GL_FALSE,
                       glm::value_ptr(worldFromNormal));
    glUniform3fv(gl::uniform(lit, "albedo"), 1, glm::value_ptr(layer.colour));
    glUniform1f(gl::uniform(lit, "roughness"), glm::clamp(layer.roughness, 0.05f, 1.0f));
    glBindVertexArray(entry.array);
    glDrawElements(GL_TRIANGLES, entry.indexCount, GL_UNSIGNED_INT, nullptr);
  }
}

void MeshStore::drawDepth(const Scene& scene, const glm::mat4& clipFromWorld) const {
  glUseProgram(depth);
  for (const MeshLayer& layer : scene.meshes) {
    const Entry& entry = entries.at(layer.mesh);
    const glm::mat4 clipFromMesh = clipFromWorld * layer.worldFromMesh;
    glUniformMatrix4fv(gl::uniform(depth, "clipFromMesh"), 1, GL_FALSE,
                       glm::value_ptr(clipFromMesh));
    glBindVertexArray(entry.array);
    glDrawElements(GL_TRIANGLES, entry.indexCount, GL_UNSIGNED_INT, nullptr);
  }
}

}  // namespace hair::draw
