#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// A ray from a point towards the light.
struct ShadowRay {
  glm::vec3 origin;      ///< metres
  glm::vec3 toLight;     ///< unit
  float length;          ///< metres; INFINITY for parallel light
  std::uint32_t strand;  ///< excluded from the crossings; kNoStrand: none
};
/// No strand is excluded.
inline constexpr std::uint32_t kNoStrand = 0xffffffffu;

/// Rays through fibres of real width: every strand is a tube of width w = fibre.width ·
/// fibre.hairsPerStrand about its polyline, intersected as a ribbon that faces the ray; each
/// crossing absorbs the fraction fibre.opacity of the light. A crossing counts once, also at the
/// joints of segments.
class FibreTracer {
 public:
  virtual ~FibreTracer() = default;
  /// Counts the fibres that each ray crosses. `out`: [rays.size()]. Threads over rays.
  virtual void countCrossings(std::span<const ShadowRay> rays,
                              std::span<std::uint32_t> out) const = 0;
};

/// A tracer without dependencies: walks a uniform grid cell by cell. Copies the strands.
std::unique_ptr<FibreTracer> makeGridTracer(StrandView strands, const Fibre& fibre);

/// A strand point at which transmittance is wanted.
struct SamplePoint {
  std::uint32_t strand;  ///< strand of the point
  std::uint32_t point;   ///< in StrandView::points
  glm::vec3 position;    ///< metres
};

/// `count` random points (by `seed`), one per strand before any strand has two; without roots,
/// which the scalp shadows. All points where there are fewer.
std::vector<SamplePoint> chooseSamplePoints(StrandView strands, std::size_t count,
                                            std::uint32_t seed);

/// Averaging of the truth.
struct TruthSettings {
  float footprint =
      3e-3f;  ///< radius of the disc across the light that is averaged over, metres, >= 0
  std::uint32_t rays = 2048;  ///< per point, [2, 2^22]
  std::uint32_t seed = 1;     ///< of the origins of the rays
};

/// Transmittance and its standard error.
struct Truth {
  std::vector<float> transmittance;  ///< [points.size()], [0, 1]
  std::vector<float> standardError;  ///< [points.size()]; of independent rays, so too large: rays
                                     ///< are spread evenly over the disc
};

/// The mean, over the disc around each point, of (1 - opacity)^crossings between it and the light;
/// the point's own strand is excluded. Throws Error for settings out of range.
Truth exactTransmittance(const FibreTracer& tracer, const Fibre& fibre, const LightSpace& light,
                         std::span<const SamplePoint> points, const TruthSettings& settings);

/// How far transmittances are from the truth. Each figure has the standard error that the choice of
/// points and the truth's own noise leave it.
struct ErrorFigures {
  /// A figure, and how sure it is.
  struct Figure {
    double value = 0;          ///< of transmittance
    double standardError = 0;  ///< of `value`
  };
  Figure meanAbsolute;  ///< mean of |measured - truth|
  Figure rms;           ///< root of the mean of (measured - truth)²
  Figure percentile99;  ///< of the absolute error
  Figure bias;          ///< mean of (measured - truth); negative: too dark
};

/// `measured`: [truth.transmittance.size()].
ErrorFigures errorFigures(std::span<const float> measured, const Truth& truth);

}  // namespace hair
