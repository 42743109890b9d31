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

TEST(StrandSequence, TimeCodesOfTheirOwnComeBack) {
  const TemporaryFolder folder;
  const StrandFile strands = anyStrands(1, {2, 2});
  const std::vector<double> whole = {-7, 0, 3, 100000}, any = {-7.25, 0.1, 1e-9 + 3, 1e17};
  for (const auto& [name, times] :
       {std::pair{"a.usda", any}, {"b.usda", whole}, {"c.##.hair", whole}}) {
    SCOPED_TRACE(name);
    StrandSequenceWriter writer(folder / name, {.fps = 23.976});
    for (std::uint32_t f = 0; f < 4; ++f) writer.addAt(times[f], moved(strands, f));
    EXPECT_NE(errorOf([&] { writer.addAt(times[3], strands); }).find("must rise"),
              std::string::npos);
    writer.close();
    StrandSequenceReader reader(folder / name);
    ASSERT_EQ(reader.frameCount(), 4u);
    EXPECT_EQ(reader.codesPerSecond(), isNumbered(name) ? 0 : 23.976);
    for (std::uint32_t f = 0; f < 4; ++f) {
      EXPECT_EQ(reader.timeCode(f), times[f]);
      StrandFile read;
      reader.read(f, read);
      EXPECT_TRUE(sameBits(read.strands.points, moved(strands, f).strands.points)) << f;
    }
  }
  StrandSequenceWriter writer(folder / "d.#.hair");
  EXPECT_NE(errorOf([&] { writer.addAt(0.5, strands); }).find("is whole"), std::string::npos);
}

TEST(StrandSequence, OfTwoSamplesOfOneTimeTheLaterCounts) {
  const TemporaryFolder folder;
  const std::string text = sampleUsda();
  const std::string sample = "[(0, 0, 0), (0, 3, 1), (1, 0, 0), (1, 3, 1), (1, 0, 2)],\n";
  const std::string twice =
      std::string(text).insert(text.find("    }\n    string note"), "      1: " + sample);
  StrandSequenceReader reader(folder.write("a.usda", twice), {.scale = 1, .up = UpAxis::Y});
  EXPECT_EQ(reader.frameCount(), 2u);
  StrandFile read;
  reader.read(0, read);
  EXPECT_EQ(read.strands.points[1], glm::vec3(0, 3, 1));
}

TEST(StrandSequence, TheWriterKnowsWhichArraysItKeptAsInTheFirstFrame) {
  const TemporaryFolder folder;
  const StrandFile strands = anyStrands(4, {2, 5, true});
  const auto kept = [&](const char* name, auto&& change) {
    StrandSequenceWriter writer(folder / name);
    StrandFile later = strands;
    change(later);
    for (int f = 0; f < 4; ++f) writer.add(f == 2 ? later : strands);
    const std::string before = writer.keptAsFirst();
    writer.close();
    EXPECT_EQ(writer.keptAsFirst(), before);
    return before;
  };
  EXPECT_EQ(kept("a.usda", [](StrandFile& s) { s.strands.points[0].x += 1; }), "");
  EXPECT_EQ(kept("a.usda", [](StrandFile& s) { s.thickness.back() *= 2; }), "thickness");
  EXPECT_EQ(kept("a.usda", [](StrandFile& s) { s.transparency.clear(); }), "transparency");
  EXPECT_EQ(kept("a.usda", [](StrandFile& s) { s.colours[0].y += 1, s.thickness[0] *= 2; }),
            "thickness, colours");
  EXPECT_EQ(kept("a.#.hair", [](StrandFile& s) { s.thickness.back() *= 2; }), "");
}

TEST(StrandSequence, TheWriterKnowsOfFilesOfAnEarlierLongerRun) {
  const TemporaryFolder folder;
  const StrandFile strands = anyStrands(1, {2, 2});
  const fs::path name = folder / "a.##.hair";
  const auto others = [&](int frames, long long first) {
    StrandSequenceWriter writer(name, {.firstFrame = first});
    for (int f = 0; f < frames; ++f) writer.add(strands);
    writer.close();
    return writer.otherFrames();
  };
  folder.write("a.hair", "");
  folder.write("a.7.hair", "");
  EXPECT_TRUE(others(4, 9).empty());
  EXPECT_EQ(others(2, 10), (std::vector{folder / "a.09.hair", folder / "a.12.hair"}));
  EXPECT_EQ(others(2, 9), (std::vector{folder / "a.11.hair", folder / "a.12.hair"}));
  StrandSequenceWriter usda(folder / "a.usda");
  usda.add(strands);
  usda.close();
  EXPECT_TRUE(usda.otherFrames().empty());
}

TEST(StrandSequence, WhatStandsBesideAShotIsLeftAlone) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a.extent");
  StrandSequenceWriter writer(folder / "a.usda");
  writer.add(anyStrands(1, {2, 2}));
  writer.close();
  EXPECT_TRUE(fs::is_directory(folder / "a.extent"));
  EXPECT_EQ(fileCount(folder.path()), 2u);
}

TEST(StrandSequence, AFileThatDoesNotMoveIsASequenceOfOne) {
  const TemporaryFolder folder;
  const StrandFile strands = anyStrands(2, {2, 5});
  for (const char* name : {"a.hair", "a.usda"}) {
    writeStrands(folder / name, strands);
    StrandSequenceReader reader(folder / name);
    EXPECT_EQ(reader.frameCount(), 1u);
    EXPECT_EQ(reader.seconds(0), 0);
    EXPECT_EQ(reader.timeCode(0), 0);
    EXPECT_EQ(reader.codesPerSecond(), 0);
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
