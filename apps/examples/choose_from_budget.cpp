// Shadow settings from what they may cost: an error, or a time. The library measures the machine
// once, looks at the hair, and says which method with which settings is enough, and why.
//
//   example_choose_from_budget
//
// Look at: a smaller error costs more time, a smaller time more error; the choice is then built and
// its time compared with the prediction.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include <libhair/measure/shadow/choose.h>
#include <libhair/model/styles.h>
#include <libhair/wisps/wisps.h>

int main() {
  const hair::MeshSdf head(hair::builtinHead().mesh);
  const hair::Groom groom = hair::makeGroom(hair::styleSettings(hair::Style::Smooth), head);
  const hair::GuideStrands guides(groom, {});
  const hair::Wisps wisps(groom, guides);
  const hair::StrandView strands = wisps.strands();
  const auto light = hair::makeLightSpace({0.3f, -1, -0.4f});
  constexpr float kFootprint = 3e-3f;  // metres over which a picture averages shadows anyway

  // Some seconds, once for a machine; costText() says it in words, to be kept in a file.
  const hair::MachineCosts machine = hair::calibrate(strands, groom.fibre, 1);

  // By errors: a strict one, and one that is easy to keep.
  std::vector<double> times;
  bool kept = true;
  hair::ShadowChoice choice;
  for (const double error : {0.012, 0.03}) {
    choice =
        hair::chooseShadow(strands, groom.fibre, light, kFootprint, {.maxError = error}, machine);
    const hair::PredictedShadow& p = choice.predicted;
    std::printf("error <= %.3f: %s; error %.3f in %.2f ms\n  %s\n", error,
                p.candidate.label.c_str(), p.error.meanAbsolute, p.time.milliseconds(),
                choice.reason.c_str());
    kept = kept && p.cautiousError() <= error;
    times.push_back(p.time.milliseconds());
  }
  // By time: between the two. (A limit that nothing keeps throws hair::Error, which says what
  // would.)
  const double budget = 0.5 * (times[0] + times[1]);
  choice = hair::chooseShadow(strands, groom.fibre, light, kFootprint, {.milliseconds = budget},
                              machine);
  const hair::PredictedShadow& p = choice.predicted;
  std::printf("time <= %.2f ms: %s; error %.3f in %.2f ms\n", budget, p.candidate.label.c_str(),
              p.error.meanAbsolute, p.time.milliseconds());
  kept = kept && p.time.milliseconds() <= budget && times[1] <= times[0];

  // What was chosen, at work.
  const auto method = hair::makeShadowMethod(p.candidate.settings);
  std::vector<float> transmittance(strands.pointCount());
  double best = 1e9;
  for (int i = 0; i < 10; ++i) {
    const auto start = std::chrono::steady_clock::now();
    method->build(strands, groom.fibre, light);
    method->sampleStrands(strands, transmittance);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count());
  }
  std::printf("predicted %.2f ms, took %.2f ms\n", p.time.milliseconds(), best);
  std::puts(kept ? "every limit was kept" : "a limit was NOT kept");
  return kept ? 0 : 1;
}
