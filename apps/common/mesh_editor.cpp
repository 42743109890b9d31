#include <apps/common/mesh_editor.h>

#include <libhair/hair_mesh/edit_history.h>
#include <libhair/hair_mesh/exterior.h>

namespace hair {

struct MeshEditor::State {
  MeshHair hair;
  HairMeshHistory history;
  InteriorPlacement interior;
  PlacementResult placement;
  std::vector<std::vector<std::uint8_t>> exterior;  // [layer][vertex]

  explicit State(MeshHair edited)
      : hair(std::move(edited)),
        history(hair.mesh),
        interior(hair.mesh),
        exterior(exteriorVertices(hair.mesh)) {}

  void follow() {
    placement = interior.place(hair.mesh);
    regrow(hair.mesh, hair.groups, hair.grown);
  }
};

MeshEditor::MeshEditor(MeshHair hair) : state_(std::make_unique<State>(std::move(hair))) {}
MeshEditor::~MeshEditor() = default;

const MeshHair& MeshEditor::hair() const {
  return state_->hair;
}

std::optional<HairMeshVertex> MeshEditor::pick(const glm::mat4& clipFromHead, glm::vec2 size,
                                               glm::vec2 cursor, float reach) const {
  const HairMesh& mesh = state_->hair.mesh;
  std::optional<HairMeshVertex> picked;
  float nearest = 0;
  for (std::uint32_t k = 1; k < mesh.layerCount(); ++k)
    for (std::uint32_t v = 0; v < mesh.layers[k].vertexCount(); ++v) {
      if (!state_->exterior[k][v]) continue;
      const glm::vec4 clip = clipFromHead * glm::vec4(mesh.layers[k].positions[v], 1);
      if (clip.w <= 0) continue;
      const glm::vec2 ndc = glm::vec2(clip) / clip.w;
      const glm::vec2 pixel = size * glm::vec2(0.5f + 0.5f * ndc.x, 0.5f - 0.5f * ndc.y);
      if (glm::distance(pixel, cursor) > reach) continue;
      if (picked && clip.w >= nearest) continue;
      picked = {k, v};
      nearest = clip.w;
    }
  return picked;
}

void MeshEditor::drag(HairMeshVertex vertex, const glm::mat4& clipFromHead, glm::vec2 size,
                      glm::vec2 cursor) {
  const glm::vec3 before = state_->hair.mesh.layers[vertex.layer].positions[vertex.vertex];
  glm::vec4 clip = clipFromHead * glm::vec4(before, 1);
  clip.x = clip.w * (2 * cursor.x / size.x - 1);
  clip.y = clip.w * (1 - 2 * cursor.y / size.y);
  const glm::vec4 place = glm::inverse(clipFromHead) * clip;
  moveTo(vertex, glm::vec3(place) / place.w);
}

void MeshEditor::moveTo(HairMeshVertex vertex, glm::vec3 place) {
  state_->hair.mesh.layers[vertex.layer].positions[vertex.vertex] = place;
  state_->follow();
}

void MeshEditor::drop() {
  state_->history.apply([&](HairMesh& mesh) { mesh = state_->hair.mesh; });
}

bool MeshEditor::canUndo() const {
  return state_->history.canUndo();
}

bool MeshEditor::canRedo() const {
  return state_->history.canRedo();
}

void MeshEditor::undo() {
  state_->history.undo();
  state_->hair.mesh = state_->history.current();
  state_->follow();
}

void MeshEditor::redo() {
  state_->history.redo();
  state_->hair.mesh = state_->history.current();
  state_->follow();
}

PlacementResult MeshEditor::placement() const {
  return state_->placement;
}

}  // namespace hair
