#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <libhair/density/cell_frame.h>

namespace hair {

/// The cell that unwrapped cell coordinates lie in.
inline glm::ivec3 floorToCell(glm::vec3 u) {
  return {floorToInt(u.x), floorToInt(u.y), floorToInt(u.z)};
}

/// One axis of a grid traversal along a segment (DDA).
struct AxisWalk {
  int way,     ///< direction of traversal, 1 or -1
      left;    ///< walls left to cross
  float next,  ///< segment parameter of the next wall, [0, 1]; kNever: none
      step;    ///< segment parameter from wall to wall

  /// From coordinate a, in `cell`, to coordinate b, in cell `last`, along this axis.
  AxisWalk(float a, float b, int cell, int last) : way(last > cell ? 1 : -1), left(last - cell) {
    const float perParameter = 1.0f / (b - a);
    const float wall = static_cast<float>(cell + (way > 0 ? 1 : 0));
    const float first = (wall - a) * perParameter;
    next = left == 0 ? kNever : first;
    step = std::abs(perParameter);
    left = std::abs(left);
  }
  /// Crosses the wall at `next` if `now`. Counts walls to find the end of the axis, which rounding
  /// in sums of steps could miss. Branch-free: the order of axes is unpredictable.
  void cross(bool now, int& cell) {
    const int one = now ? 1 : 0;
    cell += now ? way : 0;
    left -= one;
    const float further = next + (now ? step : 0.0f);
    next = left == 0 ? kNever : further;
  }

  static constexpr float kNever = 2.0f;  ///< beyond any wall
};

}  // namespace hair
