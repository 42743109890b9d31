#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <libhair/core/api.h>
#include <libhair/density/brick_store.h>

namespace HAIR_API hair {

/// Transmittance of the cells of all bricks, and of a brick of ones, slot 0.
///
/// The walk along the light meets bricks in *runs*: all slices of one brick that follow each other.
/// Run 0 is what is before all hair. (The brick in which the walk begins can be met again at its
/// end, where the modulo comes round: that is a run of its own.) DensityMap::lightIn holds a code
/// for each run and each brick across. A point looks at two slices that follow each other, and in
/// each at neighbours along a row, so a brick has a layer and a column more than cells:
///
///   layer 0: what enters the brick's first slice; layer 1 + s: what leaves slice s;
///   row z of a layer: 16 cells, and the first cell of the next brick's row in the same slice.
///
/// The code of a brick is the number of its layer 1 (layers of all bricks are counted through).
/// Where no brick is, it is kFixed and the layer that all slices of the run read: the last of the
/// last brick towards the light, or that of ones. There the value beside the row is of another
/// slice, and must not be read.
class Transmittances {
 public:
  /// Bit of a code: all slices read one layer.
  static constexpr std::uint32_t kFixed = 0x80000000u;
  static constexpr int kRow = brick::kY + 1;       ///< floats of a row
  static constexpr int kLayer = brick::kZ * kRow;  ///< of a layer
  static constexpr int kLayers = brick::kX + 1;    ///< of a brick

  /// Room for slots 0 to `slots`; what was there is lost.
  void reserve(std::size_t slots) {
    if (slots + 1 <= slots_) return;
    slots_ = slots + 1;
    values_.reset(new float[slots_ * kLayers * kLayer]);
    for (std::size_t c = 0; c < std::size_t{kLayers} * kLayer; ++c) values_[c] = 1.0f;
  }
  /// Code of a brick that is there.
  static std::uint32_t code(std::uint32_t slot) { return slot * kLayers + 1; }
  /// kLayer floats of a layer, by its number.
  float* layer(std::uint32_t number) { return values_.get() + number * std::size_t{kLayer}; }
  /// All layers, one after the other.
  const float* data() const { return values_.get(); }
  /// Row z (within its brick) of slice x (within its brick) of what a code says.
  const float* row(std::uint32_t code, std::uint32_t x, int z) const {
    const std::uint32_t number = code & kFixed ? code & ~kFixed : code + x;
    return values_.get() + number * std::size_t{kLayer} + static_cast<std::size_t>(z * kRow);
  }

 private:
  std::size_t slots_ = 0;
  std::unique_ptr<float[]> values_;
};

}  // namespace hair
