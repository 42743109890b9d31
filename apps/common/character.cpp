#include <apps/common/character.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/files/obj.h>
#include <libhair/model/head.h>
#include <libhair/model/resample.h>
#include <libhair/wisps/bind.h>

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

StrandSet loadHair(const CharacterOptions& options, std::vector<std::string>& notes) {
  StrandFile file = readStrands(options.hair, options.read);
  notes.push_back(text(options.hair.filename().string(), ": ", file.strands.strandCount(),
                       " strands, ", file.strands.pointCount(), " points; ", file.scale,
                       " m a unit, up axis ", wordOf(file.up)));
  const std::size_t dropped = dropDegenerate(file.strands);
  if (dropped > 0)
    notes.push_back(text("dropped ", dropped, " strands of a single point or shorter than 1 mm"));
  require(file.strands.strandCount() > 0, options.hair.string(),
          ": no strand is longer than 1 mm; check --scale");
  if (options.strands > 0 || options.points > 0) {
    const std::size_t count = options.strands > 0 ? options.strands : file.strands.strandCount();
    if (count > file.strands.strandCount())
      notes.push_back(
          text("--strands ", count, ": the file has only ", file.strands.strandCount()));
    const ResamplePlan plan = planResampling(
        file.strands, chooseStrands(file.strands.strandCount(), count), options.points);
    file.strands = {resample(plan, file.strands.points), plan.first};
  }
  return std::move(file.strands);
}

std::vector<glm::vec3> rootsOf(StrandView strands) {
  std::vector<glm::vec3> roots;
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    roots.push_back(strands.strand(s).front());
  return roots;
}

void moveBy(const RigidTransform& to, TriangleMesh& mesh) {
  for (glm::vec3& p : mesh.positions) p = to.point(p);
}

// A bust brings shoulders along, which do not move with a head. What is below the neck, and what is
// wider than one, goes; the body's neck reaches up into what stays.
std::size_t dropBust(TriangleMesh& mesh) {
  constexpr float kNeckBottom = -0.06f, kNeckRadius = 0.075f;
  const auto below = [&](std::uint32_t v) {
    const glm::vec3 p = mesh.positions[v];
    return p.y < kNeckBottom || (p.y < 0 && std::hypot(p.x, p.z) > kNeckRadius && p.z < 0.05f);
  };
  return std::erase_if(mesh.triangles,
                       [&](glm::uvec3 t) { return below(t.x) && below(t.y) && below(t.z); });
}

// The first of options.heads where the roots want it, and what comes with it.
RigidTransform loadHead(const CharacterOptions& options, std::span<const glm::vec3> roots,
                        Head& head, std::vector<TriangleMesh>& eyes,
                        std::vector<std::string>& notes) {
  head.mesh = readObj(options.heads.front());
  const RigidTransform headFromFile = placeHead(head.mesh, roots);
  moveBy(headFromFile, head.mesh);
  const std::size_t dropped = dropBust(head.mesh);
  if (dropped > 0)
    notes.push_back(text(options.heads.front().filename().string(), ": ", dropped,
                         " triangles of shoulders left out; the body has its own"));
  for (std::size_t i = 1; i < options.heads.size(); ++i)
    moveBy(headFromFile, eyes.emplace_back(readObj(options.heads[i])));
  return headFromFile;
}

}  // namespace

// Head and groom together, as each has to fit the other.
void Character::makeHair(const CharacterOptions& options) {
  const auto makeCollider = [&] {
    headCollider = std::make_unique<MeshSdf>(head.mesh, kColliderCell, kColliderMargin);
  };
  if (options.hair.empty()) {
    require(options.heads.empty(),
            "--head: the built-in styles grow on the built-in head; give --hair too");
    head = builtinHead();
    makeCollider();
    StyleSettings style = styleSettings(options.style);
    if (options.strands > 0) style.strands = options.strands;
    if (options.points > 0) style.points = options.points;
    groom = makeGroom(style, *headCollider);
  } else if (isHairMesh(options.hair)) {
    mesh = growMeshHair(options, notes);
    if (options.heads.empty())
      head = builtinHead();
    else
      moveBy(loadHead(options, rootsOf(mesh->grown.strands), head, eyes, notes), *mesh);
    makeCollider();
    groom = groomOf(*mesh);
  } else {
    StrandSet strands = loadHair(options, notes);
    const std::vector<glm::vec3> roots = rootsOf(strands);
    RigidTransform headFromFile;
    if (options.heads.empty()) {
      HeadFit fit = fitHeadToRoots(roots);
      head = std::move(fit.head);
      headFromFile = fit.headFromHair;
      notes.push_back(
          text("no --head: the built-in head was scaled under the roots, which lie on it to ",
               fit.residual * 1000, " mm (mean)"));
    } else {
      headFromFile = loadHead(options, roots, head, eyes, notes);
    }
    makeCollider();
    for (glm::vec3& p : strands.points) p = headFromFile.point(p);
    BindSettings bind;
    bind.guides = options.guides;
    groom = bindGroom(strands, bind);
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
