#include <libhair/files/usda/usda_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr std::size_t kLongestTimeCode = 24;  // -2.2250738585072014e-308

std::string numberText(auto number) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

// Values of an array of which each item is one number, or three.
void writeValues(TextWriter& out, std::span<const float> values) {
  out << '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out << ", ";
    out << values[i];
  }
  out << ']';
}

void writeValues(TextWriter& out, std::span<const glm::vec3> values) {
  writeUsdaVectors(out, values);
}

// A value a point, or one for all, or nothing where that one is `unstated`.
template <class T>
void writeAttribute(TextWriter& out, std::string_view typeAndName, const std::vector<T>& values,
                    const T& constant, const T& unstated) {
  if (values.empty() && constant == unstated) return;
  out << "    " << typeAndName << " = ";
  writeValues(out, values.empty() ? std::span(&constant, 1) : std::span(values));
  out << " (\n        interpolation = \"" << (values.empty() ? "constant" : "vertex")
      << "\"\n    )\n";
}

}  // namespace

std::string timeCodeText(double time) {
  constexpr double kWhole = 9007199254740992;  // 2^53: up to here each whole number is a double
  if (time == std::floor(time) && std::abs(time) <= kWhole)
    return numberText(static_cast<long long>(time));
  return numberText(time);
}

std::string usdaHeader(float scale, UpAxis up, const std::optional<UsdaTimes>& times) {
  require(up == UpAxis::Y || up == UpAxis::ZBack, "writing .usda: ", upAxisMeaning(up),
          "; the format has +Y up (y) and +Z up, -Y face (z-back)");
  std::string text =
      "#usda 1.0\n(\n    defaultPrim = \"Hair\"\n    doc = \"Strands of hair, root to tip\"\n";
  if (times) {
    std::string last = timeCodeText(times->last);
    last.resize(kLongestTimeCode, ' ');
    text += "    endTimeCode = " + last +
            "\n    framesPerSecond = " + numberText(times->perSecond) + '\n';
  }
  text += "    metersPerUnit = " + numberText(scale) + '\n';
  if (times)
    text += "    startTimeCode = " + timeCodeText(times->first) +
            "\n    timeCodesPerSecond = " + numberText(times->perSecond) + '\n';
  text += std::string("    upAxis = \"") + (up == UpAxis::Y ? 'Y' : 'Z') +
          "\"\n)\n\ndef BasisCurves \"Hair\"\n{\n    uniform token type = \"linear\"\n"
          "    uniform token wrap = \"nonperiodic\"\n";
  return text;
}

void writeUsdaStill(TextWriter& out, const StrandFile& file) {
  const StrandSet& strands = file.strands;
  out << "    int[] curveVertexCounts = [";
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    if (s > 0) out << ", ";
    out << strands.strand(s).size();
  }
  out << "]\n";
  writeAttribute(out, "float[] widths", file.thickness, file.defaultThickness, 0.0f);
  writeAttribute(out, "color3f[] primvars:displayColor", file.colours, file.defaultColour,
                 glm::vec3(0));
  std::vector<float> opacity;
  opacity.reserve(file.transparency.size());
  for (float t : file.transparency) opacity.push_back(1 - t);
  writeAttribute(out, "float[] primvars:displayOpacity", opacity, 1 - file.defaultTransparency,
                 1.0f);
}

void writeUsdaVectors(TextWriter& out, std::span<const glm::vec3> vectors) {
  out << '[';
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const glm::vec3& v = vectors[i];
    out << (i > 0 ? ", (" : "(") << v.x << ", " << v.y << ", " << v.z << ')';
  }
  out << ']';
}

void writeUsdaExtent(TextWriter& out, std::span<const glm::vec3> points, float widest) {
  const Bounds box = bounds(points);
  const std::array corners = {box.lower - 0.5f * widest, box.upper + 0.5f * widest};
  writeUsdaVectors(out, corners);
}

float widestOf(const StrandFile& file) {
  if (file.thickness.empty()) return file.defaultThickness;
  return *std::max_element(file.thickness.begin(), file.thickness.end());
}

std::string_view usdaEnd() {
  return "}\n";
}

void writeUsda(std::ostream& stream, const StrandFile& file) {
  TextWriter out(stream);
  out << usdaHeader(file.scale, file.up, {});
  writeUsdaStill(out, file);
  out << "    point3f[] points = ";
  writeUsdaVectors(out, file.strands.points);
  out << "\n    float3[] extent = ";
  writeUsdaExtent(out, file.strands.points, widestOf(file));
  out << '\n' << usdaEnd();
}

}  // namespace hair
