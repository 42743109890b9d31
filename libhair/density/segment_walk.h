#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include <libhair/density/cell_walk.h>
#include <libhair/density/cell_writer.h>
#include <libhair/density/density_grid.h>

namespace hair {

// Scalar splatting of one segment: the traversal of Deposit::Segments, and the reference for the
// kernel of Deposit::Columns, which handles sixteen at a time.

inline std::uint32_t toCount(float amount) {
  return amount >= 4294967040.0f ? kFull
                                 : static_cast<std::uint32_t>(static_cast<std::int64_t>(amount));
}

/// Rounds the amounts of one strand to counts and carries the rounding error to the next: a
/// strand's sum is exact to half a count plus 2^-17 a segment. The carry is an integer, in units of
/// 2^-16 counts, so it does not depend on the order of sums.
class Rounder {
 public:
  /// Amounts of at least this are converted without carry.
  static constexpr float kWhole = 0x1p30f;

  std::uint32_t take(float amount) {
    if (amount >= kWhole) return toCount(amount);
    const auto whole = static_cast<std::int32_t>(amount);
    const float rest = (amount - static_cast<float>(whole)) * 65536.0f;
    // As the lanes round, which have no lround. NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return take(whole, static_cast<std::int32_t>(rest + 0.5f));
  }
  /// An amount split in whole counts and parts of 2^-16.
  std::uint32_t take(std::int32_t whole, std::int32_t part) {
    rest_ += static_cast<std::uint32_t>(part);
    const std::uint32_t count = static_cast<std::uint32_t>(whole) + (rest_ >> 16);
    rest_ &= 0xffffu;
    return count;
  }

 private:
  std::uint32_t rest_ = 0x8000u;
};

/// Counts that a segment adds per cell of its length: SegmentMeasure in cell coordinates.
struct SegmentScale {
  SegmentMeasure::Of of;
  float perCell;
  const CellFrame& frame;

  float amount(glm::vec3 a, glm::vec3 b) const {
    const glm::vec3 d = b - a;
    float square = d.y * d.y + d.z * d.z;
    const float g = frame.curvature > 0 ? frame.magnification(0.5f * (a + b)) : 1.0f;
    if (of == SegmentMeasure::Of::AcrossX) return perCell * std::sqrt(square) * g;
    if (frame.curvature > 0) square = square / (g * g);
    return perCell * std::sqrt(square + d.x * d.x);
  }
};

/// Whether a segment is longer than the grid. The grid then reports aliasing; skip the traversal,
/// which could cross a billion cells.
inline bool longerThan(float longest, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 d = b - a;
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > longest;
}

/// Traverses the cells between two points in unwrapped cell coordinates (Amanatides and Woo 1987)
/// and adds to each its share of `count`. The share of the last cell stays in `pending`, because
/// the next segment usually starts there.
template <class Writer>
void depositSegment(glm::vec3 a, glm::vec3 b, std::uint32_t count, glm::ivec3& cell,
                    glm::ivec3 last, std::uint32_t& pending, Writer& writer) {
  AxisWalk x(a.x, b.x, cell.x, last.x), y(a.y, b.y, cell.y, last.y), z(a.z, b.z, cell.z, last.z);
  const auto whole = static_cast<float>(count);
  std::uint32_t left = 0;  // counts already distributed
  for (int walls = x.left + y.left + z.left; walls > 0; --walls) {
    const float wall = std::min(std::min(x.next, y.next), z.next);
    // Differences of a rounded running sum: the parts add up to the count.
    const std::uint32_t reached =
        std::min(std::max(toCount(std::max(whole * wall, 0.0f)), left), count);
    writer.add(cell, addSaturating(pending, reached - left));
    pending = 0;
    left = reached;
    const bool alongX = x.next == wall;
    const bool alongY = !alongX & (y.next == wall);
    x.cross(alongX, cell.x);
    y.cross(alongY, cell.y);
    z.cross(!(alongX | alongY), cell.z);
  }
  pending = addSaturating(pending, count - left);
}

/// As depositSegment, but clips the segment only to columns of cells and splits each piece between
/// the two slices nearest to its middle. A piece long in depth covers little of its column.
template <class Writer>
void depositColumns(glm::vec3 a, glm::vec3 b, std::uint32_t count, float longest, Writer& writer) {
  glm::ivec3 cell = floorToCell(a);
  if (longerThan(longest, a, b)) return writer.add(cell, count);
  const glm::ivec3 last = floorToCell(b);
  AxisWalk y(a.y, b.y, cell.y, last.y), z(a.z, b.z, cell.z, last.z);
  // max replaces the NaN of a denormal distance, whose reciprocal is infinite.
  y.next = std::max(0.0f, y.next), z.next = std::max(0.0f, z.next);
  const auto whole = static_cast<float>(count);
  const float middle = 0.5f * (b.x - a.x);
  // Split between the two nearest slices, so that counts change continuously with the motion.
  const auto leave = [&](glm::ivec3 in, float depth, std::uint32_t amount) {
    const float x = depth - 0.5f;
    in.x = floorToInt(x);
    const std::uint32_t far =
        std::min(toCount(static_cast<float>(amount) * (x - static_cast<float>(in.x))), amount);
    writer.add(in, amount - far);
    ++in.x;
    writer.add(in, far);
  };
  float behind = 0;
  std::uint32_t left = 0;
  for (int walls = y.left + z.left; walls > 0; --walls) {
    const float wall = std::min(std::max(std::min(y.next, z.next), behind), 1.0f);
    const std::uint32_t reached = std::min(std::max(toCount(whole * wall), left), count);
    leave(cell, a.x + middle * (behind + wall), reached - left);
    left = reached;
    behind = wall;
    const bool alongY = y.next <= z.next;
    y.cross(alongY, cell.y);
    z.cross(!alongY, cell.z);
  }
  leave(cell, a.x + middle * (behind + 1), count - left);
}

}  // namespace hair
