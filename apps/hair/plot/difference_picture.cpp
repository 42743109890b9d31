#include <apps/hair/plot/difference_picture.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

#include <apps/common/svg.h>
#include <apps/hair/plot/method_style.h>
#include <libhair/core/error.h>
#include <libhair/model/resample.h>

namespace hair {

namespace {

constexpr int kColumns = 4, kLevels = 17;
constexpr double kPanelWidth = 216, kTallest = 300, kGapX = 16, kGapY = 48, kTop = 40;
constexpr double kLegend = 66;

// Stops of a colour map, evenly from 0 to 1.
using Map = std::span<const glm::vec3>;
// Too dark is blue, too light is red, right is a light grey (after ColorBrewer's RdBu).
constexpr glm::vec3 kDifference[] = {{8, 48, 107},    {33, 102, 172}, {103, 169, 207},
                                     {222, 222, 222}, {239, 138, 98}, {178, 24, 43},
                                     {103, 0, 31}};
// Cividis: light and dark also to the colour-blind.
constexpr glm::vec3 kTransmittance[] = {{0, 34, 78},     {53, 69, 108},   {102, 105, 112},
                                        {148, 142, 119}, {200, 184, 102}, {254, 232, 56}};

std::string colourAt(Map map, double part) {
  const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(map.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), map.size() - 2);
  const glm::vec3 c =
      glm::mix(map[below], map[below + 1], static_cast<float>(at - static_cast<double>(below)));
  char hex[8];
  std::snprintf(hex, sizeof hex, "#%02x%02x%02x", static_cast<unsigned>(c.x + 0.5f),
                static_cast<unsigned>(c.y + 0.5f), static_cast<unsigned>(c.z + 0.5f));
  return hex;
}

// How world is put on the picture. Pictures count in tenths of a pixel, so that whole numbers do.
struct View {
  glm::vec3 right, up;
  glm::dvec2 centre{0};  // along right and up, metres
  double scale = 1;      // pixels a metre

  glm::ivec2 dot(glm::vec3 p) const {
    const double x = static_cast<double>(glm::dot(p, right)) - centre.x;
    const double y = static_cast<double>(glm::dot(p, up)) - centre.y;
    return {std::lround(10 * (0.5 * kPanelWidth + scale * x)),
            std::lround(10 * (0.5 * height - scale * y))};
  }

  std::vector<glm::ivec2> dots;  // [points]
  double height = 0;             // pixels
  double diameter = 1;           // of a dot, tenths
};

View makeView(StrandView strands, std::span<const SamplePoint> points, const LightSpace& light) {
  const glm::vec3 way = light.direction();
  const glm::vec3 world = std::abs(way.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  // The eye looks along `world` x light; light then runs in the picture, +Y stays up.
  const glm::vec3 eye = glm::normalize(glm::cross(world, way));
  View view;
  view.up = std::abs(way.y) < 0.999f ? world : glm::vec3(0, 1, 0);
  view.right = glm::normalize(glm::cross(eye, view.up));
  Bounds box;
  for (const glm::vec3 p : strands.points)
    box.extend({glm::dot(p, view.right), glm::dot(p, view.up), 0});
  const glm::dvec3 size = glm::max(glm::dvec3(box.size()), glm::dvec3(1e-6));
  view.scale = std::min((kPanelWidth - 10) / size.x, (kTallest - 10) / size.y);
  view.height = size.y * view.scale + 10;
  view.centre = glm::dvec2(box.centre());
  for (const SamplePoint& p : points) view.dots.push_back(view.dot(p.position));
  const double area = size.x * size.y * view.scale * view.scale;
  view.diameter =
      10 * std::clamp(std::sqrt(0.9 * area / static_cast<double>(points.size() + 1)), 1.4, 6.0);
  return view;
}

// One path a colour: a dot is then some ten bytes. `order` tells which level is drawn first.
void drawDots(Svg& svg, const View& view, double x, double y, const std::vector<float>& part,
              Map map, bool extremesOnTop) {
  std::vector<std::string> paths(kLevels);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double level = std::clamp(static_cast<double>(part[i]), 0.0, 1.0) * (kLevels - 1);
    paths[static_cast<std::size_t>(std::lround(level))] +=
        text('M', view.dots[i].x, ' ', view.dots[i].y, "h0");
  }
  svg.raw(text("<g transform=\"translate(", x, ' ', y,
               ") scale(.1)\" fill=\"none\" "
               "stroke-linecap=\"round\" stroke-width=\"",
               brief(view.diameter), "\">\n"));
  std::vector<int> order;
  for (int level = 0; level < kLevels; ++level) order.push_back(level);
  if (extremesOnTop)
    std::stable_sort(order.begin(), order.end(), [](int a, int b) {
      return std::abs(a - kLevels / 2) < std::abs(b - kLevels / 2);
    });
  for (const int level : order)
    if (const std::string& path = paths[static_cast<std::size_t>(level)]; !path.empty())
      svg.raw(text("<path stroke=\"", colourAt(map, static_cast<double>(level) / (kLevels - 1)),
                   "\" d=\"", path, "\"/>\n"));
  svg.raw("</g>\n");
}

std::string rounded(double error) {
  return brief(std::round(error * 1e4) * 1e-4);
}

// Some strands, to show where on the head the points are.
std::string strandsPath(StrandView strands, const View& view) {
  constexpr std::size_t kStrands = 220, kPoints = 24;
  std::string path;
  for (const std::uint32_t s : chooseStrands(strands.strandCount(), kStrands)) {
    const auto points = strands.strand(s);
    const std::size_t steps = std::min(points.size(), kPoints) - 1;
    for (std::size_t k = 0; k <= steps; ++k) {
      const glm::ivec2 at =
          view.dot(points[k * (points.size() - 1) / std::max<std::size_t>(steps, 1)]);
      path += text(k == 0 ? 'M' : 'L', at.x, ' ', at.y);
    }
  }
  return path;
}

// 1-2-5, so that nine tenths of all differences are on the scale.
double scaleOf(const MeasuredCase& measured) {
  std::vector<double> sizes;
  for (const std::size_t t : measured.best)
    for (std::size_t i = 0; i < measured.truth.transmittance.size(); ++i)
      sizes.push_back(static_cast<double>(
          std::abs(measured.trials[t].transmittance[i] - measured.truth.transmittance[i])));
  if (sizes.empty()) return 0.1;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) * 9 / 10);
  std::nth_element(sizes.begin(), at, sizes.end());
  for (const double limit : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5})
    if (*at <= limit) return limit;
  return 1;
}

