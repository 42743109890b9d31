// Writes the inputs that fuzzers start from:
//   fuzz_seeds FOLDER        makes FOLDER/hair/seed0, FOLDER/hair/seed1 ... FOLDER/options/seed0
//   ...
#include <filesystem>
#include <fstream>
#include <iostream>

#include "seeds.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  for (const auto& [name, inputs] : hair::fuzzSeeds()) {
    const auto folder = std::filesystem::path(argv[1]) / name;
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      std::ofstream file(folder / ("seed" + std::to_string(i)), std::ios::binary);
      if (!(file << inputs[i]).flush()) {
        std::cerr << "cannot write into " << folder << '\n';
        return 1;
      }
    }
  }
}
