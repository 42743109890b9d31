#include <apps/hair/plot/error_time_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <apps/common/svg.h>
#include <apps/hair/plot/method_style.h>
#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr double kWidth = 940, kHeight = 560;
constexpr double kLeft = 74, kRight = 764, kTop = 18, kBottom = 500;
constexpr double kLabelSize = 11;

struct Box {
  double x0, y0, x1, y1;
  double overlap(const Box& o) const {
    return std::max(0.0, std::min(x1, o.x1) - std::max(x0, o.x0)) *
           std::max(0.0, std::min(y1, o.y1) - std::max(y0, o.y0));
  }
};

Box around(double x, double y, double half) {
  return {x - half, y - half, x + half, y + half};
}

struct Placed {
  Box box;
  double x, y;  // of the point that it names
};

// A place for each label where it covers the least of markers, labels and the front. Tried: eight
// directions, near first.
class LabelPlacer {
 public:
  explicit LabelPlacer(Box area) : area_(area) {}
  void avoid(const Box& box) { taken_.push_back(box); }

  Box place(double x, double y, double width, double height) {
    Box best{};
    double least = std::numeric_limits<double>::infinity();
    constexpr double kAway[] = {9, 20, 34, 50, 70, 95};
    constexpr double kWays[][2] = {{-1, 1}, {-1, 0}, {1, -1},  {1, 0},
                                   {0, 1},  {0, -1}, {-1, -1}, {1, 1}};
    for (const double away : kAway)
      for (const auto& way : kWays) {
        const double cx = x + way[0] * (away + 0.5 * width);
        const double cy = y + way[1] * (way[0] == 0 ? away + 0.5 * height : 0.8 * away);
        const Box box{cx - 0.5 * width, cy - 0.5 * height, cx + 0.5 * width, cy + 0.5 * height};
        if (box.x0 < area_.x0 || box.x1 > area_.x1 || box.y0 < area_.y0 || box.y1 > area_.y1)
          continue;
        double cost = 0.25 * away;
        for (const Box& other : taken_) cost += box.overlap(other);
        if (cost < least) {
          least = cost;
          best = box;
        }
      }
    if (least == std::numeric_limits<double>::infinity())
      best = {x - width - 9, y - 0.5 * height, x - 9, y + 0.5 * height};
    // What is written there keeps others off by more than a marker does.
    for (int weight = 0; weight < 6; ++weight) taken_.push_back(best);
    return best;
  }

 private:
  Box area_;
  std::vector<Box> taken_;
};

void drawLegend(Svg& svg, std::span<const ShadowTrial> trials) {
  std::vector<std::string> methods;
  for (const ShadowTrial& trial : trials)
    if (!trial.failed() &&
        std::find(methods.begin(), methods.end(), trial.candidate.method) == methods.end())
      methods.push_back(trial.candidate.method);
  double y = kTop + 14;
  for (const std::string& method : methods) {
    svg.raw(marker(method, kRight + 24, y, 1.05));
    svg.words(kRight + 38, y + 4, method);
    y += 23;
  }
  y += 4;
  svg.line(kRight + 14, y, kRight + 34, y, "stroke=\"#777\" stroke-width=\"1.6\"");
  svg.words(kRight + 38, y + 4, "Pareto front");
  y += 23;
  svg.line(kRight + 24, y - 7, kRight + 24, y + 7, "stroke=\"#777\"");
  svg.words(kRight + 38, y + 4, "\xC2\xB1 1 standard error");
}

// Steps: what one gets for a time is what the fastest that fits gives.
void drawFront(Svg& svg, std::span<const ShadowTrial> trials, std::span<const std::size_t> front,
               const Axis& x, const Axis& y, LabelPlacer& placer) {
  std::vector<double> line;
  double before = 0;
  for (const std::size_t t : front) {
    const double px = x.pixel(trials[t].milliseconds());
    const double py = y.pixel(trials[t].error.meanAbsolute.value);
    if (!line.empty()) {
      line.insert(line.end(), {px, before});
      placer.avoid({line[line.size() - 4], before - 2, px, before + 2});
    }
    placer.avoid({px - 2, std::min(before, py), px + 2, std::max(before, py)});
    line.insert(line.end(), {px, py});
    before = py;
  }
  if (!line.empty()) {
    line.insert(line.begin(), {line[0], kTop});
    line.insert(line.end(), {kRight, before});
  }
  svg.polyline(line, "stroke=\"#777\" stroke-width=\"1.6\" stroke-linejoin=\"round\"");
}

