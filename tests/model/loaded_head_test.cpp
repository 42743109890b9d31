// Heads of somebody's own: in any unit and axes, with floors and rooms around them.
#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/geometry/mesh_parts.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/model/loaded_head.h>

namespace hair {
namespace {

const glm::vec3 kStands(0.1f, 1.55f, -0.3f);  // where a model has its head

const TriangleMesh& bust() {
  static const TriangleMesh moved = [] {
    TriangleMesh mesh = builtinHead().mesh;
    for (glm::vec3& p : mesh.positions) p += kStands;
    return mesh;
  }();
  return moved;
}

const std::vector<glm::vec3>& roots() {
  static const std::vector<glm::vec3> all = [] {
    std::vector<glm::vec3> found;
    for (glm::vec3 p : bust().positions)
      if (scalpMask(p - kStands) > 0.5f) found.push_back(p);
    return found;
  }();
  return all;
}

TriangleMesh inUnits(TriangleMesh mesh, const ReadOptions& units) {
  convertUnitsBack(mesh.positions, units.scale, units.up);
  convertUnitsBack(mesh.normals, 1, units.up);
  return mesh;
}

void addQuad(TriangleMesh& mesh, glm::vec3 corner, glm::vec3 u, glm::vec3 v, int n = 1) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto row = static_cast<std::uint32_t>(n + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      mesh.positions.push_back(corner + static_cast<float>(i) / static_cast<float>(n) * u +
                               static_cast<float>(j) / static_cast<float>(n) * v);
      mesh.normals.emplace_back(0, 1, 0);
    }
  for (std::uint32_t i = 0; i + 1 < row; ++i)
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = first + i * row + j;
      mesh.triangles.emplace_back(a, a + 1, a + row);
      mesh.triangles.emplace_back(a + row, a + 1, a + row + 1);
    }
}

LoadedHead load(TriangleMesh mesh, const ReadOptions& hair = {1, UpAxis::Y},
                const ReadOptions& read = {}) {
  std::vector<TriangleMesh> meshes;
  meshes.push_back(std::move(mesh));
  return loadedHead(std::move(meshes), {roots(), hair}, read);
}

void expectBuiltin(const LoadedHead& loaded, const std::string& of) {
  SCOPED_TRACE(of);
  static const TriangleMesh expected = load(bust()).head.mesh;
  ASSERT_EQ(loaded.head.mesh.positions.size(), expected.positions.size());
  ASSERT_EQ(loaded.head.mesh.triangles.size(), expected.triangles.size());
  float worst = 0;
  for (std::size_t v = 0; v < expected.positions.size(); ++v)
    worst = std::max(worst,
                     glm::distance(loaded.head.mesh.positions[v], expected.positions[v]) +
                         0.01f * glm::distance(loaded.head.mesh.normals[v], expected.normals[v]));
  EXPECT_LT(worst, 1e-5f);
}

constexpr UpAxis kAxes[] = {UpAxis::Y, UpAxis::Z, UpAxis::ZBack, UpAxis::X, UpAxis::YDown};

TEST(LoadedHead, HasTheUnitsAndAxesOfItsHair) {
  for (const float scale : {1.0f, 0.37f, 0.001f})
    for (const UpAxis up : kAxes) {
      const ReadOptions units{scale, up};
      expectBuiltin(load(inUnits(bust(), units), units), text(scale, ' ', wordOf(up)));
    }
}

TEST(LoadedHead, HasTheUnitsThatAreStatedForIt) {
  const ReadOptions units{0.01f, UpAxis::X};
  expectBuiltin(load(inUnits(bust(), units), {1, UpAxis::Z}, units), "both");
  const ReadOptions half{0, UpAxis::X};
  expectBuiltin(load(inUnits(bust(), units), {0.01f, UpAxis::Z}, half), "the axes alone");
}

TEST(LoadedHead, InMetresUnderHairOfOtherUnitsIsTakenAsMetres) {
  const LoadedHead loaded = load(bust(), {0.01f, UpAxis::ZBack});
  expectBuiltin(loaded, "metres");
  ASSERT_EQ(loaded.notes.size(), 2u);  // and the shoulders
  EXPECT_NE(loaded.notes[0].find("1 m a unit, +Y up"), std::string::npos) << loaded.notes[0];
}

