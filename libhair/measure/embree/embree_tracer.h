#pragma once

#include <memory>

#include <libhair/core/strands.h>
#include <libhair/measure/truth.h>
#include <libhair/model/groom.h>

namespace hair {

/// The same law as makeGridTracer, another's implementation: Embree's round linear curves. Target
/// hair::embree (HAIR_WITH_EMBREE). Strands are copied.
///
/// A crossing is where a ray enters the tube of a strand; its depth, and the square cut at the
/// strand's ends, are those of ribbon.h. Differs from the grid in float rounding, and where tubes
/// bend so sharply that they run into themselves.
std::unique_ptr<FibreTracer> makeEmbreeTracer(StrandView strands, const Fibre& fibre);

}  // namespace hair
