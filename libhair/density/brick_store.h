#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace hair {

/// Bricks of 4 × 16 × 4 cells along X, Y and Z. A row along Y is one vector and one cache line; a
/// brick of 1 KiB has 16 rows. Successive cells of a strand are mostly in the same brick.
namespace brick {
inline constexpr int kX = 4,                ///< cells of a brick along X
    kY = 16,                                ///< along Y; one row
    kZ = 4;                                 ///< along Z
inline constexpr int kLayer = kY * kZ;      ///< cells of one slice of a brick
inline constexpr int kCells = kX * kLayer;  ///< cells of a brick

/// Index of a wrapped cell in its brick: x slowest, y fastest.
inline std::size_t offset(glm::ivec3 cell) {
  const glm::uvec3 c(cell);
  return std::size_t{(c.x % kX * kZ + c.z % kZ) * kY + c.y % kY};
}
}  // namespace brick

/// Sparse cells: a table with an entry (place) for every brick of the grid, and a pool of allocated
/// bricks (slots). Slots are numbered from 1 in order of allocation; slot 0 is a shared brick of
/// zeros, for places without a brick.
class BrickStore {
 public:
  BrickStore() = default;
  /// A grid of cells³; the last brick along an axis may extend beyond it.
  explicit BrickStore(int cells)
      : perAxis_((cells + brick::kX - 1) / brick::kX, (cells + brick::kY - 1) / brick::kY,
                 (cells + brick::kZ - 1) / brick::kZ),
        slots_(static_cast<std::size_t>(perAxis_.x) * across()) {
    grow(64);
    std::memset(this->cells(0), 0, brick::kCells * sizeof(std::uint32_t));
  }

  glm::ivec3 perAxis() const { return perAxis_; }  ///< bricks
  /// Places of one slice along X.
  std::size_t across() const {
    return static_cast<std::size_t>(perAxis_.y) * static_cast<std::size_t>(perAxis_.z);
  }
  /// Whether it was made for a grid; false for {}.
  bool valid() const { return !slots_.empty(); }
  std::size_t size() const { return places_.size(); }     ///< allocated bricks
  std::size_t sizeBefore() const { return sizeBefore_; }  ///< size() before the last clear()
  std::size_t room() const { return room_; }              ///< capacity, bricks
  /// Memory of the table and the allocated bricks.
  std::size_t bytes() const {
    return slots_.size() * sizeof(slots_[0]) +
           size() * (sizeof(places_[0]) + brick::kCells * sizeof(std::uint32_t));
  }

  /// Place of the brick of a wrapped cell.
  std::size_t place(glm::ivec3 cell) const {
    return (static_cast<std::size_t>(cell.x / brick::kX) * static_cast<std::size_t>(perAxis_.z) +
            static_cast<std::size_t>(cell.z / brick::kZ)) *
               static_cast<std::size_t>(perAxis_.y) +
           static_cast<std::size_t>(cell.y / brick::kY);
  }
  /// Slot of a place, or 0.
  std::uint32_t slot(std::size_t place) const { return slots_[place]; }
  /// Slots of consecutive places, from `place` on.
  const std::uint32_t* slots(std::size_t place) const { return slots_.data() + place; }
  /// Places of slots 1, 2 ...
  std::span<const std::uint32_t> places() const { return places_; }

  /// The kCells cells of a brick, in the order of brick::offset.
  std::uint32_t* cells(std::uint32_t slot) {
    return cells_.get() + slot * std::size_t{brick::kCells};
  }
  /// The same, read-only.
  const std::uint32_t* cells(std::uint32_t slot) const {
    return cells_.get() + slot * std::size_t{brick::kCells};
  }
  /// The slot of a place; allocates a brick of zeros if it has none. Invalidates cells().
  std::uint32_t make(std::size_t place) {
    if (claim(place)) std::memset(cells(slots_[place]), 0, brick::kCells * sizeof(std::uint32_t));
    return slots_[place];
  }
  /// Allocates an uninitialised brick if the place has none; returns whether it did. Invalidates
  /// cells().
  bool claim(std::size_t place) {
    if (slots_[place] != 0) return false;
    if (places_.size() + 1 >= room_) grow(2 * room_ + 64);
    places_.push_back(static_cast<std::uint32_t>(place));
    slots_[place] = static_cast<std::uint32_t>(places_.size());
    return true;
  }
  /// Count of a wrapped cell; 0 without a brick.
  std::uint32_t count(glm::ivec3 cell) const {
    const std::uint32_t s = slots_[place(cell)];
    return s == 0 ? 0 : cells(s)[brick::offset(cell)];
  }

  /// Frees all bricks and keeps their memory. From two thirds full on it grows the capacity to 2.5
  /// times the bricks freed, so that moving hair rarely reallocates in a later frame.
  void clear() {
    if (3 * size() >= 2 * room_) grow(5 * size() / 2 + 64);
    for (const std::uint32_t p : places_) slots_[p] = 0;
    sizeBefore_ = places_.size();
    places_.clear();
  }

 private:
  void grow(std::size_t room) {
    places_.reserve(room);
    // One more cell, because pairs of cells are gathered.
    std::unique_ptr<std::uint32_t[]> cells(new std::uint32_t[room * brick::kCells + 1]);
    if (room_ > 0) std::memcpy(cells.get(), cells_.get(), room_ * brick::kCells * sizeof(cells[0]));
    cells_ = std::move(cells);
    room_ = room;
  }

  glm::ivec3 perAxis_{0};
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> places_;
  std::size_t sizeBefore_ = 0;
  std::size_t room_ = 0;                    // bricks, slot 0 included
  std::unique_ptr<std::uint32_t[]> cells_;  // [room_ · brick::kCells + 1]
};

}  // namespace hair
