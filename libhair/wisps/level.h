#pragma once

#include <cstdint>
#include <span>

#include <libhair/core/api.h>
#include <libhair/model/level_of_detail.h>
#include <libhair/wisps/wisps.h>

namespace HAIR_API hair {

/// What drawWisps draws from now on; wisps.points has room for it, and nothing of use in it until
/// then. Strands keep their numbers: one that is not drawn has no points. `detail`: of the wisps'
/// groom. Costs a few nanoseconds a strand of the groom; no memory is given back, lest the next
/// level has to ask for it again. Throws Error for a level out of range and another groom's detail.
void setLevel(const GroomDetail& detail, const LevelOfDetail& level, Wisps& wisps);

/// Draws strands 0, stride, 2 · stride ... with all of their points, whatever the level, after
/// prepareWisps. `out` has all strands of the groom; the others have no points. Threads over
/// strands.
void drawEvery(std::uint32_t stride, const Wisps& wisps, StrandSet& out);

/// A groom that has no more than the level draws: less memory, for one that stays small (a crowd, a
/// file). Strands that are on their way out are in or out; all are as wide, and cover as much as
/// before together. Drawn at rest, points are those of the level.
Groom groomAt(const Groom& groom, const GroomDetail& detail, const LevelOfDetail& level);

}  // namespace hair
