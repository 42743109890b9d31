#pragma once

#include <span>

#include <libhair/core/api.h>
#include <libhair/measure/shadow/truth.h>

namespace HAIR_API hair {

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
