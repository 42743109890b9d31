#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <apps/common/performance.h>
#include <apps/common/results.h>
#include <apps/common/subject.h>

namespace hair {

/// The options that several programs have: spelled once, so that they mean the same everywhere.

/// --scale, --up
void addReadOptions(CLI::App& command, ReadOptions& read);

/// --style, --hair, --head, --motion, --still, --strands, --points, --guides, --scale, --up
void addSubjectOptions(CLI::App& command, SubjectOptions& subject);

/// --fps, --cells, --light, --wind, --no-shadow, --no-self-collision, --settle, --threads
void addPerformanceOptions(CLI::App& command, PerformanceOptions& performance, int& threads);

/// --profile, --stats, --hash
void addResultOptions(CLI::App& command, ResultFiles& results);

/// Checks the end of a file's name.
inline auto endsWith(std::string ending) {
  return [ending](const std::string& name) {
    return name.ends_with(ending) ? std::string() : "must end with " + ending + ": " + name;
  };
}

/// Runs `body`, turning exceptions into one line on the error stream and exit code 1.
int runReporting(const char* program, const std::function<int()>& body);

}  // namespace hair
