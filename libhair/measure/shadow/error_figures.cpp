#include <libhair/measure/shadow/truth.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/core/random.h>

namespace hair {

namespace {

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// The standard error of the mean of values whose own noise has the given mean square. How the
/// values scatter holds their noise already; but few values may happen to scatter less than that.
double standardErrorOfMean(const std::vector<double>& values, double noise) {
  const double n = static_cast<double>(values.size()), middle = mean(values);
  double squares = 0;
  for (const double v : values) squares += (v - middle) * (v - middle);
  const double variance = n > 1 ? squares / (n - 1) : 0;
  return std::sqrt(std::max(variance, noise) / n);
}

/// Where in n sorted values the 99th percentile lies, linear between two of them.
double place99(std::size_t n) {
  return 0.99 * static_cast<double>(n - 1);
}

template <class Value>
double percentile99(std::size_t n, Value&& sortedValue) {
  const double place = place99(n);
  const std::size_t below = static_cast<std::size_t>(place);
  const double low = sortedValue(below), high = sortedValue(std::min(below + 1, n - 1));
  return low + (place - static_cast<double>(below)) * (high - low);
}

/// Spread of the percentile over samples drawn, with replacement, from the sample (Efron 1979,
/// "Bootstrap Methods: Another Look at the Jackknife").
double bootstrapError99(const std::vector<double>& sorted) {
  constexpr std::uint32_t kSamples = 200, kSeed = 20050509;
  const std::size_t n = sorted.size();
  std::vector<std::uint32_t> drawn(n);
  std::vector<double> figures(kSamples);
  for (std::uint32_t b = 0; b < kSamples; ++b) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint64_t word =
          hashWord(static_cast<std::uint32_t>(i) ^ hashWord(b ^ hashWord(kSeed)));
      drawn[i] = static_cast<std::uint32_t>(word * n >> 32);
    }
    const auto below = drawn.begin() + static_cast<std::ptrdiff_t>(place99(n));
    std::nth_element(drawn.begin(), below, drawn.end());
    const std::uint32_t low = *below;
    const std::uint32_t high =
        below + 1 == drawn.end() ? low : *std::min_element(below + 1, drawn.end());
    figures[b] = percentile99(n, [&, k = static_cast<std::size_t>(place99(n))](std::size_t at) {
      return sorted[at == k ? low : high];
    });
  }
  const double middle = mean(figures);
  double squares = 0;
  for (const double f : figures) squares += (f - middle) * (f - middle);
  return std::sqrt(squares / (kSamples - 1));
}

}  // namespace

ErrorFigures errorFigures(std::span<const float> measured, const Truth& truth) {
  const std::size_t n = truth.transmittance.size();
  require(n > 0, "error figures: there is no point to measure at; choose at least one");
  require(measured.size() == n && truth.standardError.size() == n,
          "error figures: ", measured.size(), " measured transmittances, ", n, " true ones and ",
          truth.standardError.size(), " standard errors; they must be of the same points");

  std::vector<double> error(n), absolute(n), square(n);
  double noise = 0, noiseOfSquare = 0;  // mean squares
  for (std::size_t i = 0; i < n; ++i) {
    error[i] = static_cast<double>(measured[i]) - static_cast<double>(truth.transmittance[i]);
    absolute[i] = std::abs(error[i]);
    square[i] = error[i] * error[i];
    // With normal noise of deviation s: Var((e + noise)^2) = 4 e^2 s^2 + 2 s^4.
    const double s = static_cast<double>(truth.standardError[i]), s2 = s * s;
    noise += s2;
    noiseOfSquare += 4 * square[i] * s2 + 2 * s2 * s2;
  }
  noise /= static_cast<double>(n);
  noiseOfSquare /= static_cast<double>(n);

  ErrorFigures figures;
  figures.bias = {mean(error), standardErrorOfMean(error, noise)};
  figures.meanAbsolute = {mean(absolute), standardErrorOfMean(absolute, noise)};
  // d sqrt(x) = dx / (2 sqrt(x)); no error at all: what the truth's noise would show as one.
  const double rms = std::sqrt(mean(square));
  figures.rms = {rms, rms > 0 ? standardErrorOfMean(square, noiseOfSquare) / (2 * rms)
                              : std::sqrt(noise / static_cast<double>(n))};
  std::sort(absolute.begin(), absolute.end());
  figures.percentile99 = {percentile99(n, [&](std::size_t at) { return absolute[at]; }),
                          bootstrapError99(absolute)};
  return figures;
}

}  // namespace hair
