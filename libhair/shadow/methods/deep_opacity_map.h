#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/shadow/methods/lateral_filter.h>
#include <libhair/shadow/methods/light_image.h>

namespace HAIR_API hair {

class ShadowMethod;

/// Deep opacity maps (Yuksel and Keyser 2008): each pixel's layers begin at its own first hair, z0;
/// layer k covers z0 + d[k-1] to z0 + d[k].
struct DeepOpacityMapSettings {
  /// How layer sizes d[k] - d[k-1] grow.
  enum class Growth {
    Constant,   ///< 1 1 1 1
    Linear,     ///< 1 2 3 4
    Doubling,   ///< 1 2 4 8
    Fibonacci,  ///< 1 2 3 5
  };
  /// Treatment of hair beyond the last layer (section 3, "points beyond the end").
  enum class Beyond {
    Ignored,       ///< casts no shadow
    InLastLayer,   ///< belongs to the last layer, and shadows itself
    LargerLayers,  ///< does not occur: layers are scaled so that the last one ends behind all hair
  };
  float pixelSize = 3e-3f;              ///< metres, > 0
  int layers = 7;                       ///< K
  Growth growth = Growth::Linear;       ///< of layers, away from the light
  Beyond beyond = Beyond::InLastLayer;  ///< hair behind the last layer
  float depth = 0.05f;  ///< metres, d[K], > 0: total depth of all layers; unused for LargerLayers
  int depthBits = 32;   ///< 8, 16 or 32 (float), of the stored z0
  Extinction extinction = Extinction::Unbiased;  ///< how opacity becomes optical depth
  LateralFilter filter = LateralFilter::Linear;  ///< between pixels
};

/// Words for them (core/fields.h).
constexpr auto wordsOf(DeepOpacityMapSettings::Growth) {
  return std::array{Word("constant", DeepOpacityMapSettings::Growth::Constant),
                    Word("linear", DeepOpacityMapSettings::Growth::Linear),
                    Word("doubling", DeepOpacityMapSettings::Growth::Doubling),
                    Word("fibonacci", DeepOpacityMapSettings::Growth::Fibonacci)};
}
/// Words for them (core/fields.h).
constexpr auto wordsOf(DeepOpacityMapSettings::Beyond) {
  return std::array{Word("ignored", DeepOpacityMapSettings::Beyond::Ignored),
                    Word("in last layer", DeepOpacityMapSettings::Beyond::InLastLayer),
                    Word("larger layers", DeepOpacityMapSettings::Beyond::LargerLayers)};
}
/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const DeepOpacityMapSettings*) {
  using S = DeepOpacityMapSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("layers", &S::layers, "[1, 255]"), Field("growth", &S::growth),
                    Field("beyond", &S::beyond), Field("depth", &S::depth, "(0, inf) m"),
                    Field("depthBits", &S::depthBits, "[8, 32]"),
                    Field("extinction", &S::extinction), Field("filter", &S::filter));
}

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeDeepOpacityMap(const DeepOpacityMapSettings& settings);

}  // namespace hair
