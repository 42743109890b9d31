#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/strands.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>

namespace hair {

/// Points along one ray of the light through hair, and what reaches them: the visibility function
/// that figure 5 of Mertens et al. 2004 compares methods by.
struct VisibilityRay {
  std::vector<glm::vec3> points;  ///< [steps], even, from before the hair to behind it
  std::vector<float> depth;       ///< [steps], metres from the first
  std::vector<float> truth;       ///< [steps], over the footprint's disc; no strand is left out
};

/// Which of the points' rays goes through the thick of the hair: that whose line through all hair
/// crosses more fibres than nine tenths of the others do. (The very thickest runs along a strand.)
/// Looks at 512 of the points at most; there must be one, else Error.
glm::vec3 thickOfHair(const FibreTracer& tracer, StrandView strands, const LightSpace& light,
                      std::span<const SamplePoint> points, float footprint);

/// The light's ray through `through`, from a little before the first place where the truth is below
/// 0.998 to a little behind the last where it still falls. `steps` >= 2, else Error.
VisibilityRay makeVisibilityRay(const FibreTracer& tracer, StrandView strands, const Fibre& fibre,
                                const LightSpace& light, glm::vec3 through, std::size_t steps,
                                const TruthSettings& settings);

}  // namespace hair
