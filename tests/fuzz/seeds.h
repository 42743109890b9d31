#pragma once

#include <string>
#include <vector>

namespace hair {

/// Small inputs of one kind, valid all, that between them use every feature it has.
struct FuzzSeeds {
  const char* name;  ///< "hair", "tfx" ...: a folder of the corpus
  std::vector<std::string> inputs;
};

std::vector<FuzzSeeds> fuzzSeeds();

}  // namespace hair
