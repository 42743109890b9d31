#pragma once

#include <libhair/density/brick_store.h>

namespace hair {

/// sum += from, then clears `from`. Saturates at 2^32 - 1; returns whether any cell did. Threads
/// over bricks.
bool addBricks(BrickStore& from, BrickStore& sum);

}  // namespace hair
