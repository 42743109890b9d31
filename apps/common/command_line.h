#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/glm.hpp>

#include <apps/common/character.h>
#include <apps/common/player.h>
#include <apps/common/results.h>
#include <libhair/core/error.h>

namespace hair {

/// The options that several programs have: spelled once, so that they mean the same everywhere.

/// NAME X,Y,Z, as often as wanted; `values` are replaced by those of the command line.
void addVectors(CLI::App& command, const std::string& name, std::vector<glm::vec3>& values,
                const std::string& help);

/// NAME AXIS
void addUpOption(CLI::App& command, const std::string& name, UpAxis& up, const std::string& help);

/// --scale, --up
void addReadOptions(CLI::App& command, ReadOptions& read);

/// --motion-scale, --motion-up, --head-joint
void addMotionReadOptions(CLI::App& command, MotionSettings& clip);

/// --style, --hair, --strands, --points, --scale, --up
void addHairOptions(CLI::App& command, CharacterOptions& character);

/// Those and --head, --motion, --motion-scale, --motion-up, --head-joint, --verbose, --still,
/// --guides
void addCharacterOptions(CLI::App& command, CharacterOptions& character);

/// --fps, --cells, --light, --point, --wind, --no-shadow, --no-self-collision,
/// --solver, --solver-iterations, --settle, --threads
void addPlayerOptions(CLI::App& command, PlayerOptions& player, int& threads);

/// --profile, --stats, --hash
void addResultOptions(CLI::App& command, ResultFiles& results);

/// Checks the end of an output file's name. A folder that is not there is an Error, before any
/// work.
inline auto endsWith(std::string ending) {
  return [ending](const std::string& name) -> std::string {
    if (!name.ends_with(ending)) return "must end with " + ending + ": " + name;
    const std::filesystem::path folder = std::filesystem::path(name).parent_path();
    std::error_code ignored;
    require(folder.empty() || std::filesystem::is_directory(folder, ignored), name, ": no folder ",
            folder.string(), "; make it first");
    return {};
  };
}

/// Checks that a number is in [lowest, highest], and a number.
inline auto within(double lowest, double highest) {
  return [lowest, highest](const std::string& word) -> std::string {
    const double value = std::strtod(word.c_str(), nullptr);
    if (value >= lowest && value <= highest) return {};
    std::ostringstream message;
    message << word << " is not in " << lowest << " to " << highest;
    return message.str();
  };
}

/// Has `app` read the command line. Nothing where the program is to go on; else what it exits
/// with: 0 where help or the version was asked for and is printed, 2 for bad usage, of which one
/// line on the error stream names the option.
std::optional<int> exitCodeOfParsing(CLI::App& app, int argc, const char* const* argv,
                                     std::ostream& out = std::cout, std::ostream& err = std::cerr);

/// A message as one line whatever bytes of a command line or of a file's name are in it: control
/// characters become question marks.
std::string oneLine(std::string message);

/// Runs `body`, turning exceptions into one line on the error stream and exit code 1.
int runReporting(const char* program, const std::function<int()>& body);

}  // namespace hair
