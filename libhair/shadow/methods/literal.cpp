#include <libhair/shadow/methods/literal.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace hair::literal {

namespace {

// The part of a segment inside a pixel.
struct Piece {
  double depth;         // of its middle, pixels
  double opticalDepth;  // mean over the pixel
};

// -ln of the light that passes a pixel covered once, per covered area; see extinctionOf.
double extinction(const Fibre& fibre, Extinction kind, double pixelSize) {
  const double cover = double{fibre.width} / pixelSize, opacity = double{fibre.opacity};
  return kind == Extinction::Unbiased ? -std::log(1 - opacity * cover) / cover
                                      : -std::log(1 - opacity);
}

// What is inside pixel (j, k): every segment clipped at the pixel's four sides. `alpha`:
// extinction.
std::vector<Piece> piecesOf(StrandView strands, const Fibre& fibre, const LightImage& image, int j,
                            int k, double alpha) {
  const double widthInPixels =
      double{fibre.width} * double{fibre.hairsPerStrand} / double{image.pixelSize};
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto points = strands.strand(s);
    for (std::size_t p = 1; p < points.size(); ++p) {
      const glm::dvec3 a = image.frame.cellCoordinates(points[p - 1]);
      const glm::dvec3 b = image.frame.cellCoordinates(points[p]);
      const glm::dvec3 d = b - a;
      double from = 0, to = 1;
      const int pixel[] = {j, k};
      for (int axis = 1; axis < 3; ++axis) {
        const double t0 = (pixel[axis - 1] - a[axis]) / d[axis];
        const double t1 = (pixel[axis - 1] + 1 - a[axis]) / d[axis];
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
      }
      if (to <= from) continue;
      const double g = static_cast<double>(image.frame.magnification(glm::vec3(0.5 * (a + b))));
      pieces.push_back({a.x + d.x * 0.5 * (from + to),
                        (to - from) * std::hypot(d.y, d.z) * g * widthInPixels * alpha});
    }
  }
  return pieces;
}

// Optical depth in front of a plane.
double inFrontOf(const std::vector<Piece>& pieces, double plane) {
  double sum = 0;
  for (const Piece& piece : pieces) sum += piece.depth < plane ? piece.opticalDepth : 0;
  return sum;
}

// Depth of the nearest hair.
double nearest(const std::vector<Piece>& pieces) {
  double depth = INFINITY;
  for (const Piece& piece : pieces) depth = std::min(depth, piece.depth);
  return depth;
}

// Linear between the values at the planes; constant before the first and behind the last.
double between(const std::vector<double>& planes, const std::vector<double>& values, double x) {
  if (x <= planes.front()) return values.front();
  for (std::size_t k = 1; k < planes.size(); ++k)
    if (x < planes[k])
      return values[k - 1] +
             (values[k] - values[k - 1]) * (x - planes[k - 1]) / (planes[k] - planes[k - 1]);
  return values.back();
}

// Filters the transmittances of pixels. `opticalDepth`: of pixel (j, k), in front of a depth.
std::vector<double> filtered(
    const LightImage& image, LateralFilter filter, std::span<const glm::vec3> points,
    const std::function<double(int j, int k, double depth)>& opticalDepth) {
  std::vector<double> out;
  for (const glm::vec3 p : points) {
    const glm::dvec3 u = image.frame.cellCoordinates(p);
    const auto pixel = [&](int j, int k) { return std::exp(-opticalDepth(j, k, u.x)); };
    if (filter == LateralFilter::Nearest) {
      out.push_back(pixel(static_cast<int>(std::floor(u.y)), static_cast<int>(std::floor(u.z))));
      continue;
    }
    const double y = u.y - 0.5, z = u.z - 0.5;
    const int j = static_cast<int>(std::floor(y)), k = static_cast<int>(std::floor(z));
    out.push_back(glm::mix(glm::mix(pixel(j, k), pixel(j + 1, k), y - j),
                           glm::mix(pixel(j, k + 1), pixel(j + 1, k + 1), y - j), z - k));
  }
  return out;
}

