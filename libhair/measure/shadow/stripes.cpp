#include <libhair/measure/shadow/stripes.h>

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

#include <libhair/core/error.h>

namespace hair {

double stripeEnergy(std::span<const float> residual, std::span<const float> depth, double period) {
  require(residual.size() == depth.size(), "stripes: ", residual.size(), " residuals at ",
          depth.size(), " depths");
  require(residual.size() >= 3, "stripes: ", residual.size(), " points are fewer than 3");
  require(period > 0 && std::isfinite(period), "stripes: period ", period, " is not positive");
  // Normal equations of the basis (1, cos, sin), in mean values.
  glm::dmat3 products(0);
  glm::dvec3 projections(0);
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const double angle = 2 * std::numbers::pi * std::remainder(double{depth[i]} / period, 1.0);
    const glm::dvec3 basis(1, std::cos(angle), std::sin(angle));
    products += glm::outerProduct(basis, basis);
    projections += double{residual[i]} * basis;
  }
  const auto perPoint = 1.0 / static_cast<double>(residual.size());
  products *= perPoint;
  projections *= perPoint;
  // 1/4 where phases are spread evenly, 0 where they all are one or two.
  const double spread = glm::determinant(products);
  require(std::isfinite(spread) && spread > 1e-9,
          "stripes: depths all lie at one phase of the "
          "period ",
          period, ", or are not finite");
  const glm::dvec3 fit = glm::inverse(products) * projections;
  return 0.5 * (fit.y * fit.y + fit.z * fit.z);
}

}  // namespace hair
