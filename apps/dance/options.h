#pragma once

#include <CLI/CLI.hpp>

#include <apps/dance/dance.h>

namespace hair {

/// The command line of `dance`.
void addDanceOptions(CLI::App& app, DanceOptions& options);

}  // namespace hair
