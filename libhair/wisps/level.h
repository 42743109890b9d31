#pragma once

#include <cstdint>
#include <span>

#include <libhair/core/api.h>
#include <libhair/model/level_of_detail.h>
#include <libhair/wisps/wisps.h>

namespace HAIR_API hair {

/// Sets the level of detail of drawWisps. Resizes wisps.points; its contents are undefined until
/// the next draw. Strands keep their numbers: one that is not drawn has no points. `detail`: of the
/// wisps' groom. Costs a few nanoseconds per strand of the groom. Never frees memory, so that later
/// levels need not allocate. Throws Error for a level out of range and another groom's detail.
void setLevel(const GroomDetail& detail, const LevelOfDetail& level, Wisps& wisps);

/// Draws every stride-th strand (0, stride, 2 · stride ...) with all of its points, at any level,
/// after prepareWisps. `out` has all strands of the groom; the others have no points. Threads over
/// strands. Throws Error for a stride of 0.
void drawEvery(std::uint32_t stride, const Wisps& wisps, StrandSet& out);

/// A groom of only what the level draws: less memory, where the level does not change (a crowd, a
/// file). Strands that are fading are kept from half of the full width on; all are equally wide,
/// and together cover as much as before. Drawn at rest, points are those of the level. Throws Error
/// as setLevel.
Groom groomAt(const Groom& groom, const GroomDetail& detail, const LevelOfDetail& level);

}  // namespace hair
