#include <gtest/gtest.h>

#include <libhair/core/error.h>

#include "methods.h"

// The methods again, written as the papers say it: no walk, no table, no integers.

namespace hair {
namespace {

using test::nearLight;
using test::parallelLight;
using Deep = DeepOpacityMapSettings;

struct Scene {
  StrandSet hair = test::headOfHair(80, 14);  // and a few strands of many points, below
  Fibre fibre{80e-6f, 0.6f, 12.0f};
  LightSpace light;
};

struct Piece {
  double depth, opticalDepth;
};

/// What is inside pixel (j, k): every segment is clipped against the pixel's four sides.
std::vector<Piece> piecesOf(const Scene& scene, const LightImage& image, int j, int k,
                            double alpha) {
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < scene.hair.strandCount(); ++s) {
    const auto points = scene.hair.strand(s);
    for (std::size_t p = 1; p < points.size(); ++p) {
      const glm::dvec3 a = image.frame.cellCoordinates(points[p - 1]);
      const glm::dvec3 b = image.frame.cellCoordinates(points[p]);
      const glm::dvec3 d = b - a;
      double from = 0, to = 1;
      const int cell[] = {j, k};
      for (int axis = 1; axis < 3; ++axis) {
        double t0 = (cell[axis - 1] - a[axis]) / d[axis];
        double t1 = (cell[axis - 1] + 1 - a[axis]) / d[axis];
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
      }
      if (to <= from) continue;
      const double g = static_cast<double>(image.frame.magnification(glm::vec3(0.5 * (a + b))));
      const double across = (to - from) * std::hypot(d.y, d.z);
      pieces.push_back({a.x + d.x * 0.5 * (from + to),
                        across * g * double{scene.fibre.width * scene.fibre.hairsPerStrand} *
                            alpha / double{image.pixelSize}});
    }
  }
  return pieces;
}

/// Linear between the values at planes[0] (where it is 0) and on.
double between(const std::vector<double>& planes, const std::vector<double>& values, double x) {
  if (x <= planes.front()) return values.front();
  for (std::size_t k = 1; k < planes.size(); ++k)
    if (x < planes[k])
      return values[k - 1] +
             (values[k] - values[k - 1]) * (x - planes[k - 1]) / (planes[k] - planes[k - 1]);
  return values.back();
}

double inFrontOf(const std::vector<Piece>& pieces, double plane) {
  double sum = 0;
  for (const Piece& piece : pieces) sum += piece.depth < plane ? piece.opticalDepth : 0;
  return sum;
}

/// Per covered area, of fibres of 80 micrometres that take 0.6 of the light: in a pixel that one
/// crosses, 1 - 0.6 · covered part is left.
double alphaOf(Extinction extinction, float pixelSize) {
  const double cover = 80e-6 / static_cast<double>(pixelSize);
  return extinction == Extinction::Unbiased ? -std::log(1 - 0.6 * cover) / cover : -std::log(0.4);
}

/// Optical depth that a pixel has in front of `depth`.
using PixelDepth = std::function<double(const LightImage&, int j, int k, double depth)>;

void expectLike(const Scene& scene, ShadowMethod& method, float pixelSize, LateralFilter filter,
                const PixelDepth& pixelDepth) {
  const LightImage image = makeLightImage(scene.hair, scene.light, pixelSize);
  method.build(scene.hair, scene.fibre, scene.light);
  std::vector<glm::vec3> points;
  for (std::size_t p = 0; p < scene.hair.pointCount(); p += 5)
    points.push_back(scene.hair.points[p]);
  for (std::uint32_t i = 0; i < 60; ++i)
    points.push_back(0.4f * glm::vec3(uniform(i, 0), uniform(i, 1), uniform(i, 2)) - 0.2f);
  const auto measured = test::sampled(method, points);
  int shadowed = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::dvec3 u = image.frame.cellCoordinates(points[p]);
    const auto pixel = [&](int j, int k) { return std::exp(-pixelDepth(image, j, k, u.x)); };
    double expected;
    if (filter == LateralFilter::Nearest) {
      expected = pixel(static_cast<int>(std::floor(u.y)), static_cast<int>(std::floor(u.z)));
    } else {
      const double y = u.y - 0.5, z = u.z - 0.5;
      const int j = static_cast<int>(std::floor(y)), k = static_cast<int>(std::floor(z));
      expected = glm::mix(glm::mix(pixel(j, k), pixel(j + 1, k), y - j),
                          glm::mix(pixel(j, k + 1), pixel(j + 1, k + 1), y - j), z - k);
    }
    ASSERT_NEAR(double{measured[p]}, expected, 1e-5) << "point " << p;
    shadowed += expected < 0.9 ? 1 : 0;
  }
  EXPECT_GT(shadowed, 30);
}

std::vector<Scene> scenes() {
  std::vector<Scene> all(2);
  const StrandSet fine = test::headOfHair(4, 150, 0.2f);
  for (Scene& scene : all)
    for (std::size_t s = 0; s < fine.strandCount(); ++s) scene.hair.append(fine.strand(s));
  all[0].light = parallelLight();
  all[1].light = nearLight(0.6f);
  return all;
}

