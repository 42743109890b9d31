#include <libhair/measure/motion/simulation_trial.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/guides/guide_strands.h>
#include <libhair/wisps/bind.h>

namespace hair {

namespace {

constexpr float kTwinSpeed = 1e-5f;  // m/s

enum class Tips { Guides, Drawn };

void check(const SimulationTrialSettings& s) {
  require(s.frames >= 1, "simulation trial: frames = ", s.frames, "; take at least 1");
  require(s.earlyFrames >= 1 && s.earlyFrames <= s.frames,
          "simulation trial: earlyFrames = ", s.earlyFrames, " is not in 1 to frames = ", s.frames);
  require(s.referenceSubsteps >= 2 && s.referenceSubsteps % 2 == 0,
          "simulation trial: referenceSubsteps = ", s.referenceSubsteps,
          " must be even, and at least 2: the reference is compared with half as many");
  for (int n : s.substeps) require(n >= 1, "simulation trial: substeps = ", n, "; take at least 1");
  for (const auto& iterations : {s.iterations, s.relaxation})
    for (int n : iterations)
      require(n >= 1, "simulation trial: iterations = ", n, "; take at least 1");
}

// The scene without shadows and shading.
MeasuredScene motionOnly(MeasuredScene scene) {
  scene.settings.shadow = scene.settings.shade = false;
  return scene;
}

// State that a frame passes to the next, so that runs start from equal states.
struct Start {
  explicit Start(const Hair& hair)
      : guides(hair.guides),
        push(hair.repulsion.push),
        turn(hair.repulsion.turn),
        waiting(hair.repulsion.waiting),
        capsules(hair.capsules) {}
  void to(ScenePlayer& player) const {
    player.frames = 0;
    player.hair.guides = guides;
    player.hair.repulsion.push = push;
    player.hair.repulsion.turn = turn;
    player.hair.repulsion.waiting = waiting;
    player.hair.capsules = capsules;
    player.hair.time = 0;
  }
  // The same state, translated.
  Start moved(glm::vec3 by) const {
    Start there = *this;
    for (LaneVec3& p : there.guides.position) p.x = p.x + by.x, p.y = p.y + by.y, p.z = p.z + by.z;
    there.guides.worldFromHead.translation += by;
    for (Capsule& c : there.capsules) c.a += by, c.b += by;
    return there;
  }

