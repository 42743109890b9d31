#include <set>

#include <gtest/gtest.h>

#include <libhair/hair_mesh/edit_history.h>
#include <tests/hair_mesh/random_edits.h>
#include <tests/hair_mesh/same_mesh.h>
#include <tests/hair_mesh/scalps.h>

// Laws that hold for every mesh that operations lead to: random sequences of all of them.
namespace hair {
namespace {

using test::Draw;
using test::identical;
using test::Operation;
using test::Unnumbered;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint32_t kSequences = 200;
#else
constexpr std::uint32_t kSequences = 2000;
#endif
constexpr std::uint32_t kShortRun = kSequences / 10;  // for laws that try more at each mesh
constexpr int kOperations = 12;                       // a sequence

const std::vector<PolygonMesh>& scalps() {
  static const std::vector<PolygonMesh> all = {test::gridScalp(3, 3), test::ballScalp(2),
                                               test::triangleScalp(2, 2), test::mixedScalp(),
                                               test::gridScalp(1, 1)};
  return all;
}

// Beyond this size a mesh only shrinks, or time is spent on the same again.
bool mayGrow(const HairMesh& mesh) {
  return mesh.cornerCount() < 120 && mesh.layerCount() < 7;
}

bool grows(Operation operation) {
  return operation == Operation::Extrude || operation == Operation::InsertLayer ||
         operation == Operation::DivideFace || operation == Operation::DivideEdge ||
         operation == Operation::Subdivide;
}

// Extrusion more than others, as without layers there is nothing to try, and cuts, to be welded.
std::optional<Operation> drawOperation(Draw& draw, const HairMesh& mesh) {
  const auto operation = draw.oneIn(3)   ? Operation::Extrude
                         : draw.oneIn(6) ? Operation::SeparateEdges
                                         : Operation(draw.below(test::kOperationCount));
  if (grows(operation) && !mayGrow(mesh)) return {};
  if (operation == Operation::Subdivide && mesh.cornerCount() > 60) return {};
  return operation;
}

// Calls visit(mesh, draw) after every operation of every sequence.
template <class Visit>
void visitMeshes(Visit visit) {
  for (std::uint32_t sequence = 0; sequence < kShortRun; ++sequence) {
    SCOPED_TRACE(testing::Message() << "sequence " << sequence);
    Draw draw(sequence + 1'000'000);
    HairMesh mesh = makeHairMesh(scalps()[sequence % scalps().size()]);
    for (int i = 0; i < kOperations; ++i) {
      const auto operation = drawOperation(draw, mesh);
      try {
        if (operation) test::apply(*operation, draw, mesh);
      } catch (const Error&) {
      }
      if (draw.oneIn(2)) test::moveSome(draw, mesh);
      visit(std::as_const(mesh), draw);
      if (testing::Test::HasFailure()) return;
    }
  }
}

// The scalp's faces that share a vertex, as pairs of bundles.
std::set<std::pair<std::size_t, std::size_t>> neighbours(const HairMesh& mesh, std::size_t layer) {
  std::vector<std::vector<std::size_t>> around(mesh.layers[layer].vertexCount());
  for (std::size_t j = 0; j < mesh.bundleCount(); ++j)
    if (mesh.lastLayer[j] >= layer)
      for (const std::uint32_t v : mesh.face(layer, j)) around[v].push_back(j);
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& bundles : around)
    for (const std::size_t a : bundles)
      for (const std::size_t b : bundles)
        if (a < b) pairs.emplace(a, b);
  return pairs;
}

// Vertices, edges, faces of the prisms, sides and prisms of the volume, counted with signs.
std::ptrdiff_t eulerNumber(const HairMesh& mesh, bool volume) {
  std::ptrdiff_t number = 0;
  for (std::size_t k = 0; k < (volume ? mesh.layerCount() : 1); ++k) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::set<std::array<std::uint32_t, 4>> sideQuads;  // between the edges of two layers
    std::ptrdiff_t faces = 0;
    for (std::size_t j = 0; j < mesh.bundleCount(); ++j) {
      if (mesh.lastLayer[j] < k) continue;
      ++faces;
      for (std::uint32_t c = mesh.firstCorner[j]; c < mesh.firstCorner[j + 1]; ++c) {
        const HairMeshEdge side = test::sideOf(mesh, k, c);
        edges.insert(std::minmax(side.a, side.b));
        if (k == 0) continue;
        const HairMeshEdge under = test::sideOf(mesh, k - 1, c);
        if (side.a < side.b)
          sideQuads.insert({side.a, side.b, under.b, under.a});
        else
          sideQuads.insert({side.b, side.a, under.a, under.b});
      }
    }
    const auto vertices = std::ptrdiff_t(mesh.layers[k].vertexCount());
    number += vertices - std::ptrdiff_t(edges.size()) + faces;
    if (k > 0) number += std::ptrdiff_t(sideQuads.size()) - vertices - faces;  // uprights, prisms
  }
  return number;
}

