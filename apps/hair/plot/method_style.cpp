#include <apps/hair/plot/method_style.h>

#include <apps/common/svg.h>
#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr std::string_view kDisc = "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0z";
constexpr std::string_view kSquare = "M-4.5-4.5h9v9h-9z";
constexpr std::string_view kUp = "M0-5.8L5.6 4.2H-5.6z";
constexpr std::string_view kDown = "M0 5.8L5.6-4.2H-5.6z";
constexpr std::string_view kDiamond = "M0-6.2L6.2 0L0 6.2L-6.2 0z";
constexpr std::string_view kCross =
    "M-5.6-2.8L-2.8-5.6L0-2.8L2.8-5.6L5.6-2.8L2.8 0L5.6 2.8L2.8 5.6L0 2.8L-2.8 5.6L-5.6 2.8L-2.8 "
    "0z";
constexpr std::string_view kStar =
    "M0-8L1.9-2.6L7.6-2.5L3.1 1L4.7 6.5L0 3.2L-4.7 6.5L-3.1 1L-7.6-2.5L-1.9-2.6z";

struct Entry {
  std::string_view method;
  MethodStyle style;
};
constexpr Entry kStyles[] = {
    {"auto", {"#000000", kStar}},
    {"chosen", {"#000000", kDisc}},
    {"density map", {"#0072B2", kDisc}},
    {"shadow map", {"#8C8C8C", kSquare}},
    {"opacity map", {"#E69F00", kUp}},
    {"deep opacity map", {"#009E73", kDiamond}},
    {"density clustering", {"#CC79A7", kDown}},
    {"deep shadow map", {"#D55E00", kCross}},
};

}  // namespace

MethodStyle methodStyle(std::string_view method) {
  for (const Entry& entry : kStyles)
    if (entry.method == method) return entry.style;
  return {"#666666", kDisc};
}

std::string marker(std::string_view method, double x, double y, double size,
                   std::string_view hover) {
  const MethodStyle style = methodStyle(method);
  const std::string inside =
      hover.empty() ? std::string() : text("<title>", escaped(hover), "</title>");
  return text("<path transform=\"translate(", brief(x, 5), ' ', brief(y, 5), ") scale(",
              brief(size), ")\" d=\"", style.shape, "\" fill=\"", style.colour,
              "\" stroke=\"#fff\" stroke-width=\"0.8\">", inside, "</path>\n");
}

}  // namespace hair
