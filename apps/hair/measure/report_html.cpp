#include <apps/hair/measure/report_html.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include <apps/common/svg.h>
#include <apps/hair/measure/choice.h>
#include <apps/hair/plot/difference_picture.h>
#include <apps/hair/plot/error_time_plot.h>
#include <apps/hair/plot/method_style.h>
#include <apps/hair/plot/visibility_plot.h>
#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Hair shadows measured</title>
<style>
body { font: 15px/1.5 Helvetica, Arial, "Liberation Sans", "DejaVu Sans", sans-serif; color: #222;
  background: #fff; max-width: 1060px; margin: 32px auto; padding: 0 20px; }
h1 { font-size: 26px; line-height: 1.25; margin: 0 0 6px; }
h2 { font-size: 20px; margin: 44px 0 4px; padding-top: 14px; border-top: 2px solid #222; }
h3 { font-size: 16px; margin: 30px 0 4px; }
p { margin: 6px 0 12px; max-width: 76ch; }
.lead { color: #555; }
svg { display: block; max-width: 100%; height: auto; }
svg.mark { display: inline-block; vertical-align: -2px; margin-right: 6px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 3px 7px; white-space: nowrap; }
th { border-bottom: 1.5px solid #222; vertical-align: bottom; font-weight: 600; }
th:first-child, td:first-child { text-align: left; padding-left: 2px; white-space: normal; }
tbody tr:nth-child(even) { background: #f6f6f6; }
tr.front td { font-weight: 700; }
td small { color: #777; font-size: 11px; font-weight: 400; }
td.bar { text-align: left; min-width: 200px; }
td.bar span { display: inline-block; height: 10px; vertical-align: middle; }
pre { background: #f4f4f4; padding: 10px 14px; white-space: pre-wrap; overflow-wrap: anywhere;
  font: 13px/1.45 "DejaVu Sans Mono", Menlo, Consolas, monospace; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; margin: 8px 0; }
dt { color: #555; } dd { margin: 0; }
nav { margin: 10px 0; } nav a { margin-right: 16px; }
</style>
</head>
<body>
)";

std::string fixed(double value, int digits) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

std::string cell(const ErrorFigures::Figure& f) {
  return text("<td>", fixed(f.value, 4), " <small>\xC2\xB1&nbsp;", fixed(f.standardError, 4),
              "</small></td>");
}

std::string smallMarker(const std::string& method) {
  return text("<svg class=\"mark\" width=\"14\" height=\"14\" viewBox=\"-7 -7 14 14\">",
              marker(method, 0, 0), "</svg>");
}

void writeFacts(const MeasureReport& report, std::ostream& out) {
  const MeasuredHair& hair = report.hair;
  const Fibre& fibre = hair.fibre;
  out << "<dl>\n<dt>Hair</dt><dd>" << escaped(hair.name) << ": " << hair.strands.strandCount()
      << " strands, " << hair.strands.pointCount() << " points</dd>\n<dt>Strand</dt><dd>"
      << brief(static_cast<double>(fibre.width * fibre.hairsPerStrand) * 1000)
      << " mm wide, opacity " << brief(static_cast<double>(fibre.opacity))
      << "</dd>\n<dt>Truth</dt><dd>" << report.options.rays << " rays to each of "
      << report.points.size() << " sample points</dd>\n<dt>Times</dt><dd>medians of "
      << report.options.repeats << " runs on " << report.threads << " threads of "
      << escaped(report.cpu) << "</dd>\n</dl>\n";
}

void writeTable(const MeasuredCase& measured, std::ostream& out) {
  out << "<h3>All settings</h3>\n<p>Error is method less truth, in transmittance (0 dark, 1 lit), "
         "&plusmn; one standard error from the choice of sample points and the noise of the truth. "
         "Bold: on the Pareto front. Bytes stand in memory from build to sample.</p>\n"
         "<div class=\"wide\"><table><thead><tr><th>method and settings</th><th>mean absolute</th>"
         "<th>RMS</th><th>99th percentile</th><th>bias</th><th>build<br>ms</th><th>sample<br>ms"
         "</th><th>sample<br>ns a point</th><th>memory<br>MB</th></tr></thead>\n<tbody>\n";
  std::string failures;
  for (std::size_t t = 0; t < measured.trials.size(); ++t) {
    const ShadowTrial& trial = measured.trials[t];
    const ShadowCandidate& candidate = trial.candidate;
    std::string label = candidate.label;
    if (candidate.method == label) label += ": " + settingsText(candidate.settings);
    if (trial.failed()) {
      failures += text("<p>", smallMarker(candidate.method), escaped(label),
                       " cannot shadow this hair: ", escaped(trial.failure), "</p>\n");
      continue;
    }
    const bool front = std::count(measured.front.begin(), measured.front.end(), t) > 0;
    out << (front ? "<tr class=\"front\">" : "<tr>") << "<td>" << smallMarker(candidate.method)
        << escaped(label) << "</td>" << cell(trial.error.meanAbsolute) << cell(trial.error.rms)
        << cell(trial.error.percentile99) << cell(trial.error.bias) << "<td>"
        << fixed(trial.buildMilliseconds, 2) << "</td><td>" << fixed(trial.sampleMilliseconds, 2)
        << "</td><td>" << fixed(trial.sampleNanoseconds, 1) << "</td><td>"
        << fixed(static_cast<double>(trial.bytes) * 1e-6, 2) << "</td></tr>\n";
  }
  out << "</tbody></table></div>\n" << failures;
}

void writeFlicker(const MeasureReport& report, const MeasuredCase& measured, std::ostream& out) {
  out << "<h3>Temporal flicker</h3>\n";
  if (measured.flicker.empty()) {
    out << "<p>Not measured in this run (--flicker-steps 0).</p>\n";
    return;
  }
  out << "<p>The hair stands still, the light turns by 0.1 degree a step, "
      << report.options.flickerSteps
      << " steps. <i>Shimmer</i> is the RMS of what changes from step to step beyond a straight "
         "line through neighbouring steps, as the standard deviation of noise that would look the "
         "same; <i>swim</i> the RMS distance from each point's straight line over all steps. The "
         "truth's own figures, noise of its rays included, say what is real. The most accurate "
         "setting of each method.</p>\n<div class=\"wide\"><table><thead><tr><th>method and "
         "settings</th><th>shimmer</th><th>swim</th><th></th></tr></thead>\n<tbody>\n";
  double most = measured.truthFlicker.shimmer;
  for (const Flicker& f : measured.flicker) most = std::max(most, f.shimmer);
  const auto row = [&](const std::string& name, std::string_view colour, const Flicker& f) {
    out << "<tr><td>" << name << "</td><td>" << fixed(f.shimmer, 5) << "</td><td>"
        << fixed(f.swim, 5) << "</td><td class=\"bar\"><span style=\"width:"
        << fixed(most > 0 ? 200 * f.shimmer / most : 0, 1) << "px;background:" << colour
        << "\"></span></td></tr>\n";
  };
  row("truth", "#c4c4c4", measured.truthFlicker);
  for (std::size_t b = 0; b < measured.best.size(); ++b) {
    const ShadowCandidate& candidate = measured.trials[measured.best[b]].candidate;
    row(smallMarker(candidate.method) + escaped(candidate.label),
        methodStyle(candidate.method).colour, measured.flicker[b]);
  }
  out << "</tbody></table></div>\n<p class=\"lead\">Bars: shimmer.</p>\n";
}

std::string titleOf(const MeasuredCase& measured) {
  const glm::vec3 g = measured.light.given;
  return text(measured.light.atPoint ? "Light at (" : "Light along (", g.x, ", ", g.y, ", ", g.z,
              "), footprint ", brief(static_cast<double>(measured.footprint) * 1000), " mm");
}

void writeCase(const MeasureReport& report, std::size_t number, std::ostream& out) {
  const MeasuredCase& measured = report.cases[number];
  double mean = 0, noise = 0;
  for (const float t : measured.truth.transmittance) mean += static_cast<double>(t);
  for (const float e : measured.truth.standardError) noise += static_cast<double>(e);
  const double count = std::max(static_cast<double>(report.points.size()), 1.0);
  out << "<h2 id=\"case" << number << "\">" << escaped(titleOf(measured)) << "</h2>\n<p>"
      << "Mean transmittance of the truth " << fixed(mean / count, 3)
      << "; its standard error at a sample point, on average, at most " << fixed(noise / count, 4)
      << ".</p>\n<h3>Error against time</h3>\n<p>Each mark is a method with one setting; nothing "
         "is both faster and more accurate than what is on the front.</p>\n"
      << errorTimePlot(measured.trials, measured.front, report.hair.strands.pointCount());
  writeTable(measured, out);
  if (measured.choice) {
    std::ostringstream lines;
    printChoice(*measured.choice, measured.trials, lines);
    out << "<h3>The choice from the budget</h3>\n<pre>" << escaped(lines.str()) << "</pre>\n";
  }
  out << "<h3>Visibility along one ray</h3>\n<p>What is left of the light along a ray through the "
         "thick of the hair, averaged over the footprint. Wide grey: the truth. Bold: the method's "
         "most accurate setting over all samples, which is named; thin: its other settings.</p>\n"
      << visibilityPlot(measured)
      << "<h3>Differences from the truth</h3>\n<p>The sample points, seen at right angles to the "
         "light, which travels along the arrow; each method at its most accurate setting.</p>\n"
      << differencePictures(report, measured);
  writeFlicker(report, measured, out);
}

void writeRepeat(const MeasureReport& report, std::ostream& out) {
  out << "<h2 id=\"repeat\">How to repeat it</h2>\n<pre>" << escaped(report.options.commandLine)
      << "</pre>\n<dl>\n<dt>Version</dt><dd>hair " << escaped(report.version)
      << "</dd>\n<dt>CPU</dt><dd>" << escaped(report.cpu) << "</dd>\n<dt>Threads</dt><dd>"
      << report.threads << "</dd>\n<dt>Seed</dt><dd>" << report.options.seed
      << "</dd>\n</dl>\n<p>The same command with the same seed gives the same errors to the last "
         "bit, on any number of threads (but which settings were chosen from a budget depends on "
         "times). Times are this machine's: compare them within one report. "
         "Methods take turns in every one of the "
      << report.options.repeats << " rounds, so that all meet the same machine.</p>\n";
  for (const std::string& note : report.hair.notes) out << "<p>" << escaped(note) << "</p>\n";
}

}  // namespace

void writeHtml(const MeasureReport& report, std::ostream& out) {
  out << kHead << "<h1>Shadow methods measured on " << escaped(report.hair.name)
      << "</h1>\n<p class=\"lead\">Error against ray-traced truth, time and memory, all in one run "
         "on one machine.</p>\n";
  writeFacts(report, out);
  out << "<nav>";
  for (std::size_t c = 0; c < report.cases.size(); ++c)
    out << "<a href=\"#case" << c << "\">" << escaped(titleOf(report.cases[c])) << "</a>";
  out << "<a href=\"#repeat\">How to repeat it</a></nav>\n";
  for (std::size_t c = 0; c < report.cases.size(); ++c) writeCase(report, c, out);
  writeRepeat(report, out);
  out << "</body>\n</html>\n";
}

}  // namespace hair
