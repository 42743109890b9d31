#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/density/cell_frame.h>

namespace HAIR_API hair {

/// The cell that unwrapped cell coordinates lie in.
inline glm::ivec3 floorToCell(glm::vec3 u) {
  return {floorToInt(u.x), floorToInt(u.y), floorToInt(u.z)};
}

/// One axis of a walk through the cells along a segment.
struct AxisWalk {
  int way,     ///< direction of the next wall, 1 or -1
      left;    ///< walls to cross
  float next,  ///< the next wall, in the segment's parameter, [0, 1]; kNever: none
      step;    ///< from wall to wall, in the same

  /// From coordinate a, in `cell`, to coordinate b, in cell `last`, along this axis.
  AxisWalk(float a, float b, int cell, int last) : way(last > cell ? 1 : -1), left(last - cell) {
    const float perParameter = 1.0f / (b - a);
    const float wall = static_cast<float>(cell + (way > 0 ? 1 : 0));
    const float first = (wall - a) * perParameter;
    next = left == 0 ? kNever : first;
    step = std::abs(perParameter);
    left = std::abs(left);
  }
  /// Crosses the wall at `next` if `now`. Whole numbers of walls decide where the axis ends, never
  /// sums of steps. Selections, no branches: which axis comes next cannot be predicted.
  void cross(bool now, int& cell) {
    const int one = now ? 1 : 0;
    cell += now ? way : 0;
    left -= one;
    const float further = next + (now ? step : 0.0f);
    next = left == 0 ? kNever : further;
  }

  static constexpr float kNever = 2.0f;  ///< farther than any wall
};

}  // namespace hair
