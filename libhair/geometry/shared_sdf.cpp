#include <libhair/geometry/mesh_sdf.h>

#include <compare>
#include <cstdint>
#include <map>
#include <mutex>

#include <libhair/core/state_hash.h>

namespace hair {

namespace {

// The key of a field: a hash of its inputs, with counts to make collisions even less likely.
struct Key {
  std::uint64_t hash;
  std::size_t positions, triangles;
  float cell, margin;
  auto operator<=>(const Key&) const = default;
};

Key keyOf(const TriangleMesh& mesh, float cell, float margin) {
  StateHash hash;
  hash.add(std::span<const glm::vec3>(mesh.positions));
  hash.add(std::span<const glm::uvec3>(mesh.triangles));
  return {hash.value(), mesh.positions.size(), mesh.triangles.size(), cell, margin};
}

std::mutex mutex;
std::map<Key, std::weak_ptr<const MeshSdf>> known;

}  // namespace

std::shared_ptr<const MeshSdf> sharedSdf(const TriangleMesh& mesh, float cell, float margin) {
  const Key key = keyOf(mesh, cell, margin);
  const auto find = [&]() -> std::shared_ptr<const MeshSdf> {
    const auto at = known.find(key);
    return at == known.end() ? nullptr : at->second.lock();
  };
  {
    const std::scoped_lock lock(mutex);
    if (auto sdf = find()) return sdf;
  }
  // Build without the lock: a thread that helps to build one field may be asked for another.
  auto built = std::make_shared<const MeshSdf>(mesh, cell, margin);
  const std::scoped_lock lock(mutex);
  if (auto sdf = find()) return sdf;
  std::erase_if(known, [](const auto& entry) { return entry.second.expired(); });
  known[key] = built;
  return built;
}

}  // namespace hair
