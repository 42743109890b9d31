#pragma once

#include <memory>
#include <optional>

#include <apps/common/mesh_hair.h>
#include <libhair/hair_mesh/interior_placement.h>

namespace hair {

/// A hair mesh in the user's hands: an exterior vertex is picked and dragged, interior ones are
/// placed anew and strands follow at once, as all that depends on topology is kept.
class MeshEditor {
 public:
  explicit MeshEditor(MeshHair hair);
  ~MeshEditor();

  const MeshHair& hair() const;

  /// The exterior vertex nearest to `cursor` in a picture, of those within `reach` pixels, the
  /// scalp's left out; of several the one in front. `clipFromHead`: OpenGL's clip space; `size` and
  /// `cursor` in pixels, from the upper left corner.
  std::optional<HairMeshVertex> pick(const glm::mat4& clipFromHead, glm::vec2 size,
                                     glm::vec2 cursor, float reach = 12) const;

  /// Where the vertex is in a picture, pixels.
  glm::vec2 pixelOf(HairMeshVertex vertex, const glm::mat4& clipFromHead, glm::vec2 size) const;

  /// Moves the vertex to where the cursor is, as far from the eye as it was.
  void drag(HairMeshVertex vertex, const glm::mat4& clipFromHead, glm::vec2 size, glm::vec2 cursor);
  /// Moves the vertex, head space, metres. Throws Error, and leaves all as it was, for a vertex
  /// that there is not and a place that is not finite.
  void moveTo(HairMeshVertex vertex, glm::vec3 place);
  /// Ends a drag: a step of the history, if anything has moved.
  void drop();

  /// Takes back what has moved since the last step of the history.
  void cancel();

  bool canUndo() const;
  bool canRedo() const;
  void undo();
  void redo();

  /// What the last edit's placement took.
  PlacementResult placement() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hair
