#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <libhair/density/brick_store.h>

namespace hair {

/// Transmittance of the cells of all bricks; slot 0 is a brick of ones.
///
/// Traversal along the light groups slices in *runs*: consecutive slices of one brick. Run 0 is in
/// front of all hair. (Where the modulo wraps, traversal may end in the brick in which it began;
/// that is a run of its own.) LitBricks::lightIn has a code for each run and each brick across. A
/// filter reads two consecutive slices, and neighbours along a row in each, so bricks are padded by
/// a layer and a column:
///
///   layer 0: light entering the brick's first slice; layer 1 + s: light leaving slice s;
///   row z of a layer: 16 cells, and the first cell of the next brick's row in the same slice.
///
/// The code of a brick is the index of its layer 1 (layers are numbered across all bricks). Without
/// a brick, it is kFixed and the one layer that all slices of the run read: the last layer of the
/// previous brick towards the light, or a layer of ones. In such runs the padding column belongs to
/// another slice and must not be read.
class Transmittances {
 public:
  /// Bit of a code: all slices read one layer.
  static constexpr std::uint32_t kFixed = 0x80000000u;
  static constexpr int kRow = brick::kY + 1;       ///< floats of a row
  static constexpr int kLayer = brick::kZ * kRow;  ///< floats of a layer
  static constexpr int kLayers = brick::kX + 1;    ///< layers of a brick

  /// Allocates slots 0 to `slots`; loses the contents if it has to grow.
  void reserve(std::size_t slots) {
    if (slots + 1 <= slots_) return;
    slots_ = slots + 1;
    values_.reset(new float[slots_ * kLayers * kLayer]);
    for (std::size_t c = 0; c < std::size_t{kLayers} * kLayer; ++c) values_[c] = 1.0f;
  }
  /// Code of an allocated brick.
  static std::uint32_t code(std::uint32_t slot) { return slot * kLayers + 1; }
  /// kLayer floats of a layer, by its number.
  float* layer(std::uint32_t number) { return values_.get() + number * std::size_t{kLayer}; }
  /// All layers, one after the other.
  const float* data() const { return values_.get(); }
  /// Row z of slice x, both within the brick, of a code.
  const float* row(std::uint32_t code, std::uint32_t x, int z) const {
    const std::uint32_t number = code & kFixed ? code & ~kFixed : code + x;
    return values_.get() + number * std::size_t{kLayer} + static_cast<std::size_t>(z * kRow);
  }

 private:
  std::size_t slots_ = 0;
  std::unique_ptr<float[]> values_;
};

/// Transmittance of the cells of a DensityMap, and where to find it.
///
///      light → → →    a column of bricks: 4 slices deep, 4 × 16 cells across
///     +----+----+----+----+----+
///     |    | B0 |    |    | B1 |      `lightIn` locates the transmittance of each
///     +----+----+----+----+----+      brick of the column: in itself (B0, B1), or,
///      ones  B0   B0'  B0'  B1        if not allocated, in the last slice of the
///                                     previous brick towards the light (B0'), or
///                                     in the brick of ones.
struct LitBricks {
  Transmittances values;  ///< of the bricks
  /// [runs][across] codes, see Transmittances; written where a filter may read them (bricksToRead)
  std::vector<std::uint32_t> lightIn;
  /// [0]: in front of the hair; [1 + s]: slice s of the hair.
  std::vector<std::int32_t> sliceRun,  ///< offset in lightIn of the codes of its run
      sliceInBrick;                    ///< same shape: slice within the bricks of its run
};

}  // namespace hair
