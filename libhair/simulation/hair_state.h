#pragma once

#include <iosfwd>

#include <libhair/core/api.h>
#include <libhair/simulation/frame.h>

namespace HAIR_API hair {

/// Writes the state that a frame passes to the next: guides, self-collision with its rest density,
/// colliders, time, drawn points, and the clearances measured at construction. Settings and groom
/// are not included. Layout: hair_state.cpp. Throws Error where the stream fails.
void saveState(const Hair& hair, std::ostream& out);

/// Restores a saved state: with the settings and motion of the saved run, every later frame is
/// bit-identical to it, on any machine and number of threads. Reads exactly the bytes written.
/// Transmittance and colours are recomputed by the next frame, or light(). Throws Error for a state
/// of another groom or of guide settings with another rest shape, and for a truncated or damaged
/// one; the hair is then unchanged.
void restoreState(std::istream& in, Hair& hair);

}  // namespace hair
