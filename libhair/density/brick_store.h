#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// How cells are grouped: 4 along X, 4 along Z and 16 along Y. Rows along Y are lanes: a brick of
/// 1 KiB is 16 rows of one cache line each. A strand leaves most of its cells in the brick
/// where it left the last one.
namespace brick {
inline constexpr int kX = 4,                ///< cells of a brick along X
    kY = 16,                                ///< along Y; a row of lanes
    kZ = 4;                                 ///< along Z
inline constexpr int kLayer = kY * kZ;      ///< cells of one slice of a brick
inline constexpr int kCells = kX * kLayer;  ///< cells of a brick

/// Where a wrapped cell stands in its brick: x slowest, y fastest.
inline std::size_t offset(glm::ivec3 cell) {
  const glm::uvec3 c(cell);
  return std::size_t{(c.x % kX * kZ + c.z % kZ) * kY + c.y % kY};
}
}  // namespace brick

/// Sparse cells: a table with a place for every brick of the grid, and a pool of those that exist.
/// Slots count from 1 in the order of their making; a table's 0 is "nothing there", and its cells
/// are 0.
class BrickStore {
 public:
  BrickStore() = default;
  /// A grid of cells³; the last bricks of an axis may stick out.
  explicit BrickStore(int cells)
      : perAxis_((cells + brick::kX - 1) / brick::kX, (cells + brick::kY - 1) / brick::kY,
                 (cells + brick::kZ - 1) / brick::kZ),
        slots_(static_cast<std::size_t>(perAxis_.x) * across()) {
    grow(64);
    std::memset(this->cells(0), 0, brick::kCells * sizeof(std::uint32_t));
  }

  glm::ivec3 perAxis() const { return perAxis_; }  ///< bricks
  /// Bricks of a slice of bricks.
  std::size_t across() const {
    return static_cast<std::size_t>(perAxis_.y) * static_cast<std::size_t>(perAxis_.z);
  }
  /// Made for a grid; one that is {} is not.
  bool valid() const { return !slots_.empty(); }
  std::size_t size() const { return places_.size(); }     ///< bricks that exist
  std::size_t sizeBefore() const { return sizeBefore_; }  ///< those that the last clear() took
  std::size_t room() const { return room_; }              ///< bricks that it has memory for
  /// Of the table and the bricks that exist.
  std::size_t bytes() const {
    return slots_.size() * sizeof(slots_[0]) +
           size() * (sizeof(places_[0]) + brick::kCells * sizeof(std::uint32_t));
  }

  /// Which brick holds a wrapped cell.
  std::size_t place(glm::ivec3 cell) const {
    return (static_cast<std::size_t>(cell.x / brick::kX) * static_cast<std::size_t>(perAxis_.z) +
            static_cast<std::size_t>(cell.z / brick::kZ)) *
               static_cast<std::size_t>(perAxis_.y) +
           static_cast<std::size_t>(cell.y / brick::kY);
  }
  /// Slot of a place, or 0.
  std::uint32_t slot(std::size_t place) const { return slots_[place]; }
  /// Slots of `across` places that follow each other.
  const std::uint32_t* slots(std::size_t place) const { return slots_.data() + place; }
  /// Place of slot 1, 2 ...
  std::span<const std::uint32_t> places() const { return places_; }

  /// The kCells cells of a brick, as brick::offset orders them.
  std::uint32_t* cells(std::uint32_t slot) {
    return cells_.get() + slot * std::size_t{brick::kCells};
  }
  /// The same, to read.
  const std::uint32_t* cells(std::uint32_t slot) const {
    return cells_.get() + slot * std::size_t{brick::kCells};
  }
  /// The slot of a place; a brick of zeros is made where none is. Moves the cells of all.
  std::uint32_t make(std::size_t place) {
    if (claim(place)) std::memset(cells(slots_[place]), 0, brick::kCells * sizeof(std::uint32_t));
    return slots_[place];
  }
  /// Makes a brick of whatever values where none is; true if it did.
  bool claim(std::size_t place) {
    if (slots_[place] != 0) return false;
    if (places_.size() + 1 >= room_) grow(2 * room_ + 64);
    places_.push_back(static_cast<std::uint32_t>(place));
    slots_[place] = static_cast<std::uint32_t>(places_.size());
    return true;
  }
  /// Of a wrapped cell; 0 where no brick is.
  std::uint32_t count(glm::ivec3 cell) const {
    const std::uint32_t s = slots_[place(cell)];
    return s == 0 ? 0 : cells(s)[brick::offset(cell)];
  }

  /// No brick exists any more; their memory is kept. Where it was nearly full, there is soon enough
  /// of it for twice as many, so that hair that moves hardly ever needs more in a later frame.
  void clear() {
    if (3 * size() >= 2 * room_) grow(5 * size() / 2 + 64);
    for (const std::uint32_t p : places_) slots_[p] = 0;
    sizeBefore_ = places_.size();
    places_.clear();
  }

 private:
  void grow(std::size_t room) {
    places_.reserve(room);
    // One more, because cells are looked up two at a time.
    std::unique_ptr<std::uint32_t[]> cells(new std::uint32_t[room * brick::kCells + 1]);
    if (room_ > 0) std::memcpy(cells.get(), cells_.get(), room_ * brick::kCells * sizeof(cells[0]));
    cells_ = std::move(cells);
    room_ = room;
  }

  glm::ivec3 perAxis_{0};
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> places_;
  std::size_t sizeBefore_ = 0;
  std::size_t room_ = 0;                    // bricks, that of slot 0 included
  std::unique_ptr<std::uint32_t[]> cells_;  // [room_ · brick::kCells + 1]
};

}  // namespace hair
