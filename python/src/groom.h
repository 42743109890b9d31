#pragma once

#include <memory>

#include <libhair/model/groom.h>

#include "strands.h"

namespace hair::python {

using GroomPtr = std::shared_ptr<Groom>;

}  // namespace hair::python
