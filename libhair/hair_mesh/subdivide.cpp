#include <cmath>
#include <numbers>

#include <libhair/hair_mesh/edit-inl.h>
#include <libhair/hair_mesh/operations.h>

namespace hair {

namespace {

// Origin of a new corner: an old corner's vertex, the edge that starts there, or its face.
enum class Source : std::uint8_t { Vertex, Edge, Face };

// The same for all layers.
struct Pattern {
  struct Corner {
    Source source;
    std::uint32_t corner;
  };
  std::vector<Corner> corners;
  std::vector<std::uint32_t> firstCorner = {0};
  std::vector<std::uint32_t> first = {0};  // parts of each old bundle

  void addFace(std::initializer_list<Corner> face) {
    corners.insert(corners.end(), face);
    firstCorner.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

Pattern patternOf(Subdivision rule, const HairMesh& mesh) {
  using enum Source;
  Pattern pattern;
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
    const std::uint32_t begin = mesh.firstCorner[j], sides = mesh.sides(j);
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t c = begin + i, before = begin + (i + sides - 1) % sides;
      if (rule == Subdivision::CatmullClark)
        pattern.addFace({{Vertex, c}, {Edge, c}, {Face, c}, {Edge, before}});
      else
        pattern.addFace({{Vertex, c}, {Edge, c}, {Edge, before}});
    }
    if (rule == Subdivision::Loop)
      pattern.addFace({{Edge, begin}, {Edge, begin + 1}, {Edge, begin + 2}});
    pattern.first.push_back(static_cast<std::uint32_t>(pattern.firstCorner.size() - 1));
  }
  return pattern;
}

// What the rules read of a layer. Sums in double, in the order of edges and corners.
struct Surface {
  const HairMesh& mesh;
  const CornerTable& table;
  const HairMesh::Layer& layer;
  std::vector<LayerEdge> edges;
  std::vector<glm::dvec3> centres;  // [bundleCount], of faces

