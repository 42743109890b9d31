#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hair::draw {

/// A finished picture: 8-bit sRGB, three bytes a pixel, rows from top to bottom without padding.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< [height·width·3]

  Picture() = default;
  Picture(int w, int h) : width(w), height(h), rgb(3 * std::size_t(w) * std::size_t(h)) {}

  const std::uint8_t* pixel(int x, int y) const { return rgb.data() + offset(x, y); }
  std::uint8_t* pixel(int x, int y) { return rgb.data() + offset(x, y); }

  bool operator==(const Picture&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
  }
};

/// A picture of light: linear RGB (of sRGB's primaries), three floats a pixel, rows from top to
/// bottom without padding. 1 is what a display shows at most; what is brighter is above it.
struct LinearPicture {
  int width = 0, height = 0;
  std::vector<float> rgb;  ///< [height·width·3]

  LinearPicture() = default;
  LinearPicture(int w, int h) : width(w), height(h), rgb(3 * std::size_t(w) * std::size_t(h)) {}

  const float* pixel(int x, int y) const { return rgb.data() + offset(x, y); }
  float* pixel(int x, int y) { return rgb.data() + offset(x, y); }

  bool operator==(const LinearPicture&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
  }
};

}  // namespace hair::draw
