#include <libhair/measure/shadow/ribbon.h>

#include <libhair/core/error.h>

namespace hair {

RibbonPoints makeRibbonPoints(StrandView strands, const Fibre& fibre) {
  validate(strands, "strands to trace", 0);
  const double width = static_cast<double>(fibre.width) * static_cast<double>(fibre.hairsPerStrand);
  require(width > 0 && width < 1e3, "fibre: a width of ", fibre.width, " m times ",
          fibre.hairsPerStrand, " hairs a strand is not in 0 to 1000 m; set width, hairsPerStrand");
  RibbonPoints ribbons;
  ribbons.halfWidth = 0.5 * width;
  ribbons.points.reserve(strands.pointCount());
  ribbons.strand.reserve(strands.pointCount());
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto points = strands.strand(s);
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k > 0 && points[k] == points[k - 1]) continue;
      ribbons.points.push_back(points[k]);
      ribbons.strand.push_back(static_cast<std::uint32_t>(s));
    }
  }
  return ribbons;
}

void checkRays(std::span<const ShadowRay> rays, std::size_t outputs) {
  require(outputs == rays.size(), "tracer: ", rays.size(), " rays but ", outputs, " outputs");
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const glm::vec3 way = rays[r].toLight, from = rays[r].origin;
    const float square = glm::dot(way, way);
    // Written so that NaN fails too.
    require(square > 0.5f && square < 2.0f && std::isfinite(from.x + from.y + from.z), "ray ", r,
            ": from (", from.x, ", ", from.y, ", ", from.z, ") towards (", way.x, ", ", way.y, ", ",
            way.z, "): not finite, or no unit direction");
  }
}

}  // namespace hair
