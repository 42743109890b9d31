// Damaged files, through the same entry points as the fuzzers: each is read or answered with
// Error, without a crash, a sanitizer's report, or memory out of proportion.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <tests/allocations.h>
#include <tests/fuzz/seeds.h>
#include <tests/fuzz/targets.h>

#include "samples.h"

namespace hair {
namespace {

struct Format {
  const char* name;
  bool (*read)(std::string_view bytes);
  std::string sample;
  bool binary;
};

std::vector<Format> formats() {
  return {{"hair", fuzzHair, hairBytes(sampleHair()), true},
          {"tfx", fuzzTfx, sampleTfx(), true},
          {"data", fuzzData, sampleData(), true},
          {"ply", fuzzPly, samplePlyText(), false},
          {"lines", fuzzLines, sampleObjLines(), false},
          {"usda", fuzzUsda, sampleUsda(), false},
          {"usda", fuzzUsda, sampleUsdaScene(), false},
          {"numpy", fuzzNumpy, sampleNpy(), true},
          {"numpy", fuzzNumpy, sampleNpz(false), true},
          {"numpy", fuzzNumpy, sampleNpz(true), true},
          {"pbrt", fuzzPbrt, samplePbrt(), false},
#ifdef HAIR_WITH_MODEL
          {"obj", fuzzObj, sampleObj(), false},
#endif
#ifdef HAIR_WITH_HAIR_MESH
          {"mesh", fuzzMesh, sampleHairMesh(), false},
          {"script", fuzzScript, sampleHairMeshScript(), false},
#endif
          {"bvh", fuzzBvh, sampleBvh(), false},
          {"clip", fuzzClip, sampleBvh(), false}};
}

// Files of a few hundred bytes never need more than this in one block.
constexpr std::size_t kMostBytes = std::size_t{1} << 20;

TEST(Damage, EverySeedOfTheFuzzersIsRead) {
  for (const auto& [name, inputs] : fuzzSeeds())
    for (const Format& f : formats()) {
      if (std::string(name) != f.name) continue;
      for (std::size_t i = 0; i < inputs.size(); ++i) EXPECT_TRUE(f.read(inputs[i])) << name << i;
    }
}

TEST(Damage, EveryTruncationOfABinaryFileIsAnError) {
  for (const Format& f : formats()) {
    ASSERT_TRUE(f.read(f.sample)) << f.name;
    if (!f.binary) continue;
    for (std::size_t size = 0; size < f.sample.size(); ++size)
      EXPECT_FALSE(f.read(std::string_view(f.sample).substr(0, size))) << f.name << ' ' << size;
  }
}

TEST(Damage, EveryTruncationOfABvhFileIsAnErrorUpToItsLastNumber) {
  const std::string sample = sampleBvh();
  // Between the rows of its two frames the file is whole but for a frame, which is forgiven.
  const std::size_t betweenRows = sample.find("10 \r\n") + 4, lastRow = sample.rfind("\n\n") + 2;
  for (std::size_t size = 0; size < sample.size(); ++size) {
    // "-1e1" cut short is "-1e", no number, or "-1", another number: a file without its last line
    // end cannot tell.
    const bool lastNumberStands = size == sample.size() - 1 || size == sample.size() - 3;
    EXPECT_EQ(fuzzBvh(std::string_view(sample).substr(0, size)),
              lastNumberStands || (size >= betweenRows && size <= lastRow))
        << size;
  }
}

TEST(Damage, EveryValueOfEveryByteIsReadOrAnError) {
  for (const Format& f : formats()) {
    if (f.read == fuzzClip) continue;  // the same bytes as bvh, and slower
    test::resetLargestAllocation();
    for (std::size_t at = 0; at < f.sample.size(); ++at) {
      std::string bytes = f.sample;
      for (int value = 0; value < 256; ++value) {
        bytes[at] = static_cast<char>(value);
        f.read(bytes);
      }
    }
    EXPECT_LT(test::largestAllocation(), kMostBytes) << f.name;
  }
}

TEST(Damage, AbsurdWordsAnywhereAreReadOrAnError) {
  for (const Format& f : formats()) {
    if (!f.binary) continue;
    test::resetLargestAllocation();
    for (std::size_t at = 0; at + 4 <= f.sample.size(); ++at)
      for (std::uint32_t word : {0u, 1u, 0x7fffffffu, 0x80000000u, 0xffffffffu, 0x15555556u,
                                 0x10000000u, 0x7f800000u, 0x7fc00000u})
        f.read(withBytes(f.sample, at, word));
    EXPECT_LT(test::largestAllocation(), kMostBytes) << f.name;
  }
}

// Random mutations on mutations, the same in every run: what a fuzzer does first, for compilers
// that have none.
TEST(Damage, RandomMutationsAreReadOrAnError) {
  constexpr std::uint32_t kRounds = 4000;
  static const std::string kWords[] = {"-1",
                                       "0",
                                       "1e38",
                                       "99999999999",
                                       "nan",
                                       "\n",
                                       " ",
                                       "{",
                                       "}",
                                       "/",
                                       "f",
                                       "v",
                                       "o layer_1\n",
                                       "extrude all .1\n",
                                       "delete a\n",
                                       "End Site\n{\n",
                                       "JOINT j\n{\n",
                                       "CHANNELS 3 Xrotation Yrotation Zrotation\n",
                                       "MOTION\n"};
  for (const Format& f : formats()) {
    test::resetLargestAllocation();
    std::uint32_t use = 0;
    std::size_t read = 0;
    for (std::uint32_t round = 0; round < kRounds; ++round) {
      const auto below = [&](std::size_t n) {
        return n == 0 ? 0 : static_cast<std::size_t>(uniform(round, use++) * static_cast<float>(n));
      };
      std::string bytes = f.sample;
      for (std::size_t m = 0, count = 1 + below(4); m < count; ++m) {
        const std::size_t at = below(bytes.size()), size = below(bytes.size() - at + 1);
        switch (below(6)) {
          case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
          case 1:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
            break;
          case 2:
            bytes.erase(at, size);
            break;
          case 3:
            bytes.insert(below(bytes.size()), bytes.substr(at, size));
            break;
          case 4:
            bytes.insert(at, kWords[below(std::size(kWords))]);
            break;
          case 5:
            std::swap(bytes[at], bytes[below(bytes.size())]);
            break;
        }
        if (bytes.empty()) bytes = f.sample;
      }
      read += f.read(bytes);
    }
    EXPECT_LT(test::largestAllocation(), kMostBytes) << f.name;
    // Some must get through, or the mutations never reach the depths.
    EXPECT_GT(read, kRounds / 200) << f.name;
    EXPECT_LT(read, kRounds) << f.name;
  }
}

}  // namespace
}  // namespace hair