std::string nameOf(const ShadowTrial& trial) {
  const ShadowCandidate& candidate = trial.candidate;
  if (candidate.label == candidate.method) return candidate.label;
  return candidate.label.substr(candidate.method.size() + 1);  // colour and marker say the method
}

}  // namespace

std::string errorTimePlot(std::span<const ShadowTrial> trials, std::span<const std::size_t> front,
                          std::size_t pointCount) {
  Svg svg(kWidth, kHeight, "Error against time");
  Bounds range;  // of (time, error)
  for (const ShadowTrial& trial : trials)
    if (!trial.failed())
      range.extend({static_cast<float>(std::max(trial.milliseconds(), 1e-6)),
                    static_cast<float>(std::max(trial.error.meanAbsolute.value, 1e-6)), 0});
  if (!(range.lower.x <= range.upper.x)) return svg.str();
  const Axis x = logAxis(static_cast<double>(range.lower.x), static_cast<double>(range.upper.x),
                         kLeft, kRight);
  const Axis y = logAxis(static_cast<double>(range.lower.y), static_cast<double>(range.upper.y),
                         kBottom, kTop);
  drawAxes(svg, x, y,
           text("time to build and to sample all ", pointCount, " points of the hair (ms)"),
           "mean absolute error of transmittance");
  drawLegend(svg, trials);

  LabelPlacer placer({kLeft + 3, kTop + 3, kRight - 3, kBottom - 3});
  drawFront(svg, trials, front, x, y, placer);
  std::vector<double> px, py;
  for (const ShadowTrial& trial : trials) {
    px.push_back(x.pixel(std::max(trial.milliseconds(), 1e-6)));
    py.push_back(y.pixel(std::max(trial.error.meanAbsolute.value, 1e-6)));
    if (!trial.failed()) placer.avoid(around(px.back(), py.back(), 7));
  }
  const auto isFront = [&](std::size_t t) {
    return std::find(front.begin(), front.end(), t) != front.end();
  };
  for (const bool onFront : {false, true})  // those that count lie on top
    for (std::size_t t = 0; t < trials.size(); ++t) {
      const ShadowTrial& trial = trials[t];
      if (trial.failed() || isFront(t) != onFront) continue;
      const ErrorFigures::Figure error = trial.error.meanAbsolute;
      const double least = std::max(error.value - error.standardError, y.lowest);
      svg.line(px[t], y.pixel(least), px[t],
               y.pixel(std::min(error.value + error.standardError, y.highest)),
               text("stroke=\"", methodStyle(trial.candidate.method).colour, "\""));
      svg.raw(marker(trial.candidate.method, px[t], py[t], onFront ? 1.1 : 0.8,
                     text(trial.candidate.label, ": ", brief(trial.milliseconds()), " ms, ",
                          brief(error.value), " ± ", brief(error.standardError, 2))));
    }
  for (const std::size_t t : front) {
    const std::string name = nameOf(trials[t]);
    const Box box = placer.place(px[t], py[t], textWidth(name, kLabelSize) + 4, kLabelSize + 3);
    const double nearX = std::clamp(px[t], box.x0, box.x1);
    const double nearY = std::clamp(py[t], box.y0, box.y1);
    if (std::hypot(nearX - px[t], nearY - py[t]) > 14)
      svg.line(px[t], py[t], nearX, nearY, "stroke=\"#aaa\" stroke-width=\"0.8\"");
    svg.words(0.5 * (box.x0 + box.x1), box.y1 - 3.5, name,
              text("text-anchor=\"middle\" font-size=\"", kLabelSize,
                   "\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\""));
  }
  return svg.str();
}

}  // namespace hair
