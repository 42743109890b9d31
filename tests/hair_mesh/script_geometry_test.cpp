#include <cmath>

#include <gtest/gtest.h>

#include <libhair/hair_mesh/script/script.h>

namespace hair {
namespace {

const std::string kStart = "scalp sphere 0.1 2 6\nextrude all 0.02 times 4\nauto-place off\n";

HairMesh meshOf(const std::string& line) {
  return applyScript(parseHairMeshScript(kStart + line, "a.hairmesh")).mesh;
}

// wanted(before, layer) of each vertex above the scalp, to float precision.
template <class Wanted>
void expectMoved(const std::string& line, const Wanted& wanted) {
  const HairMesh before = meshOf(""), after = meshOf(line);
  for (std::uint32_t k = 1; k < before.layerCount(); ++k)
    for (std::size_t v = 0; v < before.layers[k].vertexCount(); ++v)
      EXPECT_LT(
          glm::distance(after.layers[k].positions[v], wanted(before.layers[k].positions[v], k)),
          1e-6f)
          << line << ", layer " << k << ", vertex " << v;
}

TEST(ScriptGeometry, LinesMoveVerticesAsTheySay) {
  using glm::vec3;
  expectMoved("move all 0.1 0 -0.1",
              [](vec3 p, std::uint32_t) { return p + vec3(0.1f, 0, -0.1f); });
  expectMoved("move all at tip 0 1 0",
              [](vec3 p, std::uint32_t k) { return k == 4 ? p + vec3(0, 1, 0) : p; });
  expectMoved("move all at 2..3 ramp 0 1 0", [](vec3 p, std::uint32_t k) {
    return p + vec3(0, k == 2 ? 0.5f : k == 3 ? 1.0f : 0.0f, 0);
  });
  expectMoved("move all ramp 0 1 0", [](vec3 p, std::uint32_t k) {
    return p + vec3(0, 0.25f * static_cast<float>(k), 0);
  });
  expectMoved("scale all about 0 0.1 0 by 2 1 3",
              [](vec3 p, std::uint32_t) { return vec3(2 * p.x, p.y, 3 * p.z); });
  expectMoved("scale all at 4 ramp about 0 0.1 0 by 1 2 1",
              [](vec3 p, std::uint32_t k) { return k == 4 ? vec3(p.x, 2 * p.y - 0.1f, p.z) : p; });
  expectMoved("rotate all 90 about 1 0 0 axis 0 2 0",
              [](vec3 p, std::uint32_t) { return vec3(1 + p.z, p.y, 1 - p.x); });
  expectMoved("gather all at tip 1 2 3 1",
              [](vec3 p, std::uint32_t k) { return k == 4 ? vec3(1, 2, 3) : p; });
  expectMoved("gather all 0 0 0 -0.5", [](vec3 p, std::uint32_t) { return 1.5f * p; });
  expectMoved("keep-out all 0.05", [](vec3 p, std::uint32_t) {
    return p * (std::max(glm::length(p), 0.15f) / glm::length(p));
  });
}

TEST(ScriptGeometry, FallenHairHangsDownAsLongAsBefore) {
  const HairMesh before = meshOf(""), after = meshOf("fall all 1");
  for (std::uint32_t k = 1; k < before.layerCount(); ++k)
    for (std::uint32_t v = 0; v < before.layers[k].vertexCount(); ++v) {
      const std::uint32_t on = before.layers[k].below[v];
      const float length =
          glm::distance(before.layers[k].positions[v], before.layers[k - 1].positions[on]);
      EXPECT_LT(glm::distance(after.layers[k].positions[v],
                              after.layers[k - 1].positions[on] - glm::vec3(0, length, 0)),
                1e-6f);
    }
}

TEST(ScriptGeometry, SmoothingDrawsAVertexToItsNeighbours) {
  const std::string spike = "select a bundles 6\nmove a at 2 0 0.1 0\n";
  const HairMesh before = meshOf(spike), after = meshOf(spike + "smooth a at 2 0.5\n");
  for (const std::uint32_t v : before.face(2, 6)) {
    glm::vec3 sum(0);
    float count = 0;
    const auto add = [&](glm::vec3 p) { sum += p, ++count; };
    add(before.layers[1].positions[before.layers[2].below[v]]);
    for (std::uint32_t u = 0; u < before.layers[3].vertexCount(); ++u)
      if (before.layers[3].below[u] == v) add(before.layers[3].positions[u]);
    for (std::uint32_t j = 0; j < before.bundleCount(); ++j)
      for (std::uint32_t c = before.firstCorner[j]; c < before.firstCorner[j + 1]; ++c) {
        const std::uint32_t a = before.layers[2].corners[c];
        const std::uint32_t b = before.layers[2].corners[before.nextCorner(j, c)];
        if (a == v) add(before.layers[2].positions[b]);
        if (b == v) add(before.layers[2].positions[a]);
      }
    const glm::vec3 wanted = 0.5f * (before.layers[2].positions[v] + sum / count);
    EXPECT_LT(glm::distance(after.layers[2].positions[v], wanted), 1e-6f);
  }
}

}  // namespace
}  // namespace hair
