#include <apps/draw/mesh_store.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include <apps/draw/shaders.h>
#include <libhair/core/error.h>

namespace hair::draw {
namespace {

// Only tells apart contents of one program's meshes. Four chains, so that no product waits for the
// one before.
template <class T>
std::uint64_t contentHash(std::span<const T> values) {
  const char* const bytes = reinterpret_cast<const char*>(values.data());
  const std::size_t size = values.size_bytes();
  std::array<std::uint64_t, 4> hash{size, 1, 2, 3}, words{};
  const auto mix = [&] {
    for (std::size_t k = 0; k < hash.size(); ++k) {
      hash[k] = (hash[k] ^ words[k]) * 0x9E3779B97F4A7C15u;
      hash[k] ^= hash[k] >> 29;
    }
  };
  std::size_t i = 0;
  for (; i + sizeof words <= size; i += sizeof words) {
    std::memcpy(words.data(), bytes + i, sizeof words);
    mix();
  }
  words = {};
  if (i < size) std::memcpy(words.data(), bytes + i, size - i);
  mix();
  return hash[0] + 3 * hash[1] + 5 * hash[2] + 7 * hash[3];
}

// Whether `hash` was of something else; it is of the values then.
template <class T>
bool renew(std::uint64_t& hash, std::span<const T> values) {
  const std::uint64_t now = contentHash(values);
  return std::exchange(hash, now) != now;
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
    require(layer.vertexColours.empty() || layer.vertexColours.size() == mesh.positions.size(),
            "a mesh of the scene has ", mesh.positions.size(), " vertices but ",
            layer.vertexColours.size(), " colours");
    Entry& entry = entries[layer.mesh];
    entry.used = true;
    glBindVertexArray(entry.array);
    const bool bent = renew<glm::vec3>(entry.positions, mesh.positions);
    if (renew<glm::vec3>(entry.normals, mesh.normals) || bent) updateVertices(entry, mesh);
    if (renew<glm::uvec3>(entry.topology, mesh.triangles)) {
      gl::upload<glm::uvec3>(GL_ELEMENT_ARRAY_BUFFER, entry.triangles, mesh.triangles,
                             GL_STATIC_DRAW);
      entry.indexCount = GLsizei(3 * mesh.triangles.size());
    }
    if (renew(entry.tints, layer.vertexColours) || entry.tinted != mesh.positions.size())
      updateColours(entry, layer);
  }
  std::erase_if(entries, [](const auto& item) { return !item.second.used; });
}

void MeshStore::updateVertices(Entry& entry, const TriangleMesh& mesh) {
  scratch.clear();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    scratch.push_back(mesh.positions[i]);
    scratch.push_back(mesh.normals[i]);
  }
  gl::upload<glm::vec3>(GL_ARRAY_BUFFER, entry.vertices, scratch, GL_STREAM_DRAW);
  for (GLuint i : {0u, 1u}) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3),
                          reinterpret_cast<const void*>(i * sizeof(glm::vec3)));
  }
  entry.bounds = bounds(mesh.positions);
}

void MeshStore::updateColours(Entry& entry, const MeshLayer& layer) {
  entry.tinted = layer.mesh->positions.size();
  scratch.assign(entry.tinted, glm::vec3(1));
  std::ranges::copy(layer.vertexColours, scratch.begin());
  gl::upload<glm::vec3>(GL_ARRAY_BUFFER, entry.colours, scratch, GL_STATIC_DRAW);
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
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
