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

// Those that the options leave open are what the first file states, if it does.
HeadFiles readHeads(const CharacterOptions& options) {
  HeadFiles heads{{}, options.headRead};
  for (const std::filesystem::path& file : options.heads) {
    ObjReport report;
    heads.meshes.push_back(readObj(file, &report));
    if (heads.meshes.size() > 1) continue;
    if (heads.read.scale == 0) heads.read.scale = report.scale;
    if (heads.read.up == UpAxis::AsFile) heads.read.up = report.up;
  }
  return heads;
}

// The mesh beside the strands of an .obj is their head, where it fits.
LoadedGroom loadFileGroom(const CharacterOptions& options) {
  const LoadOptions load{options.read, options.strands, options.points};
  BindSettings bind;
  bind.guides = options.guides;
  if (!options.heads.empty() || !holdsMesh(options.hair))
    return loadGroom(options.hair, load, readHeads(options), bind);
  std::string whyNot;
  try {
    CharacterOptions own = options;
    own.heads = {options.hair};
    LoadedGroom loaded = loadGroom(options.hair, load, readHeads(own), bind);
    loaded.notes.push_back("no --head: the mesh of the same file is the head");
    return loaded;
  } catch (const Error& e) {
    whyNot = e.what();
  }
  LoadedGroom loaded = loadGroom(options.hair, load, {}, bind);
  loaded.notes.push_back("the mesh of the same file is not the head: " + whyNot);
  return loaded;
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
    LoadedHead builtin;
    builtin.head = builtinHead();
    takeHead(std::move(builtin));
    StyleSettings style = styleSettings(options.style);
    if (options.strands > 0) style.strands = options.strands;
    if (options.points > 0) style.points = options.points;
    groom = makeGroom(style, *headCollider);
  } else if (isHairMesh(options.hair)) {
    mesh = growMeshHair(options, notes);
    LoadedHead loaded;
    if (options.heads.empty()) {
      loaded.head = builtinHead();
    } else {
      HeadFiles heads = readHeads(options);
      const std::vector<glm::vec3> roots = rootsOf(mesh->grown.strands);
      loaded = loadedHead(std::move(heads.meshes), {roots, meshUnits(options)}, heads.read);
      moveBy(loaded.headFromHair, *mesh);
      note(loaded.notes);
    }
    takeHead(std::move(loaded));
    groom = groomOf(*mesh);
  } else {
    LoadedGroom loaded = loadFileGroom(options);
    note(loaded.notes);
    groom = std::move(loaded.groom);
    takeHead(std::move(loaded.head));
  }
}

namespace {

Motion makeMotion(const CharacterOptions& options, std::vector<std::string>& notes) {
  if (options.still) return Motion::still();
  if (options.motion.empty()) return Motion::dance();
  Motion motion(readBvh(options.motion), options.clip);
  const std::string file = options.motion.filename().string() + ": ";
  for (const std::string& note : motion.notes()) notes.push_back(file + note);
  if (options.verbose)
    for (const std::string& detail : motion.details()) notes.push_back(file + detail);
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
