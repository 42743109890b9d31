// Rows about guides: the work G, ours and Bullet's.

#include <benchmarks/target_rows.h>

#include <optional>

#include <benchmarks/guide_work.h>
#include <benchmarks/peers.h>
#include <benchmarks/timing.h>
#include <libhair/core/error.h>

namespace hair::bench {

namespace {

double medianFrame(GuideRun& run, int frames) {
  std::vector<double> seconds;
  for (int f = 0; f < frames; ++f) seconds.push_back(run.step());
  return median(std::move(seconds));
}

// Seconds of a peer's frame; none where it is not built in.
std::optional<double> peerFrame(std::unique_ptr<GuideSolver> solver, const GuideWork& work) {
  if (!solver) return {};
  GuideRun run(std::move(solver), work);
  return medianFrame(run, work.frames);
}

// Seconds of a frame of ours, and what the hair looks like then.
double ownRows(TargetRun& run, const std::string& name, const GuideWork& work,
               const GuideSettings& settings) {
  GuideRun own(makeOwnGuides(work, settings), work);
  const double seconds = medianFrame(own, work.frames);
  run.table.row(name, 1e3 * seconds, kNoBound, "ms");
  run.table.row(name + "; stretch", 100 * double{own.stretchMax}, atMost(0.1), "%");
  run.table.row(name + "; stretch RMS", 100 * own.stretchRms(), kNoBound, "%");
  run.table.row(name + "; deepest point in the sphere", 1e3 * double{own.penetration}, kNoBound,
                "mm");
  run.table.row(name + "; mean height of tips above the sphere's middle", 100 * own.tipHeight,
                kNoBound, "cm");
  return seconds;
}

void addWork(TargetRun& run, GuideWork work, std::string_view peer,
             std::unique_ptr<GuideSolver> (*makePeer)(const GuideWork&), int peerFrames) {
  if (run.quick) work.strands = 20, work.warmUp = 1;
  work.frames = run.repeats(work.frames);
  const std::string name = text("G(", work.strands, " strands; ", work.links, " links)");
  // Half as many substeps are as stiff, and nearer to what the peers do in a frame.
  GuideSettings coarse;
  coarse.substep *= 2;
  const std::string coarseName = name + "; substeps of 1/240 s";
  const double seconds = ownRows(run, name, work, {});
  const double coarseSeconds = ownRows(run, coarseName, work, coarse);
  work.frames = run.repeats(peerFrames);
  work.warmUp = run.repeats(5);
  const auto other = peerFrame(makePeer(work), work);
  const std::string against = text("; ", peer, " / ours");
  if (other) {
    run.table.row(name + against, *other / seconds, kNoBound, "x");
    run.table.row(coarseName + against, *other / coarseSeconds, atLeast(40), "x");
  } else {
    run.table.missing(coarseName + against, atLeast(40), "x", "peer missing");
  }
}

}  // namespace

void addGuideRows(TargetRun& run) {
  addWork(
      run, {.strands = 402}, "Bullet btMultiBody chains; 4 substeps",
      [](const GuideWork& work) { return makeBulletChains(work, 4); }, 60);
  addWork(
      run, {.strands = 10'000}, "Bullet ropes; one body; 16 iterations",
      [](const GuideWork& work) { return makeBulletRopes(work, 16); }, 10);
}

}  // namespace hair::bench
