#include <libhair/shadow/methods/deep_opacity_map.h>

#include <array>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/image_method.h>
#include <libhair/shadow/methods/layer_sums.h>
#include <libhair/shadow/methods/sample_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

namespace {

using Growth = DeepOpacityMapSettings::Growth;
using Beyond = DeepOpacityMapSettings::Beyond;

constexpr int kMostLayers = 255;

/// Ends of layers as fractions of the total depth: d[0] = 0 < d[1] < ... < d[K] = 1. To find the
/// layer of a depth, start at an entry of a uniform table and step forward.
class Layers {
 public:
  Layers(int count, Growth growth) : count_(static_cast<std::size_t>(count)) {
    std::array<double, kMostLayers> size{};
    double sum = 0;
    for (std::size_t k = 0; k < count_; ++k) sum += size[k] = sizeOf(k, growth, size);
    double end = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      end += size[k];
      ends_[k + 1] = k + 1 == count_ ? 1.0f : static_cast<float>(end / sum);
    }
    for (std::size_t k = 0; k < count_; ++k) {
      require(ends_[k + 1] - ends_[k] > 1e-6f, "deep opacity map: of ", count,
              " layers the first are thinner than a millionth of all; take fewer, or sizes that "
              "grow less");
      perPart_[k] = 1.0f / (ends_[k + 1] - ends_[k]);
    }
    for (std::size_t step = 0, k = 0; step < kSteps; ++step) {
      while (ends_[k + 1] <= static_cast<float>(step) / kSteps) ++k;
      first_[step] = static_cast<std::uint8_t>(k);
    }
  }

  /// The layer at a fraction of the total depth, [0, 1).
  std::size_t at(float part) const {
    std::size_t k = first_[static_cast<std::size_t>(part * kSteps)];
    while (part >= ends_[k + 1]) ++k;
    return k;
  }
  /// Position of a fraction within layer k, [0, 1).
  float within(std::size_t k, float part) const { return (part - ends_[k]) * perPart_[k]; }
  std::size_t count() const { return count_; }

 private:
  static constexpr std::size_t kSteps = 256;

  static double sizeOf(std::size_t k, Growth growth,
                       const std::array<double, kMostLayers>& before) {
    switch (growth) {
      case Growth::Constant:
        return 1;
      case Growth::Linear:
        return static_cast<double>(k + 1);
      case Growth::Doubling:
        return k == 0 ? 1 : 2 * before[k - 1];
      case Growth::Fibonacci:
        return k < 2 ? static_cast<double>(k + 1) : before[k - 1] + before[k - 2];
    }
    return 1;
  }

  std::size_t count_;
  std::array<float, kMostLayers + 1> ends_{};
  std::array<float, kMostLayers> perPart_{};
  std::array<std::uint8_t, kSteps> first_{};
};

class DeepOpacityMap final : public ImageMethod {
 public:
  explicit DeepOpacityMap(const DeepOpacityMapSettings& settings)
      : settings_(settings), layers_(settings.layers, settings.growth) {}

  void build(StrandView strands, const Fibre& fibre, const LightSpace& light) override {
    const LightImage image = startBuild(strands, fibre, light, settings_, "deep opacity map");
    words_.reset(image, settings_.layers + 1, "deep opacity map");
    image_ = image;
    const float all = image.farthest - image.nearest;
    const float depth =
        settings_.beyond == Beyond::LargerLayers ? all : settings_.depth / settings_.pixelSize;
    partPerDepth_ = 1.0f / std::max(depth, 1e-3f);
    findFirstHair(strands, fibre);
    if (settings_.depthBits < 32) roundDepths(all);
    forAllFragments(strands, fibre, settings_.extinction, image_,
                    [&]<bool kShared>(const Fragment& f) { addFragment<kShared>(f); });
    words_.accumulate(1, layers_.count());
  }

  void sample(std::span<const glm::vec3> points, std::span<float> out) const override {
    sampleImage(image_, settings_.filter, points, out, [this](std::size_t pixel, float depth) {
      const std::uint32_t* words = words_.pixel(pixel);
      const float part = partOf(words, depth);
      if (part <= 0) return 0.0f;  // also where the pixel is empty
      if (part >= 1) return LayerSums::toOpticalDepth(words[layers_.count()]);
      const std::size_t k = layers_.at(part);
      const float front = k == 0 ? 0.0f : LayerSums::toOpticalDepth(words[k]);
      const float back = LayerSums::toOpticalDepth(words[k + 1]);
      return front + layers_.within(k, part) * (back - front);
    });
  }

  std::size_t bytes() const override { return words_.bytes(); }

 private:
  /// Depth behind the image's nearest, never negative.
  float behindNearest(float depth) const { return std::max(depth - image_.nearest, 0.0f); }

  /// Depth in a pixel's layers as a fraction of the total; minus infinity in a pixel without hair.
  float partOf(const std::uint32_t* words, float depth) const {
    return (depth - image_.nearest - std::bit_cast<float>(words[0])) * partPerDepth_;
  }

  /// z0 of all pixels, in pixels behind the image's nearest; infinite where there is no hair.
  void findFirstHair(StrandView strands, const Fibre& fibre) {
    constexpr auto kNone = std::bit_cast<std::uint32_t>(INFINITY);
    parallelFor(image_.pixelCount(), 1 << 14, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) words_.pixel(p)[0] = kNone;
    });
    forAllFragments(
        strands, fibre, settings_.extinction, image_, [&]<bool kShared>(const Fragment& f) {
          LayerSums::keepLeast<kShared>(words_.pixel(f.pixel)[0], behindNearest(f.depth));
        });
  }

  /// Quantises depths to 8 or 16 bits, rounding towards the light, so that no hair is in front of
  /// its z0. They remain 32-bit words, because all channels of the paper's texture are alike.
  void roundDepths(float all) {
    const auto levels = static_cast<float>((1 << settings_.depthBits) - 1);
    const float step = std::max(all, 1e-3f) / levels;
    parallelFor(image_.pixelCount(), 1 << 14, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        std::uint32_t& word = words_.pixel(p)[0];
        const auto z0 = std::bit_cast<float>(word);
        if (std::isinf(z0)) continue;
        float level = std::min(std::floor(z0 / step), levels);
        if (level * step > z0) level -= 1;
        word = std::bit_cast<std::uint32_t>(std::max(level, 0.0f) * step);
      }
    });
  }

  template <bool kShared>
  void addFragment(const Fragment& f) {
    std::uint32_t* words = words_.pixel(f.pixel);
    const float part = std::max(partOf(words, f.depth), 0.0f);
    if (part >= 1 && settings_.beyond == Beyond::Ignored) return;
    const std::size_t k = part < 1 ? layers_.at(part) : layers_.count() - 1;
    LayerSums::add<kShared>(words[k + 1], LayerSums::toCount(f.opticalDepth));
  }

  DeepOpacityMapSettings settings_;
  Layers layers_;
  LightImage image_;
  LayerSums words_;  // [pixel]: z0 (bits of a float), then the layers' optical depths
  float partPerDepth_ = 0;
};

}  // namespace

std::unique_ptr<ShadowMethod> makeDeepOpacityMap(const DeepOpacityMapSettings& settings) {
  validateFields(settings, "deep opacity map");
  require(settings.depthBits == 8 || settings.depthBits == 16 || settings.depthBits == 32,
          "deep opacity map: depths of ", settings.depthBits, " bits are not 8, 16 or 32");
  return std::make_unique<DeepOpacityMap>(settings);
}

}  // namespace hair
