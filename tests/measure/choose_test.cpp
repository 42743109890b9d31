#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/files/strand_file.h>
#include <libhair/measure/shadow/choose.h>
#include <libhair/measure/shadow/cost_model.h>
#include <libhair/measure/shadow/error_model.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/model/fill_wisps.h>
#include <libhair/model/head.h>
#include <libhair/model/styles.h>
#include <tests/measure/scene.h>

namespace hair {
namespace {

struct Subject {
  StrandSet strands;
  Fibre fibre;
};

Subject grown(Style style) {
  const Groom groom = makeGroom(styleSettings(style), MeshSdf{builtinHead().mesh, 0.004f, 0.05f});
  Subject subject{{std::vector<glm::vec3>(groom.pointCount()), groom.first}, groom.fibre};
  for (std::size_t s = 0; s < groom.strandCount(); ++s)
    drawAtRest(groom, s, subject.strands.strand(s));
  return subject;
}

const LightSpace kLight = makeLightSpace({0.45f, -0.8f, -0.4f});
constexpr float kFootprint = 3e-3f;

/// Numbers as a machine's might be; choices do not ask how fast it is.
MachineCosts someMachine() {
  MachineCosts machine;
  for (CostTerms& stage : machine.nanoseconds) stage = {10, 10, 1, 0, 1};
  machine.threads = 1;
  return machine;
}

/// Errors at other points, by other rays.
class Measured {
 public:
  Measured(const Subject& subject, std::size_t count, std::uint32_t rays)
      : subject_(subject), points_(chooseSamplePoints(subject.strands, count, 1)) {
    const auto tracer = makeGridTracer(subject.strands, subject.fibre);
    truth_ = exactTransmittance(*tracer, subject.fibre, kLight, points_, {kFootprint, rays, 1});
  }
  double meanAbsolute(const ShadowSettings& settings) const {
    const auto method = makeShadowMethod(settings);
    method->build(subject_.strands, subject_.fibre, kLight);
    std::vector<float> all(subject_.strands.pointCount()), at;
    method->sampleStrands(subject_.strands, all);
    for (const SamplePoint& point : points_) at.push_back(all[point.point]);
    return errorFigures(at, truth_).meanAbsolute.value;
  }

