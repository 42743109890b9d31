// States of hair, saved and restored.

#include <sstream>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/random.h>

#include "scene.h"

namespace hair {
namespace {

using test::Scene;
using test::small;
using test::stateOf;

FrameSettings windy() {
  FrameSettings settings;
  settings.wind.velocity = {2, 0, 1};
  return settings;
}

void restoreFrom(const std::string& bytes, Hair& hair) {
  std::istringstream in(bytes);
  restoreState(in, hair);
}

TEST(HairState, ARestoredRunGoesOnWithTheSameBits) {
  Scene run(small(Style::Curly), Motion::dance(), windy());
  ASSERT_TRUE(run.settings.selfCollision);
  for (int f = 0; f < 21; ++f) run.step();
  const std::string saved = stateOf(run.hair);
  // Another hair, made elsewhere in the dance and in motion.
  Scene other(small(Style::Curly), Motion::dance(), windy());
  other.hair = Hair(other.groom, other.settings, other.bodyAt(5), &other.collider);
  for (int f = 0; f < 4; ++f) other.step();
  restoreFrom(saved, other.hair);
  EXPECT_TRUE(stateOf(other.hair) == saved);
  other.time = run.time;
  for (int f = 0; f < 20; ++f) run.step(), other.step();
  EXPECT_TRUE(stateOf(other.hair) == stateOf(run.hair));
  EXPECT_EQ(other.hair.colours, run.hair.colours);
}

TEST(HairState, NotAByteMoreIsReadThanWasWritten) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  const std::string first = stateOf(scene.hair);
  scene.step();
  const std::string second = stateOf(scene.hair);
  std::istringstream in(first + second + "and more");
  restoreState(in, scene.hair);
  EXPECT_TRUE(stateOf(scene.hair) == first);
  restoreState(in, scene.hair);
  EXPECT_TRUE(stateOf(scene.hair) == second);
  std::string rest;
  std::getline(in, rest);
  EXPECT_EQ(rest, "and more");
}

// Error, and the hair as it was.
void expectRefused(const std::string& bytes, const std::string& word, Hair& hair) {
  const std::string before = stateOf(hair);
  try {
    restoreFrom(bytes, hair);
    ADD_FAILURE() << "was taken; expected: " << word;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
  EXPECT_TRUE(stateOf(hair) == before);
}

TEST(HairState, OfAnotherGroomOrRestShapeIsRefused) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  Scene curly(small(Style::Curly), Motion::dance());
  expectRefused(stateOf(curly.hair), "another groom", scene.hair);
  FrameSettings stiff = Scene::simulationOnly();
  stiff.guides.bendingStiffness *= 2;
  Scene stiffer(small(Style::Smooth), Motion::dance(), stiff);
  expectRefused(stateOf(stiffer.hair), "another groom", scene.hair);
  StyleSettings shifted = small(Style::Smooth);
  shifted.strands += 1;
  Scene more(shifted, Motion::dance());
  expectRefused(stateOf(more.hair), "another groom", scene.hair);
}

TEST(HairState, ThatIsNoneOrOfALaterVersionIsRefused) {
  Scene scene(small(Style::Smooth), Motion::dance());
  std::string bytes = stateOf(scene.hair);
  expectRefused("", "truncated", scene.hair);
  expectRefused("HAIR" + std::string(124, '\1'), "HAIRSTAT", scene.hair);
  bytes[8] = 2;
  expectRefused(bytes, "version 2", scene.hair);
}

TEST(HairState, ThatIsCutShortIsRefused) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  const std::string bytes = stateOf(scene.hair);
  scene.step();
  for (std::uint32_t i = 0; i < 100; ++i)
    expectRefused(bytes.substr(0, static_cast<std::size_t>(static_cast<double>(bytes.size()) *
                                                           uniform(i, 0))),
                  "truncated", scene.hair);
  expectRefused(bytes.substr(0, bytes.size() - 1), "truncated", scene.hair);
}

TEST(HairState, OfWhichOneBitIsWrongIsRefused) {
  Scene scene(small(Style::Smooth), Motion::dance());
  scene.step();
  const std::string bytes = stateOf(scene.hair);
  scene.step();
  const auto flip = [&](std::size_t bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    expectRefused(damaged, "saved state", scene.hair);
  };
  for (std::size_t bit = 0; bit < 8 * 56; bit += 3) flip(bit);
  for (std::uint32_t i = 0; i < 100; ++i)
    flip(static_cast<std::size_t>(8.0 * static_cast<double>(bytes.size()) * uniform(i, 1)));
  flip(8 * bytes.size() - 1);
}

TEST(HairState, SavedWithoutSelfCollisionGoesOnWithIt) {
  FrameSettings off = Scene::simulationOnly();
  off.selfCollision = false;
  Scene without(small(Style::Smooth), Motion::dance(), off);
  Scene with(small(Style::Smooth), Motion::dance());
  for (int f = 0; f < 10; ++f) without.step(), with.step();
  restoreFrom(stateOf(without.hair), with.hair);
  with.time = without.time;
  with.step(), without.step();
  // The first frame feels no push yet.
  EXPECT_EQ(with.hash(), without.hash());
  with.step(), without.step();
  EXPECT_NE(with.hash(), without.hash());
}

}  // namespace
}  // namespace hair
