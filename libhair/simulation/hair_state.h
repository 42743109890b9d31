#pragma once

#include <iosfwd>

#include <libhair/core/api.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

/// Writes what a frame hands to the next: guides, self-collision, colliders, time, drawn points,
/// and what was learnt at rest in the place where the hair was made. Settings and groom are not
/// part of it. Layout: hair_state.cpp. Throws Error where the stream fails.
void saveState(const Hair& hair, std::ostream& out);

/// Goes on from a saved state: with the settings and the motion of the run that was saved, every
/// later frame has that run's bits, on any machine and number of threads. Reads not a byte more
/// than was written. Transmittance and colours are made again by the next frame, or light().
/// Throws Error where the state is of another groom or of guide settings that give another rest
/// shape, was cut short or damaged; the hair then is as it was.
void restoreState(std::istream& in, Hair& hair);

}  // namespace hair
