// What docs/c_interface.md promises of structs that grow, tried with one that has.
#include <cstdint>

#include <gtest/gtest.h>

#include <libhair/c/boundary.h>

namespace {

struct Grown {
  std::uint32_t size;
  float old;
  float added;
};

}  // namespace

template <>
inline constexpr std::size_t hair::c::kFirstSize<Grown> = 8;

namespace {

using hair::c::hand, hair::c::taken;

const Grown kDefaults{sizeof(Grown), 1, 2};

TEST(Growth, AProgramOfTheFirstVersionGetsTheDefaultsOfWhatItLacks) {
  const Grown theirs{8, 5, 77};  // nothing is read behind the 8 bytes that it has
  const Grown here = taken(&theirs, kDefaults, "grown");
  EXPECT_EQ(here.old, 5);
  EXPECT_EQ(here.added, 2);
}

TEST(Growth, AProgramOfThisVersionIsTakenWhole) {
  const Grown theirs{sizeof(Grown), 5, 7};
  EXPECT_EQ(taken(&theirs, kDefaults, "grown").added, 7);
}

TEST(Growth, NothingIsWrittenBehindWhatAnOlderProgramHas) {
  Grown theirs{8, 0, 77};
  hand(kDefaults, &theirs, 8, "grown");
  EXPECT_EQ(theirs.size, 8u);
  EXPECT_EQ(theirs.old, 1);
  EXPECT_EQ(theirs.added, 77);
}

TEST(Growth, WhatIsSmallerThanTheFirstVersionIsRefused) {
  const Grown theirs{7, 5, 7};
  EXPECT_THROW(taken(&theirs, kDefaults, "grown"), hair::Error);
}

}  // namespace
