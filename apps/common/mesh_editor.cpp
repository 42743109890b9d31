#include <apps/common/mesh_editor.h>

#include <utility>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/edit_history.h>
#include <libhair/hair_mesh/exterior.h>
#include <libhair/hair_mesh/surface.h>

namespace hair {

struct MeshEditor::State {
  MeshHair hair;
  HairMeshHistory history;
  InteriorPlacement interior;
  PlacementResult placement;
  std::vector<std::vector<std::uint8_t>> exterior;  // [layer][vertex]
  bool moved = false;                               // since the last step of the history

  explicit State(MeshHair edited)
      : hair(std::move(edited)),
        history(hair.mesh),
        interior(hair.mesh),
        exterior(exteriorVertices(hair.mesh)) {}

  // To a step of the history: vertices inside stand where they stood.
  void restore() {
    hair.mesh = history.current();
    moved = false;
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
      const float depth = (clipFromHead * glm::vec4(mesh.layers[k].positions[v], 1)).w;
      if (depth <= 0 || glm::distance(pixelOf({k, v}, clipFromHead, size), cursor) > reach)
        continue;
      if (picked && depth >= nearest) continue;
      picked = {k, v};
      nearest = depth;
    }
  return picked;
}

glm::vec2 MeshEditor::pixelOf(HairMeshVertex vertex, const glm::mat4& clipFromHead,
                              glm::vec2 size) const {
  const glm::vec3 p = state_->hair.mesh.layers[vertex.layer].positions[vertex.vertex];
  const glm::vec4 clip = clipFromHead * glm::vec4(p, 1);
  return size * (0.5f + 0.5f * glm::vec2(clip.x, -clip.y) / clip.w);
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
  State& s = *state_;
  require(vertex.layer < s.hair.mesh.layerCount() &&
              vertex.vertex < s.hair.mesh.layers[vertex.layer].vertexCount(),
          "hair mesh: there is no vertex ", vertex.vertex, " in layer ", vertex.layer);
  glm::vec3& position = s.hair.mesh.layers[vertex.layer].positions[vertex.vertex];
  const glm::vec3 before = std::exchange(position, place);
  try {
    s.placement = s.interior.place(s.hair.mesh);  // moves nothing if it throws
  } catch (const Error&) {
    position = before;
    throw;
  }
  s.moved = true;
  regrow(s.hair.mesh, s.hair.groups, s.hair.grown);
}

void MeshEditor::drop() {
  if (!state_->moved) return;
  state_->history.apply([&](HairMesh& mesh) { mesh = state_->hair.mesh; });
  state_->moved = false;
}

void MeshEditor::cancel() {
  if (state_->moved) state_->restore();
}

bool MeshEditor::canUndo() const {
  return state_->history.canUndo();
}

bool MeshEditor::canRedo() const {
  return state_->history.canRedo();
}

void MeshEditor::undo() {
  state_->history.undo();
  state_->restore();
}

void MeshEditor::redo() {
  state_->history.redo();
  state_->restore();
}

PlacementResult MeshEditor::placement() const {
  return state_->placement;
}

}  // namespace hair
