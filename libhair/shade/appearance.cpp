#include <libhair/shade/appearance.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shade/shaded_points.h>

namespace hair {

namespace {

void check(StrandView strands, const Illumination& illumination, const Appearance& appearance,
           std::span<glm::vec3> radiance, std::span<std::uint32_t> colours) {
  validate(appearance);
  const std::size_t points = strands.pointCount();
  validate(illumination, points);
  const auto fits = [&](std::size_t room, const char* what) {
    require(room == points || room == 0, "shade: ", points, " points but room for ", room, ' ',
            what);
  };
  fits(radiance.size(), "radiances");
  fits(colours.size(), "colours");
}

}  // namespace

void validate(const Appearance& appearance) {
  std::visit(
      []<class Model>(const Model& model) {
        // The model's own: one without would convert to Appearance, and come back here for ever.
        constexpr void (*own)(const Model&) = &validate;
        own(model);
      },
      appearance);
}

void shade(StrandView strands, std::size_t begin, std::size_t end, const Illumination& illumination,
           const Appearance& appearance, std::span<glm::vec3> radiance,
           std::span<std::uint32_t> colours) {
  check(strands, illumination, appearance, radiance, colours);
  require(begin <= end && end <= strands.strandCount(), "shade: strands ", begin, " to ", end,
          " of ", strands.strandCount());
  std::visit(
      [&](const auto& model) {
        shadeStrands(strands, begin, end, illumination, model, {radiance.data(), colours.data()});
      },
      appearance);
}

void shade(StrandView strands, const Illumination& illumination, const Appearance& appearance,
           std::span<glm::vec3> radiance, std::span<std::uint32_t> colours) {
  check(strands, illumination, appearance, radiance, colours);
  if (radiance.empty() && colours.empty()) return;
  const ShadedPoints out{radiance.data(), colours.data()};
  std::visit(
      [&](const auto& model) {
        parallelFor(strands.strandCount(), 64, [&](std::size_t begin, std::size_t end) {
          shadeStrands(strands, begin, end, illumination, model, out);
        });
      },
      appearance);
}

}  // namespace hair
