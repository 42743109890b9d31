#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/methods/light_image.h>

namespace hair {

/// Storage of image methods: a few 32-bit words a pixel, contiguous per pixel, so that a sample
/// reads one or two cache lines per row of pixels. Optical depths are integers, so their sums do
/// not depend on the order of threads.
class LayerSums {
 public:
  /// One count is an optical depth of 2^-20; words hold optical depths up to 1024, far beyond
  /// opaque.
  static constexpr float kQuantum = 0x1p-20f;
  static constexpr std::uint32_t kMost = 1u << 30;

  /// All words zero; memory only grows. Throws Error where they would take more than 4 GiB;
  /// `method` begins the message.
  void reset(const LightImage& image, int wordsPerPixel, const char* method) {
    const auto stride = static_cast<std::size_t>(wordsPerPixel);
    require(image.pixelCount() <= (std::size_t{1} << 30) / stride, method, ": ", image.size.x,
            " x ", image.size.y, " pixels of ", wordsPerPixel,
            " layers are more than 4 GiB; take larger pixels or fewer layers");
    words_.resize(image.pixelCount() * stride);
    stride_ = stride;
    parallelFor(words_.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
      std::fill(words_.data() + begin, words_.data() + end, 0u);
    });
  }
  std::uint32_t* pixel(std::size_t index) { return words_.data() + index * stride_; }
  const std::uint32_t* pixel(std::size_t index) const { return words_.data() + index * stride_; }
  std::size_t bytes() const { return words_.size() * sizeof(std::uint32_t); }

  static std::uint32_t toCount(float opticalDepth) {
    constexpr auto kMostDepth = static_cast<float>(kMost) * kQuantum;
    // Round to nearest, without a library call.
    const float count = std::min(opticalDepth, kMostDepth) / kQuantum;
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(count + 0.5f));  // NOLINT(bugprone-incorrect-roundings)
  }
  static float toOpticalDepth(std::uint32_t count) {
    return static_cast<float>(static_cast<std::int32_t>(count)) * kQuantum;
  }
  static std::uint32_t addSaturating(std::uint32_t a, std::uint32_t b) {
    return std::min(a + b, kMost);
  }

  /// Adds to a word; kShared: other threads add concurrently.
  template <bool kShared>
  static void add(std::uint32_t& word, std::uint32_t count) {
    change<kShared>(word, [=](std::uint32_t now) { return addSaturating(now, count); });
  }
  /// Minimum of non-negative floats in a word (their bits are ordered as their values).
  template <bool kShared>
  static void keepLeast(std::uint32_t& word, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    change<kShared>(word, [=](std::uint32_t now) { return std::min(now, bits); });
  }

  /// Replaces words [first, first + count) of each pixel by their prefix sums.
  void accumulate(std::size_t first, std::size_t count) {
    if (stride_ == 0) return;
    parallelFor(words_.size() / stride_, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        std::uint32_t* words = pixel(p) + first;
        std::uint32_t sum = 0;
        for (std::size_t k = 0; k < count; ++k) words[k] = sum = addSaturating(sum, words[k]);
      }
    });
  }

 private:
  template <bool kShared, class Next>
  static void change(std::uint32_t& word, Next&& next) {
    if constexpr (kShared) {
      std::atomic_ref shared(word);
      std::uint32_t now = shared.load(std::memory_order_relaxed);
      for (;;) {
        const std::uint32_t then = next(now);
        if (then == now || shared.compare_exchange_weak(now, then, std::memory_order_relaxed))
          return;
      }
    } else {
      word = next(word);
    }
  }

  std::vector<std::uint32_t> words_;  // [pixelCount · stride_]
  std::size_t stride_ = 0;
};

/// Calls visit.operator()<kShared>(Fragment) for all fragments of all strands, on all threads;
/// kShared is false for a single thread.
template <class Visit>
void forAllFragments(StrandView strands, const Fibre& fibre, Extinction extinction,
                     const LightImage& image, Visit&& visit) {
  const bool shared = threadCount() > 1;
  parallelFor(strands.strandCount(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      if (shared)
        forFragments(strands.strand(s), fibre, extinction, image,
                     [&](const Fragment& f) { visit.template operator()<true>(f); });
      else
        forFragments(strands.strand(s), fibre, extinction, image,
                     [&](const Fragment& f) { visit.template operator()<false>(f); });
    }
  });
}

}  // namespace hair
