#include <apps/hair/measure/tables.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace hair {

namespace {

// "0.0123 ± 0.0004"; the sign is two bytes, which setw would count.
std::string figure(const ErrorFigures::Figure& f, bool sign = false) {
  std::ostringstream out;
  if (sign) out << std::showpos;
  out << std::fixed << std::setprecision(4) << f.value << std::noshowpos << " \xC2\xB1 "
      << f.standardError;
  return out.str();
}

std::string fixed(double value, int digits) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

}  // namespace

void printTable(const MeasureReport& report, const MeasuredCase& measured, std::ostream& out) {
  std::size_t width = 8;
  for (const ShadowTrial& trial : measured.trials)
    if (!trial.failed()) width = std::max(width, trial.candidate.label.size());
  double mean = 0;
  for (const float t : measured.truth.transmittance) mean += static_cast<double>(t);
  mean /= std::max(static_cast<double>(measured.truth.transmittance.size()), 1.0);

  out << measured.light.name() << ", footprint " << measured.footprint
      << " m: " << report.points.size() << " samples, mean transmittance " << fixed(mean, 4)
      << "\n\n";
  const int name = static_cast<int>(width);
  out << "  " << std::left << std::setw(name) << "method" << std::right
      << "      mean absolute               RMS   99th percentile               bias  build ms "
         "sample ms  ns/point       MB\n";
  for (std::size_t t = 0; t < measured.trials.size(); ++t) {
    const ShadowTrial& trial = measured.trials[t];
    if (trial.failed()) continue;
    const bool front =
        std::find(measured.front.begin(), measured.front.end(), t) != measured.front.end();
    out << (front ? "* " : "  ") << std::left << std::setw(name) << trial.candidate.label
        << std::right;
    out << std::setw(20) << figure(trial.error.meanAbsolute) << std::setw(19)
        << figure(trial.error.rms) << std::setw(19) << figure(trial.error.percentile99)
        << std::setw(20) << figure(trial.error.bias, true);
    out << std::setw(10) << fixed(trial.buildMilliseconds, 2) << std::setw(10)
        << fixed(trial.sampleMilliseconds, 2) << std::setw(10) << fixed(trial.sampleNanoseconds, 1)
        << std::setw(9) << fixed(static_cast<double>(trial.bytes) * 1e-6, 2) << '\n';
  }
  out << "* on the Pareto front of build + sample time and mean absolute error\n";
  if (!measured.flicker.empty()) {
    out << "\n  flicker under a light that turns by 0.1 degree a step, "
        << report.options.flickerSteps << " steps\n  " << std::left << std::setw(name)
        << "most accurate of each method" << std::right << "   shimmer      swim\n";
    const auto row = [&](const std::string& label, const Flicker& f) {
      const int cells = std::max(name, 28);
      out << "  " << std::left << std::setw(cells) << label << std::right << std::setw(10)
          << fixed(f.shimmer, 5) << std::setw(10) << fixed(f.swim, 5) << '\n';
    };
    row("truth", measured.truthFlicker);
    for (std::size_t b = 0; b < measured.best.size(); ++b)
      row(measured.trials[measured.best[b]].candidate.label, measured.flicker[b]);
  }
  out << '\n';
}

void writeCsv(const MeasureReport& report, std::ostream& out) {
  out << kCsvHeader << '\n';
  for (const MeasuredCase& measured : report.cases)
    for (std::size_t t = 0; t < measured.trials.size(); ++t) {
      const ShadowTrial& trial = measured.trials[t];
      if (trial.failed()) continue;
      const glm::vec3 given = measured.light.given;
      out << std::setprecision(6) << (measured.light.atPoint ? "point" : "parallel") << ','
          << given.x << ',' << given.y << ',' << given.z << ',' << measured.footprint << ','
          << trial.candidate.method << ',';
      std::string settings = settingsText(trial.candidate.settings);
      std::replace(settings.begin(), settings.end(), ',', ';');
      out << settings << std::setprecision(9);
      for (const ErrorFigures::Figure& f :
           {trial.error.meanAbsolute, trial.error.rms, trial.error.percentile99, trial.error.bias})
        out << ',' << f.value << ',' << f.standardError;
      out << ',' << trial.buildMilliseconds << ',' << trial.sampleMilliseconds << ','
          << trial.sampleNanoseconds << ',' << trial.bytes << ','
          << std::count(measured.front.begin(), measured.front.end(), t) << ',';
      const auto best = std::find(measured.best.begin(), measured.best.end(), t);
      if (best != measured.best.end() && !measured.flicker.empty()) {
        const Flicker f = measured.flicker[static_cast<std::size_t>(best - measured.best.begin())];
        out << f.shimmer << ',' << f.swim << '\n';
      } else {
        out << ",\n";
      }
    }
}

void writeDump(const MeasureReport& report, const MeasuredCase& measured, std::ostream& out) {
  out << "strand,point,x,y,z,truth,truth_se";
  for (const ShadowTrial& trial : measured.trials)
    if (!trial.failed()) out << ',' << trial.candidate.label;
  out << '\n' << std::setprecision(9);
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const SamplePoint& point = report.points[i];
    const MeasuredHair::Origin origin = report.hair.origin(point.strand, point.point);
    out << origin.strand << ',' << origin.point << ',' << point.position.x << ','
        << point.position.y << ',' << point.position.z << ',' << measured.truth.transmittance[i]
        << ',' << measured.truth.standardError[i];
    for (const ShadowTrial& trial : measured.trials)
      if (!trial.failed()) out << ',' << trial.transmittance[i];
    out << '\n';
  }
}

}  // namespace hair
