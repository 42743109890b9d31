#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/light/light_space.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// From a point against the light, and how far.
struct ShadowRay {
  glm::vec3 origin;      ///< metres
  glm::vec3 toLight;     ///< unit
  float length;          ///< metres; INFINITY for parallel light
  std::uint32_t strand;  ///< its fibre is not seen; kNoStrand: all are
};
/// No strand: none is left out.
inline constexpr std::uint32_t kNoStrand = 0xffffffffu;

/// Rays through fibres of real width: every strand is a tube of width w = fibre.width ·
/// fibre.hairsPerStrand about its polyline, seen by a ray as a ribbon that faces it; each crossing
/// takes the part fibre.opacity of the light. A strand is crossed once where it is crossed, also at
/// the joints of its segments.
class FibreTracer {
 public:
  virtual ~FibreTracer() = default;
  /// How many fibres each ray crosses. `out`: [rays.size()]. On all threads.
  virtual void countCrossings(std::span<const ShadowRay> rays,
                              std::span<std::uint32_t> out) const = 0;
};

/// Plain: a uniform grid, walked cell by cell. Strands are copied.
std::unique_ptr<FibreTracer> makeGridTracer(StrandView strands, const Fibre& fibre);

/// A strand point at which transmittance is wanted.
struct SamplePoint {
  std::uint32_t strand;  ///< that the point is of
  std::uint32_t point;   ///< in StrandView::points
  glm::vec3 position;    ///< metres
};

/// `count` points, each of its own strand as long as there are strands enough, chosen at random by
/// `seed`; roots are left out (scalps shadow them). All points where there are fewer.
std::vector<SamplePoint> chooseSamplePoints(StrandView strands, std::size_t count,
                                            std::uint32_t seed);

/// How the truth is averaged.
struct TruthSettings {
  float footprint =
      3e-3f;  ///< radius of the disc across the light that is averaged over, metres, >= 0
  std::uint32_t rays = 2048;  ///< a point, >= 2
  std::uint32_t seed = 1;     ///< of where rays begin
};

/// Transmittance and the standard error of that figure.
struct Truth {
  std::vector<float> transmittance;  ///< [points.size()], [0, 1]
  std::vector<float> standardError;  ///< [points.size()]; of plain random rays, so rather too
                                     ///< large: rays are spread evenly over the disc
};

/// The mean over the disc around each point of (1 - opacity)^crossings on the way to the light, own
/// strand excluded. Throws Error for settings out of range.
Truth exactTransmittance(const FibreTracer& tracer, const Fibre& fibre, const LightSpace& light,
                         std::span<const SamplePoint> points, const TruthSettings& settings);

}  // namespace hair
