#include <apps/common/mesh_editor.h>

#include <gtest/gtest.h>

#include <apps/draw/camera.h>
#include <libhair/core/error.h>
#include <libhair/hair_mesh/exterior.h>
#include <libhair/hair_mesh/surface.h>
#include <tests/hair_mesh/sample_meshes.h>

namespace hair {
namespace {

const glm::vec2 kSize(800, 600);

MeshHair sample() {
  MeshHair hair;
  hair.mesh = test::stack(test::gridScalp(4, 4), 3);
  hair.groups = {{.strands = 200, .points = 12}};
  hair.grown = growHair(hair.mesh, hair.groups);
  return hair;
}

// From above and one side, so that vertices do not stand behind each other.
glm::mat4 clipFromHead() {
  draw::Camera camera;
  camera.target = {0.04f, 0.05f, 0.04f};
  camera.distance = 0.4f;
  camera.yaw = 0.4f;
  camera.pitch = 0.5f;
  return camera.clipFromView(kSize.x / kSize.y) * camera.viewFromWorld();
}

glm::vec2 pixelOf(glm::vec3 p) {
  const glm::vec4 clip = clipFromHead() * glm::vec4(p, 1);
  return kSize * (0.5f + 0.5f * glm::vec2(clip.x, -clip.y) / clip.w);
}

TEST(MeshEditor, PicksExteriorVerticesUnderTheCursorAndNothingBesideThem) {
  const MeshEditor editor(sample());
  const HairMesh& mesh = editor.hair().mesh;
  const auto exterior = exteriorVertices(mesh);
  for (std::uint32_t k = 1; k < mesh.layerCount(); ++k)
    for (std::uint32_t v = 0; v < mesh.layers[k].vertexCount(); ++v) {
      const glm::vec2 at = pixelOf(mesh.layers[k].positions[v]);
      const auto picked = editor.pick(clipFromHead(), kSize, at, 1);
      if (exterior[k][v])
        EXPECT_EQ(picked, (HairMeshVertex{k, v}));
      else
        EXPECT_FALSE(picked.has_value()) << "an interior vertex";
    }
  EXPECT_FALSE(editor.pick(clipFromHead(), kSize, {2, 2}).has_value());
}

TEST(MeshEditor, ADraggedVertexIsUnderTheCursorAsFarAwayAsItWas) {
  MeshEditor editor(sample());
  const HairMeshVertex vertex{3, 4};
  const glm::vec3 before = editor.hair().mesh.layers[3].positions[4];
  const glm::vec2 to = pixelOf(before) + glm::vec2(40, -25);
  editor.drag(vertex, clipFromHead(), kSize, to);
  const glm::vec3 after = editor.hair().mesh.layers[3].positions[4];
  EXPECT_LT(glm::distance(pixelOf(after), to), 0.01f);
  EXPECT_NEAR((clipFromHead() * glm::vec4(after, 1)).w, (clipFromHead() * glm::vec4(before, 1)).w,
              1e-5f);
}

TEST(MeshEditor, InteriorVerticesAndStrandsFollowAndComeBackWithUndo) {
  MeshEditor editor(sample());
  // An edge of layer 2 from the outside in: vertices follow those that they share an edge with.
  const auto exterior = exteriorVertices(editor.hair().mesh);
  HairMeshVertex outside, inside;
  for (const auto& [a, b] : linesOf(editor.hair().mesh)) {
    if (a.layer != 2 || b.layer != 2 || exterior[2][a.vertex] == exterior[2][b.vertex]) continue;
    outside = exterior[2][a.vertex] ? a : b;
    inside = exterior[2][a.vertex] ? b : a;
  }
  const auto at = [&](HairMeshVertex v) {
    return editor.hair().mesh.layers[v.layer].positions[v.vertex];
  };
  const glm::vec3 place = at(outside);
  const MeshHair before = editor.hair();
  const glm::vec3 insideBefore = at(inside);
  editor.moveTo(outside, place + glm::vec3(-0.02f, 0.01f, -0.02f));
  editor.drop();
  EXPECT_GT(glm::distance(at(inside), insideBefore), 1e-3f);
  EXPECT_NE(editor.hair().grown.strands.points, before.grown.strands.points);
  EXPECT_TRUE(editor.placement().converged);

  editor.undo();
  EXPECT_EQ(at(outside), place);
  EXPECT_EQ(at(inside), insideBefore);
  EXPECT_EQ(editor.hair().grown.strands.points, before.grown.strands.points);
  EXPECT_TRUE(editor.canRedo());
  editor.redo();
  EXPECT_FALSE(editor.canRedo());
  EXPECT_NE(at(outside), place);
}

TEST(MeshEditor, AClickIsNoStepAndWhatCannotBeIsTakenBack) {
  MeshEditor editor(sample());
  editor.drop();
  EXPECT_FALSE(editor.canUndo());
  const std::vector<glm::vec3> before = editor.hair().grown.strands.points;
  EXPECT_THROW(editor.moveTo({1, 0}, {NAN, 0, 0}), Error);
  EXPECT_THROW(editor.moveTo({9, 0}, {0, 0, 0}), Error);
  EXPECT_EQ(editor.hair().grown.strands.points, before);
  editor.moveTo({1, 0}, {0, 0.2f, 0});
  EXPECT_NE(editor.hair().grown.strands.points, before);
  editor.cancel();
  EXPECT_EQ(editor.hair().grown.strands.points, before);
  EXPECT_FALSE(editor.canUndo());
}

}  // namespace
}  // namespace hair
