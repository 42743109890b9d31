#include <libhair/shadow/methods/opacity_map.h>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/image_method.h>
#include <libhair/shadow/methods/layer_sums.h>
#include <libhair/shadow/methods/sample_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

namespace {

class OpacityMap final : public ImageMethod {
 public:
  explicit OpacityMap(const OpacityMapSettings& settings) : settings_(settings) {}

  void build(StrandView strands, const Fibre& fibre, const LightSpace& light) override {
    const LightImage image = startBuild(strands, fibre, light, settings_, "opacity map");
    sums_.reset(image, settings_.slices, "opacity map");
    image_ = image;
    // Hair in one plane would give slices of height 0.
    slicesPerDepth_ =
        static_cast<float>(settings_.slices) / std::max(image.farthest - image.nearest, 1e-3f);
    forAllFragments(strands, fibre, settings_.extinction, image_,
                    [&]<bool kShared>(const Fragment& f) {
                      LayerSums::add<kShared>(sums_.pixel(f.pixel)[place(f.depth).slice],
                                              LayerSums::toCount(f.opticalDepth));
                    });
    sums_.accumulate(0, static_cast<std::size_t>(settings_.slices));
  }

  void sample(std::span<const glm::vec3> points, std::span<float> out) const override {
    sampleImage(image_, settings_.filter, points, out, [this](std::size_t pixel, float depth) {
      const Place at = place(depth);
      const std::uint32_t* sums = sums_.pixel(pixel);
      // Sums are located at the far planes of their slices; in front of the first the sum is 0.
      const float front = at.slice == 0 ? 0.0f : LayerSums::toOpticalDepth(sums[at.slice - 1]);
      const float back = LayerSums::toOpticalDepth(sums[at.slice]);
      return front + at.part * (back - front);
    });
  }

  std::size_t bytes() const override { return sums_.bytes(); }

 private:
  /// A slice and how far into it, [0, 1].
  struct Place {
    std::size_t slice;
    float part;
  };
  Place place(float depth) const {
    const auto slices = static_cast<float>(settings_.slices);
    const float t = std::min(std::max((depth - image_.nearest) * slicesPerDepth_, 0.0f), slices);
    const int slice = std::min(static_cast<int>(t), settings_.slices - 1);
    return {static_cast<std::size_t>(slice), t - static_cast<float>(slice)};
  }

  OpacityMapSettings settings_;
  LightImage image_;
  LayerSums sums_;  // [pixel][slice]
  float slicesPerDepth_ = 0;
};

}  // namespace

std::unique_ptr<ShadowMethod> makeOpacityMap(const OpacityMapSettings& settings) {
  validateFields(settings, "opacity map");
  return std::make_unique<OpacityMap>(settings);
}

}  // namespace hair
