#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/simd_test.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <limits>

#include <libhair/core/approximate.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

// out: [6 · 16], what the operations make of a and b.
void someOfEverything(const float* a, const float* b, float* out) {
  const Floats x = loadFloats(a), y = loadFloats(b);
  store(sqrt(abs(x)) / y + x * y, out);
  store(select(x < y, min(x, y), -max(x, y)), out + 16);
  store(toFloats(floorToInt(x) + Ints(3) * (floorToInt(y) & Ints(5))), out + 32);
  store(expMinusApproximate(abs(x)), out + 48);
  store(gather(b, laneNumbers() & Ints(7)), out + 64);
  std::int32_t packed[32] = {};
  const std::size_t n = compress(laneNumbers(), x < y, packed);
  for (std::size_t l = 0; l < 16; ++l)
    out[80 + l] = l < n ? static_cast<float>(packed[l]) : static_cast<float>(bits(x < y));
}

void turnPoints(const glm::vec3* in, glm::vec3* out) {
  const Vec3 p = loadPoints(in);
  storePoints(cross(p, Vec3(glm::vec3(0, 1, 2))) + dot(p, p) * p, out);
}

// [16] each.
void approximations(const float* x, const float* y, float* exp2, float* log2, float* pow) {
  store(exp2Approximate(loadFloats(y)), exp2);
  store(log2Approximate(loadFloats(x)), log2);
  store(powApproximate(loadFloats(x), loadFloats(y)), pow);
}

// As unsigned numbers: is a sum less than what was added?
std::uint32_t carries(const std::int32_t* a, const std::int32_t* b) {
  const Ints x = loadInts(a), s = x + loadInts(b);
  const Ints lowest(std::numeric_limits<std::int32_t>::min());
  return bits((s + lowest) < (x + lowest));
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/random.h>

namespace hair {
namespace {

HWY_EXPORT(someOfEverything);
HWY_EXPORT(turnPoints);
HWY_EXPORT(carries);
HWY_EXPORT(approximations);

struct Input {
  float a[16], b[16];
  Input() {
    for (std::uint32_t l = 0; l < 16; ++l) {
      a[l] = 40 * uniform(l, 0) - 20;
      b[l] = 40 * uniform(l, 1) - 20;
    }
  }
};

TEST(Simd, RoundsAsScalarsDo) {
  const Input in;
  float out[96];
  HWY_DYNAMIC_DISPATCH(someOfEverything)(in.a, in.b, out);
  std::uint32_t less = 0;
  for (std::size_t l = 0; l < 16; ++l) less |= in.a[l] < in.b[l] ? 1u << l : 0u;
  for (std::size_t l = 0; l < 16; ++l) {
    const float a = in.a[l], b = in.b[l];
    EXPECT_EQ(out[l], std::sqrt(std::abs(a)) / b + a * b);
    EXPECT_EQ(out[16 + l], a < b ? std::min(a, b) : -std::max(a, b));
    EXPECT_EQ(out[32 + l],
              std::floor(a) + 3.0f * static_cast<float>(static_cast<int>(std::floor(b)) & 5));
    EXPECT_EQ(out[48 + l], expMinusApproximate(std::abs(a)));
    EXPECT_EQ(out[64 + l], in.b[l & 7]);
  }
  std::size_t at = 80;
  for (std::size_t l = 0; l < 16; ++l)
    if (in.a[l] < in.b[l]) {
      EXPECT_EQ(out[at++], static_cast<float>(l));
    }
  for (; at < 96; ++at) EXPECT_EQ(out[at], static_cast<float>(less));
}

TEST(Simd, PointsComeInAndGoOutInterleaved) {
  std::array<glm::vec3, 16> in, out;
  for (std::uint32_t l = 0; l < 16; ++l) in[l] = {uniform(l, 0), uniform(l, 1), uniform(l, 2)};
  HWY_DYNAMIC_DISPATCH(turnPoints)(in.data(), out.data());
  for (std::size_t l = 0; l < 16; ++l)
    EXPECT_EQ(out[l], glm::cross(in[l], glm::vec3(0, 1, 2)) + glm::dot(in[l], in[l]) * in[l]);
}

TEST(Simd, AllInstructionSetsGiveTheSameBits) {
  const Input in;
  float best[96];
  HWY_DYNAMIC_DISPATCH(someOfEverything)(in.a, in.b, best);
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    ASSERT_EQ(instructionSet(), name);
    float out[96];
    HWY_DYNAMIC_DISPATCH(someOfEverything)(in.a, in.b, out);
    EXPECT_EQ(std::memcmp(out, best, sizeof out), 0) << name;
  }
}

TEST(Simd, ApproximationsStayWithinTheirStatedErrors) {
  float x[16], y[16], exp2[16], log2[16], pow[16];
  double exp2Worst = 0, log2Worst = 0;
  for (int i = 0; i <= 200000; i += 16) {
    for (int l = 0; l < 16; ++l) {
      y[l] = static_cast<float>(i + l - 100000) * 1e-3f;
      x[l] = std::exp(static_cast<float>(i + l - 100000) * 5e-4f);
    }
    HWY_DYNAMIC_DISPATCH(approximations)(x, y, exp2, log2, pow);
    for (int l = 0; l < 16; ++l) {
      exp2Worst = std::max(exp2Worst, std::abs(exp2[l] / std::exp2(double{y[l]}) - 1));
      const double exact = std::log2(double{x[l]});
      log2Worst = std::max(log2Worst, std::abs(log2[l] - exact) / std::max(1.0, std::abs(exact)));
    }
  }
  EXPECT_LT(exp2Worst, 2e-7);
  EXPECT_LT(log2Worst, 1e-6);
  // Powers of parts of one, at the ends too.
  for (int l = 0; l < 16; ++l)
    x[l] = static_cast<float>(l) / 15, y[l] = 0.5f + static_cast<float>(l);
  HWY_DYNAMIC_DISPATCH(approximations)(x, y, exp2, log2, pow);
  for (int l = 0; l < 16; ++l) EXPECT_NEAR(pow[l], std::pow(x[l], y[l]), 1e-6);
  EXPECT_EQ(pow[0], 0.0f);
  EXPECT_EQ(pow[15], 1.0f);
}

TEST(Simd, WholeNumbersTurnOver) {
  std::int32_t a[16], b[16];
  std::uint32_t expected = 0;
  for (std::uint32_t l = 0; l < 16; ++l) {
    const auto x = static_cast<std::uint32_t>(4.2e9 * uniform(l, 3)),
               y = static_cast<std::uint32_t>(4.2e9 * uniform(l, 4));
    a[l] = static_cast<std::int32_t>(x), b[l] = static_cast<std::int32_t>(y);
    expected |= x + y < x ? 1u << l : 0u;
  }
  ASSERT_NE(expected, 0u);
  for (const std::string_view name : instructionSets()) {
    const InstructionSetLimit limit(name);
    EXPECT_EQ(HWY_DYNAMIC_DISPATCH(carries)(a, b), expected) << name;
  }
}

TEST(Simd, AnInstructionSetThatIsNotThereIsRefused) {
  EXPECT_THROW(InstructionSetLimit("MMX"), Error);
}

}  // namespace
}  // namespace hair

#endif
