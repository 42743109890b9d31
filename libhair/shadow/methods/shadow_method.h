#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/fields.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/shadow/density_map.h>

namespace HAIR_API hair {

/// Common interface of shadow methods, for comparison by measurement. Programs that use one method
/// call its passes directly; frame() calls those of the density map.
class ShadowMethod {
 public:
  virtual ~ShadowMethod() = default;

  /// Builds the shadow of the strands under the light; replaces the previous one and reuses its
  /// memory. Multi-threaded; the result has the same bits for any number of threads.
  virtual void build(StrandView strands, const Fibre& fibre, const LightSpace& light) = 0;

  /// Transmittance at any points, [0, 1]; 1 where no hair is in front. On all threads.
  /// `out`: [points.size()].
  virtual void sample(std::span<const glm::vec3> points, std::span<float> out) const = 0;

  /// Transmittance at all points of the strands passed to build, without self-shadowing of a strand
  /// if the method supports it. `out`: [pointCount].
  virtual void sampleStrands(StrandView strands, std::span<float> out) const {
    sample(strands.points, out);
  }

  /// Memory in use between build and the last sample.
  virtual std::size_t bytes() const = 0;
};

/// Extinction of light by a fibre.
enum class Extinction {
  Unbiased,   ///< the mean over the cell, of which the fibre covers a part
  Published,  ///< -ln(1 - opacity), as in the papers: too dark, because fibres do not fill cells
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(Extinction) {
  return std::array{Word("unbiased", Extinction::Unbiased),
                    Word("published", Extinction::Published)};
}

/// Interpolation between pixel centres of a light image.
enum class LateralFilter {
  Nearest,  ///< the pixel that contains the point, as the papers' single texture fetch
  Linear,   ///< transmittances of the four nearest pixels, bilinear
};
/// Words for them (core/fields.h).
constexpr auto wordsOf(LateralFilter) {
  return std::array{Word("nearest", LateralFilter::Nearest), Word("linear", LateralFilter::Linear)};
}

/// Shadow map (Williams 1978) with percentage-closer filtering (Reeves, Salesin and Cook 1987): the
/// depth of the first hair in each pixel; transmittance at a point is the fraction of the pixels
/// around it whose first hair is not in front of it. Treats hair as opaque.
struct ShadowMapSettings {
  float pixelSize = 1e-3f;     ///< metres, > 0
  float filterRadius = 3e-3f;  ///< metres, >= 0: radius of the disc of compared pixels
  float bias = 1e-3f;          ///< metres, >= 0, by which points are moved towards the light
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const ShadowMapSettings*) {
  using S = ShadowMapSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("filterRadius", &S::filterRadius, "[0, inf) m"),
                    Field("bias", &S::bias, "[0, inf) m"));
}

/// Opacity shadow maps (Kim and Neumann 2001): equidistant planes across the light slice the hair;
/// each pixel of each slice sums the opacity inside; sums are interpolated linearly between planes.
struct OpacityMapSettings {
  float pixelSize = 3e-3f;                       ///< metres, > 0
  int slices = 16;                               ///< across the light, evenly
  Extinction extinction = Extinction::Unbiased;  ///< how opacity becomes optical depth
  LateralFilter filter = LateralFilter::Linear;  ///< between pixels
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const OpacityMapSettings*) {
  using S = OpacityMapSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("slices", &S::slices, "[1, 1024]"), Field("extinction", &S::extinction),
                    Field("filter", &S::filter));
}

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

/// Density clustering (Mertens et al. 2004): each pixel's fragments are clustered by depth; a
/// cluster is a bin over which optical depth grows linearly, sqrt(3) standard deviations to both
/// sides of its mean (section 3.2).
struct DensityClusteringSettings {
  /// Initial positions of clusters (section 3.3).
  enum class Start {
    Uniform,       ///< evenly between a pixel's first and last fragment
    TowardsLight,  ///< closer together near the light, where shadows change most
  };
  float pixelSize = 3e-3f;                       ///< metres, > 0
  int clusters = 4;                              ///< K
  int iterations = 1;                            ///< of k-means, >= 1
  Start start = Start::Uniform;                  ///< of k-means
  Extinction extinction = Extinction::Unbiased;  ///< how opacity becomes optical depth
  LateralFilter filter = LateralFilter::Linear;  ///< between pixels
};

/// Words for them (core/fields.h).
constexpr auto wordsOf(DensityClusteringSettings::Start) {
  return std::array{Word("uniform", DensityClusteringSettings::Start::Uniform),
                    Word("towards light", DensityClusteringSettings::Start::TowardsLight)};
}
/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const DensityClusteringSettings*) {
  using S = DensityClusteringSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("clusters", &S::clusters, "[1, 64]"),
                    Field("iterations", &S::iterations, "[1, inf)"), Field("start", &S::start),
                    Field("extinction", &S::extinction), Field("filter", &S::filter));
}

/// Deep shadow maps (Lokovic and Veach 2000): each pixel's visibility function, compressed greedily
/// to linear pieces that are within `tolerance` of it everywhere.
struct DeepShadowMapSettings {
  float pixelSize = 3e-3f;  ///< metres, > 0
  float tolerance = 0.01f;  ///< of transmittance, >= 0; 0: every fragment is kept
  Extinction extinction = Extinction::Unbiased;  ///< how opacity becomes optical depth
  LateralFilter filter = LateralFilter::Linear;  ///< between pixels
};

/// Its fields and their ranges (core/fields.h).
constexpr auto fieldsOf(const DeepShadowMapSettings*) {
  using S = DeepShadowMapSettings;
  return std::tuple(Field("pixelSize", &S::pixelSize, "(0, inf) m"),
                    Field("tolerance", &S::tolerance, "[0, inf)"),
                    Field("extinction", &S::extinction), Field("filter", &S::filter));
}

/// A method and its settings: one row of a table that compares them.
using ShadowSettings =
    std::variant<DensityMapSettings, ShadowMapSettings, OpacityMapSettings, DeepOpacityMapSettings,
                 DensityClusteringSettings, DeepShadowMapSettings>;

/// Throws Error for settings out of range.
std::unique_ptr<ShadowMethod> makeShadowMethod(const ShadowSettings& settings);

/// The method's name in lower case: "density map", "deep opacity map" ...
std::string methodName(const ShadowSettings& settings);
/// Its settings in a few words without commas: "3 mm 7 layers linear".
std::string settingsText(const ShadowSettings& settings);

}  // namespace hair