TEST(HairMeshLaws, EveryOperationLeavesAValidMeshOrNothingChanged) {
  std::array<int, test::kOperationCount> done = {}, refused = {};
  for (std::uint32_t sequence = 0; sequence < kSequences; ++sequence) {
    Draw draw(sequence);
    HairMesh mesh = makeHairMesh(scalps()[sequence % scalps().size()]);
    for (int i = 0; i < kOperations; ++i) {
      const auto operation = drawOperation(draw, mesh);
      if (!operation) continue;
      const HairMesh before = mesh;
      const auto o = static_cast<std::size_t>(*operation);
      const std::string where =
          text("sequence ", sequence, ", operation ", i, ": ", test::kOperationNames[o]);
      try {
        test::apply(*operation, draw, mesh);
        ++done[o];
        ASSERT_FALSE(identical(before, mesh)) << where;
      } catch (const Error& e) {
        ++refused[o];
        ASSERT_TRUE(identical(before, mesh)) << where;
        ASSERT_GT(std::string_view(e.what()).size(), 15u) << where;
        // Reasons are about the arguments; the result alone says why a divided face is none, or a
        // triangle of Loop.
        ASSERT_TRUE(!std::string_view(e.what()).starts_with("hair mesh ") ||
                    operation == Operation::DivideFace || operation == Operation::Subdivide)
            << where << ": " << e.what();
      }
      ASSERT_EQ(whyInvalid(mesh), "") << where;
      if (draw.oneIn(2)) test::moveSome(draw, mesh);
    }
  }
  for (std::size_t o = 0; o < test::kOperationCount; ++o) {
    RecordProperty(test::kOperationNames[o], done[o]);
    std::printf("%-18s %6d done, %6d refused\n", test::kOperationNames[o], done[o], refused[o]);
    EXPECT_GT(done[o], int(kSequences) / 20) << test::kOperationNames[o];
    EXPECT_GT(refused[o], 0) << test::kOperationNames[o];
  }
}

TEST(HairMeshLaws, FacesAreNeighboursOnlyIfTheyAreOnTheScalp) {
  visitMeshes([](const HairMesh& mesh, Draw&) {
    for (std::size_t k = 1; k < mesh.layerCount(); ++k) {
      const auto above = neighbours(mesh, k), below = neighbours(mesh, k - 1);
      ASSERT_TRUE(std::includes(below.begin(), below.end(), above.begin(), above.end()));
    }
  });
}

TEST(HairMeshLaws, EdgesNeverCollapseAndTheVolumeHasTheScalpsGenus) {
  visitMeshes([](const HairMesh& mesh, Draw&) {
    for (std::size_t k = 1; k < mesh.layerCount(); ++k)
      for (std::uint32_t c = 0; c < mesh.cornerCount(); ++c) {
        if (mesh.layers[k].corners[c] == kNoVertex) continue;
        const HairMeshEdge side = test::sideOf(mesh, k, c);
        ASSERT_NE(mesh.layers[k].below[side.a], mesh.layers[k].below[side.b]);
      }
    ASSERT_EQ(eulerNumber(mesh, true), eulerNumber(mesh, false));
  });
}

TEST(HairMeshLaws, TheScalpStaysWhatItIsUnlessFacesOfItAreDividedOrDeleted) {
  for (std::uint32_t sequence = 0; sequence < kShortRun; ++sequence) {
    Draw draw(sequence);
    const HairMesh scalp = makeHairMesh(scalps()[sequence % scalps().size()]);
    HairMesh mesh = scalp;
    for (int i = 0; i < kOperations; ++i) {
      auto operation = Operation(draw.below(std::size_t(Operation::DivideFace)));
      if (operation == Operation::Delete) operation = Operation::Extrude;
      if (grows(operation) && !mayGrow(mesh)) continue;
      try {
        test::apply(operation, draw, mesh);
      } catch (const Error&) {
      }
      ASSERT_EQ(mesh.layers[0].corners, scalp.layers[0].corners);
      ASSERT_EQ(mesh.layers[0].positions, scalp.layers[0].positions);
    }
  }
}

// Of each layer, pairs of corners that start its inner edges.
std::vector<std::vector<std::array<std::uint32_t, 2>>> innerEdges(const HairMesh& mesh) {
  std::vector<std::vector<std::array<std::uint32_t, 2>>> edges(mesh.layerCount());
  for (std::size_t k = 0; k < mesh.layerCount(); ++k) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> starts;
    for (std::uint32_t c = 0; c < mesh.cornerCount(); ++c) {
      if (mesh.layers[k].corners[c] == kNoVertex) continue;
      const HairMeshEdge side = test::sideOf(mesh, k, c);
      if (const auto other = starts.find({side.b, side.a}); other != starts.end())
        edges[k].push_back({other->second, c});
      starts[{side.a, side.b}] = c;
    }
  }
  return edges;
}

