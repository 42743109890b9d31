#pragma once

#include <optional>

namespace hair::python {

/// What thread_limit says to calls made here and now. Call with Python's lock.
std::optional<int> threadsAllowed();

}  // namespace hair::python
