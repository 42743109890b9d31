// A line for each topological operation (operations.h).
#include <algorithm>
#include <array>
#include <map>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/operations.h>
#include <libhair/hair_mesh/script/workshop.h>

namespace hair {

namespace {

constexpr std::uint32_t kMostLayers = 100'000;
constexpr std::uint32_t kAnyNumber = 0xfffffffe;

std::size_t sidesOf(const HairMesh& mesh, std::span<const std::uint32_t> bundles) {
  std::size_t sides = 0;
  for (const std::uint32_t j : bundles) sides += mesh.sides(j);
  return sides;
}

// extrude SEL DISTANCE [towards X Y Z SHARE] [times N]
ScriptStep readExtrude(ScriptWords& words) {
  const std::string name = words.name("a selection");
  const float distance = words.number("distance", -1, 1);
  glm::vec3 goal(0);
  float share = 0;
  std::uint32_t times = 1;
  words.options({{"towards",
                  [&] {
                    goal = words.point("towards");
                    share = words.number("share", 0, 1);
                  }},
                 {"times", [&] { times = words.whole("times", 1, 1000); }}});
  return [=](Workshop& w) {
    const std::vector<std::uint32_t> bundles = w.bundles(name);
    HairMesh& mesh = w.mesh();
    for (std::uint32_t i = 0; i < times; ++i) {
      w.spend();
      w.requireRoom(sidesOf(mesh, bundles), 1);
      extrudeFaces(bundles, distance, mesh);
      if (share == 0) continue;
      std::vector<BundleSet> moved(mesh.layerCount());
      for (const std::uint32_t j : bundles) {
        const std::uint32_t top = mesh.lastLayer[j];
        HairMesh::Layer& layer = mesh.layers[top];
        moved[top].resize(layer.vertexCount(), 0);
        for (const std::uint32_t v : mesh.face(top, j)) {
          if (moved[top][v]++) continue;
          moved[top][v] = 1;
          const glm::vec3 from = mesh.layers[top - 1].positions[layer.below[v]];
          const glm::vec3 step = layer.positions[v] - from, way = goal - from;
          const float length = glm::length(way);
          const glm::vec3 wanted = length > 0 ? way * (glm::length(step) / length) : step;
          layer.positions[v] = from + glm::mix(step, wanted, share);
        }
      }
    }
    w.afterGeometry();
  };
}

// delete SEL [times N]
ScriptStep readDelete(ScriptWords& words) {
  const std::string name = words.name("a selection");
  std::uint32_t times = 1;
  words.options({{"times", [&] { times = words.whole("times", 1, 1000); }}});
  return [=](Workshop& w) {
    for (std::uint32_t i = 0; i < times; ++i) {
      w.spend();
      const std::vector<std::uint32_t> bundles = w.bundles(name);
      BundleSet goes(w.mesh().bundleCount(), 0);
      for (const std::uint32_t j : bundles) goes[j] = w.mesh().lastLayer[j] == 0;
      std::vector<std::uint32_t> from;
      for (std::uint32_t j = 0; j < goes.size(); ++j)
        if (!goes[j]) from.push_back(j);
      require(!from.empty(), "nothing of the scalp would be left");
      deleteFaces(bundles, w.mesh());
      w.renumber(from);
    }
    w.afterGeometry();
  };
}

// Calls change(bundles) once for each connected part of a layer.
template <class Change>
void forEachPiece(Workshop& w, std::uint32_t layer, const std::string& name, const Change& change) {
  BundleSet done(w.mesh().bundleCount(), 0);
  std::vector<std::vector<std::uint32_t>> pieces;
  for (const std::uint32_t j : w.bundles(name)) {
    if (done[j] || w.mesh().lastLayer[j] < layer) continue;
    w.spend();
    pieces.push_back(connectedFaces(w.mesh(), layer, j));
    for (const std::uint32_t i : pieces.back()) done[i] = 1;
  }
  require(!pieces.empty(), "no bundle of '", name, "' has a layer ", layer);
  for (const auto& piece : pieces) change(piece);
}

// insert LAYER SEL
ScriptStep readInsert(ScriptWords& words) {
  const std::uint32_t layer = words.whole("layer", 1, kMostLayers);
  return [layer, name = words.name("a selection")](Workshop& w) {
    forEachPiece(w, layer, name, [&](const std::vector<std::uint32_t>& piece) {
      w.requireRoom(sidesOf(w.mesh(), piece), 1);
      insertLayer(layer, piece.front(), w.mesh());
    });
    w.afterGeometry();
  };
}

// remove LAYER SEL
ScriptStep readRemove(ScriptWords& words) {
  const std::uint32_t layer = words.whole("layer", 1, kMostLayers);
  return [layer, name = words.name("a selection")](Workshop& w) {
    forEachPiece(w, layer, name, [&](const std::vector<std::uint32_t>& piece) {
      removeLayer(layer, piece.front(), w.mesh());
    });
    w.afterGeometry();
  };
}

// A SEL [from | with B] [at LAYER], or the parting, or all edges that meet in the whorl.
struct Seam {
  std::string a, b;  // b empty: all others
  bool parting = false, whorl = false;
  std::uint32_t layer = 1;
};

Seam readSeam(ScriptWords& words, std::string_view and_) {
  Seam seam;
  seam.parting = words.take("parting");
  seam.whorl = !seam.parting && words.take("whorl");
  if (!seam.parting && !seam.whorl) {
    seam.a = words.name("a selection");
    if (words.take(and_)) seam.b = words.name("a selection");
  }
  if (words.take("at")) seam.layer = words.whole("layer", 1, kMostLayers);
  return seam;
}

struct SeamEdge {
  std::uint32_t cornerA, nextA, cornerB, nextB;  // A runs from a to b where B runs from b to a
};

std::vector<SeamEdge> edgesOf(const Workshop& w, const Seam& seam) {
  const HairMesh& mesh = w.mesh();
  BundleSet a(mesh.bundleCount(), 0), b = a;
  if (seam.parting || seam.whorl) {
    w.selected("all");
    require(w.sectors > 0,
            "a scalp from a file has no parting or whorl; name the bundles on both sides");
    // The first and the last sector meet at the parting; both are even if their number is odd.
    for (std::size_t j = 0; j < a.size(); ++j) {
      const bool even = w.sector[j] % 2 == 0, last = w.sector[j] + 1 == w.sectors;
      a[j] = seam.parting ? w.sector[j] == 0 : w.ring[j] == 0 && even;
      b[j] = seam.parting ? last : w.ring[j] == 0 && !even;
    }
  } else {
    a = w.selected(seam.a);
    if (!seam.b.empty()) b = w.selected(seam.b);
    for (std::size_t j = 0; seam.b.empty() && j < a.size(); ++j) b[j] = !a[j];
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> ofA;
  const auto& root = mesh.layers[0].corners;
  const auto corners = [&](const BundleSet& set, auto&& use) {
    for (std::uint32_t j = 0; j < set.size(); ++j)
      for (std::uint32_t c = mesh.firstCorner[j];
           set[j] && mesh.lastLayer[j] >= seam.layer && c < mesh.firstCorner[j + 1]; ++c)
        use(j, c, mesh.nextCorner(j, c));
  };
  std::vector<std::uint32_t> bundleAt(mesh.cornerCount());
  corners(a, [&](std::uint32_t j, std::uint32_t c, std::uint32_t next) {
    ofA[{root[c], root[next]}] = c;
    bundleAt[c] = j;
  });
  std::vector<SeamEdge> edges;
  corners(b, [&](std::uint32_t j, std::uint32_t c, std::uint32_t next) {
    const auto found = ofA.find({root[next], root[c]});
    if (found == ofA.end() || bundleAt[found->second] == j) return;
    edges.push_back(
        {found->second, mesh.nextCorner(bundleAt[found->second], found->second), c, next});
  });
  require(!edges.empty(), "no edge lies between them in layer ", seam.layer);
  return edges;
}

// separate SEL [from SEL] [at LAYER] | separate parting|whorl [at LAYER]
ScriptStep readSeparate(ScriptWords& words) {
  const Seam seam = readSeam(words, "from");
  return [seam](Workshop& w) {
    const std::vector<SeamEdge> seamEdges = edgesOf(w, seam);
    const auto& corners = w.mesh().layers[seam.layer].corners;
    std::vector<HairMeshEdge> edges;
    for (const SeamEdge& e : seamEdges)
      if (corners[e.cornerA] == corners[e.nextB] && corners[e.nextA] == corners[e.cornerB])
        edges.push_back({corners[e.cornerA], corners[e.nextA]});
    require(!edges.empty(), "they are separated already in layer ", seam.layer);
    separateEdges(seam.layer, edges, w.mesh());
    w.afterGeometry();
  };
}

// weld SEL [with SEL] [at LAYER] | weld parting|whorl [at LAYER]
ScriptStep readWeld(ScriptWords& words) {
  const Seam seam = readSeam(words, "with");
  return [seam](Workshop& w) {
    bool any = false;
    for (const SeamEdge& e : edgesOf(w, seam)) {
      // Corner indices are stable, unlike vertex indices.
      const auto& corners = w.mesh().layers[seam.layer].corners;
      const HairMeshEdge a{corners[e.cornerA], corners[e.nextA]};
      const HairMeshEdge b{corners[e.nextB], corners[e.cornerB]};
      if (a.a == b.a && a.b == b.b) continue;
      w.spend();
      weldEdges(seam.layer, a, b, w.mesh());
      any = true;
    }
    require(any, "they are joined already in layer ", seam.layer);
    w.afterGeometry();
  };
}

void requireLayer(const Workshop& w, std::uint32_t layer) {
  w.selected("all");
  require(layer < w.mesh().layerCount(), "there is no layer ", layer, "; the last is ",
          w.mesh().layerCount() - 1);
}

// separate-vertices SEL at LAYER: every face gets vertices of its own
ScriptStep readSeparateVertices(ScriptWords& words) {
  const std::string name = words.name("a selection");
  words.expect(words.take("at"), "`at LAYER` is missing");
  const std::uint32_t layer = words.whole("layer", 1, kMostLayers);
  return [=](Workshop& w) {
    requireLayer(w, layer);
    std::vector<std::uint32_t> faces(w.mesh().layers[layer].vertexCount(), 0);
    for (const std::uint32_t v : w.mesh().layers[layer].corners)
      if (v != kNoVertex) ++faces[v];
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t j : w.bundles(name))
      if (w.mesh().lastLayer[j] >= layer)
        for (const std::uint32_t v : w.mesh().face(layer, j))
          if (faces[v] > 1) vertices.push_back(v);
    require(!vertices.empty(), "'", name, "' shares no vertex in layer ", layer);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    separateVertices(layer, vertices, w.mesh());
    w.afterGeometry();
  };
}

// OPERATION LAYER A B ...: on vertices of one layer, by their numbers.
template <std::size_t kCount, class Operation>
ScriptStep onVertices(ScriptWords& words, Operation operation) {
  const std::uint32_t layer = words.whole("layer", 1, kMostLayers);
  std::array<std::uint32_t, kCount> v;
  for (std::uint32_t& vertex : v) vertex = words.whole("vertex", 0, kAnyNumber);
  return [=](Workshop& w) {
    requireLayer(w, layer);
    operation(layer, v, w.mesh());
    w.afterGeometry();
  };
}

// separate-edge LAYER A B
ScriptStep readSeparateEdge(ScriptWords& words) {
  return onVertices<2>(words, [](std::uint32_t layer, const auto& v, HairMesh& mesh) {
    separateEdges(layer, std::vector<HairMeshEdge>{{v[0], v[1]}}, mesh);
  });
}

// weld-vertices LAYER A B
ScriptStep readWeldVertices(ScriptWords& words) {
  return onVertices<2>(words, [](std::uint32_t layer, const auto& v, HairMesh& mesh) {
    weldVertices(layer, v[0], v[1], mesh);
  });
}

// weld-edges LAYER A B C D
ScriptStep readWeldEdges(ScriptWords& words) {
  return onVertices<4>(words, [](std::uint32_t layer, const auto& v, HairMesh& mesh) {
    weldEdges(layer, {v[0], v[1]}, {v[2], v[3]}, mesh);
  });
}

void requireBundle(const Workshop& w, std::uint32_t bundle) {
  w.selected("all");
  require(bundle < w.mesh().bundleCount(), "there is no bundle ", bundle, "; there are ",
          w.mesh().bundleCount(), ", from 0");
}

// divide-face BUNDLE CORNER CORNER
ScriptStep readDivideFace(ScriptWords& words) {
  const std::uint32_t bundle = words.whole("bundle", 0, kAnyNumber);
  const std::uint32_t a = words.whole("corner", 0, kAnyNumber);
  const std::uint32_t b = words.whole("corner", 0, kAnyNumber);
  return [=](Workshop& w) {
    requireBundle(w, bundle);
    w.requireRoom(2 * w.mesh().layerCount(), 0);
    divideFace(bundle, a, b, w.mesh());
    std::vector<std::uint32_t> from(w.mesh().bundleCount());
    for (std::uint32_t j = 0; j + 1 < from.size(); ++j) from[j] = j;
    from.back() = bundle;
    w.renumber(from);
    w.afterGeometry();
  };
}

// divide-edge BUNDLE CORNER
ScriptStep readDivideEdge(ScriptWords& words) {
  const std::uint32_t bundle = words.whole("bundle", 0, kAnyNumber);
  const std::uint32_t corner = words.whole("corner", 0, kAnyNumber);
  return [=](Workshop& w) {
    requireBundle(w, bundle);
    w.requireRoom(2 * w.mesh().layerCount(), 0);
    divideEdge(bundle, corner, w.mesh());
    w.afterGeometry();
  };
}

// subdivide catmull-clark | loop [flat]
ScriptStep readSubdivide(ScriptWords& words) {
  const bool loop = words.take("loop");
  words.expect(loop || words.take("catmull-clark"), "a subdivision is `catmull-clark` or `loop`");
  const bool smooth = !words.take("flat");
  return [=](Workshop& w) {
    w.selected("all");
    w.requireRoom(3 * usedCorners(w.mesh()), 3 * w.mesh().layerCount());
    const std::vector<std::uint32_t> first =
        subdivide(loop ? Subdivision::Loop : Subdivision::CatmullClark, smooth, w.mesh());
    std::vector<std::uint32_t> from;
    for (std::uint32_t j = 0; j + 1 < first.size(); ++j) from.resize(first[j + 1], j);
    w.renumber(from);
    w.afterGeometry();
  };
}

}  // namespace

std::span<const ScriptCommand> topologyCommands() {
  static constexpr ScriptCommand kCommands[] = {{"extrude", readExtrude},
                                                {"delete", readDelete},
                                                {"insert", readInsert},
                                                {"remove", readRemove},
                                                {"separate", readSeparate},
                                                {"separate-vertices", readSeparateVertices},
                                                {"separate-edge", readSeparateEdge},
                                                {"weld", readWeld},
                                                {"weld-vertices", readWeldVertices},
                                                {"weld-edges", readWeldEdges},
                                                {"divide-face", readDivideFace},
                                                {"divide-edge", readDivideEdge},
                                                {"subdivide", readSubdivide}};
  return kCommands;
}

}  // namespace hair