TEST(HairMeshLaws, WeldingUndoesSeparating) {
  int tried = 0;
  visitMeshes([&](const HairMesh& mesh, Draw& draw) {
    HairMesh parted = mesh;
    try {
      test::apply(draw.oneIn(2) ? Operation::SeparateEdges : Operation::SeparateVertices, draw,
                  parted);
    } catch (const Error&) {
      return;
    }
    ++tried;
    ASSERT_NE(Unnumbered(parted), Unnumbered(mesh));
    const auto edges = innerEdges(mesh);
    for (std::size_t k = mesh.layerCount() - 1; k > 0; --k)
      for (const auto& [c, d] : edges[k]) {
        const HairMeshEdge x = test::sideOf(parted, k, c), y = test::sideOf(parted, k, d);
        if (x.a != y.b || x.b != y.a) weldEdges(k, x, y, parted);
      }
    ASSERT_EQ(Unnumbered(parted), Unnumbered(mesh));
  });
  EXPECT_GT(tried, int(kShortRun));
}

TEST(HairMeshLaws, RemovingUndoesInserting) {
  int tried = 0;
  visitMeshes([&](const HairMesh& mesh, Draw& draw) {
    if (mesh.layerCount() < 2) return;
    const auto [layer, bundle] = test::drawFace(mesh, draw);
    if (mesh.lastLayer[bundle] == 0) return;
    ++tried;
    HairMesh changed = mesh;
    insertLayer(layer, bundle, changed);
    ASSERT_EQ(changed.lastLayer[bundle], mesh.lastLayer[bundle] + 1);
    removeLayer(layer, bundle, changed);
    ASSERT_EQ(Unnumbered(changed), Unnumbered(mesh));
  });
  EXPECT_GT(tried, 5 * int(kShortRun));
}

// False where faces have no area: those between three corners of what was one edge.
bool extruded(std::span<const std::uint32_t> bundles, HairMesh& mesh) {
  try {
    extrudeFaces(bundles, 0.01f, mesh);
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(HairMeshLaws, DeletingUndoesExtruding) {
  int tried = 0;
  visitMeshes([&](const HairMesh& mesh, Draw& draw) {
    const auto bundles = test::drawBundles(mesh, draw);
    HairMesh changed = mesh;
    if (!extruded(bundles, changed)) return;
    deleteFaces(bundles, changed);
    ASSERT_EQ(Unnumbered(changed), Unnumbered(mesh));
    ++tried;
  });
  EXPECT_GT(tried, 5 * int(kShortRun));
}

TEST(HairMeshLaws, ExtrudingTipsOfALayerOneByOneIsExtrudingThemAtOnce) {
  int tried = 0;
  visitMeshes([&](const HairMesh& mesh, Draw& draw) {
    // Where others stand in the next layer already, it matters which of them a face meets first.
    const auto top = static_cast<std::uint32_t>(mesh.layerCount() - 1);
    std::vector<std::uint32_t> bundles;
    for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
      if (mesh.lastLayer[j] == top) bundles.push_back(j);
    HairMesh atOnce = mesh, oneByOne = mesh;
    if (bundles.size() < 2 || !extruded(bundles, atOnce)) return;
    for (std::size_t i = bundles.size(); i > 1; --i)
      std::swap(bundles[i - 1], bundles[draw.below(i)]);
    for (const std::uint32_t j : bundles) extruded({&j, 1}, oneByOne);
    ASSERT_EQ(Unnumbered(oneByOne), Unnumbered(atOnce));
    ++tried;
  });
  EXPECT_GT(tried, 4 * int(kShortRun));
}

TEST(HairMeshLaws, UndoAndRedoGiveBackEveryBit) {
  for (std::uint32_t sequence = 0; sequence < kShortRun; ++sequence) {
    Draw draw(sequence);
    HairMeshHistory history(makeHairMesh(scalps()[sequence % scalps().size()]));
    std::vector<HairMesh> states = {history.current()};
    for (int i = 0; i < kOperations; ++i) {
      const auto operation = drawOperation(draw, history.current());
      if (!operation) continue;
      try {
        history.apply([&](HairMesh& mesh) {
          test::moveSome(draw, mesh);
          test::apply(*operation, draw, mesh);
        });
        states.push_back(history.current());
      } catch (const Error&) {
        ASSERT_TRUE(identical(history.current(), states.back()));
      }
    }
    for (std::size_t i = states.size() - 1; i > 0; --i) {
      history.undo();
      ASSERT_TRUE(identical(history.current(), states[i - 1]));
    }
    EXPECT_FALSE(history.canUndo());
    for (std::size_t i = 1; i < states.size(); ++i) {
      history.redo();
      ASSERT_TRUE(identical(history.current(), states[i]));
    }
    EXPECT_FALSE(history.canRedo());
  }
}

}  // namespace
}  // namespace hair
