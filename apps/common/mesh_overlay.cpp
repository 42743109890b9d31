#include <apps/common/mesh_overlay.h>

#include <libhair/hair_mesh/exterior.h>
#include <libhair/hair_mesh/mesh_groom.h>
#include <libhair/hair_mesh/surface.h>

namespace hair {

namespace {

using draw::packColour;

std::vector<std::vector<std::uint8_t>> tipVertices(const HairMesh& mesh) {
  std::vector<std::vector<std::uint8_t>> tips;
  for (const HairMesh::Layer& layer : mesh.layers) tips.emplace_back(layer.vertexCount(), 0);
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    for (const std::uint32_t v : mesh.face(mesh.lastLayer[j], j)) tips[mesh.lastLayer[j]][v] = 1;
  return tips;
}

}  // namespace

struct MeshOverlay::State {
  struct Line {
    HairMeshVertex a, b;
    std::uint32_t colour;
    bool inside;
  };

  HairMesh rest, now;  // now: world space
  HairMeshChains chains;
  std::vector<std::vector<std::uint8_t>> exterior;  // [layer][vertex]
  std::vector<Line> lines;
  std::vector<glm::vec3> guides;

  explicit State(const HairMesh& mesh)
      : rest(mesh), now(mesh), chains(chainsOf(mesh)), exterior(exteriorVertices(mesh)) {
    const auto tips = tipVertices(mesh);
    for (const auto& [a, b] : linesOf(mesh)) {
      const bool inside = !isExterior(a) || !isExterior(b);
      const bool tip = a.layer == b.layer && tips[a.layer][a.vertex] && tips[b.layer][b.vertex];
      std::uint32_t colour = packColour({0.75f, 0.78f, 0.85f, 0.8f});
      if (tip) colour = packColour({0.75f, 0.35f, 0.9f, 0.9f});
      if (b.layer == 0) colour = packColour({0.25f, 0.8f, 0.3f, 0.9f});
      if (inside) colour = packColour({0.85f, 0.35f, 0.25f, 0.35f});
      lines.push_back({a, b, colour, inside});
    }
  }
  bool isExterior(HairMeshVertex v) const { return exterior[v.layer][v.vertex] != 0; }
};

MeshOverlay::MeshOverlay(const HairMesh& mesh) : state_(std::make_unique<State>(mesh)) {}
MeshOverlay::~MeshOverlay() = default;

void MeshOverlay::follow(const Hair& hair) {
  State& s = *state_;
  s.guides.resize(hair.guides.guideCount() * hair.guides.pointsPerGuide());
  hair.guides.copyPoints(s.guides);
  followGuides(s.rest, s.chains, s.guides, hair.guides.pointsPerGuide(), s.now);
  // The scalp stays with the head, where no hair grows too.
  HairMesh::Layer& scalp = s.now.layers.front();
  for (std::size_t v = 0; v < scalp.vertexCount(); ++v)
    scalp.positions[v] = hair.worldFromHead.point(s.rest.layers.front().positions[v]);
}

void MeshOverlay::place(const HairMesh& mesh, const RigidTransform& worldFromHead) {
  state_->rest = mesh;
  for (std::size_t k = 0; k < mesh.layerCount(); ++k)
    for (std::size_t v = 0; v < mesh.layers[k].vertexCount(); ++v)
      state_->now.layers[k].positions[v] = worldFromHead.point(mesh.layers[k].positions[v]);
}

void MeshOverlay::drawLines(bool inside, draw::DebugLayer& layer) const {
  const HairMesh& mesh = state_->now;
  const auto at = [&](HairMeshVertex v) { return mesh.layers[v.layer].positions[v.vertex]; };
  for (const State::Line& line : state_->lines)
    if (inside || !line.inside) layer.line(at(line.a), at(line.b), line.colour);
  for (std::uint32_t k = 1; k < mesh.layerCount(); ++k)
    for (std::uint32_t v = 0; v < mesh.layers[k].vertexCount(); ++v) {
      const bool outside = state_->isExterior({k, v});
      if (outside || inside)
        layer.points.push_back({at({k, v}), outside ? packColour({0.25f, 0.5f, 1.0f, 1.0f})
                                                    : packColour({1.0f, 0.25f, 0.15f, 1.0f})});
    }
}

TriangleMesh MeshOverlay::surface() const {
  return outerSurface(state_->now);
}

}  // namespace hair
