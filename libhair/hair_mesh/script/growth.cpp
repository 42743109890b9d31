// Script operations that grow many layers at once along paths of hair from the roots; and groups.
#include <libhair/hair_mesh/script/growth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/hair_mesh/operations.h>
#include <libhair/model/comb.h>

namespace hair {

void growTo(Workshop& w, std::span<const std::uint32_t> bundles, std::uint32_t layers) {
  HairMesh& mesh = w.mesh();
  std::size_t corners = 0;
  for (const std::uint32_t j : bundles) {
    require(mesh.lastLayer[j] <= layers, "bundle ", j, " has ", mesh.lastLayer[j],
            " layers already, more than ", layers, "; `delete` takes some off");
    corners += std::size_t{mesh.sides(j)} * (layers - mesh.lastLayer[j]);
  }
  w.requireRoom(corners, layers);
  while (true) {
    std::vector<std::uint32_t> shorter;
    for (const std::uint32_t j : bundles)
      if (mesh.lastLayer[j] < layers) shorter.push_back(j);
    if (shorter.empty()) return;
    w.spend();
    extrudeFaces(shorter, 1e-3f, mesh);
  }
}

namespace {

// Middle of the faces around each vertex of a layer, on the scalp.
std::vector<glm::vec3> besideVertices(const HairMesh& mesh, std::size_t layer) {
  std::vector<glm::vec4> sum(mesh.layers[layer].vertexCount(), glm::vec4(0));
  for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j) {
    if (mesh.lastLayer[j] < layer) continue;
    glm::vec4 centre(0);
    for (const std::uint32_t v : mesh.face(0, j))
      centre += glm::vec4(mesh.layers[0].positions[v], 1);
    centre /= centre.w;
    for (const std::uint32_t v : mesh.face(layer, j)) sum[v] += centre;
  }
  std::vector<glm::vec3> middle;
  middle.reserve(sum.size());
  for (const glm::vec4 s : sum) middle.emplace_back(glm::vec3(s) / s.w);
  return middle;
}

}  // namespace

void layAlong(Workshop& w, std::span<const std::uint32_t> bundles, std::uint32_t layers,
              const CurveFromRoot& curveOf) {
  growTo(w, bundles, layers);
  HairMesh& mesh = w.mesh();
  // Vertices that stand on one root between the same faces share a curve.
  struct Use {
    std::uint32_t layer, vertex, curve;
  };
  struct Start {
    glm::vec3 root, beside;
  };
  std::map<std::array<float, 4>, std::uint32_t> known;
  std::vector<Start> starts;
  std::vector<Use> uses;
  std::vector<std::uint32_t> root(mesh.layers[0].vertexCount());
  for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = v;
  for (std::uint32_t k = 1; k <= layers; ++k) {
    std::vector<std::uint32_t> here;
    for (const std::uint32_t on : mesh.layers[k].below) here.push_back(root[on]);
    root = std::move(here);
    const std::vector<glm::vec3> beside = besideVertices(mesh, k);
    BundleSet wanted(root.size(), 0);
    for (const std::uint32_t j : bundles)
      for (const std::uint32_t v : mesh.face(k, j)) wanted[v] = 1;
    for (std::uint32_t v = 0; v < root.size(); ++v) {
      if (!wanted[v]) continue;
      const glm::vec3 b = beside[v];
      const auto [at, isNew] = known.try_emplace({static_cast<float>(root[v]), b.x, b.y, b.z},
                                                 static_cast<std::uint32_t>(starts.size()));
      if (isNew) starts.push_back({mesh.layers[0].positions[root[v]], b});
      uses.push_back({k, v, at->second});
    }
  }
  std::vector<glm::vec3> points(starts.size() * (layers + 1));
  parallelFor(starts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      curveOf(starts[i].root, starts[i].beside,
              std::span(points).subspan(i * (layers + 1), layers + 1));
  });
  for (const Use& use : uses)
    mesh.layers[use.layer].positions[use.vertex] = points[use.curve * (layers + 1) + use.layer];
}

