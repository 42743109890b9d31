#include <benchmarks/targets.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include <apps/common/svg.h>
#include <benchmarks/target_rows.h>
#include <libhair/core/error.h>
#include <libhair/core/instruction_set.h>
#include <libhair/core/parallel.h>

namespace hair::bench {

namespace {

struct Group {
  std::string_view name;
  void (*add)(TargetRun& run);
};
// Memory first: a child counts what its parent had when it was made. Then scene by scene.
constexpr Group kGroups[] = {
    {"memory", addMemoryRows}, {"shadow", addShadowRows},  {"error", addErrorRows},
    {"cells", addCellRows},    {"frame", addFrameRows},    {"guides", addGuideRows},
    {"floor", addFloorRows},   {"threads", addThreadRows}, {"many", addManyRows},
};

std::string words(Bound bound) {
  switch (bound.kind) {
    case Bound::Kind::AtLeast:
      return ">=" + brief(bound.value);
    case Bound::Kind::AtMost:
      return "<=" + brief(bound.value);
    case Bound::Kind::None:
      break;
  }
  return "";
}

// NaN keeps no promise.
std::string_view verdict(double measured, Bound bound) {
  switch (bound.kind) {
    case Bound::Kind::AtLeast:
      return measured >= bound.value ? "yes" : "no";
    case Bound::Kind::AtMost:
      return measured <= bound.value ? "yes" : "no";
    case Bound::Kind::None:
      break;
  }
  return "";
}

}  // namespace

TargetTable::TargetTable(std::ostream& out) : out_(out) {}

void TargetTable::row(std::string_view name, double measured, Bound bound, std::string_view unit) {
  out_ << name << ',' << brief(measured) << ',' << words(bound) << ',' << unit << ','
       << verdict(measured, bound) << std::endl;
}

void TargetTable::missing(std::string_view name, Bound bound, std::string_view unit,
                          std::string_view why) {
  out_ << name << ",," << words(bound) << ',' << unit << ',' << why << std::endl;
}

void TargetTable::comment(std::string_view words) {
  out_ << "# " << words << std::endl;
}

Scene& TargetRun::scene(SceneOptions options) {
  if (quick) {
    options.strands = 134, options.wisps = options.wisps > 0 ? 10 : 0;
    options.frames = 2;
  }
  Scene& scene = scenes.of(options);
  if (told != options.name)
    table.comment(text(options.name, ": ", scene.character->groom.strandCount(), " strands, ",
                       scene.segmentCount(), " segments, ", scene.character->groom.guideCount(),
                       " guides, state ", scene.hash));
  told = options.name;
  return scene;
}

void writeTargets(const TargetOptions& options, std::ostream& out) {
  const auto wanted = [&](const Group& group) {
    return group.name.find(options.only) != std::string_view::npos;
  };
  require(std::ranges::any_of(kGroups, wanted), "--only: no group of rows is named like ",
          options.only);
  TargetRun run{TargetTable(out), {}, options.quick, {}};
  // The child would have its parent's memory, so that the parent must not grow before.
  const double megabytes = options.quick ? 1 : 64;
  run.table.comment(text("copy ", brief(1e-9 * copyBandwidth(megabytes * 1e6)), " GB/s of ",
                         megabytes, " MB, ", threadCount(), " threads, ", instructionSet(),
                         options.quick ? "; quick: figures mean nothing" : ""));
  out << "row,measured,target,unit,ok" << std::endl;
  for (const Group& group : kGroups)
    if (wanted(group)) group.add(run);
}

}  // namespace hair::bench
