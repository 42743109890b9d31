#include <apps/common/svg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <sstream>

#include <libhair/core/error.h>

namespace hair {

std::string escaped(std::string_view words) {
  std::string out;
  for (const char c : words) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string brief(double value, int digits) {
  std::ostringstream out;
  // 1000 rather than 1e+03.
  const int whole =
      std::abs(value) < 1e6 ? static_cast<int>(std::log10(std::abs(value) + 1)) + 1 : 1;
  out << std::setprecision(std::max(digits, whole)) << (value == 0 ? 0.0 : value);
  return out.str();
}

double textWidth(std::string_view words, double fontSize) {
  double width = 0;
  for (const char c : words)
    width += std::string_view("iljtf.,:;|!'()[] ").find(c) != std::string_view::npos ? 0.31
             : std::string_view("mwMW").find(c) != std::string_view::npos            ? 0.85
                                                                                     : 0.57;
  return width * fontSize;
}

Svg::Svg(double width, double height, std::string_view title)
    : body_(text("<svg viewBox=\"0 0 ", width, ' ', height, "\" width=\"", width, "\" height=\"",
                 height,
                 "\" role=\"img\" font-family=\"Helvetica, Arial, 'Liberation Sans', "
                 "'DejaVu Sans', sans-serif\" font-size=\"12\" fill=\"#222\">\n<title>",
                 escaped(title), "</title>\n")) {}

void Svg::line(double x1, double y1, double x2, double y2, std::string_view attributes) {
  body_ += text("<line x1=\"", brief(x1, 5), "\" y1=\"", brief(y1, 5), "\" x2=\"", brief(x2, 5),
                "\" y2=\"", brief(y2, 5), "\" ", attributes, "/>\n");
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view attributes) {
  body_ += text("<rect x=\"", brief(x, 5), "\" y=\"", brief(y, 5), "\" width=\"", brief(width, 5),
                "\" height=\"", brief(height, 5), "\" ", attributes, "/>\n");
}

void Svg::polyline(const std::vector<double>& xy, std::string_view attributes) {
  body_ += "<polyline points=\"";
  for (std::size_t i = 0; i + 1 < xy.size(); i += 2)
    body_ += text(i > 0 ? " " : "", brief(xy[i], 5), ',', brief(xy[i + 1], 5));
  body_ += text("\" fill=\"none\" ", attributes, "/>\n");
}

void Svg::words(double x, double y, std::string_view words, std::string_view attributes) {
  body_ += text("<text x=\"", brief(x, 5), "\" y=\"", brief(y, 5), "\" ", attributes, '>',
                escaped(words), "</text>\n");
}

std::string asFile(std::string svg) {
  constexpr std::string_view kTitleEnd = "</title>\n";
  svg.insert(svg.find(kTitleEnd) + kTitleEnd.size(),
             "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
  return svg.replace(0, 4, "<svg xmlns=\"http://www.w3.org/2000/svg\"");
}

double Axis::pixel(double value) const {
  const double part = logarithmic ? std::log(value / lowest) / std::log(highest / lowest)
                                  : (value - lowest) / (highest - lowest);
  return from + (to - from) * part;
}

Axis logAxis(double lowest, double highest, double from, double to) {
  lowest = std::max(lowest, 1e-12);
  highest = std::max(highest, lowest);
  // At least half a decade, and a tenth of the whole as a margin.
  const double missing = std::max(std::log10(3.0) - std::log10(highest / lowest), 0.0);
  const double margin = std::pow(10.0, 0.5 * missing + 0.06 * std::log10(highest / lowest));
  Axis axis{lowest / margin, highest * margin, from, to, true, {}};
  const double decade = std::abs(to - from) / std::log10(axis.highest / axis.lowest);
  const int first = static_cast<int>(std::floor(std::log10(axis.lowest)));
  const int last = static_cast<int>(std::ceil(std::log10(axis.highest)));
  for (int power = first; power <= last; ++power)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, power);
      if (value < axis.lowest * 0.999999 || value > axis.highest * 1.000001) continue;
      const bool labelled = digit == 1 || ((digit == 2 || digit == 5) && decade > 90) ||
                            ((digit == 3 || digit == 7) && decade > 300);
      axis.ticks.push_back({value, labelled ? brief(value) : ""});
    }
  return axis;
}

Axis linearAxis(double lowest, double highest, double from, double to, int count) {
  highest = highest > lowest ? highest : lowest + 1;
  Axis axis{lowest, highest, from, to, false, {}};
  const double rough = (highest - lowest) / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double part = rough / power;
  const double step = power * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
  const auto first = static_cast<std::int64_t>(std::ceil(lowest / step - 1e-9));
  const auto last = static_cast<std::int64_t>(std::floor(highest / step + 1e-9));
  for (std::int64_t k = first; k <= last; ++k) {
    const double value = static_cast<double>(k) * step;
    axis.ticks.push_back({value, brief(value)});
  }
  return axis;
}

void drawAxes(Svg& svg, const Axis& x, const Axis& y, std::string_view alongX,
              std::string_view alongY) {
  const double left = x.from, right = x.to, top = y.to, bottom = y.from;
  for (const Axis::Tick& tick : x.ticks) {
    const double at = x.pixel(tick.value);
    const bool named = !tick.label.empty();
    if (named) svg.line(at, top, at, bottom, "stroke=\"#ececec\"");
    svg.line(at, bottom, at, bottom + (named ? 6 : 3), "stroke=\"#555\"");
    if (named) svg.words(at, bottom + 20, tick.label, "text-anchor=\"middle\"");
  }
  for (const Axis::Tick& tick : y.ticks) {
    const double at = y.pixel(tick.value);
    const bool named = !tick.label.empty();
    if (named) svg.line(left, at, right, at, "stroke=\"#ececec\"");
    svg.line(left - (named ? 6 : 3), at, left, at, "stroke=\"#555\"");
    if (named) svg.words(left - 9, at + 4, tick.label, "text-anchor=\"end\"");
  }
  svg.rectangle(left, top, right - left, bottom - top, "fill=\"none\" stroke=\"#555\"");
  svg.words(0.5 * (left + right), bottom + 44, alongX, "text-anchor=\"middle\" font-size=\"13\"");
  svg.words(0, 0, alongY,
            text("text-anchor=\"middle\" font-size=\"13\" transform=\"translate(", left - 54, ' ',
                 0.5 * (top + bottom), ") rotate(-90)\""));
}

}  // namespace hair
