#include <benchmarks/plots.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

#include <apps/common/svg.h>
#include <libhair/core/error.h>

namespace hair::bench {

namespace {

constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00"};

constexpr const char* kPaper = "fill=\"#fff\"";  // also where the page around it is dark

std::optional<double> number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value <= 0) return {};
  return value;
}

std::string spaced(std::string words) {
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string axisName(const std::string& group) {
  if (group == "strands") return "drawn strands of 8 points";
  if (group == "points") return "points a strand, of 3,350 strands";
  if (group == "cells") return "cells of the map along each axis, same hair";
  return group;
}

// In the order of their first appearance.
std::vector<std::string> distinct(const std::vector<Measured>& rows,
                                  std::string Measured::* field) {
  std::vector<std::string> words;
  for (const Measured& row : rows)
    if (std::ranges::find(words, row.*field) == words.end()) words.push_back(row.*field);
  return words;
}

struct Range {
  double lowest = 1e30, highest = 0;
  void add(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

void drawAxes(Svg& svg, const Axis& x, const Axis& y, const std::string& name) {
  for (const Axis::Tick& tick : x.ticks) {
    const double at = x.pixel(tick.value);
    svg.line(at, y.from, at, tick.label.empty() ? y.from + 3 : y.to,
             tick.label.empty() ? "stroke=\"#555\"" : "stroke=\"#e4e4e4\"");
    svg.words(at, y.from + 18, tick.label, "text-anchor=\"middle\"");
  }
  for (const Axis::Tick& tick : y.ticks) {
    const double at = y.pixel(tick.value);
    svg.line(tick.label.empty() ? x.from - 3 : x.to, at, x.from, at,
             tick.label.empty() ? "stroke=\"#555\"" : "stroke=\"#e4e4e4\"");
    svg.words(x.from - 8, at + 4, tick.label, "text-anchor=\"end\"");
  }
  svg.rectangle(x.from, y.to, x.to - x.from, y.from - y.to, "fill=\"none\" stroke=\"#555\"");
  svg.words(0.5 * (x.from + x.to), y.from + 38, name, "text-anchor=\"middle\"");
  svg.words(0, 0, "milliseconds",
            text("text-anchor=\"middle\" transform=\"translate(16 ", 0.5 * (y.from + y.to),
                 ") rotate(-90)\""));
}

std::string linePlot(const std::vector<Measured>& rows) {
  Range times, numbers;
  for (const Measured& row : rows) {
    times.add(row.milliseconds);
    times.add(row.floor);
    numbers.add(*number(row.how));
  }
  constexpr double kLeft = 66, kRight = 560, kTop = 14, kBottom = 350;
  Svg svg(720, 400, text("Time over ", axisName(rows.front().group)));
  svg.rectangle(0, 0, 720, 400, kPaper);
  const Axis x = logAxis(numbers.lowest, numbers.highest, kLeft, kRight);
  const Axis y = logAxis(times.lowest, times.highest, kBottom, kTop);
  drawAxes(svg, x, y, axisName(rows.front().group));
  double legend = kTop + 12;
  std::size_t colour = 0;
  for (const std::string& what : distinct(rows, &Measured::what)) {
    std::vector<double> line, floor;
    const std::string stroke = text("stroke=\"", kColours[colour++ % std::size(kColours)], "\"");
    for (const Measured& row : rows) {
      if (row.what != what) continue;
      const double at = x.pixel(*number(row.how));
      line.insert(line.end(), {at, y.pixel(row.milliseconds)});
      floor.insert(floor.end(), {at, y.pixel(row.floor)});
      svg.raw(text("<circle cx=\"", brief(at, 5), "\" cy=\"", brief(line.back(), 5),
                   "\" r=\"3.5\" fill=\"#fff\" stroke-width=\"2\" ", stroke, "><title>",
                   escaped(row.how), ": ", brief(row.milliseconds), " ms</title></circle>\n"));
    }
    svg.polyline(line, stroke + " stroke-width=\"2\"");
    svg.polyline(floor, stroke + " stroke-dasharray=\"4 4\"");
    svg.line(kRight + 14, legend, kRight + 36, legend, stroke + " stroke-width=\"2\"");
    svg.words(kRight + 42, legend + 4, spaced(what));
    svg.line(kRight + 14, legend + 18, kRight + 36, legend + 18,
             stroke + " stroke-dasharray=\"4 4\"");
    svg.words(kRight + 42, legend + 22, "its floor");
    legend += 46;
  }
  return svg.str();
}

std::string barPlot(const std::vector<Measured>& rows) {
  constexpr double kLeft = 200, kRight = 640, kTop = 8, kRow = 19, kHead = 24;
  const std::vector<std::string> works = distinct(rows, &Measured::what);
  const double bottom =
      kTop + kRow * static_cast<double>(rows.size()) + kHead * static_cast<double>(works.size());
  Range times;
  for (const Measured& row : rows) {
    times.add(row.milliseconds);
    times.add(row.floor);
  }
  Svg svg(720, bottom + 46, text("Times of ", rows.front().group));
  svg.rectangle(0, 0, 720, bottom + 46, kPaper);
  const Axis x = logAxis(times.lowest / 2, times.highest, kLeft, kRight);
  for (const Axis::Tick& tick : x.ticks) {
    if (tick.label.empty()) continue;
    svg.line(x.pixel(tick.value), kTop, x.pixel(tick.value), bottom, "stroke=\"#e4e4e4\"");
    svg.words(x.pixel(tick.value), bottom + 16, tick.label, "text-anchor=\"middle\"");
  }
  svg.words(0.5 * (kLeft + kRight), bottom + 36, "milliseconds; black: the floor",
            "text-anchor=\"middle\"");
  double at = kTop;
  for (const std::string& work : works) {
    svg.words(4, at + 16, spaced(work), "font-weight=\"bold\"");
    at += kHead;
    for (const Measured& row : rows) {
      if (row.what != work) continue;
      const bool ours = row.how.starts_with("ours");
      const double end = x.pixel(row.milliseconds);
      svg.words(kLeft - 8, at + 13, spaced(row.how), "text-anchor=\"end\"");
      svg.rectangle(kLeft, at + 2, std::max(end - kLeft, 1.0), kRow - 5,
                    text("fill=\"", ours ? kColours[0] : "#999999", '"'));
      svg.rectangle(x.pixel(row.floor) - 1, at + 2, 2, kRow - 5, "fill=\"#000\"");
      svg.words(end + 5, at + 13, brief(row.milliseconds) + " ms");
      at += kRow;
    }
  }
  return svg.str();
}

}  // namespace

void Collector::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    const std::string& name = run.run_name.function_name;
    const std::size_t first = name.find('/'), second = name.find('/', first + 1);
    if (run.error_occurred || run.run_type != Run::RT_Iteration || second == std::string::npos)
      continue;
    const auto floor = run.counters.find("floor_ms");
    measured.push_back({name.substr(0, first), name.substr(first + 1, second - first - 1),
                        name.substr(second + 1), run.GetAdjustedRealTime(),
                        floor == run.counters.end() ? 0 : floor->second.value});
  }
}

void writePlots(const std::vector<Measured>& measured, const std::filesystem::path& folder) {
  for (const std::string& group : distinct(measured, &Measured::group)) {
    std::vector<Measured> rows;
    std::ranges::copy_if(measured, std::back_inserter(rows),
                         [&](const Measured& row) { return row.group == group; });
    const bool numbers =
        std::ranges::all_of(rows, [](const Measured& row) { return number(row.how).has_value(); });
    const std::filesystem::path path = folder / (group + ".svg");
    std::ofstream file(path);
    file << asFile(numbers ? linePlot(rows) : barPlot(rows));
    require(static_cast<bool>(file), path.string(), ": cannot be written");
  }
}

}  // namespace hair::bench
