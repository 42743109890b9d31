#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <apps/common/player.h>
#include <apps/common/results.h>
#include <apps/common/scene_view.h>
#include <libhair/files/strand_file.h>
#include <libhair/measure/motion/simulation_trial.h>
#include <libhair/model/level_of_detail.h>

namespace hair {

/// One struct of options and one function a command of the program `hair`; each in a file of its
/// own. Functions print results on the standard output and throw Error for bad input.

/// hair info FILE
struct InfoOptions {
  std::filesystem::path file;  ///< strands of any format, a mesh (.obj) or a motion (.bvh)
  ReadOptions read;
  MotionSettings clip;   ///< of a motion
  bool verbose = false;  ///< notes of a motion in detail
};
void runInfo(const InfoOptions& options);

/// hair convert IN OUT
struct ConvertOptions {
  std::filesystem::path in;   ///< strands of any format, or a sequence of them
  std::filesystem::path out;  ///< the same
  ReadOptions read;
  WriteOptions write;
  std::optional<std::size_t> frame;  ///< of a sequence, from 0; none: all, or the first
  std::size_t strands = 0;           ///< keep so many, chosen at random but always the same; 0: all
  std::size_t points = 0;            ///< a strand, evenly along its length; 0: as they are
  float minLength = 1e-3f;           ///< shorter strands are dropped, metres
};
void runConvert(const ConvertOptions& options);

/// hair simulate
struct SimulateOptions {
  CharacterOptions character;
  PlayerOptions player;
  int frames = 120;
  int threads = 0;              ///< 0: as many as the machine has
  std::filesystem::path cache;  ///< a sequence (strand_sequence.h); numbered where it has to be
  std::filesystem::path loadState, saveState;  ///< where the run starts and ends; empty: at rest
  ResultFiles results;
};
void runSimulate(const SimulateOptions& options);

/// hair render
struct RenderOptions {
  CharacterOptions character;
  PlayerOptions player;
  int frames = 0;  ///< simulated before the picture is taken
  int threads = 0;
  float yaw = 30, pitch = 3;  ///< degrees from straight before the face
  float distance = 0.95f;     ///< metres
  int width = 960, height = 960;
  bool sideBySide = false;  ///< left half without self-shadow
  InternalsShown shown;
  std::filesystem::path out;  ///< .png (sRGB bytes) or .exr (linear floats)
};
void runRender(const RenderOptions& options);

/// hair measure
struct MeasureOptions {
  CharacterOptions character;     ///< --style, or --hair with its strands as they are in the file
  float width = 0;                ///< of a strand, metres; 0: the groom's, the file's, or 80e-6
  float alpha = 0;                ///< opacity of a fibre, (0, 1]; 0: Fibre's
  std::vector<glm::vec3> lights;  ///< the ways that lights at infinity travel
  std::vector<glm::vec3> lamps;   ///< positions of lights at points, metres
  std::vector<float> footprints = {3e-3f};  ///< metres
  std::size_t samples = 4000;
  std::uint32_t rays = 2048;  ///< a sample point
  std::uint32_t seed = 1;
  std::string methods = "all";     ///< or "quick", or names with hyphens and commas between
  std::optional<double> maxError;  ///< choose the fastest within it
  std::optional<double> budgetMs;  ///< choose the most accurate within it, milliseconds
  int repeats = 5;                 ///< timed runs of each method and setting
  int flickerSteps = 20;           ///< of 0.1 degree; 0: flicker is not measured
  int threads = 0;
  std::filesystem::path csv, dump, html;
  std::string commandLine;  ///< as typed, for who repeats it
};
void runMeasure(const MeasureOptions& options);

/// hair measure-motion
struct MeasureMotionOptions {
  CharacterOptions character;
  PlayerOptions player;
  SimulationTrialSettings trial;
  std::vector<std::size_t> guideCounts{402, 201, 100, 50, 25};  ///< empty: guides are not thinned
  int threads = 0;
  std::filesystem::path csv;   ///< one row a setting
  std::filesystem::path plot;  ///< SVG of the substeps' trial
};
void runMeasureMotion(const MeasureMotionOptions& options);

/// hair plan
struct PlanOptions {
  CharacterOptions character;
  PlayerOptions player;
  int frames = 120;  ///< of every player; cut into blocks
  int threads = 0;
  std::filesystem::path csv;  ///< one row a feature
};
void runPlan(const PlanOptions& options);

/// hair lod
struct LodOptions {
  CharacterOptions character;
  PlayerOptions player;
  std::vector<float> sizes{800, 400, 200, 100, 50};  ///< of the head, pixels
  float importance = 1;
  DetailSettings detail;
  int frames = 30;  ///< timed, of each level
  int threads = 0;
  float yaw = 30, pitch = 3;    ///< degrees from straight before the face
  float distance = 0.95f;       ///< metres
  std::filesystem::path sheet;  ///< .png
  std::filesystem::path csv;    ///< one row a size
};
void runLod(const LodOptions& options);

#ifdef HAIR_WITH_HAIR_MESH
/// hair mesh apply SCRIPT
struct MeshApplyOptions {
  std::filesystem::path script;   ///< .hairmesh
  std::filesystem::path out;      ///< .obj: the hair mesh
  std::filesystem::path hair;     ///< .hair: its strands; empty: none
  std::filesystem::path density;  ///< picture over the scalp: where hair grows; empty: everywhere
};
void runMeshApply(const MeshApplyOptions& options);

/// hair mesh info FILE
struct MeshInfoOptions {
  std::filesystem::path file;  ///< .obj, or .hairmesh: what it makes
};
void runMeshInfo(const MeshInfoOptions& options);
#endif

}  // namespace hair
