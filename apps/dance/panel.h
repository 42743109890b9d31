#pragma once

#include <string>

#include <apps/dance/controls.h>

namespace hair {

/// Draws the panel into the open ImGui frame, along the window's left edge; changes `controls` as
/// the user says.
Requests drawPanel(Controls& controls, Readout& readout);

/// A line in the middle of the window, over everything: what the user is to wait for.
void drawNotice(const std::string& text);

}  // namespace hair
