#include <iomanip>
#include <iostream>

#include <apps/common/measured.h>
#include <apps/common/svg.h>
#include <apps/hair/commands.h>
#include <apps/hair/plot/motion_plot.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>
#include <libhair/measure/motion/simulation_trial.h>

namespace hair {

namespace {

struct NamedRow {
  const char* what;
  SimulationRow row;
};

void printHead(const char* tips) {
  std::cout << std::left << std::setw(18) << tips << std::right
            << "sub-                rms of tips, mm       max   stretch  penetr.    ms a frame\n"
               "                  steps iter guides   first     all    last      mm     max %"
               "       mm   guides   wisps\n";
}

void print(const NamedRow& named) {
  const SimulationRow& r = named.row;
  std::cout << std::left << std::setw(18) << named.what << std::right << std::setw(6) << r.substeps
            << std::setw(5) << r.iterations << std::setw(7) << r.guides << std::fixed
            << std::setprecision(3) << std::setw(8) << 1e3 * r.tips.early << std::setw(8)
            << 1e3 * r.tips.rms << std::setw(8) << 1e3 * r.tips.late << std::setprecision(1)
            << std::setw(8) << 1e3 * r.tips.max << std::setprecision(5) << std::setw(10)
            << 100 * r.stretchMax << std::setprecision(3) << std::setw(9) << 1e3 * r.penetrationMax
            << std::setw(9) << r.guidesMs << std::setw(8) << r.wispsMs << '\n'
            << std::defaultfloat;
}

void writeCsv(const std::filesystem::path& file, const std::vector<NamedRow>& rows) {
  writeAtomically(file, [&](std::ostream& out) {
    out << "what,substeps,iterations,guides,tip_early_mm,tip_rms_mm,tip_late_mm,tip_max_mm,"
           "stretch_max,penetration_max_mm,guides_ms,wisps_ms\n";
    for (const auto& [what, r] : rows)
      out << what << ',' << r.substeps << ',' << r.iterations << ',' << r.guides << ','
          << 1e3 * r.tips.early << ',' << 1e3 * r.tips.rms << ',' << 1e3 * r.tips.late << ','
          << 1e3 * r.tips.max << ',' << r.stretchMax << ',' << 1e3 * r.penetrationMax << ','
          << r.guidesMs << ',' << r.wispsMs << '\n';
  });
}

}  // namespace

void runMeasureMotion(const MeasureMotionOptions& options) {
  const ThreadLimit limit(options.threads);
  const Character character(options.character);
  for (const std::string& note : character.notes) std::cerr << note << '\n';
  const MeasuredScene scene = measuredScene(character, options.player, options.trial.frames);

  std::vector<NamedRow> rows;
  const auto show = [&](const char* what, const SimulationRow& row) {
    rows.push_back({what, row});
    print(rows.back());
  };
  SimulationTrialSettings trial = options.trial;
  trial.earlyFrames = std::min(trial.earlyFrames, trial.frames);
  std::cout << trial.frames << " frames at " << options.player.fps << " a second; first, last: of "
            << trial.earlyFrames << " frames\n\n";
  {
    const SubstepTrial result = measureSubsteps(scene, trial);
    printHead("tips of guides");
    show("half of reference", result.reference);
    show("twin", result.twin);
    for (const SimulationRow& row : result.rows)
      show(row.linkSolver == LinkSolver::Direct ? "substeps" : "relaxation", row);
    if (!options.plot.empty())
      writeAtomically(options.plot, [&](std::ostream& out) { out << asFile(motionPlot(result)); });
  }
  if (!options.guideCounts.empty()) {
    const GuideCountTrial result = measureGuideCounts(scene, options.guideCounts, trial);
    std::cout << '\n';
    printHead("tips of strands");
    show("all guides", result.all);
    show("all guides twin", result.twin);
    for (const SimulationRow& row : result.rows) show("bound to", row);
  }
  if (!options.csv.empty()) writeCsv(options.csv, rows);
}

}  // namespace hair
