#include <libhair/hair_mesh/mesh_groom.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <libhair/core/error.h>
#include <libhair/guides/rest_shape.h>
#include <libhair/hair_mesh/grow.h>
#include <libhair/model/comb.h>
#include <libhair/wisps/bind.h>

namespace hair {

namespace {

constexpr float kShortestChain = 1e-3f;  // metres

// The chain at a corner of a face is the strand that has all of its weight there.
HairMeshRoots rootsOf(const HairMesh& mesh, const HairMeshChains& chains) {
  HairMeshRoots roots;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    for (std::uint32_t i = 0; i < mesh.sides(j); ++i) {
      const std::uint32_t corner = mesh.firstCorner[j] + i;
      if (chains.chainOfCorner[corner] != roots.rootCount()) continue;  // none, or not the first
      roots.bundle.push_back(static_cast<std::uint32_t>(j));
      roots.number.push_back(i);
      roots.weights.resize(roots.weights.size() + mesh.sides(j), 0.0f);
      roots.weights[roots.firstWeight.back() + i] = 1;
      roots.firstWeight.push_back(static_cast<std::uint32_t>(roots.weights.size()));
      roots.positions.push_back(mesh.layers[0].positions[mesh.layers[0].corners[corner]]);
    }
    roots.firstRoot.push_back(static_cast<std::uint32_t>(roots.rootCount()));
  }
  return roots;
}

std::vector<glm::vec3> guidesAlong(const HairMesh& mesh, const HairMeshChains& chains,
                                   std::uint32_t pointsPerGuide) {
  StrandSet curves;
  traceStrands(mesh, rootsOf(mesh, chains), 8 * pointsPerGuide, curves);
  std::vector<glm::vec3> points(chains.chainCount() * pointsPerGuide);
  for (std::size_t c = 0; c < chains.chainCount(); ++c) {
    const auto curve = curves.strand(c);
    const float length = arcLength(curve);
    require(length >= kShortestChain, "hair mesh: the chain on vertex ", chains.chain(c)[0],
            " of the scalp is ", length, " m long; at least ", kShortestChain,
            " m can be simulated: move its layers apart");
    equalLinks(curve, std::span(points).subspan(c * pointsPerGuide, pointsPerGuide));
  }
  return points;
}

// [chainCount]: number of tied points, those no farther along the chain than its tied layer.
std::vector<std::uint32_t> tiedPoints(const HairMesh& mesh, const HairMeshChains& chains,
                                      std::span<const std::uint32_t> tied,
                                      std::uint32_t pointsPerGuide) {
  std::vector<std::uint32_t> layer(chains.chainCount(), 0), points(chains.chainCount(), 1);
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c)
      if (const std::uint32_t chain = chains.chainOfCorner[c]; chain != kNoVertex)
        layer[chain] = std::max(layer[chain], std::min(tied[j], mesh.lastLayer[j]));
  for (std::size_t c = 0; c < chains.chainCount(); ++c) {
    const auto vertices = chains.chain(c);
    float length = 0, upToTie = 0;
    for (std::size_t k = 1; k < vertices.size(); ++k) {
      length += glm::distance(mesh.layers[k - 1].positions[vertices[k - 1]],
                              mesh.layers[k].positions[vertices[k]]);
      if (k <= layer[c]) upToTie = length;
    }
    const auto last = static_cast<float>(pointsPerGuide - 1);
    points[c] += static_cast<std::uint32_t>(last * upToTie / length + 0.01f);
  }
  return points;
}

// Sets the parents to the three corners of most weight, the greatest first. (A face has at least
// three.)
void hang(const HairMesh& mesh, const HairMeshChains& chains, const HairMeshRoots& roots,
          std::size_t root, glm::uvec3& parents, glm::vec3& weights) {
  const auto w = roots.weightsOf(root);
  const std::uint32_t corner = mesh.firstCorner[roots.bundle[root]];
  std::vector<std::uint32_t> order(w.size());
  std::iota(order.begin(), order.end(), 0u);
  std::partial_sort(order.begin(), order.begin() + 3, order.end(),
                    [&](auto a, auto b) { return w[a] != w[b] ? w[a] > w[b] : a < b; });
  for (int j = 0; j < 3; ++j) {
    const std::uint32_t i = order[static_cast<std::size_t>(j)];
    parents[j] = chains.chainOfCorner[corner + i];
    weights[j] = w[i];
  }
  weights /= weights.x + weights.y + weights.z;
}

}  // namespace

Groom makeGroom(const HairMesh& mesh, std::span<const HairMeshRoots> roots, StrandView strands,
                const MeshGroomSettings& settings) {
  validate(strands, "hair mesh: strands", 2);
  require(strands.strandCount() > 0, "hair mesh: no strands; extrude a face, or ask for more");
  const std::size_t byLayers = std::clamp<std::size_t>(mesh.layerCount(), 16, kMaxGuidePoints);
  const std::uint32_t pointsPerGuide =
      settings.pointsPerGuide > 0 ? settings.pointsPerGuide : static_cast<std::uint32_t>(byLayers);
  require(pointsPerGuide >= 3 && pointsPerGuide <= kMaxGuidePoints,
          "hair mesh: pointsPerGuide = ", pointsPerGuide, " is not in 3 to ", kMaxGuidePoints);
  const HairMeshChains chains = chainsOf(mesh);
  Groom groom;
  groom.pointsPerGuide = pointsPerGuide;
  groom.guidePoints = guidesAlong(mesh, chains, pointsPerGuide);
  if (!settings.tied.empty()) {
    require(settings.tied.size() == mesh.bundleCount(), "hair mesh: ties of ", settings.tied.size(),
            " bundles, but there are ", mesh.bundleCount());
    groom.tied = tiedPoints(mesh, chains, settings.tied, pointsPerGuide);
  }
  for (const HairMeshRoots& group : roots) {
    validate(group, mesh);
    for (std::size_t r = 0; r < group.rootCount(); ++r)
      hang(mesh, chains, group, r, groom.parents.emplace_back(), groom.weights.emplace_back());
  }
  require(groom.strandCount() == strands.strandCount(), "hair mesh: ", groom.strandCount(),
          " roots, but ", strands.strandCount(), " strands");
  groom.first.assign(strands.first.begin(), strands.first.end());
  groom.fibre.hairsPerStrand =
      std::max(1.0f, settings.hairs / static_cast<float>(strands.strandCount()));
  keepShape(strands, groom);
  return groom;
}

}  // namespace hair
