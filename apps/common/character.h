#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <apps/common/mesh_hair.h>
#include <libhair/files/strand_file.h>
#include <libhair/model/loaded_head.h>
#include <libhair/model/styles.h>
#include <libhair/motion/body_mesh.h>
#include <libhair/motion/motion.h>
#include <libhair/simulation/frame.h>

namespace hair {

/// Whose hair: what the options of `dance` and `hair simulate` say in the same words.
struct CharacterOptions {
  Style style = Style::Smooth;  ///< --style, unless `hair` is given
  std::filesystem::path hair;   ///< --hair FILE, strands or a hair mesh; empty: the style
  /// --head FILE, may be repeated: first the head, which hair collides with, then what is drawn
  /// with it (eyes). Empty: the built-in head, fitted to the hair.
  std::vector<std::filesystem::path> heads;
  std::filesystem::path motion;  ///< --motion FILE.bvh; empty: the built-in dance
  bool still = false;            ///< --still: nobody moves
  ReadOptions read;              ///< --scale, --up: of the hair file and the head files
  ReadOptions headRead;          ///< --head-scale, --head-up: where the head files differ
  MotionSettings clip;           ///< --motion-scale, --motion-up, --head-joint: of that file
  bool verbose = false;          ///< --verbose: notes in detail
  std::uint32_t strands = 0;     ///< --strands; 0: the style's, or all of the file's
  std::uint32_t points = 0;      ///< --points a strand; 0: the style's, or the file's
  std::uint32_t guides = 402;    ///< --guides, of a loaded groom
};

/// Head, hair, body and motion, all loaded and in the library's units.
struct Character {
  explicit Character(const CharacterOptions& options);
  Character(const Character&) = delete;  // Hair keeps references into it
  Character& operator=(const Character&) = delete;

  std::vector<std::string> notes;  ///< what was assumed, dropped or repaired, for the user
  Head head;                       ///< head space
  std::vector<TriangleMesh> eyes;  ///< drawn with the head, head space
  std::unique_ptr<MeshSdf> headCollider;
  std::optional<MeshHair> mesh;  ///< what the groom was made of, if it was a hair mesh
  Groom groom;
  Motion motion;
  BodyMesh body;
  KajiyaKaySettings look;

 private:
  void takeHead(LoadedHead loaded);
  void makeHair(const CharacterOptions& options);
};

}  // namespace hair