namespace {

constexpr std::uint32_t kMostLayers = 1000;

const MeshSdf& builtinHeadSdf() {
  // As for the built-in styles. Cached: it takes a second to build.
  static const std::shared_ptr<const MeshSdf> sdf = sharedSdf(builtinHead().mesh, 0.004f, 0.1f);
  return *sdf;
}

// comb SEL LAYERS [length A] [cut FRONT BACK] [volume V] [lift L] [turn-in T] [wave R]
//   [whorl Z] [shoulders S]: as the built-in styles lie
ScriptStep readComb(ScriptWords& words) {
  const std::string name = words.name("a selection");
  const std::uint32_t layers = words.whole("layers", 2, kMostLayers);
  StyleSettings style;
  style.maxLength = 0.3f;
  style.cutHeightFront = style.cutHeightBack = -10;
  style.minLength = 0.03f;
  style.lengthVariation = style.waviness = style.partAtShoulders = style.turnIn = 0;
  float whorl = NAN;
  words.options({{"length", [&] { style.maxLength = words.number("length", 0.005f, 2); }},
                 {"cut",
                  [&] {
                    style.cutHeightFront = words.number("cut", -2, 0.3f);
                    style.cutHeightBack = words.number("cut", -2, 0.3f);
                  }},
                 {"least", [&] { style.minLength = words.number("least", 0, 2); }},
                 {"volume", [&] { style.volume = words.number("volume", 0, 0.1f); }},
                 {"lift", [&] { style.rootLift = words.number("lift", 0, 10); }},
                 {"turn-in", [&] { style.turnIn = words.number("turn-in", -2, 2); }},
                 {"wave", [&] { style.waviness = words.number("wave", 0, 2); }},
                 {"whorl", [&] { whorl = words.number("whorl", -0.1f, 0.1f); }},
                 {"shoulders", [&] { style.partAtShoulders = words.number("shoulders", 0, 1); }}});
  return [=](Workshop& w) {
    const std::vector<std::uint32_t> bundles = w.bundles(name);
    require(w.onHead, "only hair of the built-in head is combed; `drape` is for others");
    StyleSettings settings = style;
    settings.parting = w.parting;
    if (!std::isnan(whorl)) settings.parting.whorlZ = whorl;
    const MeshSdf& head = builtinHeadSdf();
    layAlong(w, bundles, layers, [&](glm::vec3 root, glm::vec3 beside, std::span<glm::vec3> curve) {
      // A root on the parting falls to the side its faces are on; that of the whorl to the back,
      // where faces are all around it.
      constexpr float kAside = 0.004f, kAllAround = 0.005f;
      const glm::vec3 way = beside - root;
      glm::vec3 aside = glm::length(way) > 1e-5f ? kAside * glm::normalize(way) : glm::vec3(0);
      if (glm::distance(root, w.whorl) < 2e-3f && glm::length(way) < kAllAround)
        aside = {0, 0, -kAside};
      const glm::vec3 from = onScalp(head, root + aside);
      combGuide(settings, head, from, from, 0, curve);
      for (std::size_t k = 0; k < curve.size(); ++k) {
        const float left = 1 - static_cast<float>(k) / static_cast<float>(curve.size() - 1);
        curve[k] += left * left * (root - from);
      }
    });
  };
}

// drape SEL LAYERS length A [lift L] [stiffness M] [clearance C] [volume V]: on any scalp
ScriptStep readDrape(ScriptWords& words) {
  const std::string name = words.name("a selection");
  const std::uint32_t layers = words.whole("layers", 1, kMostLayers);
  float length = 0.2f, lift = 0.7f, stiffness = 0.04f, clearance = 0.003f, volume = 0.01f;
  words.options({{"length", [&] { length = words.number("length", 0.005f, 2); }},
                 {"lift", [&] { lift = words.number("lift", 0, 1); }},
                 {"stiffness", [&] { stiffness = words.number("stiffness", 0.005f, 10); }},
                 {"clearance", [&] { clearance = words.number("clearance", 0, 0.1f); }},
                 {"volume", [&] { volume = words.number("volume", 0, 0.1f); }}});
  return [=](Workshop& w) {
    const std::vector<std::uint32_t> bundles = w.bundles(name);
    layAlong(w, bundles, layers, [&](glm::vec3 root, glm::vec3, std::span<glm::vec3> curve) {
      constexpr int kSteps = 200;
      const float step = length / kSteps;
      const glm::vec3 normal = outwards(w.obstacle, root), down(0, -1, 0);
      glm::vec3 flat = down - glm::dot(down, normal) * normal;
      flat = glm::length(flat) > 1e-3f ? glm::normalize(flat) : anyNormal(normal);
      glm::vec3 p = root, d = glm::mix(flat, normal, lift);
      d = glm::length(d) > 1e-6f ? glm::normalize(d) : normal;
      std::array<glm::vec3, kSteps + 1> dense{root};
      for (int i = 1; i <= kSteps; ++i) {
        const float s = step * static_cast<float>(i);
        const glm::vec3 turned = glm::mix(d, down, std::min(step / stiffness, 1.0f));
        if (glm::length(turned) > 1e-3f) d = glm::normalize(turned);
        p += step * d;
        const float least = std::min(clearance, 0.5f * s) + volume * (1 - std::exp(-s / 0.09f));
        const float lacks = least - w.obstacle(p);
        if (lacks > 0) p += lacks * outwards(w.obstacle, p);
        dense[static_cast<std::size_t>(i)] = p;
      }
      equalLinks(dense, curve);
    });
  };
}

// group [strands N] [points P] [seed S] and the fields of StylingSettings
ScriptStep readGroup(ScriptWords& words) {
  StrandGroup group;
  StylingSettings& s = group.styling;
  const auto share = [&](const char* name, float& value, float highest = 1) {
    value = words.number(name, 0, highest);
  };
  const auto metres = [&](const char* name, float& value, float lowest) {
    value = words.number(name, lowest, 1);
  };
  constexpr float kBelowOne = 0.999f, kAboveZero = 1e-4f;
  words.options(
      {{"strands", [&] { group.strands = words.whole("strands", 1, 10'000'000); }},
       {"points", [&] { group.points = words.whole("points", 2, 4096); }},
       {"seed", [&] { group.seed = words.whole("seed", 0, 0xfffffffe); }},
       {"per-square-metre",
        [&] { group.perSquareMetre = words.number("per-square-metre", 0, 1e7f); }},
       {"length-cut", [&] { share("length-cut", s.lengthCut, kBelowOne); }},
       {"length-variation", [&] { share("length-variation", s.lengthVariation, kBelowOne); }},
       {"clump", [&] { share("clump", s.clump); }},
       {"clump-size", [&] { s.clumpSize = words.whole("clump-size", 1, 1'000'000); }},
       {"curl-radius", [&] { metres("curl-radius", s.curlRadius, 0); }},
       {"curl-pitch", [&] { metres("curl-pitch", s.curlPitch, kAboveZero); }},
       {"curl-from-root", [&] { share("curl-from-root", s.curlFromRoot, kBelowOne); }},
       {"noise", [&] { metres("noise", s.noise, 0); }},
       {"noise-length", [&] { metres("noise-length", s.noiseLength, kAboveZero); }},
       {"frizz", [&] { metres("frizz", s.frizz, 0); }},
       {"frizz-length", [&] { metres("frizz-length", s.frizzLength, kAboveZero); }},
       {"frizz-share", [&] { share("frizz-share", s.frizzShare); }}});
  return [group](Workshop& w) {
    require(w.style.groups.size() < 100, "a hairstyle may have 100 groups");
    w.style.groups.push_back(group);
  };
}

// groups none: removes the groups of an included script, so that this one defines all
ScriptStep readGroups(ScriptWords& words) {
  words.expect(words.take("none"), "after `groups` comes `none`");
  return [](Workshop& w) { w.style.groups.clear(); };
}

// tie SEL [at LAYER]: fixes the hair to the head, up to its tips or up to a layer
ScriptStep readTie(ScriptWords& words) {
  const std::string name = words.name("a selection");
  std::uint32_t layer = kMostLayers;
  if (words.take("at")) layer = words.whole("layer", 1, kMostLayers);
  return [=](Workshop& w) {
    std::vector<std::uint32_t>& tied = w.style.tied;
    tied.resize(w.mesh().bundleCount(), 0);
    for (const std::uint32_t j : w.bundles(name)) tied[j] = std::min(layer, w.mesh().lastLayer[j]);
  };
}

}  // namespace

std::span<const ScriptCommand> growthCommands() {
  static constexpr ScriptCommand kCommands[] = {{"comb", readComb},
                                                {"drape", readDrape},
                                                {"group", readGroup},
                                                {"groups", readGroups},
                                                {"tie", readTie}};
  return kCommands;
}

}  // namespace hair