// Sizes of the layers, relative to the first.
std::vector<double> layerSizes(DeepOpacityMapSettings::Growth growth, int layers) {
  using Growth = DeepOpacityMapSettings::Growth;
  std::vector<double> sizes;
  for (int n = 0; n < layers; ++n)
    sizes.push_back(growth == Growth::Constant   ? 1
                    : growth == Growth::Linear   ? n + 1
                    : growth == Growth::Doubling ? std::exp2(n)
                    : n < 2                      ? n + 1
                                                 : sizes[static_cast<std::size_t>(n) - 1] +
                                  sizes[static_cast<std::size_t>(n) - 2]);
  return sizes;
}

}  // namespace

std::vector<double> transmittance(StrandView strands, const Fibre& fibre, const LightSpace& light,
                                  const OpacityMapSettings& settings,
                                  std::span<const glm::vec3> points) {
  const LightImage image = makeLightImage(strands, light, settings.pixelSize);
  const double alpha = extinction(fibre, settings.extinction, double{settings.pixelSize});
  return filtered(image, settings.filter, points, [&](int j, int k, double depth) {
    const auto pieces = piecesOf(strands, fibre, image, j, k, alpha);
    std::vector<double> planes, values;
    for (int n = 0; n <= settings.slices; ++n) {
      planes.push_back(double{image.nearest} +
                       double{image.farthest - image.nearest} * n / settings.slices);
      values.push_back(inFrontOf(pieces, n == settings.slices ? INFINITY : planes.back()));
    }
    return between(planes, values, depth);
  });
}

std::vector<double> transmittance(StrandView strands, const Fibre& fibre, const LightSpace& light,
                                  const DeepOpacityMapSettings& settings,
                                  std::span<const glm::vec3> points) {
  using Beyond = DeepOpacityMapSettings::Beyond;
  const LightImage image = makeLightImage(strands, light, settings.pixelSize);
  const double alpha = extinction(fibre, settings.extinction, double{settings.pixelSize});
  const double whole = settings.beyond == Beyond::LargerLayers
                           ? double{image.farthest - image.nearest}
                           : double{settings.depth} / double{settings.pixelSize};
  const std::vector<double> sizes = layerSizes(settings.growth, settings.layers);
  double sum = 0;
  for (const double size : sizes) sum += size;
  return filtered(image, settings.filter, points, [&](int j, int k, double depth) {
    const auto pieces = piecesOf(strands, fibre, image, j, k, alpha);
    if (pieces.empty()) return 0.0;
    const double z0 = nearest(pieces);
    std::vector<double> planes{z0}, values{0};
    double end = 0;
    for (const double size : sizes) {
      planes.push_back(z0 + whole * (end += size) / sum);
      values.push_back(inFrontOf(pieces, planes.back()));
    }
    if (settings.beyond != Beyond::Ignored) values.back() = inFrontOf(pieces, INFINITY);
    return between(planes, values, depth);
  });
}

std::vector<double> transmittance(StrandView strands, const LightSpace& light,
                                  const ShadowMapSettings& settings,
                                  std::span<const glm::vec3> points) {
  const LightImage image = makeLightImage(strands, light, settings.pixelSize);
  std::vector<double> first(image.pixelCount());
  for (int k = image.lower.y; k < image.lower.y + image.size.y; ++k)
    for (int j = image.lower.x; j < image.lower.x + image.size.x; ++j)
      first[image.index(j, k)] = nearest(piecesOf(strands, {}, image, j, k, 1));
  const double radius = double{settings.filterRadius} / double{settings.pixelSize};
  const double bias = double{settings.bias} / double{settings.pixelSize};
  std::vector<double> out;
  for (const glm::vec3 p : points) {
    const glm::dvec3 u = image.frame.cellCoordinates(p);
    int pixels = 0, lit = 0;
    const auto compare = [&](int j, int k) {
      ++pixels;
      lit += !image.inside(j, k) || u.x - bias <= first[image.index(j, k)] ? 1 : 0;
    };
    const int j0 = static_cast<int>(std::floor(u.y)), k0 = static_cast<int>(std::floor(u.z));
    const int reach = static_cast<int>(std::ceil(radius)) + 1;
    for (int k = k0 - reach; k <= k0 + reach; ++k)
      for (int j = j0 - reach; j <= j0 + reach; ++j)
        if (std::hypot(j + 0.5 - u.y, k + 0.5 - u.z) <= radius) compare(j, k);
    if (pixels == 0) compare(j0, k0);
    out.push_back(static_cast<double>(lit) / pixels);
  }
  return out;
}

}  // namespace hair::literal
