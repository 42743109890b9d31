// Writes a small valid file of every format for the fuzzers to start from:
//   fuzz_seeds FOLDER        makes FOLDER/hair/sample, FOLDER/tfx/sample ...
#include <filesystem>
#include <fstream>
#include <iostream>

#include <tests/files/samples.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  const std::pair<const char*, std::string> samples[] = {
      {"hair", hair::hairBytes(hair::sampleHair())},
      {"tfx", hair::sampleTfx()},
      {"data", hair::sampleData()},
      {"bvh", hair::sampleBvh()},
      {"obj", hair::sampleObj()}};
  for (const auto& [format, bytes] : samples) {
    const auto folder = std::filesystem::path(argv[1]) / format;
    std::filesystem::create_directories(folder);
    std::ofstream file(folder / "sample", std::ios::binary);
    if (!(file << bytes).flush()) {
      std::cerr << "cannot write " << folder << '\n';
      return 1;
    }
  }
}