TEST(LoadedHead, ThatDoesNotFitIsToldWhatWould) {
  for (const float scale : {0.0254f})
    for (const UpAxis up : kAxes) {
      std::string message;
      try {
        load(inUnits(bust(), {scale, up}));
      } catch (const Error& e) {
        message = e.what();
      }
      const std::string advice = text("--head-scale ", scale, " --head-up ", wordOf(up));
      EXPECT_NE(message.find(advice), std::string::npos) << message << "\nwanted " << advice;
    }
  // Hair that is in centimetres itself.
  std::vector<glm::vec3> large = roots();
  for (glm::vec3& p : large) p *= 100.0f;
  try {
    loadedHead({inUnits(bust(), {0.01f, UpAxis::Y})}, {large, {1, UpAxis::Y}});
    FAIL() << "a head of 20 m";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("--scale: 0.01 times"), std::string::npos) << e.what();
  }
  // Somebody else's.
  TriangleMesh far = bust();
  for (glm::vec3& p : far.positions) p += glm::vec3(0.5f, 0.7f, 0);
  EXPECT_THROW(load(far), Error);
  // A helmet's worth away it is a note.
  TriangleMesh near = bust();
  for (glm::vec3& p : near.positions) p = kStands + 0.6f * (p - kStands);
  const LoadedHead loaded = load(near);
  EXPECT_NE(loaded.notes.at(0).find("from the hair's roots"), std::string::npos);
}

TEST(LoadedHead, WhatStandsAroundItIsLeftOut) {
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  TriangleMesh stray = bust();
  stray.positions.push_back({100, 100, 100});
  stray.normals.push_back(y);
  expectBuiltin(load(stray), "a stray vertex");
  for (const int n : {1, 40}) {
    TriangleMesh floor = bust();
    addQuad(floor, {-5, 0, -5}, 10.0f * z, 10.0f * x, n);
    expectBuiltin(load(floor), "a floor");
    TriangleMesh room = floor;
    addQuad(room, {-5, 3, -5}, 10.0f * x, 10.0f * z, n);
    addQuad(room, {-5, 0, -5}, 10.0f * x, 3.0f * y, n);
    addQuad(room, {-5, 0, -5}, 3.0f * y, 10.0f * z, n);
    addQuad(room, {1, 0, 0.5f}, 0.3f * x, 0.3f * z, n);  // a chair
    expectBuiltin(load(room), "a room");
    const ReadOptions units{0.01f, UpAxis::ZBack};
    expectBuiltin(load(inUnits(room, units), units), "turned");
  }
  // Eyes stay, though no hair grows on them.
  TriangleMesh eyes = bust();
  const std::size_t triangles = load(bust()).head.mesh.triangles.size();
  addQuad(eyes, kStands + glm::vec3(0.02f, 0.06f, 0.07f), 0.02f * x, 0.02f * y);
  EXPECT_EQ(load(eyes).head.mesh.triangles.size(), triangles + 2);
}

TEST(LoadedHead, WhatMovesWithItHasItsUnitsAndPlace) {
  const ReadOptions units{0.01f, UpAxis::ZBack};
  TriangleMesh eye;
  addQuad(eye, kStands, {0.01f, 0, 0}, {0, 0.01f, 0});
  const LoadedHead loaded =
      loadedHead({inUnits(bust(), units), inUnits(eye, units)}, {roots(), units});
  ASSERT_EQ(loaded.others.size(), 1u);
  EXPECT_LT(glm::length(loaded.others[0].positions[0] - loaded.headFromHair.point(kStands)), 1e-5f);
  EXPECT_LT(glm::length(loaded.headFromHair.translation + kStands), 1e-4f);
}

TEST(MeshParts, AreConnectedThroughPositions) {
  TriangleMesh mesh = bust();
  EXPECT_EQ(partsOf(mesh).count, 1u);
  addQuad(mesh, {5, 5, 5}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(partsOf(mesh).count, 2u);
  EXPECT_EQ(partsOf(mesh).of.back(), 1u);
  // Every triangle with vertices of its own is as connected as before.
  TriangleMesh seams;
  for (const glm::uvec3& t : mesh.triangles) {
    seams.triangles.emplace_back(glm::uvec3(static_cast<std::uint32_t>(seams.positions.size())) +
                                 glm::uvec3(0, 1, 2));
    for (int k = 0; k < 3; ++k) seams.positions.push_back(mesh.positions[t[k]]);
  }
  EXPECT_EQ(partsOf(seams).of, partsOf(mesh).of);
}

TEST(MeshParts, AVertexWithoutATriangleIsNoSurface) {
  const MeshSdf alone(bust(), 0.01f, 0.03f);
  TriangleMesh mesh = bust();
  mesh.positions.push_back({1000, 0, 0});
  const MeshSdf sdf(mesh, 0.01f, 0.03f);
  EXPECT_EQ(sdf.nodes(), alone.nodes());
  EXPECT_EQ(sdf.distance(kStands), alone.distance(kStands));
}

}  // namespace
}  // namespace hair
