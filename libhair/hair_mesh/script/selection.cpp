// Script operations that make scalps and select bundles.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <libhair/hair_mesh/scalp_patch.h>
#include <libhair/hair_mesh/script/workshop.h>
#include <libhair/model/head.h>

namespace hair {

namespace {

void setScalp(Workshop& w, const PolygonMesh& scalp) {
  require(w.mesh().bundleCount() == 0, "there is a scalp already");
  require(scalp.corners.size() <= w.limits.corners, "the scalp has ", scalp.corners.size(),
          " corners of faces, at most ", w.limits.corners);
  w.mesh() = makeHairMesh(scalp);
}

void requireRoom(const Workshop& w, const ScalpPatch& patch) {
  const std::size_t corners = std::size_t{patch.sectors} * (4 * patch.rings - 1);
  require(corners <= w.limits.corners, "the scalp would have ", corners,
          " corners of faces, at most ", w.limits.corners);
}

void setRings(Workshop& w, const ScalpPatch& patch) {
  w.sectors = patch.sectors;
  for (std::uint32_t j = 0; j < w.mesh().bundleCount(); ++j) {
    w.ring.push_back(j / patch.sectors);
    w.sector.push_back(j % patch.sectors);
  }
}

ScalpPatch readPatch(ScriptWords& words) {
  ScalpPatch patch;
  patch.rings = words.whole("rings", 1, 100);
  patch.sectors = words.whole("sectors", 3, 400);
  return patch;
}

// scalp head RINGS SECTORS [parting X] [whorl Z]
ScriptStep readHeadScalp(ScriptWords& words) {
  const ScalpPatch patch = readPatch(words);
  Parting parting;
  words.options({{"parting", [&] { parting.x = words.number("parting", -0.05f, 0.05f); }},
                 {"whorl", [&] { parting.whorlZ = words.number("whorl", -0.06f, 0.06f); }}});
  return [=](Workshop& w) {
    requireRoom(w, patch);
    setScalp(w, headScalp(patch, parting));
    setRings(w, patch);
    w.parting = parting;
    w.whorl = w.mesh().layers[0].positions[w.mesh().face(0, 0)[0]];
    w.onHead = true;
    w.obstacle = headField;
  };
}

// scalp sphere RADIUS RINGS SECTORS [to DEGREES]
ScriptStep readSphereScalp(ScriptWords& words) {
  const float radius = words.number("radius", 1e-3f, 10);
  const ScalpPatch patch = readPatch(words);
  float degrees = 90;
  words.options({{"to", [&] { degrees = words.number("degrees", 1, 170); }}});
  return [=](Workshop& w) {
    requireRoom(w, patch);
    setScalp(w, sphereScalp(patch, radius, degrees));
    setRings(w, patch);
    w.obstacle = [radius](glm::vec3 p) { return glm::length(p) - radius; };
  };
}

ScriptStep readScalp(ScriptWords& words) {
  if (words.take("head")) return readHeadScalp(words);
  if (words.take("sphere")) return readSphereScalp(words);
  words.expect(words.take("file"), "a scalp is `head`, `sphere` or `file`");
  return [file = std::string(words.word("a file"))](Workshop& w) {
    require(w.files != nullptr, "files are not read here: '", TextReader::shown(file), "'");
    setScalp(w, parsePolygons(w.files(file), file));
    w.onHead = true;  // a scalp of one's own for the same head
    w.obstacle = headField;
  };
}

glm::vec3 faceCentre(const HairMesh& mesh, std::size_t layer, std::size_t bundle) {
  glm::vec3 sum(0);
  for (const std::uint32_t v : mesh.face(layer, bundle)) sum += mesh.layers[layer].positions[v];
  return sum / static_cast<float>(mesh.sides(bundle));
}

float lengthOf(const HairMesh& mesh, std::size_t bundle) {
  float length = 0;
  for (std::uint32_t k = 1; k <= mesh.lastLayer[bundle]; ++k)
    length += glm::distance(faceCentre(mesh, k - 1, bundle), faceCentre(mesh, k, bundle));
  return length;
}

// Properties of a bundle that `select ... z < 0` compares.
struct Quantity {
  std::string_view name;
  float (*of)(const Workshop& w, std::uint32_t bundle);
};
constexpr Quantity kQuantities[] = {
    {"x", [](const Workshop& w, std::uint32_t j) { return faceCentre(w.mesh(), 0, j).x; }},
    {"y", [](const Workshop& w, std::uint32_t j) { return faceCentre(w.mesh(), 0, j).y; }},
    {"z", [](const Workshop& w, std::uint32_t j) { return faceCentre(w.mesh(), 0, j).z; }},
    {"angle",
     [](const Workshop& w, std::uint32_t j) {
       const glm::vec3 p = faceCentre(w.mesh(), 0, j);
       return std::atan2(p.x, p.z) * 180 / std::numbers::pi_v<float>;
     }},
    {"tip-x", [](const Workshop& w,
                 std::uint32_t j) { return faceCentre(w.mesh(), w.mesh().lastLayer[j], j).x; }},
    {"tip-y", [](const Workshop& w,
                 std::uint32_t j) { return faceCentre(w.mesh(), w.mesh().lastLayer[j], j).y; }},
    {"tip-z", [](const Workshop& w,
                 std::uint32_t j) { return faceCentre(w.mesh(), w.mesh().lastLayer[j], j).z; }},
    {"length", [](const Workshop& w, std::uint32_t j) { return lengthOf(w.mesh(), j); }},
    {"layers",
     [](const Workshop& w, std::uint32_t j) { return static_cast<float>(w.mesh().lastLayer[j]); }},
    {"sides",
     [](const Workshop& w, std::uint32_t j) { return static_cast<float>(w.mesh().sides(j)); }},
    {"ring",
     [](const Workshop& w, std::uint32_t j) {
       require(!w.ring.empty(), "a scalp from a file has no rings");
       return static_cast<float>(w.ring[j]);
     }},
    {"sector", [](const Workshop& w, std::uint32_t j) {
       require(!w.sector.empty(), "a scalp from a file has no sectors");
       return static_cast<float>(w.sector[j]);
     }}};

// Bundles with a vertex on the rim of the scalp: on an edge that has one face.
BundleSet rim(const HairMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto edgesOf = [&](std::uint32_t j, auto&& use) {
    for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c)
      use(mesh.layers[0].corners[c], mesh.layers[0].corners[mesh.nextCorner(j, c)]);
  };
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    edgesOf(j, [&](std::uint32_t a, std::uint32_t b) { edges.emplace_back(a, b); });
  std::sort(edges.begin(), edges.end());
  BundleSet set(mesh.bundleCount(), 0);
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
    edgesOf(j, [&](std::uint32_t a, std::uint32_t b) {
      if (!std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) set[j] = 1;
    });
  return set;
}

using SetOf = std::function<BundleSet(const Workshop&)>;

SetOf readComparison(ScriptWords& words, const Quantity& quantity) {
  const std::string_view comparison = words.word("<, <=, >, >= or =");
  const float bound = words.number(quantity.name, -1e6f, 1e6f);
  bool (*holds)(float, float) = nullptr;
  if (comparison == "<") holds = [](float a, float b) { return a < b; };
  if (comparison == "<=") holds = [](float a, float b) { return a <= b; };
  if (comparison == ">") holds = [](float a, float b) { return a > b; };
  if (comparison == ">=") holds = [](float a, float b) { return a >= b; };
  if (comparison == "=") holds = [](float a, float b) { return a == b; };
  words.expect(holds != nullptr, "'", TextReader::shown(comparison),
               "' is none of <, <=, >, >= and =");
  return [=, of = quantity.of](const Workshop& w) {
    BundleSet set(w.mesh().bundleCount());
    for (std::uint32_t j = 0; j < set.size(); ++j) set[j] = holds(of(w, j), bound);
    return set;
  };
}

SetOf readSet(ScriptWords& words) {
  if (words.take("rim")) return [](const Workshop& w) { return rim(w.mesh()); };
  if (words.take("bundles")) {
    const auto [least, greatest] = words.range("bundles", 0, 100'000'000);
    return [first = least, last = greatest](const Workshop& w) {
      require(last < w.mesh().bundleCount(), "there is no bundle ", last, "; there are ",
              w.mesh().bundleCount(), ", from 0");
      BundleSet set(w.mesh().bundleCount(), 0);
      std::fill(set.begin() + first, set.begin() + last + 1, std::uint8_t{1});
      return set;
    };
  }
  const std::string name = words.name("a selection");
  for (const Quantity& quantity : kQuantities)
    if (quantity.name == name) return readComparison(words, quantity);
  return [name](const Workshop& w) { return w.selected(name); };
}

SetOf readTerm(ScriptWords& words) {
  if (!words.take("not")) return readSet(words);
  return [set = readSet(words)](const Workshop& w) {
    BundleSet others = set(w);
    for (std::uint8_t& in : others) in = !in;
    return others;
  };
}

// select NAME TERM { (and | or | minus) TERM }, from left to right
ScriptStep readSelect(ScriptWords& words) {
  const std::string name = words.name("a name");
  for (const Quantity& quantity : kQuantities)
    words.expect(quantity.name != name, "'", name, "' has a meaning already");
  for (const std::string_view taken : {"all", "rim", "bundles", "not", "parting", "whorl"})
    words.expect(taken != name, "'", name, "' has a meaning already");
  struct Part {
    char how;
    SetOf set;
  };
  std::vector<Part> parts{{'o', readTerm(words)}};
  while (!words.done()) {
    const bool where = words.take("where");
    const char how = where || words.take("and") ? 'a'
                     : words.take("or")         ? 'o'
                     : words.take("minus")      ? 'm'
                                                : 0;
    words.expect(how != 0, "after a set comes `and`, `or`, `minus` or `where`");
    parts.push_back({how, readTerm(words)});
    words.expect(parts.size() <= 100, "a selection may have 100 terms");
  }
  return [=](Workshop& w) {
    w.selected("all");  // there is a scalp
    BundleSet set(w.mesh().bundleCount(), 0);
    for (const Part& part : parts) {
      const BundleSet other = part.set(w);
      for (std::size_t j = 0; j < set.size(); ++j)
        set[j] = part.how == 'o'   ? set[j] || other[j]
                 : part.how == 'a' ? set[j] && other[j]
                                   : set[j] && !other[j];
    }
    require(std::find(set.begin(), set.end(), 1) != set.end(), "'", name, "' holds no bundle");
    require(w.selections.size() < 1000 || w.selections.contains(name),
            "a script may have 1000 selections");
    w.selections.insert_or_assign(name, std::move(set));
  };
}

}  // namespace

std::span<const ScriptCommand> selectionCommands() {
  static constexpr ScriptCommand kCommands[] = {{"scalp", readScalp}, {"select", readSelect}};
  return kCommands;
}

}  // namespace hair
