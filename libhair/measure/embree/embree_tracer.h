#pragma once

#include <memory>

#include <libhair/core/api.h>
#include <libhair/core/strands.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

/// The law of makeGridTracer (ribbon.h), asked of the segments that Embree finds along a ray: a
/// second, independent search, to check the first. Target hair::embree (HAIR_WITH_EMBREE). Strands
/// are copied.
///
/// Known limit: in a few of 100,000 rays Embree 3.13 does not see the seam where a tube becomes its
/// round end; these rays cross one fibre too few.
std::unique_ptr<FibreTracer> makeEmbreeTracer(StrandView strands, const Fibre& fibre);

}  // namespace hair
