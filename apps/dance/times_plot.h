#pragma once

#include <apps/dance/history.h>

namespace hair {

/// Stages of the last frames as stacked bars, with medians and last times in numbers; the last
/// pictures' drawing as a line. Into the open ImGui window.
void drawTimes(const History& history, bool drawnByCpu);

}  // namespace hair
