#pragma once

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace hair {

/// What a script sees of a program.
struct Outcome {
  int code;
  std::string out;  // both streams
};

inline Outcome runCommand(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string out;
  std::array<char, 4096> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), pipe))
    out.append(block.data(), size);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out};
}

/// The program `hair`.
inline Outcome run(const std::string& arguments) {
  return runCommand(std::string(HAIR_PROGRAM) + ' ' + arguments);
}

}  // namespace hair
