#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>

#include <libhair/files/strand_file.h>
#include <libhair/files/text_writer.h>

namespace hair {

/// The pieces of a USD text file (usda_file.h says which attributes and why), in their order.

/// Of an animation.
struct UsdaTimes {
  double first = 0, last = 0;  ///< time codes
  double perSecond = 60;       ///< time codes, and frames
};

/// A time code: a whole number without an exponent, others with the fewest digits that give the
/// same double again.
std::string timeCodeText(double time);
/// Layer metadata and the start of the prim. As long for one `last` as for another, so that it can
/// be written again when the last frame is known. Throws Error where `up` is not Y or ZBack.
std::string usdaHeader(float scale, UpAxis up, const std::optional<UsdaTimes>& times);
/// What does not move: counts (of 2 points at least), widths, colours, opacity.
void writeUsdaStill(TextWriter& out, const StrandFile& file);
/// [(x, y, z), ...]
void writeUsdaVectors(TextWriter& out, std::span<const glm::vec3> vectors);
/// The two corners of the points, half of `widest` around them.
void writeUsdaExtent(TextWriter& out, std::span<const glm::vec3> points, float widest);
/// The largest diameter that the file states; 0: none.
float widestOf(const StrandFile& file);
std::string_view usdaEnd();

/// All of it, for strands that do not move. In the file's units: `scale` and `up` are stated.
void writeUsda(std::ostream& out, const StrandFile& file);

}  // namespace hair
