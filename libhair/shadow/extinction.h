#pragma once

#include <algorithm>
#include <cmath>

#include <libhair/core/api.h>
#include <libhair/core/fibre.h>

namespace HAIR_API hair {

/// What a fibre takes away of the light that meets it.
enum class Extinction {
  Unbiased,   ///< what it takes on average from a cell that it crosses somewhere
  Published,  ///< -ln(1 - opacity), as in the papers: too dark, since fibres do not fill cells
};

/// Optical depth of a cell that is covered once, by fibres of one kind side by side; a cell of
/// which they cover part c has c times that.
///
/// A fibre of width w that crosses a cell of size s covers c = w / s of it and lets 1 - opacity · c
/// of its light through. That makes an optical depth of -ln(1 - opacity · c), and per covered area
///
///   -ln(1 - opacity · c) / c     →  opacity                for fibres much thinner than a cell,
///                                →  -ln(1 - opacity)       for one as wide as a cell.
///
/// Fibres cross the cell independently of each other, so that their factors multiply.
/// `cell`: metres, the width over which the fibre is smeared out.
inline float extinctionOf(const Fibre& fibre, float cell,
                          Extinction extinction = Extinction::Unbiased) {
  const float cover = std::min(fibre.width / cell, 1.0f);
  if (extinction == Extinction::Published) return -std::log(std::max(1 - fibre.opacity, 1e-4f));
  // Below: the limit, without the division of two small numbers.
  if (cover < 1e-4f) return fibre.opacity;
  return -std::log(std::max(1 - fibre.opacity * cover, 1e-4f)) / cover;
}

}  // namespace hair
