#include <libhair/hair_mesh/edit_history.h>

#include <utility>

#include <libhair/core/error.h>

namespace hair {

HairMeshHistory::HairMeshHistory(HairMesh mesh, std::size_t maxSteps) : maxSteps_(maxSteps) {
  validate(mesh);
  steps_.push_back(std::move(mesh));
}

void HairMeshHistory::apply(const std::function<void(HairMesh&)>& edit) {
  HairMesh next = current();
  edit(next);
  validate(next, "hair mesh after the edit");
  // Only the insertion can throw, and then it has no effect.
  const auto inserted =
      steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(at_ + 1), std::move(next));
  steps_.erase(inserted + 1, steps_.end());
  if (steps_.size() > maxSteps_ + 1) steps_.erase(steps_.begin());
  at_ = steps_.size() - 1;
}

void HairMeshHistory::undo() {
  require(canUndo(), "nothing to undo");
  --at_;
}

void HairMeshHistory::redo() {
  require(canRedo(), "nothing to redo");
  ++at_;
}

}  // namespace hair
