#pragma once

#include <functional>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/hair_mesh/hair_mesh.h>

namespace HAIR_API hair {

/// Undo history of a hair mesh. A step is a full copy of the mesh, so memory is bounded by
/// maxSteps + 1 meshes; beyond that the oldest step is dropped.
class HairMeshHistory {
 public:
  /// Throws Error if `mesh` is not valid.
  explicit HairMeshHistory(HairMesh mesh, std::size_t maxSteps = 100);

  /// The current mesh.
  const HairMesh& current() const { return steps_[at_]; }

  /// Applies one step of any number of edits, and discards undone steps. If `edit` throws, or
  /// leaves an invalid mesh (Error), nothing changes.
  void apply(const std::function<void(HairMesh&)>& edit);

  /// Whether undo() has a step to go to.
  bool canUndo() const { return at_ > 0; }
  /// Whether redo() has a step to go to.
  bool canRedo() const { return at_ + 1 < steps_.size(); }
  /// Back by one step. Throws Error if there is none.
  void undo();
  /// Forward by one step. Throws Error if there is none.
  void redo();

 private:
  std::vector<HairMesh> steps_;
  std::size_t at_ = 0, maxSteps_;
};

}  // namespace hair
