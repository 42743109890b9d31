#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/core/strands.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

/// Optical depth of a cell covered exactly once by fibres side by side; for a covered fraction c,
/// multiply by c.
///
/// A fibre of width w that crosses a cell of size s covers c = w / s of it and transmits
/// 1 - opacity · c. The optical depth is -ln(1 - opacity · c), and per covered area
///
///   -ln(1 - opacity · c) / c     →  opacity                for fibres much thinner than a cell,
///                                →  -ln(1 - opacity)       for one as wide as a cell.
///
/// Fibres are independent of each other, so their transmittances multiply.
/// `cell`: metres, the width over which the fibre is averaged.
inline float extinctionOf(const Fibre& fibre, float cell,
                          Extinction extinction = Extinction::Unbiased) {
  const float cover = std::min(fibre.width / cell, 1.0f);
  if (extinction == Extinction::Published) return -std::log(std::max(1 - fibre.opacity, 1e-4f));
  // Use the limit, instead of dividing two small numbers.
  if (cover < 1e-4f) return fibre.opacity;
  return -std::log(std::max(1 - fibre.opacity * cover, 1e-4f)) / cover;
}

}  // namespace hair
