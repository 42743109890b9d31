#pragma once

#include <memory>
#include <optional>
#include <string>

#include <apps/common/mesh_editor.h>
#include <apps/dance/controls.h>
#include <apps/dance/dance.h>
#include <apps/draw/window.h>

namespace hair {

/// What the command line says, as the panel shows it.
Controls controlsOf(const DanceOptions& options);

/// A character that plays in a view, under the panel's controls, and whose hair mesh can be edited
/// there. The window has one; other hair makes another (takeOver).
class CharacterViewer {
 public:
  /// The hair of `growth`, everything else of the command line. Throws Error as Character does.
  CharacterViewer(const DanceOptions& options, const Controls::Growth& growth);
  CharacterViewer(const CharacterViewer&) = delete;
  CharacterViewer& operator=(const CharacterViewer&) = delete;

  /// Passes on what has changed since the last call; shadows again where that needs it, so that a
  /// paused picture changes too.
  void apply(const Controls& controls);
  /// Sees what `before` saw, in the same light.
  void takeOver(const draw::Scene& before);
  void report(Readout& readout) const;

  /// Puts the hair to rest, as its mesh is shown while it is edited.
  void rest();
  /// Lets the pointer pick and drag vertices of the hair mesh in a picture of so many pixels; the
  /// hair follows, at rest. Returns whether it holds one.
  bool edit(const draw::Pointer& pointer, glm::vec2 size);
  void undo();
  void redo();

  Character character;
  Player player;
  SceneView view;
  ProfileLog drawn;  ///< of the frames whose drawing was timed

 private:
  void follow();

  std::unique_ptr<MeshEditor> editor_;  // once the mesh has been edited
  std::optional<HairMeshVertex> dragged_;
  glm::vec2 grip_{0}, cursor_{0};  // from the cursor to the dragged vertex, and where it was last
  std::string editFailure_;
  double editMilliseconds_ = 0;
  Controls applied_;
  float mapExtent_;  // metres; the same for any number of cells
};

}  // namespace hair