  GuideStrands guides;
  std::vector<LaneVec3> push;
  std::size_t turn;
  float waiting;
  std::vector<Capsule> capsules;
};

MeasuredScene moved(MeasuredScene scene, glm::vec3 by) {
  scene.pose = [pose = scene.pose, by](double t, BodyPose& out) {
    pose(t, out);
    out.worldFromHead.translation += by;
    for (Capsule& c : out.capsules) c.a += by, c.b += by;
  };
  return scene;
}

// Translation that brings the head to the origin. A multiple of the cell size of self-collision,
// whose grid is fixed in the world; zero in wind, whose gusts depend on the place.
glm::vec3 wayToOrigin(const ScenePlayer& player) {
  if (!player.scene.settings.wind.still()) return glm::vec3(0);
  const float cell = player.scene.settings.repulsion.cellSize;
  return -cell * glm::round(player.hair.guides.worldFromHead.translation / cell);
}

struct Run {
  SimulationRow row;
  std::vector<glm::vec3> tips;  // [frames · tip count]
};

void recordTips(const Hair& hair, Tips which, std::vector<glm::vec3>& out) {
  if (which == Tips::Guides) {
    for (std::size_t g = 0; g < hair.guides.guideCount(); ++g)
      out.push_back(hair.guides.point(g, hair.guides.pointsPerGuide() - 1));
  } else {
    const StrandView strands = hair.strands();
    for (std::size_t s = 0; s < strands.strandCount(); ++s) out.push_back(strands.strand(s).back());
  }
}

int substepsOf(const MeasuredScene& scene) {
  return std::max(
      1, static_cast<int>(std::ceil(scene.frameSeconds / scene.settings.guides.substep - 1e-3f)));
}

// Maximum that propagates NaN.
void worse(float& worst, float value) {
  if (!(value <= worst) && !std::isnan(worst)) worst = value;
}

Run perform(ScenePlayer& player, const SimulationTrialSettings& settings, Tips which) {
  Run run;
  ProfileLog log;
  run.row.substeps = substepsOf(player.scene);
  run.row.linkSolver = player.scene.settings.guides.linkSolver;
  run.row.iterations = player.scene.settings.guides.iterations;
  run.row.guides = player.hair.guides.guideCount();
  for (int f = 0; f < settings.frames; ++f) {
    player.step();
    log.add(player.profile);
    recordTips(player.hair, which, run.tips);
    const GuideStats stats = measureGuides(player.hair.guides, player.scene.settings.guides,
                                           player.body().capsules, player.scene.head);
    worse(run.row.stretchMax, stats.stretchMax);
    worse(run.row.penetrationMax, stats.penetrationMax);
  }
  run.row.guidesMs = log.milliseconds(Stage::Guides, 0.5);
  run.row.wispsMs = log.milliseconds(Stage::Wisps, 0.5);
  return run;
}

TipDistance distance(const Run& a, const Run& b, const SimulationTrialSettings& settings) {
  const auto frames = static_cast<std::size_t>(settings.frames),
             early = static_cast<std::size_t>(settings.earlyFrames);
  const std::size_t tips = a.tips.size() / frames;
  TipDistance result;
  double first = 0, all = 0, last = 0;
  for (std::size_t f = 0; f < frames; ++f) {
    double sum = 0;
    for (std::size_t t = f * tips; t < (f + 1) * tips; ++t) {
      const glm::vec3 d = a.tips[t] - b.tips[t];
      const auto squared = static_cast<double>(glm::dot(d, d));
      sum += squared;
      result.max = std::max(result.max, squared);
    }
    all += sum;
    if (f < early) first += sum;
    if (f + early >= frames) last += sum;
  }
  const auto count = static_cast<double>(tips);
  result.early = std::sqrt(first / (count * static_cast<double>(early)));
  result.rms = std::sqrt(all / (count * static_cast<double>(frames)));
  result.late = std::sqrt(last / (count * static_cast<double>(early)));
  result.max = std::sqrt(result.max);
  return result;
}

// The run from a start with a minimal perturbation (kTwinSpeed).
Run performTwin(ScenePlayer& player, const Start& start, const SimulationTrialSettings& settings,
                Tips which) {
  start.to(player);
  for (LaneVec3& v : player.hair.guides.velocity) v.x = v.x + kTwinSpeed;
  return perform(player, settings, which);
}

}  // namespace

SubstepTrial measureSubsteps(const MeasuredScene& scene, const SimulationTrialSettings& settings) {
  check(settings);
  ScenePlayer player(motionOnly(scene));
  const Start start(player.hair);
  GuideSettings& guides = player.scene.settings.guides;
  const GuideSettings own = guides;
  const auto run = [&](int substeps, LinkSolver solver, int iterations) {
    start.to(player);
    guides.linkSolver = solver;
    guides.substep = scene.frameSeconds / static_cast<float>(substeps);
    guides.iterations = iterations;
    return perform(player, settings, Tips::Guides);
  };

  SubstepTrial trial;
  // With many substeps, motion per substep is below the rounding error a metre from the origin.
  const glm::vec3 toOrigin = wayToOrigin(player);
  const Start startThere = start.moved(toOrigin);
  ScenePlayer there(moved(player.scene, toOrigin));
  const auto converge = [&](int substeps) {
    startThere.to(there);
    there.scene.settings.guides.substep = scene.frameSeconds / static_cast<float>(substeps);
    Run result = perform(there, settings, Tips::Guides);
    for (glm::vec3& tip : result.tips) tip -= toOrigin;
    return result;
  };
  const Run reference = converge(settings.referenceSubsteps);
  trial.reference = reference.row;
  trial.reference.tips = distance(converge(settings.referenceSubsteps / 2), reference, settings);
  const auto add = [&](int substeps, LinkSolver solver, int iterations) {
    const Run row = run(substeps, solver, iterations);
    trial.rows.push_back(row.row);
    trial.rows.back().tips = distance(row, reference, settings);
  };
  const int usual = substepsOf(scene);
  for (int substeps : settings.substeps) add(substeps, own.linkSolver, own.iterations);
  for (int iterations : settings.iterations) add(usual, own.linkSolver, iterations);
  for (int iterations : settings.relaxation) add(usual, LinkSolver::Relaxation, iterations);

  const Run mine = run(usual, own.linkSolver, own.iterations);
  const Run twin = performTwin(player, start, settings, Tips::Guides);
  trial.twin = twin.row;
  trial.twin.tips = distance(twin, mine, settings);
  return trial;
}

GuideCountTrial measureGuideCounts(const MeasuredScene& scene, std::span<const std::size_t> counts,
                                   const SimulationTrialSettings& settings) {
  check(settings);
  for (std::size_t count : counts)
    require(count >= 1, "simulation trial: 0 guides; take at least 1");
  GuideCountTrial trial;
  MeasuredScene bare = motionOnly(scene);
  Run all;
  {
    ScenePlayer player(bare);
    const Start start(player.hair);
    all = perform(player, settings, Tips::Drawn);
    const Run twin = performTwin(player, start, settings, Tips::Drawn);
    trial.all = all.row;
    trial.twin = twin.row;
    trial.twin.tips = distance(twin, all, settings);
  }
  const Groom& groom = *scene.groom;
  const GuideStrands rest(groom, scene.settings.guides);
  const Wisps drawn(groom, rest);
  for (std::size_t count : counts) {
    Groom bound =
        bindGroom(drawn.strands(), {static_cast<std::uint32_t>(count), groom.pointsPerGuide, 0.5f});
    bound.fibre = groom.fibre;
    bare.groom = borrowed(bound);
    ScenePlayer player(bare);
    const Run row = perform(player, settings, Tips::Drawn);
    trial.rows.push_back(row.row);
    trial.rows.back().tips = distance(row, all, settings);
  }
  return trial;
}

}  // namespace hair
