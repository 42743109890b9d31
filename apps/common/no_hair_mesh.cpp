// What the programs are without hair meshes (HAIR_WITH_HAIR_MESH=OFF): a file that is one is
// refused, and so there is none to show or to edit.
#include <apps/common/character.h>
#include <apps/common/mesh_editor.h>
#include <libhair/core/error.h>

namespace hair {

MeshHair growMeshHair(const CharacterOptions& options, std::vector<std::string>&) {
  throw Error(text(options.hair.string(),
                   ": hair meshes were left out of this build; configure it with "
                   "HAIR_WITH_HAIR_MESH=ON"));
}

ReadOptions meshUnits(const CharacterOptions&) {
  return {1, UpAxis::Y};
}

Groom groomOf(const MeshHair&) {
  return {};
}

void moveBy(const RigidTransform&, MeshHair&) {}

struct MeshEditor::State {
  MeshHair hair;
};

MeshEditor::MeshEditor(MeshHair hair) : state_(std::make_unique<State>(std::move(hair))) {}
MeshEditor::~MeshEditor() = default;
const MeshHair& MeshEditor::hair() const {
  return state_->hair;
}
std::optional<HairMeshVertex> MeshEditor::pick(const glm::mat4&, glm::vec2, glm::vec2,
                                               float) const {
  return {};
}
glm::vec2 MeshEditor::pixelOf(HairMeshVertex, const glm::mat4&, glm::vec2) const {
  return {};
}
void MeshEditor::drag(HairMeshVertex, const glm::mat4&, glm::vec2, glm::vec2) {}
void MeshEditor::moveTo(HairMeshVertex, glm::vec3) {}
void MeshEditor::drop() {}
void MeshEditor::cancel() {}
bool MeshEditor::canUndo() const {
  return false;
}
bool MeshEditor::canRedo() const {
  return false;
}
void MeshEditor::undo() {}
void MeshEditor::redo() {}
PlacementResult MeshEditor::placement() const {
  return {};
}

}  // namespace hair
