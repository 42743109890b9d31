#include <apps/hair/plot/visibility_plot.h>

#include <apps/common/svg.h>
#include <apps/hair/plot/method_style.h>
#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr int kColumns = 4;
constexpr double kPanelWidth = 208, kPanelHeight = 170, kGapX = 36, kGapY = 66;
constexpr double kLeft = 54, kTop = 46, kBottom = 52;

void drawCurve(Svg& svg, const std::vector<float>& depth, const std::vector<float>& values,
               const Axis& x, const Axis& y, std::string_view attributes) {
  std::vector<double> line;
  for (std::size_t i = 0; i < depth.size(); ++i)
    line.insert(line.end(), {x.pixel(static_cast<double>(depth[i]) * 1000),
                             y.pixel(static_cast<double>(values[i]))});
  svg.polyline(line, attributes);
}

void drawLegend(Svg& svg, double x, double y) {
  svg.line(x, y, x + 30, y, "stroke=\"#c4c4c4\" stroke-width=\"6\"");
  svg.words(x + 38, y + 4, "truth");
  svg.line(x, y + 22, x + 30, y + 22, "stroke=\"#444\" stroke-width=\"2\"");
  svg.words(x + 38, y + 26, "most accurate setting");
  svg.line(x, y + 44, x + 30, y + 44,
           "stroke=\"#444\" stroke-width=\"0.9\" stroke-opacity=\"0.5\"");
  svg.words(x + 38, y + 48, "other settings");
}

}  // namespace

std::string visibilityPlot(const MeasuredCase& measured) {
  const int panels = static_cast<int>(measured.best.size());
  const int rows = panels / kColumns + 1;  // with a place for the legend
  Svg svg(kLeft + kColumns * (kPanelWidth + kGapX),
          kTop + rows * (kPanelHeight + kGapY) - kGapY + kBottom, "Transmittance along one ray");
  for (int panel = 0; panel < panels; ++panel) {
    const std::size_t best = measured.best[static_cast<std::size_t>(panel)];
    const ShadowCandidate& candidate = measured.trials[best].candidate;
    const double left = kLeft + (panel % kColumns) * (kPanelWidth + kGapX);
    const double top = kTop + (panel / kColumns) * (kPanelHeight + kGapY);
    const double bottom = top + kPanelHeight, right = left + kPanelWidth;
    const Axis x =
        linearAxis(0, static_cast<double>(measured.ray.depth.back()) * 1000, left, right, 5);
    const Axis y = linearAxis(0, 1.02, bottom, top, 5);
    for (const Axis::Tick& tick : x.ticks) {
      const double at = x.pixel(tick.value);
      svg.line(at, bottom, at, bottom + 4, "stroke=\"#555\"");
      svg.words(at, bottom + 17, tick.label, "text-anchor=\"middle\" font-size=\"11\"");
    }
    for (const Axis::Tick& tick : y.ticks) {
      const double at = y.pixel(tick.value);
      svg.line(left, at, right, at, "stroke=\"#eee\"");
      svg.line(left - 4, at, left, at, "stroke=\"#555\"");
      svg.words(left - 7, at + 4, tick.label, "text-anchor=\"end\" font-size=\"11\"");
    }
    svg.rectangle(left, top, kPanelWidth, kPanelHeight, "fill=\"none\" stroke=\"#555\"");
    drawCurve(svg, measured.ray.depth, measured.ray.truth, x, y,
              "stroke=\"#c4c4c4\" stroke-width=\"6\" stroke-linejoin=\"round\"");
    const auto colour = methodStyle(candidate.method).colour;
    for (const ShadowTrial& trial : measured.trials)
      if (!trial.failed() && trial.candidate.method == candidate.method)
        drawCurve(svg, measured.ray.depth, trial.probes, x, y,
                  text("stroke=\"", colour, "\" stroke-width=\"0.9\" stroke-opacity=\"0.4\""));
    drawCurve(svg, measured.ray.depth, measured.trials[best].probes, x, y,
              text("stroke=\"", colour, "\" stroke-width=\"2\" stroke-linejoin=\"round\""));
    svg.raw(marker(candidate.method, left + 7, top - 23, 0.95));
    svg.words(left + 18, top - 19, candidate.method, "font-weight=\"bold\"");
    const std::string settings = candidate.label == candidate.method
                                     ? settingsText(candidate.settings)
                                     : candidate.label.substr(candidate.method.size() + 1);
    svg.words(left, top - 5, settings,
              text("font-size=\"", textWidth(settings, 10.5) > kPanelWidth + 20 ? 9.2 : 10.5,
                   "\" fill=\"#555\""));
    if (panel + kColumns >= panels)
      svg.words(0.5 * (left + right), bottom + 36, "depth along the ray (mm)",
                "text-anchor=\"middle\"");
    if (panel % kColumns == 0)
      svg.words(0, 0, "transmittance",
                text("text-anchor=\"middle\" transform=\"translate(14 ", 0.5 * (top + bottom),
                     ") rotate(-90)\""));
  }
  drawLegend(svg, kLeft + (panels % kColumns) * (kPanelWidth + kGapX),
             kTop + (panels / kColumns) * (kPanelHeight + kGapY) + 30);
  return svg.str();
}

}  // namespace hair
