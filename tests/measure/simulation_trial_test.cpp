// Error and time of the motion: what must hold whatever the machine.
#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/measure/motion/simulation_trial.h>

#include "drawn_groom.h"

namespace hair {
namespace {

using test::boundSphere;
using test::shakenScene;

// Free strands hanging from a head that swings: pendulums. The motion is smooth, so that halving
// the substep must bring them closer to the limit.
MeasuredScene pendulums(glm::vec3 place = glm::vec3(0)) {
  MeasuredScene scene = shakenScene(boundSphere(24, 24), place);
  scene.settings.selfCollision = false;
  return scene;
}

SimulationTrialSettings quick() {
  SimulationTrialSettings settings;
  settings.frames = 40;
  settings.earlyFrames = 10;
  settings.substeps = {1, 2, 4, 8, 16};
  settings.iterations = {};
  settings.relaxation = {};
  return settings;
}

TEST(SubstepTrial, ErrorFallsAsSubstepsGrow) {
  const SubstepTrial trial = measureSubsteps(pendulums(), quick());
  ASSERT_EQ(trial.rows.size(), 5u);
  EXPECT_GT(trial.rows[0].tips.rms, 1e-3);  // there is something to measure
  for (std::size_t i = 1; i < trial.rows.size(); ++i) {
    EXPECT_EQ(trial.rows[i].substeps, 2 * trial.rows[i - 1].substeps);
    EXPECT_LT(trial.rows[i].tips.rms, 0.75 * trial.rows[i - 1].tips.rms)
        << trial.rows[i].substeps << " substeps";
  }
  EXPECT_LT(trial.reference.tips.rms, trial.rows.back().tips.rms);
}

TEST(SubstepTrial, ARunComparedWithItselfIsAtNoDistance) {
  SimulationTrialSettings settings = quick();
  settings.referenceSubsteps = 8;
  settings.substeps = {8, 4};
  const SubstepTrial trial = measureSubsteps(pendulums(), settings);
  EXPECT_EQ(trial.rows[0].tips.rms, 0);
  EXPECT_EQ(trial.rows[0].tips.max, 0);
  // And the reference's uncertainty is its distance from half as many.
  EXPECT_EQ(trial.rows[1].tips.rms, trial.reference.tips.rms);
  EXPECT_EQ(trial.rows[1].tips.early, trial.reference.tips.early);
  EXPECT_EQ(trial.rows[1].tips.late, trial.reference.tips.late);
}

// What it starts with is as much as rounding gives it at every substep (a position's last bit over
// h), and is damped out as fast: it has no say in errors.
TEST(SubstepTrial, TheTwinOfHairThatTouchesNothingStaysClose) {
  SimulationTrialSettings settings = quick();
  settings.substeps = {8};  // the scene's own
  const SubstepTrial trial = measureSubsteps(pendulums(), settings);
  EXPECT_EQ(trial.twin.substeps, 8);
  EXPECT_GT(trial.twin.tips.early, 0);
  EXPECT_LT(trial.twin.tips.rms, 0.01 * trial.rows[0].tips.rms);
  EXPECT_LT(trial.twin.tips.max, 0.01 * trial.rows[0].tips.max);
}

TEST(SubstepTrial, ErrorsAreTheSameWhereverTheSceneIs) {
  SimulationTrialSettings settings = quick();
  settings.substeps = {4};
  const SubstepTrial here = measureSubsteps(pendulums(), settings);
  const SubstepTrial there = measureSubsteps(pendulums({0.5f, 1.5f, -1}), settings);
  EXPECT_NEAR(there.rows[0].tips.rms / here.rows[0].tips.rms, 1, 0.02);
  EXPECT_NEAR(there.reference.tips.rms / here.reference.tips.rms, 1, 0.02);
}

// The reference is run elsewhere, but must be the run that it would have been here: also where hair
// pushes hair, by cells that stand on the world's grid.
TEST(SubstepTrial, TheReferenceIsTheSameRunElsewhere) {
  MeasuredScene scene = shakenScene(boundSphere(200, 24), {0.513f, 1.507f, -1.009f});
  scene.settings.repulsion.threshold = 0;
  scene.settings.repulsion.tolerance = 1;
  scene.settings.repulsion.strandStride = 1;
  scene.settings.repulsion.strength = 2;
  SimulationTrialSettings settings = quick();
  settings.referenceSubsteps = 8;
  settings.substeps = {8, 4};
  const SubstepTrial trial = measureSubsteps(scene, settings);
  // Rounded elsewhere, at every substep, and that is nothing beside the error of twice as long a
  // substep. (Not twice the twin, which is rounded otherwise only once: a single draw.)
  EXPECT_GT(trial.rows[0].tips.rms, 0);
  EXPECT_LT(trial.rows[0].tips.rms, 0.0144 * trial.rows[1].tips.rms);
  EXPECT_LT(trial.twin.tips.rms, 0.05 * trial.rows[1].tips.rms);
}

TEST(SubstepTrial, MeansLieBelowTheWorstAndLinksKeepTheirLengths) {
  const SubstepTrial trial = measureSubsteps(pendulums(), quick());
  for (const SimulationRow& row : trial.rows) {
    EXPECT_LE(row.tips.rms, row.tips.max);
    EXPECT_LE(row.tips.early, row.tips.max);
    EXPECT_LE(row.tips.late, row.tips.max);
    EXPECT_LT(row.stretchMax, 1e-3f);
    EXPECT_EQ(row.penetrationMax, 0);  // there is nothing to get into
    EXPECT_EQ(row.guides, 24u);
  }
}

TEST(SubstepTrial, RelaxationComesCloserAsItIterates) {
  SimulationTrialSettings settings = quick();
  settings.substeps = {8};  // the scene's own
  settings.relaxation = {1, 4, 16};
  const SubstepTrial trial = measureSubsteps(pendulums(), settings);
  ASSERT_EQ(trial.rows.size(), 4u);
  EXPECT_EQ(trial.rows[0].linkSolver, LinkSolver::Direct);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(trial.rows[i].linkSolver, LinkSolver::Relaxation);
    EXPECT_EQ(trial.rows[i].iterations, settings.relaxation[i - 1]);
    EXPECT_EQ(trial.rows[i].substeps, 8);
    EXPECT_GT(trial.rows[i].stretchMax, trial.rows[0].stretchMax);
  }
  EXPECT_LT(trial.rows[2].stretchMax, 0.5f * trial.rows[1].stretchMax);
  EXPECT_LT(trial.rows[3].stretchMax, 0.5f * trial.rows[2].stretchMax);
  EXPECT_LT(trial.rows[3].tips.rms, trial.rows[1].tips.rms);
  // What it leaves of the scene's settings is the scene's: the twin is solved directly.
  EXPECT_EQ(trial.twin.linkSolver, LinkSolver::Direct);
}

TEST(GuideCountTrial, AGroomBoundAgainToItsOwnGuidesMovesAsBefore) {
  MeasuredScene scene = shakenScene(boundSphere(200, 40));
  scene.settings.selfCollision = false;
  const std::size_t counts[] = {40, 10, 3};
  const GuideCountTrial trial = measureGuideCounts(scene, counts, quick());
  EXPECT_EQ(trial.all.tips.max, 0);
  ASSERT_EQ(trial.rows.size(), 3u);
  EXPECT_LT(trial.rows[0].tips.max, 1e-4);
  EXPECT_GT(trial.rows[1].tips.rms, 10 * trial.rows[0].tips.rms);
  EXPECT_GT(trial.rows[2].tips.rms, trial.rows[1].tips.rms);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(trial.rows[i].guides, counts[i]);
}

TEST(SimulationTrial, SettingsOutOfRangeAreErrors) {
  const MeasuredScene scene = pendulums();
  const auto with = [](auto change) {
    SimulationTrialSettings settings = quick();
    change(settings);
    return settings;
  };
  using S = SimulationTrialSettings;
  for (const S& bad :
       {with([](S& s) { s.frames = 0; }), with([](S& s) { s.earlyFrames = 41; }),
        with([](S& s) { s.earlyFrames = 0; }), with([](S& s) { s.referenceSubsteps = 7; }),
        with([](S& s) { s.referenceSubsteps = 0; }), with([](S& s) { s.substeps = {0}; }),
        with([](S& s) { s.iterations = {33}; }), with([](S& s) { s.relaxation = {0}; })})
    EXPECT_THROW(measureSubsteps(scene, bad), Error);
  const std::size_t none[] = {0};
  EXPECT_THROW(measureGuideCounts(scene, none, quick()), Error);
  EXPECT_THROW(measureSubsteps({}, quick()), Error);
}

}  // namespace
}  // namespace hair
