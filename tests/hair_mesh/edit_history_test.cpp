#include <libhair/hair_mesh/edit_history.h>

#include <stdexcept>

#include <tests/hair_mesh/small_cases.h>

namespace hair {
namespace {

using test::identical;

// Moves vertex 0 of layer 1 to a height, so that steps can be told apart.
auto heightOf(float y) {
  return [y](HairMesh& mesh) { mesh.layers[1].positions[0].y = y; };
}
float height(const HairMeshHistory& history) {
  return history.current().layers[1].positions[0].y;
}

HairMesh grown() {
  return test::stack(test::gridScalp(2, 1), 1);
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "nothing was thrown";
}

TEST(HairMeshHistory, GoesBackAndForth) {
  HairMeshHistory history(grown());
  EXPECT_FALSE(history.canUndo());
  EXPECT_FALSE(history.canRedo());
  history.apply(heightOf(1));
  history.apply(heightOf(2));
  history.undo();
  EXPECT_EQ(height(history), 1);
  EXPECT_TRUE(history.canRedo());
  history.undo();
  EXPECT_TRUE(identical(history.current(), grown()));
  EXPECT_EQ(messageOf([&] { history.undo(); }), "nothing to undo");
  history.redo();
  history.redo();
  EXPECT_EQ(height(history), 2);
  EXPECT_EQ(messageOf([&] { history.redo(); }), "nothing to redo");
}

TEST(HairMeshHistory, ForgetsWhatWasUndoneWhenEditedOn) {
  HairMeshHistory history(grown());
  history.apply(heightOf(1));
  history.apply(heightOf(2));
  history.undo();
  history.apply(heightOf(3));
  EXPECT_FALSE(history.canRedo());
  history.undo();
  EXPECT_EQ(height(history), 1);
}

TEST(HairMeshHistory, KeepsTheLastStepsOnly) {
  HairMeshHistory history(grown(), 3);
  for (int i = 1; i <= 10; ++i) history.apply(heightOf(float(i)));
  int steps = 0;
  for (; history.canUndo(); ++steps) history.undo();
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(height(history), 7);
  HairMeshHistory none(grown(), 0);
  none.apply(heightOf(1));
  EXPECT_FALSE(none.canUndo());
  EXPECT_EQ(height(none), 1);
}

TEST(HairMeshHistory, IsUnchangedByAnEditThatThrowsOrBreaksTheMesh) {
  HairMeshHistory history(grown());
  history.apply(heightOf(1));
  history.apply(heightOf(2));
  history.undo();
  EXPECT_EQ(messageOf([&] {
              history.apply([](HairMesh& mesh) {
                heightOf(3)(mesh);
                throw std::runtime_error("no more");
              });
            }),
            "no more");
  EXPECT_EQ(
      messageOf([&] { history.apply([](HairMesh& mesh) { mesh.lastLayer[0] = 0; }); }),
      "hair mesh after the edit: layer 1, face of bundle 0: is there, and lastLayer says that "
      "the tip is in layer 0");
  EXPECT_EQ(height(history), 1);
  history.redo();
  EXPECT_EQ(height(history), 2);
}

TEST(HairMeshHistory, BeginsWithAValidMesh) {
  EXPECT_EQ(messageOf([] { HairMeshHistory history((HairMesh())); }),
            "hair mesh: no layers: there is no scalp");
}

}  // namespace
}  // namespace hair
