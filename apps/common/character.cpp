#include <apps/common/character.h>

#include <utility>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/files/obj.h>
#include <libhair/wisps/load_groom.h>

namespace hair {

namespace {

constexpr float kColliderCell = 0.004f, kColliderMargin = 0.03f;

KajiyaKaySettings lookOf(Style style) {
  KajiyaKaySettings look;
  if (style == Style::Curly) {
    look.rootColour = {0.21f, 0.045f, 0.016f};
    look.tipColour = {0.34f, 0.085f, 0.03f};
  }
  return look;
}

std::vector<TriangleMesh> readHeads(const CharacterOptions& options) {
  std::vector<TriangleMesh> meshes;
  for (const std::filesystem::path& file : options.heads) meshes.push_back(readObj(file));
  return meshes;
}

}  // namespace

void Character::takeHead(LoadedHead loaded) {
  head = std::move(loaded.head);
  eyes = std::move(loaded.others);
  headCollider = std::make_unique<MeshSdf>(head.mesh, kColliderCell, kColliderMargin);
}

// Head and groom together, as each has to fit the other.
void Character::makeHair(const CharacterOptions& options) {
  const auto note = [&](const std::vector<std::string>& more) {
    notes.insert(notes.end(), more.begin(), more.end());
  };
  if (options.hair.empty()) {
    require(options.heads.empty(),
            "--head: the built-in styles grow on the built-in head; give --hair too");
    takeHead({builtinHead(), {}, {}, {}});
    StyleSettings style = styleSettings(options.style);
    if (options.strands > 0) style.strands = options.strands;
    if (options.points > 0) style.points = options.points;
    groom = makeGroom(style, *headCollider);
  } else if (isHairMesh(options.hair)) {
    mesh = growMeshHair(options, notes);
    LoadedHead loaded{builtinHead(), {}, {}, {}};
    if (!options.heads.empty()) {
      loaded = loadedHead(readHeads(options), rootsOf(mesh->grown.strands));
      moveBy(loaded.headFromFile, *mesh);
      note(loaded.notes);
    }
    takeHead(std::move(loaded));
    groom = groomOf(*mesh);
  } else {
    BindSettings bind;
    bind.guides = options.guides;
    LoadedGroom loaded = loadGroom(options.hair, {options.read, options.strands, options.points},
                                   readHeads(options), bind);
    note(loaded.notes);
    groom = std::move(loaded.groom);
    takeHead(std::move(loaded.head));
  }
}

namespace {

Motion makeMotion(const CharacterOptions& options, std::vector<std::string>& notes) {
  if (options.still) return Motion::still();
  if (options.motion.empty()) return Motion::dance();
  Motion motion(clipFromBvh(readBvh(options.motion), options.motionScale));
  const auto& joints = motion.clip().skeleton.names;
  if (motion.droppedFrames() > 0)
    notes.push_back(text(options.motion.filename().string(), ": dropped ", motion.droppedFrames(),
                         " frames of a calibration pose at the start"));
  for (const Flip& flip : motion.flips())
    notes.push_back(text(options.motion.filename().string(), ": ", joints[flip.joint], " flips by ",
                         flip.degrees, " degrees at frame ", flip.frame, "; ", flip.frames,
                         flip.frames == 1 ? " frame" : " frames", " interpolated"));
  for (const std::string& note : motion.body().notes) notes.push_back(note);
  return motion;
}

}  // namespace

Character::Character(const CharacterOptions& options)
    : motion(makeMotion(options, notes)),
      body(motion.body()),
      look(lookOf(options.hair.empty() ? options.style : Style::Smooth)) {
  makeHair(options);
}

}  // namespace hair