TEST(OpacityMap, IsTheSumOverTheFragmentsOfAPixel) {
  for (const Scene& scene : scenes())
    for (LateralFilter filter : {LateralFilter::Nearest, LateralFilter::Linear})
      for (Extinction extinction : {Extinction::Unbiased, Extinction::Published})
        for (int slices : {1, 7, 64}) {
          SCOPED_TRACE(text(slices, " slices, filter ", static_cast<int>(filter)));
          OpacityMapSettings s;
          s.pixelSize = 5e-3f;
          s.slices = slices;
          s.filter = filter;
          s.extinction = extinction;
          const auto method = makeOpacityMap(s);
          expectLike(scene, *method, s.pixelSize, filter,
                     [&](const LightImage& image, int j, int k, double depth) {
                       const auto pieces =
                           piecesOf(scene, image, j, k, alphaOf(extinction, s.pixelSize));
                       std::vector<double> planes, values;
                       for (int n = 0; n <= slices; ++n) {
                         planes.push_back(double{image.nearest} +
                                          double{image.farthest - image.nearest} * n / slices);
                         values.push_back(n == slices ? inFrontOf(pieces, 1e9)
                                                      : inFrontOf(pieces, planes.back()));
                       }
                       return between(planes, values, depth);
                     });
        }
}

TEST(DeepOpacityMap, IsTheSumOverTheFragmentsOfAPixel) {
  const auto sizes = [](Deep::Growth growth) -> std::vector<double> {
    switch (growth) {
      case Deep::Growth::Constant:
        return {1, 1, 1, 1, 1};
      case Deep::Growth::Linear:
        return {1, 2, 3, 4, 5};
      case Deep::Growth::Doubling:
        return {1, 2, 4, 8, 16};
      case Deep::Growth::Fibonacci:
        return {1, 2, 3, 5, 8};
    }
    return {};
  };
  for (const Scene& scene : scenes())
    for (auto growth : {Deep::Growth::Constant, Deep::Growth::Linear, Deep::Growth::Doubling,
                        Deep::Growth::Fibonacci})
      for (auto beyond :
           {Deep::Beyond::Ignored, Deep::Beyond::InLastLayer, Deep::Beyond::LargerLayers}) {
        SCOPED_TRACE(
            text("growth ", static_cast<int>(growth), ", beyond ", static_cast<int>(beyond)));
        Deep s;
        s.pixelSize = 5e-3f;
        s.layers = 5;
        s.growth = growth;
        s.beyond = beyond;
        s.depth = 0.04f;
        const auto method = makeDeepOpacityMap(s);
        expectLike(scene, *method, s.pixelSize, s.filter,
                   [&](const LightImage& image, int j, int k, double depth) {
                     const auto pieces =
                         piecesOf(scene, image, j, k, alphaOf(Extinction::Unbiased, s.pixelSize));
                     if (pieces.empty()) return 0.0;
                     double z0 = 1e30;
                     for (const Piece& piece : pieces) z0 = std::min(z0, piece.depth);
                     const double whole = beyond == Deep::Beyond::LargerLayers
                                              ? double{image.farthest - image.nearest}
                                              : 0.04 / 5e-3;
                     double sum = 0;
                     for (double size : sizes(growth)) sum += size;
                     std::vector<double> planes{z0}, values{0};
                     double end = 0;
                     for (double size : sizes(growth)) {
                       planes.push_back(z0 + whole * (end += size) / sum);
                       values.push_back(inFrontOf(pieces, planes.back()));
                     }
                     if (beyond != Deep::Beyond::Ignored) values.back() = inFrontOf(pieces, 1e9);
                     return between(planes, values, depth);
                   });
      }
}

TEST(ShadowMap, IsTheShareOfThePixelsInADiscThatSeeThePoint) {
  for (const Scene& scene : scenes())
    for (float radius : {0.0f, 4e-3f, 15e-3f}) {
      ShadowMapSettings s;
      s.pixelSize = 5e-3f;
      s.filterRadius = radius;
      s.bias = 2e-3f;
      const auto method = makeShadowMap(s);
      const LightImage image = makeLightImage(scene.hair, scene.light, s.pixelSize);
      method->build(scene.hair, scene.fibre, scene.light);
      std::vector<double> first(image.pixelCount(), 1e30);
      for (int k = 0; k < image.size.y; ++k)
        for (int j = 0; j < image.size.x; ++j)
          for (const Piece& piece :
               piecesOf(scene, image, image.lower.x + j, image.lower.y + k, 0.6)) {
            double& z0 = first[image.index(image.lower.x + j, image.lower.y + k)];
            z0 = std::min(z0, piece.depth);
          }
      const auto measured = test::sampled(*method, scene.hair.points);
      int between = 0;
      for (std::size_t p = 0; p < scene.hair.pointCount(); ++p) {
        const glm::dvec3 u = image.frame.cellCoordinates(scene.hair.points[p]);
        const double r = double{radius / s.pixelSize}, depth = u.x - double{s.bias / s.pixelSize};
        int pixels = 0, lit = 0;
        const auto compare = [&](int j, int k) {
          ++pixels;
          lit += !image.inside(j, k) || depth <= first[image.index(j, k)] ? 1 : 0;
        };
        const int j0 = static_cast<int>(std::floor(u.y)), k0 = static_cast<int>(std::floor(u.z));
        for (int k = k0 - 5; k <= k0 + 5; ++k)
          for (int j = j0 - 5; j <= j0 + 5; ++j)
            if (std::hypot(j + 0.5 - u.y, k + 0.5 - u.z) <= r) compare(j, k);
        if (pixels == 0) compare(j0, k0);
        ASSERT_NEAR(double{measured[p]}, double{static_cast<float>(lit)} / pixels, 1e-6) << p;
        between += lit > 0 && lit < pixels ? 1 : 0;
      }
      EXPECT_EQ(between > 100, radius > 0);
    }
}

}  // namespace
}  // namespace hair
