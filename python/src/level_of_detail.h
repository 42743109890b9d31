#pragma once

#include <memory>

#include <libhair/model/level_of_detail.h>

namespace hair::python {

using DetailPtr = std::shared_ptr<GroomDetail>;

}  // namespace hair::python