void drawScale(Svg& svg, double x, double y, double width, Map map,
               const std::vector<std::pair<double, std::string>>& ticks, std::string_view title) {
  for (int level = 0; level < kLevels; ++level)
    svg.rectangle(x + width * level / kLevels, y, width / kLevels + 0.5, 11,
                  text("fill=\"", colourAt(map, static_cast<double>(level) / (kLevels - 1)), "\""));
  for (const auto& [part, label] : ticks) {
    const double at = x + width * (0.5 + part * (kLevels - 1)) / kLevels;
    svg.line(at, y + 11, at, y + 15, "stroke=\"#555\"");
    svg.words(at, y + 27, label, "text-anchor=\"middle\" font-size=\"11\"");
  }
  svg.words(x + 0.5 * width, y - 6, title, "text-anchor=\"middle\" font-size=\"11.5\"");
}

void drawLightArrow(Svg& svg, const MeasuredLight& light, const View& view, glm::dvec2 middle) {
  const glm::vec3 way = light.space.direction();
  glm::dvec2 on(glm::dot(way, view.right), -glm::dot(way, view.up));
  on /= std::max(glm::length(on), 1e-6);
  const glm::dvec2 tip = middle + 15.0 * on, tail = middle - 15.0 * on, side(-on.y, on.x);
  svg.line(tail.x, tail.y, tip.x, tip.y, "stroke=\"#222\" stroke-width=\"2\"");
  svg.polyline({tip.x - 8 * on.x + 4 * side.x, tip.y - 8 * on.y + 4 * side.y, tip.x, tip.y,
                tip.x - 8 * on.x - 4 * side.x, tip.y - 8 * on.y - 4 * side.y},
               "stroke=\"#222\" stroke-width=\"2\"");
  svg.words(middle.x + 26, middle.y + 4, light.atPoint ? "light at the middle" : "light");
}

}  // namespace

std::string differencePictures(const MeasureReport& report, const MeasuredCase& measured) {
  const View view = makeView(report.hair.strands, report.points, measured.light.space);
  const int panels = static_cast<int>(measured.best.size()) + 1;
  const int rows = (panels + kColumns - 1) / kColumns;
  const double bottom = kTop + rows * (view.height + kGapY) - kGapY;
  Svg svg(kColumns * (kPanelWidth + kGapX), bottom + kLegend, "Difference from the truth");
  const double limit = scaleOf(measured);
  const std::string strands = strandsPath(report.hair.strands, view);
  for (int panel = 0; panel < panels; ++panel) {
    const double x = (panel % kColumns) * (kPanelWidth + kGapX);
    const double y = kTop + (panel / kColumns) * (view.height + kGapY);
    svg.rectangle(x, y, kPanelWidth, view.height, "fill=\"#fff\" stroke=\"#ccc\"");
    svg.raw(text("<path transform=\"translate(", brief(x, 5), ' ', brief(y, 5),
                 ") scale(.1)\" fill=\"none\" stroke=\"#e6e6e6\" stroke-width=\"5\" d=\"", strands,
                 "\"/>\n"));
    if (panel == 0) {
      svg.words(x, y - 19, "truth", "font-weight=\"bold\"");
      svg.words(x, y - 5, "transmittance", "font-size=\"10.5\" fill=\"#555\"");
      drawDots(svg, view, x, y, measured.truth.transmittance, kTransmittance, false);
      continue;
    }
    const ShadowTrial& trial = measured.trials[measured.best[static_cast<std::size_t>(panel) - 1]];
    std::vector<float> part;
    for (std::size_t i = 0; i < trial.transmittance.size(); ++i)
      part.push_back(0.5f + 0.5f * (trial.transmittance[i] - measured.truth.transmittance[i]) /
                                static_cast<float>(limit));
    svg.raw(marker(trial.candidate.method, x + 7, y - 23, 0.95));
    svg.words(x + 18, y - 19, trial.candidate.method, "font-weight=\"bold\"");
    svg.words(x, y - 5,
              text("mean absolute ", rounded(trial.error.meanAbsolute.value), ", bias ",
                   rounded(trial.error.bias.value)),
              "font-size=\"10.5\" fill=\"#555\"");
    drawDots(svg, view, x, y, part, kDifference, true);
  }
  drawScale(svg, 8, bottom + 30, 200, kTransmittance, {{0, "0"}, {0.5, "0.5"}, {1, "1"}},
            "transmittance (truth)");
  const std::string plus = brief(limit), half = brief(limit / 2);
  drawScale(svg, kPanelWidth + kGapX + 8, bottom + 30, 420, kDifference,
            {{0, "-" + plus}, {0.25, "-" + half}, {0.5, "0"}, {0.75, half}, {1, plus}},
            "method less truth: too dark (blue) to too light (red); larger differences on top");
  drawLightArrow(svg, measured.light, view, {3 * (kPanelWidth + kGapX) + 40, bottom + 36});
  return svg.str();
}

}  // namespace hair
