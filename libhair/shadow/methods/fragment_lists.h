#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/strands.h>
#include <libhair/shadow/methods/light_image.h>

namespace hair {

/// A fragment in the list of its pixel.
struct PixelFragment {
  float depth;         ///< along the light, in pixels
  float opticalDepth;  ///< > 0
};

/// The fragments of every pixel, sorted by depth from the light, then by optical depth.
struct FragmentLists {
  std::vector<std::uint32_t> first;      ///< [pixelCount + 1]: pixel p has [first[p], first[p + 1])
  std::vector<PixelFragment> fragments;  ///< of all pixels, one pixel after the other
  std::vector<std::uint32_t> next;  ///< [pixelCount], scratch: index of the pixel's next fragment

  /// Fragments of pixel p, front to back.
  std::span<const PixelFragment> pixel(std::size_t p) const {
    return std::span(fragments).subspan(first[p], first[p + 1] - first[p]);
  }
  /// Memory of the fragments and offsets.
  std::size_t bytes() const;
};

/// Fills the lists with all fragments of the strands (forFragments); reuses their memory. Omits
/// fragments of optical depth 0. Threads over strands, then over pixels; sorting each pixel's
/// fragments makes the result independent of the order of threads.
/// Throws Error for 2^32 fragments or more.
void buildFragmentLists(StrandView strands, const Fibre& fibre, Extinction extinction,
                        const LightImage& image, FragmentLists& lists);

}  // namespace hair
