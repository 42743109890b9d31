// The exact bits of the built-in styles, pinned: any change of motion, shadow or colour shows here.
//
// A commit that means to change them prints new constants,
//
//   build/release/bin/test_golden --print
//
// puts them into kGolden, and says why.

#include <cstdio>
#include <cstring>
#include <ostream>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>
#include <libhair/core/state_hash.h>

#include "../frame/scene.h"

namespace hair {
namespace {

/// A hash for each array that a frame leaves behind.
struct Hashes {
  std::uint64_t guides, points, transmittance, colours;
  bool operator==(const Hashes&) const = default;
};

struct Golden {
  const char* name;
  Style style;
  Hashes hashes;
};

constexpr Golden kGolden[] = {
    {"smooth",
     Style::Smooth,
     {0x8051b3354d7f2972, 0x9feaa8a232dfc557, 0xd9349006d6f1523e, 0x39b66cbf7f1f09bc}},
    {"curly",
     Style::Curly,
     {0x3b57d7f259492777, 0x9e5854ccd2aa4ba2, 0xa476f8151e0b7f61, 0x1483ff50a76ce65a}},
    {"long",
     Style::Long,
     {0xb9ef9a9a65b64a70, 0x058a0a1bda48249e, 0xce4b73b781ed5b6b, 0x53176d483c9a9355}},
};

template <class T>
std::uint64_t hashOf(const std::vector<T>& values) {
  StateHash hash;
  hash.add(std::span<const T>(values));
  return hash.value();
}

/// A style as it comes, with all default settings, after two seconds of the built-in dance.
Hashes danced(Style style) {
  test::Scene scene(styleSettings(style), Motion::dance(), FrameSettings{});
  EXPECT_TRUE(scene.settings.selfCollision && scene.settings.shadow && scene.settings.shade);
  for (int f = 0; f < 120; ++f) scene.step();
  StateHash guides;
  scene.hair.guides.addTo(guides);
  return {guides.value(), hashOf(scene.hair.wisps.points), hashOf(scene.hair.transmittance),
          hashOf(scene.hair.colours)};
}

std::string constants(const Hashes& h) {
  char text[128];
  std::snprintf(
      text, sizeof text, "{0x%016llx, 0x%016llx, 0x%016llx, 0x%016llx}",
      static_cast<unsigned long long>(h.guides), static_cast<unsigned long long>(h.points),
      static_cast<unsigned long long>(h.transmittance), static_cast<unsigned long long>(h.colours));
  return text;
}

void PrintTo(const Hashes& hashes, std::ostream* out) {
  *out << constants(hashes);
}

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

using Run = std::tuple<Golden, int, std::string_view>;  // style, threads, instruction set

class GoldenHash : public testing::TestWithParam<Run> {};

TEST_P(GoldenHash, IsThatOfEveryBuild) {
  const auto& [golden, threads, instructions] = GetParam();
  const ThreadLimit threadLimit(threads);
  const InstructionSetLimit instructionLimit(instructions);
  EXPECT_EQ(danced(golden.style), golden.hashes) << golden.name << ": guides, points, "
                                                 << "transmittance, colours";
}

std::string nameOf(const testing::TestParamInfo<Run>& run) {
  return text(std::get<0>(run.param).name, '_', std::get<1>(run.param), "_threads_",
              std::get<2>(run.param));
}

// Threads with the best instruction set; the others, which are slow, with two threads.
INSTANTIATE_TEST_SUITE_P(Threads, GoldenHash,
                         testing::Combine(testing::ValuesIn(kGolden), testing::Values(1, 7),
                                          testing::Values(instructionSets().front())),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(InstructionSets, GoldenHash,
                         testing::Combine(testing::ValuesIn(kGolden), testing::Values(2),
                                          testing::ValuesIn(instructionSets())),
                         nameOf);

}  // namespace
}  // namespace hair

int main(int count, char** words) {
  if (count > 1 && std::strcmp(words[1], "--print") == 0) {
    for (const hair::Golden& golden : hair::kGolden)
      std::printf("%s: %s\n", golden.name, hair::constants(hair::danced(golden.style)).c_str());
    return 0;
  }
  testing::InitGoogleTest(&count, words);
  return RUN_ALL_TESTS();
}
