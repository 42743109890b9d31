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

/// What image methods keep: a few 32-bit words a pixel, those of one pixel side by side, so that a
/// sample reads one line of memory or two per row of pixels. Optical depths are integers: sums of
/// them do not depend on the order in which threads add.
class LayerSums {
 public:
  /// One count is 2^-20 of an optical depth; a word stops at 1024 of them, where light ends long
  /// before.
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
    // To the nearest, without the library call that rounding is.
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

  /// Adds to a word; Shared: other threads do so at the same time.
  template <bool kShared>
  static void add(std::uint32_t& word, std::uint32_t count) {
    change<kShared>(word, [=](std::uint32_t now) { return addSaturating(now, count); });
  }
  /// Keeps the lesser of non-negative floats in a word (whose bits are in the order of values).
  template <bool kShared>
  static void keepLeast(std::uint32_t& word, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    change<kShared>(word, [=](std::uint32_t now) { return std::min(now, bits); });
  }

  /// Each of words [first, first + count) of each pixel becomes the sum up to it.
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
/// kShared is false where there is but one.
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
