// The command lines of `hair` and `dance`, up to the work: the commands here look at what they were
// told to do, and do nothing.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <apps/common/command_line.h>
#include <apps/dance/options.h>
#include <apps/hair/measure/check.h>
#include <apps/hair/options.h>

#include "promise.h"
#include "targets.h"

namespace hair {

namespace {

bool finite(glm::vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class T>
void promiseWithin(T value, T lowest, T highest, const char* what) {
  promise(value >= lowest && value <= highest, what);
}

void promiseThreads(int threads) {
  promiseWithin(threads, 0, 1024, "--threads");
}

void promiseRead(const ReadOptions& read) {
  promise(read.scale == 0 || (read.scale >= 0.9e-9f && read.scale <= 1.1e9f), "--scale");
  promise(!wordOf(read.up).empty(), "--up");
}

void promiseSubject(const CharacterOptions& character) {
  promiseRead(character.read);
  promise(character.strands <= 10'000'000, "--strands");
  promise(character.points != 1 && character.points <= 4096, "--points");
  promise(character.guides >= 1 && character.guides <= 1'000'000, "--guides");
  if (character.clip.scale != 0)  // 0: recognised
    promiseWithin(character.clip.scale, 0.9e-9f, 1.1e9f, "--motion-scale");
  promiseWithin(character.style, Style::Smooth, Style::Long, "--style");
}

void promisePerformance(const PlayerOptions& player) {
  promiseWithin(player.fps, 1.0, 1000.0, "--fps");
  promiseWithin(player.cells, 2, 1024, "--cells");
  promiseWithin(player.settle, 0.0f, 60.0f, "--settle");
  promise(finite(player.wind), "--wind");
  promiseWithin(player.linkIterations, 1, 32, "--solver-iterations");
  for (const Light& light : player.lights)
    promise(finite(light.direction) && finite(light.position) && finite(light.colour) &&
                glm::all(glm::greaterThanEqual(light.colour, glm::vec3(0))),
            "--light, --point");
}

void promiseDance(const DanceOptions& dance) {
  promiseSubject(dance.character);
  promisePerformance(dance.player);
  promiseThreads(dance.threads);
  promiseWithin(dance.frames, 0, 10'000'000, "--frames");
  promiseWithin(dance.width, 16, 8192, "--width");
  promiseWithin(dance.height, 16, 8192, "--height");
  promiseWithin(dance.videoFps, 1.0, 240.0, "--video-fps");
  promiseWithin(dance.yaw, -360.0f, 360.0f, "--yaw");
  promiseWithin(dance.pitch, -89.0f, 89.0f, "--pitch");
  promiseWithin(dance.distance, 0.05f, 100.0f, "--distance");
  promise(dance.out.extension() == ".mp4" || dance.out.filename() == ".mp4", "--out");
}

// A message that helps says which option or which word is meant.
bool namesWhatIsWrong(const std::string& message, const CLI::App& app,
                      const std::vector<std::string>& words) {
  const auto said = [&](const std::string& name) {
    return !name.empty() && message.find(name) != std::string::npos;
  };
  if (said("subcommand")) return true;
  if (std::any_of(words.begin() + 1, words.end(), [&](const auto& w) { return said(oneLine(w)); }))
    return true;
  const auto saysAnOptionOf = [&](const CLI::App* command) {
    const auto options = command->get_options();
    return std::any_of(options.begin(), options.end(),
                       [&](const CLI::Option* option) { return said(option->get_name()); });
  };
  std::vector<const CLI::App*> commands{&app};  // and those below, as far as they were given
  for (std::size_t i = 0; i < commands.size(); ++i)
    for (const CLI::App* below : commands[i]->get_subcommands()) commands.push_back(below);
  return std::any_of(commands.begin(), commands.end(), saysAnOptionOf);
}

void promiseMessage(const std::string& message, const CLI::App& app,
                    const std::vector<std::string>& words) {
  promise(std::none_of(message.begin(), message.end(), [](char c) { return c >= 0 && c < 32; }),
          "a message is one line");
  promise(namesWhatIsWrong(message, app, words), "a message names what is wrong");
}

}  // namespace

#ifdef HAIR_WITH_HAIR_MESH
void runMeshApply(const MeshApplyOptions& options) {
  promise(options.out.string().ends_with(".obj"), "--out");
  promise(options.hair.empty() || options.hair.string().ends_with(".hair"), "--hair");
}

void runMeshInfo(const MeshInfoOptions&) {}
#endif

void runInfo(const InfoOptions& options) {
  promiseRead(options.read);
}

void runConvert(const ConvertOptions& options) {
  promiseRead(options.read);
  promise(options.strands <= 2'000'000'000, "--strands");
  promise(options.points != 1 && options.points <= 65536, "--points");
  promise(options.write.scale >= 0.9e-9f && options.write.scale <= 1.1e9f, "--out-scale");
  promise(!wordOf(options.write.up).empty(), "--out-up");
  promise(options.frame.value_or(0) <= 1'000'000'000, "--frame");
  promise(isStrandFile(options.out), "OUT");
  promise(options.minLength >= 0 && std::isfinite(options.minLength), "--min-length");
}

void runSimulate(const SimulateOptions& options) {
  promiseSubject(options.character);
  promisePerformance(options.player);
  promiseThreads(options.threads);
  promise(options.cache.empty() || isStrandFile(options.cache), "--cache");
  promiseWithin(options.frames, 1, 10'000'000, "--frames");
}

void runRender(const RenderOptions& options) {
  promiseSubject(options.character);
  promisePerformance(options.player);
  promiseThreads(options.threads);
  promiseWithin(options.frames, 0, 10'000'000, "--frames");
  promiseWithin(options.yaw, -360.0f, 360.0f, "--yaw");
  promiseWithin(options.pitch, -89.0f, 89.0f, "--pitch");
  promiseWithin(options.distance, 0.05f, 100.0f, "--distance");
  promiseWithin(options.width, 16, 16384, "--width");
  promiseWithin(options.height, 16, 16384, "--height");
}

void runMeasure(const MeasureOptions& options) {
  promiseSubject(options.character);
  promiseThreads(options.threads);
  promise(options.width == 0 || (options.width >= 0.9e-7f && options.width <= 0.11f), "--width");
  promise(options.alpha == 0 || (options.alpha >= 0.9e-4f && options.alpha <= 1), "--alpha");
  for (const glm::vec3 light : options.lights) promise(finite(light), "--light");
  for (const glm::vec3 lamp : options.lamps) promise(finite(lamp), "--point");
  promise(!options.footprints.empty(), "there is a footprint");
  for (const float footprint : options.footprints)
    promiseWithin(footprint, 0.9e-6f, 1.1f, "--footprint");
  promise(options.samples >= 1 && options.samples <= 10'000'000, "--samples");
  promise(options.rays >= 2 && options.rays <= 1u << 22, "--rays");
  promiseWithin(options.repeats, 1, 10'000, "--repeats");
  promiseWithin(options.flickerSteps, 0, 10'000, "--flicker-steps");
  checkOptions(options);
  methodsWanted(options.methods);
  if (const std::optional<ShadowBudget> budget = budgetOf(options))
    promise(budget->maxError > 0 && budget->milliseconds > 0, "--max-error, --budget-ms");
}

void runMeasureMotion(const MeasureMotionOptions& options) {
  promiseSubject(options.character);
  promisePerformance(options.player);
  promiseThreads(options.threads);
  const SimulationTrialSettings& trial = options.trial;
  promiseWithin(trial.frames, 1, 1'000'000, "--frames");
  promiseWithin(trial.earlyFrames, 1, 1'000'000, "--early");
  promise(trial.referenceSubsteps >= 2 && trial.referenceSubsteps <= 1024 &&
              trial.referenceSubsteps % 2 == 0,
          "--reference");
  for (const int n : trial.substeps) promiseWithin(n, 1, 1024, "--substeps");
  for (const int n : trial.iterations) promiseWithin(n, 1, 32, "--iterations");
  for (const int n : trial.relaxation) promiseWithin(n, 1, 32, "--relaxation");
  for (const std::size_t n : options.guideCounts)
    promise(n >= 1 && n <= 1'000'000, "--guide-counts");
}

void runLod(const LodOptions& options) {
  promiseSubject(options.character);
  promisePerformance(options.player);
  promiseThreads(options.threads);
  promise(!options.sizes.empty(), "--sizes");
  for (const float pixels : options.sizes) promiseWithin(pixels, 4.0f, 2000.0f, "--sizes");
  promiseWithin(options.importance, 0.9e-3f, 1.0f, "--importance");
  promiseWithin(options.detail.strandsPerPixel, 0.9e-3f, 1.1e6f, "--strands-per-pixel");
  promiseWithin(options.detail.pixelsOff, 0.9e-6f, 1.1e3f, "--pixels-off");
  promiseWithin(options.detail.pixelsPerCell, 0.0f, 1.1e3f, "--pixels-per-cell");
  promiseWithin(options.detail.fade, 0.9e-3f, 1.0f, "--fade");
  promiseWithin(options.frames, 1, 1'000'000, "--frames");
  promise(options.sheet.empty() || options.sheet.string().ends_with(".png"), "--sheet");
}

void runPlan(const PlanOptions& options) {
  promiseSubject(options.character);
  promisePerformance(options.player);
  promiseThreads(options.threads);
  promiseWithin(options.frames, 10, 1'000'000, "--frames");
}

bool fuzzOptions(std::string_view lines) {
  std::vector<std::string> words;
  std::istringstream in{std::string(lines)};
  // No word of a command line holds a zero.
  for (std::string word; std::getline(in, word);) words.push_back(word.c_str());
  if (words.empty() || (words[0] != "hair" && words[0] != "dance")) return false;
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());

  CLI::App app("", words[0]);
  Run run;
  DanceOptions dance;
  if (words[0] == "dance") {
    addDanceOptions(app, dance);
    run = [&dance] { promiseDance(dance); };
  } else {
    addCommands(app, run, words[0]);
  }
  std::ostringstream out, err;
  try {
    const std::optional<int> code =
        exitCodeOfParsing(app, static_cast<int>(argv.size()), argv.data(), out, err);
    if (!code) {
      run();
    } else if (*code == 0) {
      promise(err.str().empty() && !out.str().empty(), "help is printed, and no error");
    } else {
      std::string message = err.str();
      promise(out.str().empty() && message.ends_with('\n'), "bad usage prints a line");
      message.pop_back();
      promiseMessage(message, app, words);
    }
    return !code;
  } catch (const Error& e) {
    promiseMessage(oneLine(e.what()), app, words);
    return false;
  }
}

}  // namespace hair
