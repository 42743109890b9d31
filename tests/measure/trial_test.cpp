#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/shadow/shadow_trial.h>
#include <libhair/measure/shadow/visibility_ray.h>
#include <tests/measure/scene.h>

namespace hair {
namespace {

class Trial : public testing::Test {
 protected:
  Trial() {
    tracer = makeGridTracer(hair, broadFibre());
    points = chooseSamplePoints(hair, 200, 1);
    for (const SamplePoint& point : points) probes.push_back(point.position);
    truth = exactTransmittance(*tracer, broadFibre(), light, points, {3e-3f, 64, 1});
  }
  TrialScene scene() const { return {hair, broadFibre(), light, points, truth, probes}; }

  const StrandSet hair = hangingHair();
  const LightSpace light = makeLightSpace({0.5f, -0.3f, 0.35f});
  std::unique_ptr<FibreTracer> tracer;
  std::vector<SamplePoint> points;
  std::vector<glm::vec3> probes = {{-1, 0, 0}};
  Truth truth;
};

TEST_F(Trial, CandidatesHaveNamesOfTheirOwnWithoutCommas) {
  for (const CandidateSet set : {CandidateSet::Quick, CandidateSet::All})
    for (const float footprint : {1e-3f, 3e-3f, 1e-2f}) {
      std::set<std::string> labels, methods;
      for (const ShadowCandidate& c : shadowCandidates(hair, light, footprint, set)) {
        EXPECT_TRUE(labels.insert(c.label).second) << c.label;
        EXPECT_EQ(c.label.find_first_of(",\"\n"), std::string::npos) << c.label;
        methods.insert(c.method);
      }
      const auto known = candidateMethods();
      EXPECT_EQ(methods, std::set<std::string>(known.begin(), known.end()));
    }
}

TEST_F(Trial, TheFirstCandidateIsAutoAlone) {
  const auto all = shadowCandidates(hair, light, 3e-3f, CandidateSet::All);
  EXPECT_EQ(all.front().label, "auto");
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const ShadowCandidate& c) { return c.method == "auto"; }),
            1);
}

TEST_F(Trial, EveryCandidateCanShadowHair) {
  const auto all = shadowCandidates(hair, light, 3e-3f, CandidateSet::All);
  for (const ShadowTrial& trial : runTrials(all, scene(), 1)) {
    EXPECT_EQ(trial.failure, "") << trial.candidate.label;
    EXPECT_GT(trial.bytes, 0u) << trial.candidate.label;
    EXPECT_GT(trial.milliseconds(), 0) << trial.candidate.label;
    EXPECT_EQ(trial.probes[0], 1) << trial.candidate.label;                       // before all hair
    EXPECT_LT(*std::min_element(trial.probes.begin(), trial.probes.end()), 0.9f)  // amid it
        << trial.candidate.label;
  }
}

TEST_F(Trial, ErrorsHaveTheSameBitsInEveryRun) {
  const auto all = shadowCandidates(hair, light, 3e-3f, CandidateSet::Quick);
  const auto once = runTrials(all, scene(), 1);
  const ThreadLimit limit(1);
  const auto again = runTrials(all, scene(), 3);
  for (std::size_t t = 0; t < once.size(); ++t) {
    EXPECT_EQ(once[t].transmittance, again[t].transmittance) << all[t].label;
    EXPECT_EQ(once[t].probes, again[t].probes) << all[t].label;
    EXPECT_EQ(std::memcmp(&once[t].error, &again[t].error, sizeof(ErrorFigures)), 0)
        << all[t].label;
  }
}

TEST_F(Trial, SamplesAreThoseOfTheStrandsWithoutTheirOwnFibre) {
  DeepShadowMapSettings settings;
  const std::vector<ShadowCandidate> one = {{"deep shadow map", "d", settings}};
  const auto trials = runTrials(one, scene(), 1);
  const auto method = makeShadowMethod(settings);
  method->build(hair, broadFibre(), light);
  std::vector<float> all(hair.pointCount());
  method->sampleStrands(hair, all);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(trials[0].transmittance[i], all[points[i].point]);
}

