#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include <apps/hair/commands.h>

namespace hair {

/// What the chosen command will do once the whole command line has been understood.
using Run = std::function<void()>;

/// All commands of `hair`; `commandLine` is told to who wants to repeat a measurement.
void addCommands(CLI::App& app, Run& run, const std::string& commandLine);

/// Those that measure: `hair measure`, `measure-motion`, `plan`.
void addMeasure(CLI::App& app, Run& run, const std::string& commandLine);
void addMeasureMotion(CLI::App& app, Run& run);
void addPlan(CLI::App& app, Run& run);

/// `hair lod`.
void addLod(CLI::App& app, Run& run);

/// `hair mesh apply`, `hair mesh info`.
void addMesh(CLI::App& app, Run& run);

}  // namespace hair
