#pragma once

#include <libhair/density/brick_store.h>

namespace hair {

/// sum += from, and `from` is empty. Sums that do not fit stand at 2^32 - 1; true if there is one.
/// Threads share the bricks.
bool addBricks(BrickStore& from, BrickStore& sum);

}  // namespace hair
