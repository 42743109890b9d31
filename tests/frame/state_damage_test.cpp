// Damaged states, through the same entry point as the fuzzer: each is refused, or restores hair
// whose next frame is sound.
#include <string>

#include <gtest/gtest.h>

#include <libhair/core/random.h>
#include <tests/allocations.h>
#include <tests/fuzz/small_hair.h>
#include <tests/fuzz/targets.h>

namespace hair {
namespace {

// States of some kilobytes never need more than this in one block; the map of self-collision does.
constexpr std::size_t kMostBytes = std::size_t{1} << 22;

std::string sample() {
  SmallHair small;
  for (int f = 0; f < 3; ++f) small.step();
  return small.state();
}

TEST(StateDamage, EverySeedOfTheFuzzerIsRestored) {
  for (const std::string& state : sampleStates()) EXPECT_TRUE(fuzzState(state));
}

TEST(StateDamage, EveryTruncationIsRefused) {
  const std::string good = sample();
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(fuzzState(std::string_view(good).substr(0, size))) << size;
}

TEST(StateDamage, EveryByteMayBeAnother) {
  const std::string good = sample();
  test::resetLargestAllocation();
  std::size_t restored = 0, tried = 0;
  for (std::size_t at = 0; at < good.size(); ++at)
    for (const int flip : {0x01, 0x10, 0x40, 0x80, 0xff}) {
      std::string bytes = good;
      bytes[at] = static_cast<char>(bytes[at] ^ flip);
      restored += fuzzState(bytes), ++tried;
    }
  EXPECT_LT(test::largestAllocation(), kMostBytes);
  EXPECT_GT(restored, tried / 10);
  EXPECT_LT(restored, tried);
}

TEST(StateDamage, AbsurdNumbersAnywhere) {
  const std::string good = sample();
  for (std::size_t at = 0; at + 4 <= good.size(); at += 4)
    for (const std::uint32_t word : {0u, 0x7f7fffffu, 0xff7fffffu, 0x7f800000u, 0x7fc00000u, 1u,
                                     0xffffffffu, 0x50000000u, 0xd0000000u, 0x3f800000u}) {
      std::string bytes = good;
      bytes.replace(at, 4, reinterpret_cast<const char*>(&word), 4);
      fuzzState(bytes);
    }
}

TEST(StateDamage, ManyBytesAtOnce) {
  const std::string good = sample();
  for (std::uint32_t round = 0; round < 2000; ++round) {
    std::uint32_t use = 0;
    const auto below = [&](std::size_t n) {
      return static_cast<std::size_t>(uniform(round, use++) * static_cast<float>(n));
    };
    std::string bytes = good;
    for (std::size_t m = 0, count = 1 + below(40); m < count; ++m)
      bytes[72 + below(bytes.size() - 72)] = static_cast<char>(below(256));
    fuzzState(bytes);
  }
}

}  // namespace
}  // namespace hair
