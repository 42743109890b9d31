// hair-bench: what the library's stages take, beside what moving their data must take, beside the
// literal transcription of the paper, and beside other people's software. One run, one machine.

#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include <apps/common/player.h>
#include <apps/common/svg.h>
#include <benchmarks/plots.h>
#include <benchmarks/suite.h>
#include <benchmarks/targets.h>
#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>

namespace hair::bench {
namespace {

constexpr std::string_view kHelp =
    R"(hair-bench [--benchmark_filter=REGEX ...]
    Benchmarks group/what/how, with options of Google Benchmark (below):
    --benchmark_format=csv or json, --benchmark_out=FILE ...
hair-bench --plots=FOLDER [--benchmark_filter=REGEX ...]
    The same, then a picture of every group, GROUP.svg.
hair-bench --targets [--only=WORD] [--quick]
    CSV of what is promised and what is measured, in a minute or two.
    --only: groups of rows with WORD in their name: memory, shadow, error, cells,
    frame, guides, floor, threads, many. --quick: hardly any work, to try the
    program and not the machine.
hair-bench --demo
    60 frames of the default demo, without drawing.
hair-bench --help
    This, and the options of Google Benchmark.

)";

struct Options {
  bool targets = false, demo = false, help = false;
  TargetOptions target;
  std::optional<std::filesystem::path> plots;
};

// Takes what is ours out of the arguments; the rest is Google Benchmark's.
Options takeOptions(std::vector<char*>& arguments) {
  Options options;
  std::erase_if(arguments, [&](const char* word) {
    const std::string_view argument(word);
    const auto value = [&](std::string_view name) -> std::optional<std::string_view> {
      if (!argument.starts_with(name)) return {};
      return argument.substr(name.size());
    };
    if (argument == "--targets") return options.targets = true;
    if (argument == "--quick") return options.target.quick = true;
    if (argument == "--demo") return options.demo = true;
    if (argument == "-h") return options.help = true;
    if (argument == "--help") options.help = true;  // Google Benchmark has its own to say
    if (const auto only = value("--only=")) return options.target.only = *only, true;
    if (const auto folder = value("--plots=")) return options.plots = *folder, true;
    return false;
  });
  return options;
}

int runBenchmarks(std::vector<char*>& arguments, const Options& options) {
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::AddCustomContext("threads", std::to_string(threadCount()));
  benchmark::AddCustomContext("instruction_set", std::string(instructionSet()));
  for (const double megabytes : {1.0, 16.0, 256.0})
    benchmark::AddCustomContext(text("copy_GBps_of_", megabytes, "_MB"),
                                brief(1e-9 * copyBandwidth(megabytes * 1e6)));
  Scenes scenes;
  registerStages(scenes);
  registerScaling(scenes);
  registerPeers(scenes);
  if (options.plots) {
    std::filesystem::create_directories(*options.plots);
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    writePlots(collector.measured, *options.plots);
  } else {
    benchmark::RunSpecifiedBenchmarks();
  }
  benchmark::Shutdown();
  return 0;
}

int program(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  const Options options = takeOptions(arguments);
  if (options.help) {
    std::cout << kHelp << std::flush;
    benchmark::PrintDefaultHelp();
    return 0;
  }
  if (options.demo) {
    const Character character{CharacterOptions{}};
    Player player(character, {});
    for (int frame = 0; frame < 60; ++frame) player.step();
    return 0;
  }
  if (options.targets) {
    require(arguments.size() == 1, "hair-bench --targets: unknown argument ", arguments.back());
    writeTargets(options.target, std::cout);
    return 0;
  }
  return runBenchmarks(arguments, options);
}

}  // namespace
}  // namespace hair::bench

int main(int argc, char** argv) {
  try {
    return hair::bench::program(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
