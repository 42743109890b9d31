#include <apps/hair/plot/motion_plot.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include <apps/common/svg.h>
#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr double kLeft = 74, kTop = 18, kBottom = 400, kPanelWidth = 380, kPanelStep = 490;
constexpr double kWidth = kLeft + kPanelStep + kPanelWidth + 16, kHeight = 456;

// Rows that one dial tells apart.
struct Series {
  std::string name;
  std::string_view colour;
  double labelY;  // of a label from its marker
  int SimulationRow::* dial;
  std::vector<SimulationRow> rows;
};

// By what they differ in from the scene's own settings, which the twin has.
std::vector<Series> seriesOf(const SubstepTrial& trial) {
  const SimulationRow& own = trial.twin;
  const std::string solver = own.linkSolver == LinkSolver::Direct ? "direct: " : "relaxation: ";
  const std::string at = text("iterations at ", own.substeps, " substeps");
  std::vector<Series> all = {
      {solver + "substeps a frame", "#0072b2", -7, &SimulationRow::substeps, {}},
      {solver + at, "#009e73", 17, &SimulationRow::iterations, {}},
      {"relaxation: " + at, "#d55e00", -7, &SimulationRow::iterations, {}}};
  for (const SimulationRow& row : trial.rows) {
    const std::size_t which = row.linkSolver != own.linkSolver   ? 2
                              : row.iterations != own.iterations ? 1
                                                                 : 0;
    all[which].rows.push_back(row);
  }
  std::erase_if(all, [](const Series& s) { return s.rows.empty(); });
  return all;
}

template <class Value>
Axis axisOf(std::span<const Series> all, Value value, double from, double to) {
  double lowest = 1e12, highest = 0;
  for (const Series& series : all)
    for (const SimulationRow& row : series.rows) {
      lowest = std::min(lowest, value(row));
      highest = std::max(highest, value(row));
    }
  return logAxis(lowest, highest, from, to);
}

double timeOf(const SimulationRow& row) {
  return std::max(row.guidesMs, 1e-3);
}

template <class Value>
void drawPanel(Svg& svg, std::span<const Series> all, double left, std::string_view what,
               Value value, double floor) {
  const auto shown = [&](const SimulationRow& row) { return std::max(value(row), 1e-5); };
  const Axis x = axisOf(all, timeOf, left, left + kPanelWidth);
  const Axis y = axisOf(all, shown, kBottom, kTop);
  drawAxes(svg, x, y, "guides, ms a frame", what);
  if (floor > y.lowest && floor < y.highest) {
    svg.line(left, y.pixel(floor), left + kPanelWidth, y.pixel(floor),
             "stroke=\"#777\" stroke-dasharray=\"5 4\"");
    svg.words(left + 6, y.pixel(floor) - 5, "the reference's own uncertainty", "fill=\"#777\"");
  }
  for (const Series& series : all) {
    std::vector<double> line;
    for (const SimulationRow& row : series.rows)
      line.insert(line.end(), {x.pixel(timeOf(row)), y.pixel(shown(row))});
    svg.polyline(line, text("stroke=\"", series.colour, "\" stroke-width=\"1.6\""));
    for (std::size_t i = 0; i < series.rows.size(); ++i) {
      const double px = line[2 * i], py = line[2 * i + 1];
      svg.rectangle(px - 3.5, py - 3.5, 7, 7, text("fill=\"", series.colour, "\""));
      svg.words(px + 6, py + series.labelY, text(series.rows[i].*series.dial),
                text("font-size=\"11\" fill=\"", series.colour,
                     "\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\""));
    }
  }
}

}  // namespace

std::string motionPlot(const SubstepTrial& trial) {
  Svg svg(kWidth, kHeight, "Motion: error and stretch against time");
  const std::vector<Series> all = seriesOf(trial);
  if (all.empty()) return svg.str();
  drawPanel(
      svg, all, kLeft, "tips from the converged run, RMS (mm)",
      [](const SimulationRow& row) { return 1e3 * row.tips.rms; }, 1e3 * trial.reference.tips.rms);
  drawPanel(
      svg, all, kLeft + kPanelStep, "greatest stretch (%)",
      [](const SimulationRow& row) { return 100 * static_cast<double>(row.stretchMax); }, 0);
  double y = kTop + 20;
  for (const Series& series : all) {
    svg.rectangle(kLeft + kPanelWidth - 208, y - 7, 7, 7, text("fill=\"", series.colour, "\""));
    svg.words(kLeft + kPanelWidth - 194, y, series.name);
    y += 20;
  }
  return svg.str();
}

}  // namespace hair
