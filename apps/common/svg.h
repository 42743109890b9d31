#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hair {

/// "<" and its like as HTML and SVG want them in texts and attributes.
std::string escaped(std::string_view words);

/// `value` with so many significant digits and no more zeros than that needs: 0.02, 1.5e-05.
std::string brief(double value, int digits = 3);

/// What text of a sans-serif font takes up, roughly.
double textWidth(std::string_view words, double fontSize);

/// A picture in SVG, to stand inside an HTML page. Pixels, y down. Attributes are given as SVG
/// spells them: `stroke="#888" stroke-width="2"`.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);
  void line(double x1, double y1, double x2, double y2, std::string_view attributes);
  void rectangle(double x, double y, double width, double height, std::string_view attributes);
  void polyline(const std::vector<double>& xy, std::string_view attributes);
  void words(double x, double y, std::string_view words, std::string_view attributes = {});
  void raw(std::string_view element) { body_ += element; }
  /// The whole element.
  std::string str() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

/// The element as a file of its own: that says what it is, and stands on white wherever it is
/// shown.
std::string asFile(std::string svg);

/// An axis: values to pixels, and where its ticks are.
struct Axis {
  struct Tick {
    double value;
    std::string label;  ///< empty: a small tick
  };
  double lowest = 0, highest = 1;  ///< values
  double from = 0, to = 1;         ///< their pixels
  bool logarithmic = false;
  std::vector<Tick> ticks;

  double pixel(double value) const;
};

/// Ticks at 1-2-5, as many labels as do not touch. The ends are put a little outside of the data.
Axis logAxis(double lowest, double highest, double from, double to);
/// Ticks at 1-2-5, about `count` of them; the ends stay as they are.
Axis linearAxis(double lowest, double highest, double from, double to, int count);

/// Frame, ticks, thin lines at labelled ticks, and what is along the axes. y.from is the bottom.
void drawAxes(Svg& svg, const Axis& x, const Axis& y, std::string_view alongX,
              std::string_view alongY);

}  // namespace hair