  Surface(const HairMesh& m, const CornerTable& t, std::size_t k)
      : mesh(m),
        table(t),
        layer(m.layers[k]),
        edges(edgesOf(t, layer.corners)),
        centres(m.bundleCount(), glm::dvec3(0)) {
    for (std::size_t j = 0; j < m.bundleCount(); ++j) {
      if (m.lastLayer[j] < k) continue;
      for (const std::uint32_t v : m.face(k, j)) centres[j] += point(v);
      centres[j] /= double(m.sides(j));
    }
  }
  glm::dvec3 point(std::uint32_t v) const { return layer.positions[v]; }
  glm::dvec3 middle(const LayerEdge& e) const { return 0.5 * (point(e.a) + point(e.b)); }
  glm::dvec3 centreAt(std::uint32_t corner) const { return centres[table.bundle[corner]]; }
  // Of the triangle whose edge starts at the corner.
  glm::dvec3 opposite(std::uint32_t corner) const {
    return point(layer.corners[table.next[table.next[corner]]]);
  }
};

glm::dvec3 smoothEdge(Subdivision rule, const Surface& s, const LayerEdge& e) {
  if (!e.isInner()) return s.middle(e);
  if (rule == Subdivision::CatmullClark)
    return 0.5 * s.middle(e) + 0.25 * (s.centreAt(e.corner) + s.centreAt(e.other));
  return 0.75 * s.middle(e) + 0.125 * (s.opposite(e.corner) + s.opposite(e.other));
}

// Inside a layer: with n neighbours, F and N the means of faces and neighbours around,
//   Catmull-Clark  ((n - 2) P + F + N) / n,  which is (F + 2R + (n - 3) P) / n, R of edges' middles
//   Loop           (1 - n b) P + n b N,  n b = 5/8 - (3/8 + cos(2 pi / n) / 4)^2
// On the boundary, both: 3/4 P and 1/8 of each neighbour along it, the cubic B-spline.
std::vector<glm::dvec3> smoothVertices(Subdivision rule, const Surface& s) {
  struct Around {
    glm::dvec3 neighbours = glm::dvec3(0), faces = glm::dvec3(0), boundary = glm::dvec3(0);
    int edges = 0;
    bool isBoundary = false;
  };
  std::vector<Around> around(s.layer.vertexCount());
  for (const LayerEdge& e : s.edges)
    for (const auto& [v, other] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
      around[v].neighbours += s.point(other);
      ++around[v].edges;
      if (e.isInner()) continue;
      around[v].boundary += s.point(other);
      around[v].isBoundary = true;
    }
  for (std::uint32_t c = 0; c < s.layer.corners.size(); ++c)
    if (s.layer.corners[c] != kNoVertex) around[s.layer.corners[c]].faces += s.centreAt(c);

  std::vector<glm::dvec3> places;
  for (std::uint32_t v = 0; v < around.size(); ++v) {
    const Around& a = around[v];
    const double n = a.edges;
    if (a.isBoundary) {
      places.push_back(0.75 * s.point(v) + 0.125 * a.boundary);
    } else if (rule == Subdivision::CatmullClark) {
      places.push_back(((n - 2) * s.point(v) + (a.faces + a.neighbours) / n) / n);
    } else {
      const double inner = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
      const double share = 0.625 - inner * inner;
      places.push_back((1 - share) * s.point(v) + share / n * a.neighbours);
    }
  }
  return places;
}

// Orders the new vertices: those of old vertices, then of edges, then (Catmull-Clark) of faces.
HairMesh::Layer subdivideLayer(Subdivision rule, bool smooth, const Surface& s,
                               const Pattern& pattern, std::size_t k) {
  HairMesh::Layer fine;
  const std::vector<std::uint32_t>& corners = s.layer.corners;
  if (smooth)
    for (const glm::dvec3& place : smoothVertices(rule, s)) fine.positions.emplace_back(place);
  else
    fine.positions = s.layer.positions;

  std::vector<std::uint32_t> edgeVertex(corners.size(), kNoVertex);  // of the edge from a corner
  for (const LayerEdge& e : s.edges) {
    edgeVertex[e.corner] = static_cast<std::uint32_t>(fine.positions.size());
    if (e.isInner()) edgeVertex[e.other] = edgeVertex[e.corner];
    fine.positions.emplace_back(smooth ? smoothEdge(rule, s, e) : s.middle(e));
  }
  std::vector<std::uint32_t> faceVertex(s.mesh.bundleCount(), kNoVertex);
  if (rule == Subdivision::CatmullClark)
    for (std::size_t j = 0; j < faceVertex.size(); ++j) {
      if (s.mesh.lastLayer[j] < k) continue;
      faceVertex[j] = static_cast<std::uint32_t>(fine.positions.size());
      fine.positions.emplace_back(s.centres[j]);
    }
  for (const auto& [source, c] : pattern.corners)
    fine.corners.push_back(source == Source::Vertex ? corners[c]
                           : source == Source::Edge ? edgeVertex[c]
                                                    : faceVertex[s.table.bundle[c]]);
  fine.pinned = s.layer.pinned;
  fine.pinned.resize(fine.positions.size(), 0);
  return fine;
}

}  // namespace

std::vector<std::uint32_t> subdivide(Subdivision rule, bool smooth, HairMesh& mesh) {
  Pattern pattern;
  editCopy(mesh, [&](HairMesh& m) {
    if (rule == Subdivision::Loop)
      for (std::size_t j = 0; j < m.bundleCount(); ++j)
        require(m.sides(j) == 3, "Loop's subdivision needs triangles, and bundle ", j, " has ",
                m.sides(j), " sides; divide its face, or use Catmull-Clark");
    pattern = patternOf(rule, m);
    HairMesh fine;
    const CornerTable table(m);
    for (std::size_t k = 0; k < m.layerCount(); ++k)
      fine.layers.push_back(subdivideLayer(rule, smooth, Surface(m, table, k), pattern, k));
    fine.firstCorner = pattern.firstCorner;
    for (std::size_t j = 0; j < m.bundleCount(); ++j)
      fine.lastLayer.insert(fine.lastLayer.end(), pattern.first[j + 1] - pattern.first[j],
                            m.lastLayer[j]);
    rejoinFrom(0, fine);
    m = std::move(fine);
  });
  return pattern.first;
}

}  // namespace hair
