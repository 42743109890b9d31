#include <benchmarks/peers.h>

#include <cmath>
#include <memory>

#include <openvdb/openvdb.h>

#include <libhair/core/parallel.h>

namespace hair::bench {

ShadowPeer makeOpenVdbShadow(StrandView strands, const LightSpace& light, float cellSize,
                             float extinction) {
  openvdb::initialize();
  const glm::vec3 toLight = -light.direction();
  return [=](std::span<float> out) {
    const auto grid = openvdb::FloatGrid::create(0.0f);
    auto writer = grid->getAccessor();
    const float perMetre = 1 / cellSize;
    const auto cellOf = [](glm::vec3 u) {
      return openvdb::Coord(static_cast<int>(std::floor(u.x)), static_cast<int>(std::floor(u.y)),
                            static_cast<int>(std::floor(u.z)));
    };
    for (const glm::vec3 p : strands.points)
      writer.modifyValue(cellOf(p * perMetre), [](float& count) { count += 1; });
    const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
    const float depth = extinction * cellSize;  // of one point
    parallelFor(strands.pointCount(), 512, [&](std::size_t begin, std::size_t end) {
      const auto reader = grid->getConstAccessor();
      for (std::size_t i = begin; i < end; ++i) {
        glm::vec3 u = strands.points[i] * perMetre;
        float count = 0;
        for (openvdb::Coord cell = cellOf(u); box.isInside(cell); cell = cellOf(u)) {
          count += reader.getValue(cell);
          u += toLight;
        }
        out[i] = std::exp(-depth * count);
      }
    });
  };
}

}  // namespace hair::bench
