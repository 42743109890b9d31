#include <libhair/shadow/methods/shadow_map.h>

#include <libhair/core/error.h>
#include <libhair/density/cell_frame.h>
#include <libhair/shadow/methods/layer_sums.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

namespace {

constexpr float kWidestFilter = 256;  // pixels

class ShadowMap final : public ShadowMethod {
 public:
  explicit ShadowMap(const ShadowMapSettings& settings)
      : settings_(settings),
        radius_(settings.filterRadius / settings.pixelSize),
        bias_(settings.bias / settings.pixelSize) {}

  void build(StrandView strands, const Fibre& fibre, const LightSpace& light) override {
    requireFibre(fibre, "shadow map");
    const LightImage image = makeLightImage(strands, light, settings_.pixelSize);
    depths_.reset(image, 1, "shadow map");
    image_ = image;
    constexpr auto kNone = std::bit_cast<std::uint32_t>(INFINITY);
    parallelFor(image_.pixelCount(), 1 << 16, [&](std::size_t begin, std::size_t end) {
      std::fill(depths_.pixel(begin), depths_.pixel(begin) + (end - begin), kNone);
    });
    forAllFragments(strands, fibre, Extinction::Unbiased, image_,
                    [&]<bool kShared>(const Fragment& f) {
                      LayerSums::keepLeast<kShared>(*depths_.pixel(f.pixel),
                                                    std::max(f.depth - image_.nearest, 0.0f));
                    });
  }

  void sample(std::span<const glm::vec3> points, std::span<float> out) const override {
    require(out.size() == points.size(), "shadow map: ", points.size(), " points but room for ",
            out.size(), " values");
    parallelFor(points.size(), 512, [&](std::size_t begin, std::size_t end) {
      CellBatch c;
      for (std::size_t p = begin; p < end; p += CellBatch::kSize) {
        const std::size_t count = std::min(end - p, CellBatch::kSize);
        c.fill(image_.frame, points.subspan(p, count), glm::vec3(0));
        for (std::size_t l = 0; l < count; ++l)
          out[p + l] = litShare({c.x[l], c.y[l], c.z[l]}, {c.j[l], c.k[l]});
      }
    });
  }

  std::size_t bytes() const override { return depths_.bytes(); }

 private:
  /// Lit fraction of the pixels with centres in the disc around u; if there are none, of the
  /// point's own pixel.
  float litShare(glm::vec3 u, glm::ivec2 own) const {
    const float depth = u.x - bias_ - image_.nearest;
    if (depth <= 0) return 1;
    const glm::ivec2 upper = image_.lower + image_.size;
    // Beside the image, discs included.
    const glm::vec2 lowest = glm::vec2(image_.lower) - radius_,
                    highest = glm::vec2(upper) + radius_;
    if (!(u.y > lowest.x && u.z > lowest.y && u.y < highest.x && u.z < highest.y)) return 1;
    int pixels = 0, dark = 0;
    for (int k = firstMiddle(u.z - radius_); k <= lastMiddle(u.z + radius_); ++k) {
      const float dz = static_cast<float>(k) + 0.5f - u.z;
      const float half = std::sqrt(std::max(radius_ * radius_ - dz * dz, 0.0f));
      const int from = firstMiddle(u.y - half), to = lastMiddle(u.y + half);
      pixels += std::max(to - from + 1, 0);
      if (k >= image_.lower.y && k < upper.y)
        dark += darkPixels(k, std::max(from, image_.lower.x), std::min(to, upper.x - 1), depth);
    }
    if (pixels == 0) {
      pixels = 1;
      dark = image_.inside(own.x, own.y) ? darkPixels(own.y, own.x, own.x, depth) : 0;
    }
    return static_cast<float>(pixels - dark) / static_cast<float>(pixels);
  }

  /// Number of pixels in columns `from` to `to` of row k, inside the image, with hair in front of
  /// the depth.
  int darkPixels(int k, int from, int to, float depth) const {
    if (to < from) return 0;
    const std::uint32_t* row = depths_.pixel(image_.index(from, k));
    // Bits of non-negative floats are ordered as their values.
    const auto bits = static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(depth));
    int dark = 0;
    for (int y = 0; y <= to - from; ++y) dark += static_cast<std::int32_t>(row[y]) < bits ? 1 : 0;
    return dark;
  }
  /// The first pixel with its centre at x or after, and the last at x or before.
  static int firstMiddle(float x) { return -floorToInt(0.5f - x); }
  static int lastMiddle(float x) { return floorToInt(x - 0.5f); }

  ShadowMapSettings settings_;
  float radius_, bias_;  // pixels
  LightImage image_;
  LayerSums depths_;  // [pixel]: bits of the first hair's depth behind the image's nearest
};

}  // namespace

std::unique_ptr<ShadowMethod> makeShadowMap(const ShadowMapSettings& settings) {
  validateFields(settings, "shadow map");
  require(settings.filterRadius <= kWidestFilter * settings.pixelSize, "shadow map: filter radius ",
          settings.filterRadius, " m is more than ", kWidestFilter, " pixels of ",
          settings.pixelSize, " m; take larger pixels");
  return std::make_unique<ShadowMap>(settings);
}

}  // namespace hair
