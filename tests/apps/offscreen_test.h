#pragma once

#include <memory>

#include <gtest/gtest.h>

#include <apps/common/player.h>
#include <apps/draw/gl_context.h>
#include <libhair/core/error.h>

namespace hair::test {

/// Draws without a window. Skips where there is no OpenGL.
class OffscreenTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      context_ = std::make_unique<draw::OffscreenContext>();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// Options of a character with few strands.
  static CharacterOptions fewStrands(std::uint32_t strands) {
    CharacterOptions options;
    options.strands = strands;
    return options;
  }
  /// Options of a player that settles for a moment alone before its first frame.
  static PlayerOptions settlesForAMoment() {
    PlayerOptions options;
    options.settle = 0.02f;
    return options;
  }

 private:
  std::unique_ptr<draw::OffscreenContext> context_;
};

}  // namespace hair::test
