#pragma once

#include <string>
#include <string_view>

namespace hair {

/// How a method looks in all plots: a colour that colour-blind readers tell apart (Okabe and Ito
/// 2008, "Color Universal Design") and a marker for those who print in black.
struct MethodStyle {
  std::string_view colour;  ///< #rrggbb
  std::string_view shape;   ///< an SVG path about (0, 0), 12 pixels wide
};

/// By ShadowCandidate::method; unknown names are grey discs.
MethodStyle methodStyle(std::string_view method);

/// The marker as an SVG element. `size` 1: 12 pixels.
std::string marker(std::string_view method, double x, double y, double size = 1,
                   std::string_view hover = {});

}  // namespace hair