TEST_F(Trial, OneThatCannotFailsAlone) {
  std::vector<ShadowCandidate> two = {
      {"opacity map", "no pixels", OpacityMapSettings{.pixelSize = 0}},
      {"density map", "good", DensityMapSettings{}}};
  const auto trials = runTrials(two, scene(), 2);
  EXPECT_TRUE(trials[0].failed());
  EXPECT_FALSE(trials[1].failed());
  EXPECT_EQ(bestOfEachMethod(trials), std::vector<std::size_t>{1});
  EXPECT_EQ(trialFront(trials), std::vector<std::size_t>{1});
}

TEST_F(Trial, TheBestOfAMethodHasTheLeastMeanError) {
  std::vector<ShadowTrial> trials(4);
  const char* const methods[] = {"a", "b", "a", "b"};
  const double errors[] = {0.3, 0.1, 0.2, 0.4};
  for (std::size_t t = 0; t < 4; ++t) {
    trials[t].candidate.method = methods[t];
    trials[t].error.meanAbsolute.value = errors[t];
  }
  EXPECT_EQ(bestOfEachMethod(trials), (std::vector<std::size_t>{2, 1}));
}

TEST_F(Trial, EveryStepIsReported) {
  const auto all = shadowCandidates(hair, light, 3e-3f, CandidateSet::Quick);
  std::size_t steps = 0;
  runTrials(all, scene(), 3, [&] { ++steps; });
  EXPECT_EQ(steps, 3 * all.size());
}

TEST_F(Trial, DisagreeingArgumentsAreErrors) {
  const auto all = shadowCandidates(hair, light, 3e-3f, CandidateSet::Quick);
  EXPECT_THROW(runTrials(all, scene(), 0), Error);
  points.pop_back();
  EXPECT_THROW(runTrials(all, scene(), 1), Error);
  EXPECT_THROW(shadowCandidates(hair, light, 0, CandidateSet::All), Error);
  EXPECT_THROW(shadowCandidates(hair, light, NAN, CandidateSet::All), Error);
}

TEST_F(Trial, ARayBeginsLitAndOnlyDarkens) {
  for (const LightSpace& lamp :
       {light, makePointLightSpace({0.5f, 0.4f, 0.3f}, {0.03f, -0.05f, 0.03f})}) {
    const glm::vec3 thick = thickOfHair(*tracer, hair, lamp, points, 3e-3f);
    const VisibilityRay ray =
        makeVisibilityRay(*tracer, hair, broadFibre(), lamp, thick, 100, {3e-3f, 256, 1});
    ASSERT_EQ(ray.points.size(), 100u);
    EXPECT_EQ(ray.truth.front(), 1);
    EXPECT_LT(ray.truth.back(), 0.5f);
    for (std::size_t i = 1; i < 100; ++i) EXPECT_LT(ray.truth[i], ray.truth[i - 1] + 0.02f);
    // On the light's ray through the point that was chosen.
    const glm::vec3 way = glm::normalize(ray.points.back() - ray.points.front());
    EXPECT_LT(glm::length(glm::cross(way, thick - ray.points.front())), 1e-4f);
    EXPECT_NEAR(glm::dot(way, lamp.directionAt(thick)), 1, 1e-5f);
  }
}

TEST_F(Trial, TheThickOfHairIsNotItsRim) {
  const glm::vec3 thick = thickOfHair(*tracer, hair, light, points, 3e-3f);
  std::vector<float> ends;
  const auto behind = [&](glm::vec3 p) {
    return makeVisibilityRay(*tracer, hair, broadFibre(), light, p, 2, {3e-3f, 256, 1})
        .truth.back();
  };
  for (std::size_t i = 0; i < points.size(); i += 4) ends.push_back(behind(points[i].position));
  std::sort(ends.begin(), ends.end());
  EXPECT_LE(behind(thick), ends[ends.size() / 2]);
}

}  // namespace
}  // namespace hair
