#include <libhair/shadow/methods/density_map_method.h>

#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/shadow/deposit.h>
#include <libhair/shadow/filter.h>
#include <libhair/shadow/methods/shadow_method.h>
#include <libhair/shadow/transmittance.h>

namespace hair {

namespace {

class DensityMapMethod final : public ShadowMethod {
 public:
  explicit DensityMapMethod(const DensityMapSettings& settings) : settings_(settings) {
    clear(map_, settings_, LightSpace{});  // validates; pages come when they are written
  }

  void build(StrandView strands, const Fibre& fibre, const LightSpace& light) override {
    clear(map_, settings_, light);
    deposit(strands, fibre, map_);
    require(!map_.aliased(), "density map: the hair is larger than the map of ", settings_.cells,
            " cells of ", settings_.cellSize, " m: take more or larger cells");
    computeTransmittance(map_);
  }

  void sample(std::span<const glm::vec3> points, std::span<float> out) const override {
    sampleTransmittance(map_, points, out);
  }

  /// All its arrays, whether their pages were ever written or not.
  std::size_t bytes() const override {
    const auto n = static_cast<std::size_t>(settings_.cells);
    return n * n * n * sizeof(std::uint32_t) + n * n * sizeof(std::uint8_t) +
           (n * n * n + 31) / 32 * sizeof(std::uint32_t) + (n * n * n + n) * sizeof(float) +
           map_.rowOf.size() * sizeof(std::uint32_t);
  }

 private:
  DensityMapSettings settings_;
  DensityMap map_;
};

}  // namespace

std::unique_ptr<ShadowMethod> makeDensityMapMethod(const DensityMapSettings& settings) {
  require(settings.quantity == Quantity::OpticalDepth,
          "density map: a map of lengths has no transmittance; take Quantity::OpticalDepth");
  return std::make_unique<DensityMapMethod>(settings);
}

}  // namespace hair
