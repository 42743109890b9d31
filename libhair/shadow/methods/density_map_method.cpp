#include <libhair/shadow/methods/density_map_method.h>

#include <libhair/core/error.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

namespace {

class DensityMapMethod final : public ShadowMethod {
 public:
  explicit DensityMapMethod(const DensityMapSettings& settings) : settings_(settings) {
    clear(map_, settings_, LightSpace{});  // validates; memory pages are committed on first write
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

  /// The paper's filters are measured as published, with self-shadowing.
  void sampleStrands(StrandView strands, std::span<float> out) const override {
    if (settings_.filter == Filter::None || settings_.filter == Filter::Paper)
      sampleTransmittance(map_, strands.points, out);
    else
      sampleStrandTransmittance(map_, strands, out);
  }

  std::size_t bytes() const override { return map_.bytes(); }

 private:
  DensityMapSettings settings_;
  DensityMap map_;
};

}  // namespace

std::unique_ptr<ShadowMethod> makeDensityMapMethod(const DensityMapSettings& settings) {
  return std::make_unique<DensityMapMethod>(settings);
}

}  // namespace hair
