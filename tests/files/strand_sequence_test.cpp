// Animations out and in, frame by frame.
#include <iterator>

#include <gtest/gtest.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <libhair/core/state_hash.h>
#include <libhair/files/strand_sequence.h>
#include <tests/allocations.h>

#include "samples.h"
#include "strand_samples.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

std::size_t fileCount(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Strands that are elsewhere in every frame.
StrandFile moved(StrandFile strands, std::uint32_t frame) {
  for (std::uint32_t i = 0; i < strands.strands.pointCount(); ++i)
    for (int c = 0; c < 3; ++c)
      strands.strands.points[i][c] = anyCoordinate(frame, 3 * i + static_cast<std::uint32_t>(c));
  return strands;
}

std::uint64_t hashOf(const std::vector<glm::vec3>& points) {
  StateHash hash;
  hash.add(std::span<const glm::vec3>(points));
  return hash.value();
}

TEST(StrandSequence, EveryFrameComesBackBitForBitInAnyOrder) {
  const TemporaryFolder folder;
  for (const char* name :
       {"a.usda", "b.##.usda", "c.####.hair", "d#.ply", "####.obj", "f.#.tfx", "g-##-.data"}) {
    SCOPED_TRACE(name);
    const bool arrays = fs::path(name).extension() == ".usda";
    const StrandFile strands = anyStrands(5, {5, 5, arrays});
    constexpr std::uint32_t kFrames = 12;
    StrandSequenceWriter writer(folder / name, {.fps = 24, .firstFrame = 99});
    for (std::uint32_t f = 0; f < kFrames; ++f) writer.add(moved(strands, f));
    writer.close();
    StrandSequenceReader reader(folder / name);
    ASSERT_EQ(reader.frameCount(), kFrames);
    StrandFile read;
    for (std::uint32_t k = 0; k < kFrames; ++k) {
      const std::uint32_t f = k * 7 % kFrames;  // to and fro
      reader.read(f, read);
      EXPECT_EQ(read.strands.first, strands.strands.first);
      EXPECT_TRUE(sameBits(read.strands.points, moved(strands, f).strands.points)) << f;
      EXPECT_TRUE(sameBits(read.thickness, strands.thickness));
      if (name == std::string("a.usda")) {
        EXPECT_NEAR(reader.seconds(f), f / 24.0, 1e-12);
      }
    }
    EXPECT_NE(errorOf([&] { reader.read(kFrames, read); }).find("there are 12"), std::string::npos);
  }
}

TEST(StrandSequence, NumbersHaveAtLeastAsManyDigitsAsThePattern) {
  EXPECT_EQ(numberedFile("a/shot.####.hair", 7), "a/shot.0007.hair");
  EXPECT_EQ(numberedFile("shot#.hair", 1234), "shot1234.hair");
  EXPECT_EQ(numberedFile("s##.hair", -3), "s-03.hair");
  EXPECT_TRUE(isNumbered("a/s#.hair"));
  EXPECT_FALSE(isNumbered("a#/s.hair"));
}

TEST(StrandSequence, AnInterruptedShotLeavesWhatWasThere) {
  const TemporaryFolder folder;
  const StrandFile strands = anyStrands(1, {2, 5});
  const fs::path old = folder.write("a.usda", "old");
  {
    StrandSequenceWriter writer(old);
    for (std::uint32_t f = 0; f < 50; ++f) writer.add(moved(strands, f));
  }
  std::ifstream in(old);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "old");
  EXPECT_EQ(fileCount(folder.path()), 1u);
  {
    StrandSequenceWriter writer(old);
    EXPECT_NE(errorOf([&] { writer.close(); }).find("without frames"), std::string::npos);
    writer.add(strands);
    writer.close();
  }
  EXPECT_EQ(StrandSequenceReader(old).frameCount(), 1u);
  EXPECT_EQ(fileCount(folder.path()), 1u);
}

TEST(StrandSequence, WhatCannotBeWrittenOrReadIsAnError) {
  const TemporaryFolder folder;
  const auto says = [](const std::string& message, const char* words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  says(errorOf([&] { StrandSequenceWriter(folder / "a.hair"); }), "put ####");
  says(errorOf([&] { StrandSequenceWriter(folder / "a.abc"); }), "unknown format");
  says(errorOf([&] { StrandSequenceWriter(folder / "a.usda", {.fps = 0}); }), "frames a second");
  says(errorOf([&] { StrandSequenceReader(folder / "a.####.hair"); }), "no files of that name");
  StrandSequenceWriter writer(folder / "a.usda");
  writer.add(anyStrands(1, {2, 2}));
  says(errorOf([&] { writer.add(anyStrands(1, {3, 3})); }), "has other strands than the first");
}

TEST(StrandSequence, AFileThatDoesNotMoveIsASequenceOfOne) {
  const TemporaryFolder folder;
  const StrandFile strands = anyStrands(2, {2, 5});
  for (const char* name : {"a.hair", "a.usda"}) {
    writeStrands(folder / name, strands);
    StrandSequenceReader reader(folder / name);
    EXPECT_EQ(reader.frameCount(), 1u);
    EXPECT_EQ(reader.seconds(0), 0);
    StrandFile read;
    reader.read(0, read);
    EXPECT_EQ(hashOf(read.strands.points), hashOf(strands.strands.points));
  }
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(StrandSequence, MemoryDoesNotGrowWithTheNumberOfFrames) {
  const TemporaryFolder folder;
  StrandFile strands;
  for (int s = 0; s < 100; ++s) strands.strands.append(std::vector<glm::vec3>(32));
  const std::size_t frameBytes = strands.strands.pointCount() * sizeof(glm::vec3);
  constexpr std::uint32_t kFew = 10, kMany = 210;
  const auto inUse = [] { return static_cast<long long>(mallinfo2().uordblks); };
  for (const char* name : {"a.usda", "a.####.hair"}) {
    SCOPED_TRACE(name);
    test::resetLargestAllocation();
    long long afterFew = 0;
    {
      StrandSequenceWriter writer(folder / name);
      for (std::uint32_t f = 0; f < kMany; ++f) {
        writer.add(moved(strands, f));
        if (f + 1 == kFew) afterFew = inUse();
      }
      EXPECT_LT(inUse() - afterFew, static_cast<long long>(frameBytes));
      writer.close();
    }
    StrandSequenceReader reader(folder / name);
    StrandFile read;
    for (std::uint32_t f = 0; f < kMany; ++f) {
      reader.read(f, read);
      EXPECT_EQ(hashOf(read.strands.points), hashOf(moved(strands, f).strands.points));
      if (f + 1 == kFew) afterFew = inUse();
    }
    EXPECT_LT(inUse() - afterFew, static_cast<long long>(frameBytes));
    // Nor is all of it ever in one block, not even for a moment.
    EXPECT_LT(test::largestAllocation(), 8 * frameBytes);
  }
}
#endif

}  // namespace
}  // namespace hair
