#pragma once

#include <span>

namespace hair {

/// Stripes: the part of a residual (measured transmittance less the truth) that comes and goes with
/// depth, every `period`, as the shadows of opacity slices do (Yuksel and Keyser 2008, figure 1).
///
///   residual(i) = m + a cos(2 pi depth(i) / period) + b sin(2 pi depth(i) / period) + rest(i)
///
/// by least squares; returns the energy (a² + b²) / 2, the mean square of the stripes. Noise alone
/// of variance v leaves about 2 v / n of it.
///
/// `residual`, `depth`: [n], n >= 3; depth and period in the same unit, of any origin. Throws Error
/// for other sizes, a period that is not positive, and depths that cannot tell stripes from a
/// constant (all at one phase).
double stripeEnergy(std::span<const float> residual, std::span<const float> depth, double period);

}  // namespace hair