 private:
  const Subject& subject_;
  std::vector<SamplePoint> points_;
  Truth truth_;
};

/// One of each kind, and density maps at the ends of their range, predicted and measured.
void expectErrorsWithin25Percent(const Subject& subject, std::uint32_t rays) {
  ErrorPilot pilot(subject.strands, subject.fibre, kLight, kFootprint);
  const Measured measuredAt(subject, 3000, rays);
  const auto all = choiceCandidates(subject.strands, kLight, kFootprint);
  // The first of every method, and both ends and the middle of the range of density maps.
  std::vector<std::size_t> tried{all.size() - 18, all.size() - 12, all.size() - 6, all.size() - 1};
  for (const std::string& method : candidateMethods()) {
    const auto c = std::find_if(all.begin(), all.end(),
                                [&](const ShadowCandidate& a) { return a.method == method; });
    if (c != all.end()) tried.push_back(static_cast<std::size_t>(c - all.begin()));
  }
  for (const std::size_t c : tried) {
    const PredictedError predicted = pilot.predict(all[c].settings);
    const double measured = measuredAt.meanAbsolute(all[c].settings);
    EXPECT_NEAR(predicted.meanAbsolute / measured, 1, 0.25)
        << all[c].label << ": predicted " << predicted.meanAbsolute << " +- "
        << predicted.standardError << ", measured " << measured;
  }
}

TEST(ErrorPilot, PredictsErrorsOnCurls) {
  expectErrorsWithin25Percent(grown(Style::Curly), 128);
}

TEST(ErrorPilot, PredictsErrorsOnStraightHair) {
  const std::filesystem::path file = std::filesystem::path(HAIR_DATA_DIR) / "hair/straight.hair";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  expectErrorsWithin25Percent(
      {readStrands(file, {.scale = 0.00465f}).strands, {0.465e-3f, 0.64f, 1}}, 1024);
}

TEST(ErrorPilot, PredictsErrorsOfThinFibres) {
  const std::filesystem::path file = std::filesystem::path(HAIR_DATA_DIR) / "hair/sintel.tfx";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "real data not found at " << file;
  // Their truth is the noisiest: without its correction errors would seem half as large again.
  expectErrorsWithin25Percent({readStrands(file).strands, {80e-6f, 0.6f, 1}}, 8192);
}

TEST(ErrorPilot, FewRaysDoNotSeemLikeErrors) {
  const Subject hair{hangingHair(2000), {.width = 0.3e-3f, .opacity = 0.6f, .hairsPerStrand = 1}};
  const DensityMapSettings settings = std::get<DensityMapSettings>(
      choiceCandidates(hair.strands, kLight, kFootprint).back().settings);
  PilotSettings few, many;
  few.noise = many.noise = 0;
  few.leastRays = few.mostRays = 64;
  many.leastRays = many.mostRays = 4096;
  const double noisy =
      ErrorPilot(hair.strands, hair.fibre, kLight, kFootprint, few).predict(settings).meanAbsolute;
  const double clean =
      ErrorPilot(hair.strands, hair.fibre, kLight, kFootprint, many).predict(settings).meanAbsolute;
  EXPECT_NEAR(noisy / clean, 1, 0.05);
}

TEST(ErrorPilot, StandardErrorsAreThoseOfOtherPoints) {
  const Subject hair{hangingHair(2000), broadFibre()};
  const ShadowSettings settings =
      choiceCandidates(hair.strands, kLight, kFootprint).back().settings;
  PilotSettings pilot;
  pilot.points = 200;
  std::vector<double> errors;
  double stated = 0, mean = 0, variance = 0;
  constexpr int kPilots = 24;
  for (int p = 0; p < kPilots; ++p) {
    pilot.seed = static_cast<std::uint32_t>(p);
    const PredictedError e =
        ErrorPilot(hair.strands, hair.fibre, kLight, kFootprint, pilot).predict(settings);
    errors.push_back(e.meanAbsolute);
    stated += e.standardError / kPilots;
    mean += e.meanAbsolute / kPilots;
  }
  for (const double e : errors) variance += (e - mean) * (e - mean) / (kPilots - 1);
  // The deviation of 24 has a standard error of 15 %.
  EXPECT_NEAR(std::sqrt(variance) / stated, 1, 0.45);
}

TEST(CostModel, CountsCellsThatSegmentsCross) {
  StrandSet one;
  const LightSpace light = makeLightSpace({1, 0, 0});
  one.append(std::vector<glm::vec3>{{0, 0, 0}, {0.1f, 0, 0}, {0.1f, 0.03f, -0.04f}});
  const HairFeatures hair = hairFeatures(one, light);
  EXPECT_EQ(hair.segments, 2);
  EXPECT_NEAR(hair.cellsCrossed(0.01), 2 + 10 + 7, 1e-4);
  EXPECT_NEAR(hair.pixelsCrossed(0.01), 2 + 7, 1e-4);
  EXPECT_NEAR(hair.longestWay, 0.14, 1e-6);
}

TEST(CostModel, OccupiedBoxesFollowTheirSize) {
  // A line through empty space fills as many boxes as it is long; and is forgotten when it is cold.
  StrandSet line;
  line.append(std::vector<glm::vec3>{{0, 0, 0}, {0.1f, 0.1f, 0.1f}});
  const HairFeatures hair = hairFeatures(line, makeLightSpace({1, 0, 0}));
  EXPECT_NEAR(hair.boxes.at(1e-3) / hair.boxes.at(2e-3), 2, 0.1);
  EXPECT_NEAR(hair.pixels.at(1e-3) / hair.pixels.at(4e-3), 4, 0.4);
  EXPECT_EQ(hair.coldShare, 1);
  for (int again = 0; again < 3; ++again)
    line.append(std::vector<glm::vec3>(line.strand(0).begin(), line.strand(0).end()));
  EXPECT_NEAR(hairFeatures(line, makeLightSpace({1, 0, 0})).coldShare, 0.25, 0.01);
}

TEST(CostModel, CalibrationFitsWhatItTimed) {
  // No assertion on times: that every stage was timed, and nothing is negative or endless.
  const MachineCosts machine = calibrate(hangingHair(400, 9), broadFibre(), 1);
  EXPECT_EQ(machine.threads, threadCount());
  for (const CostTerms& stage : machine.nanoseconds) {
    double sum = 0;
    for (const double ns : stage) {
      EXPECT_GE(ns, 0);
      EXPECT_TRUE(std::isfinite(ns));
      sum += ns;
    }
    EXPECT_GT(sum, 0);
  }
  EXPECT_FALSE(costText(machine).empty());
  EXPECT_THROW(calibrate(hangingHair(400, 9), broadFibre(), 0), Error);
  EXPECT_THROW(calibrate(hangingHair(1, 9), broadFibre(), 1), Error);
}

class Choice : public testing::Test {
 protected:
  static const std::vector<PredictedShadow>& predictions() {
    static const std::vector<PredictedShadow> all = [] {
      std::vector<PredictedShadow> list;
      const HairFeatures features = hairFeatures(hair(), kLight);
      ErrorPilot pilot(hair(), broadFibre(), kLight, kFootprint, fewPoints());
      for (const ShadowCandidate& c : choiceCandidates(hair(), kLight, kFootprint))
        list.push_back(
            {c, predictTime(someMachine(), features, c.settings), pilot.predict(c.settings)});
      return list;
    }();
    return all;
  }
  static const StrandSet& hair() {
    static const StrandSet strands = hangingHair(500);
    return strands;
  }
  static PilotSettings fewPoints() {
    PilotSettings pilot;
    pilot.points = 100;
    return pilot;
  }
  static ShadowChoice choose(const ShadowBudget& budget) {
    return chooseShadow(hair(), broadFibre(), kLight, kFootprint, budget, someMachine(),
                        fewPoints());
  }
  static std::string failure(const ShadowBudget& budget) {
    try {
      choose(budget);
    } catch (const Error& e) {
      return e.what();
    }
    return {};
  }
};

TEST_F(Choice, CandidatesHaveNamesOfTheirOwn) {
  std::set<std::string> labels;
  for (const ShadowCandidate& c : choiceCandidates(hair(), kLight, kFootprint))
    EXPECT_TRUE(labels.insert(c.label).second) << c.label;
  EXPECT_GT(labels.size(), 30u);
}

TEST_F(Choice, ALargerLimitOfErrorsNeverCostsMoreTime) {
  double before = INFINITY;
  int choices = 0;
  for (double limit = 1e-3; limit < 1; limit *= 1.1) {
    try {
      const ShadowChoice choice = chooseAmong(predictions(), {.maxError = limit});
      EXPECT_LE(choice.predicted.time.milliseconds(), before);
      EXPECT_LE(choice.predicted.cautiousError(), limit);
      choices += choice.predicted.time.milliseconds() < before ? 1 : 0;
      before = choice.predicted.time.milliseconds();
    } catch (const Error&) {
      EXPECT_EQ(before, INFINITY) << "a larger limit failed: " << limit;
    }
  }
  EXPECT_GE(choices, 3);  // else nothing was asked
}

TEST_F(Choice, ALargerLimitOfTimeNeverPredictsMoreError) {
  double before = INFINITY;
  int choices = 0;
  for (double limit = 1e-3; limit < 1e3; limit *= 1.1) {
    try {
      const ShadowChoice choice = chooseAmong(predictions(), {.milliseconds = limit});
      EXPECT_LE(choice.predicted.error.meanAbsolute, before);
      EXPECT_LE(choice.predicted.time.milliseconds(), limit);
      choices += choice.predicted.error.meanAbsolute < before ? 1 : 0;
      before = choice.predicted.error.meanAbsolute;
    } catch (const Error&) {
      EXPECT_EQ(before, INFINITY) << "a larger limit failed: " << limit;
    }
  }
  EXPECT_GE(choices, 3);
}

TEST_F(Choice, ForOneHairIsTheChoiceAmongAllPredictions) {
  // Errors that cannot matter are not predicted; the choice is as if they had been.
  for (const ShadowBudget& budget :
       {ShadowBudget{.maxError = 0.05}, ShadowBudget{.maxError = 0.02},
        ShadowBudget{.milliseconds = 1.5}, ShadowBudget{.maxError = 0.05, .milliseconds = 1.5}}) {
    const ShadowChoice choice = choose(budget), among = chooseAmong(predictions(), budget);
    EXPECT_EQ(choice.predicted.candidate.label, among.predicted.candidate.label);
    EXPECT_LE(choice.tried, among.tried);
  }
}

TEST_F(Choice, HasTheSameBitsInEveryRunAndForAnyThreads) {
  const ShadowBudget budget{.maxError = 0.03};
  const ShadowChoice once = choose(budget);
  const ThreadLimit limit(3);
  const ShadowChoice again = choose(budget);
  EXPECT_EQ(once.predicted.candidate.label, again.predicted.candidate.label);
  EXPECT_EQ(std::memcmp(&once.predicted.error, &again.predicted.error, sizeof(PredictedError)), 0);
  EXPECT_EQ(std::memcmp(&once.predicted.time, &again.predicted.time, sizeof(PredictedTime)), 0);
}

TEST_F(Choice, WhatIsImpossibleSaysWhatIsNearest) {
  const std::string error = failure({.maxError = 1e-6}), time = failure({.milliseconds = 1e-6});
  EXPECT_NE(error.find("raise the max error to "), std::string::npos) << error;
  EXPECT_NE(time.find("raise the time budget to "), std::string::npos) << time;
  // And that is possible: the limit that the message names, rounded up in its last digit.
  const auto named = [](const std::string& message, const std::string& knob) {
    return 1.00001 * std::stod(message.substr(message.find("raise " + knob) + 6 + knob.size() + 4));
  };
  EXPECT_NO_THROW(choose({.maxError = named(error, "the max error")}));
  EXPECT_NO_THROW(choose({.milliseconds = named(time, "the time budget")}));
  // Both limits, each possible alone.
  const double fastest = named(time, "the time budget"), nearest = named(error, "the max error");
  EXPECT_NE(failure({.maxError = nearest, .milliseconds = fastest}), "");
}

TEST_F(Choice, LimitsThatAreNoneAreErrors) {
  for (const double bad : {0.0, -1.0, -double{INFINITY}, double{NAN}}) {
    EXPECT_NE(failure({.maxError = bad}).find("max error"), std::string::npos) << bad;
    EXPECT_NE(failure({.milliseconds = bad}).find("time budget"), std::string::npos) << bad;
  }
  EXPECT_NE(failure({}).find("no limit"), std::string::npos);
  EXPECT_THROW(chooseAmong({}, {.maxError = 1}), Error);
}

}  // namespace
}  // namespace hair
