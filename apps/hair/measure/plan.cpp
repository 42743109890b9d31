#include <iomanip>
#include <iostream>

#include <apps/common/measured.h>
#include <apps/hair/commands.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>
#include <libhair/measure/motion/feature_cost.h>

namespace hair {

namespace {

// A number in so many columns, or a dash where there is none.
std::string cell(std::optional<double> value, int precision) {
  if (!value) return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(precision) << *value;
  return out.str();
}

std::optional<double> scaled(std::optional<double> value, double by) {
  return value ? std::optional(*value * by) : value;
}

void print(const FeaturePlan& plan) {
  std::cout
      << "frame: " << cell(plan.frameMs, 3) << " ms (median), " << cell(plan.bytes * 1e-6, 1)
      << " MB\n\n"
      << "left out               own ms  saves ms      +-       %      MB  moves mm  recolours\n";
  for (const FeatureCost& f : plan.features) {
    std::cout << std::left << std::setw(21) << f.name << std::right << std::setw(8)
              << cell(f.ownMs, 3) << std::setw(10) << cell(f.savedMs, 3) << std::setw(8)
              << cell(f.savedMsError, 3) << std::setw(8) << cell(100 * f.savedShare, 1)
              << std::setw(8) << cell(f.savedBytes * 1e-6, 1) << std::setw(10)
              << cell(scaled(f.movedMetres, 1e3), 2) << std::setw(11) << cell(f.recoloured, 2)
              << '\n';
    if (!f.advice.empty()) std::cout << "  " << f.advice << '\n';
  }
  const SceneWatch& watch = plan.watch;
  std::cout << "\nover " << watch.frames << " frames: self-collision pushes "
            << cell(100 * watch.pushed, 1) << " % of guide points; darkest transmittance "
            << cell(watch.darkest, 3) << "; the hair spans " << watch.cellsUsed.x << " x "
            << watch.cellsUsed.y << " x " << watch.cellsUsed.z << " of " << watch.cells
            << "³ cells\n";
}

void writeCsv(const std::filesystem::path& file, const FeaturePlan& plan) {
  writeAtomically(file, [&](std::ostream& out) {
    const auto optional = [&](std::optional<double> v) {
      if (v) out << *v;
      out << ',';
    };
    out << "feature,own_ms,saved_ms,saved_ms_error,saved_percent,saved_mb,moved_mm,recoloured,"
           "relit,advice\n";
    out << "everything,," << plan.frameMs << ",,100," << plan.bytes * 1e-6 << ",,,,\n";
    for (const FeatureCost& f : plan.features) {
      out << f.name << ',';
      optional(f.ownMs);
      out << f.savedMs << ',' << f.savedMsError << ',' << 100 * f.savedShare << ','
          << f.savedBytes * 1e-6 << ',';
      optional(scaled(f.movedMetres, 1e3));
      optional(f.recoloured);
      optional(f.relit);
      out << '"' << f.advice << "\"\n";
    }
  });
}

}  // namespace

void runPlan(const PlanOptions& options) {
  const ThreadLimit limit(options.threads);
  const Character character(options.character);
  for (const std::string& note : character.notes) std::cerr << note << '\n';
  FeatureCostSettings settings;
  settings.blocks = std::max(2, options.frames / settings.framesPerBlock);
  const MeasuredScene scene =
      measuredScene(character, options.player, settings.blocks * settings.framesPerBlock);
  const FeaturePlan plan = measureFeatures(scene, featuresOf(scene), settings);
  print(plan);
  if (!options.csv.empty()) writeCsv(options.csv, plan);
}

}  // namespace hair
