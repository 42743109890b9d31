#include <iostream>

#include <apps/hair/commands.h>
#include <libhair/core/error.h>
#include <libhair/model/resample.h>

namespace hair {

void runConvert(const ConvertOptions& options) {
  StrandFile file = readStrands(options.in, options.read);
  std::cout << options.in.string() << ": " << file.strands.strandCount() << " strands, "
            << file.strands.pointCount() << " points; " << file.scale << " m per unit, "
            << upAxisMeaning(file.up) << '\n';

  const std::size_t read = file.strands.strandCount();
  const std::size_t dropped = dropDegenerate(file, options.minLength);
  if (dropped > 0)
    std::cout << "dropped " << dropped << " strands of fewer than 2 points or shorter than "
              << options.minLength << " m\n";
  require(dropped < read, options.in.string(), ": all ", read, " strands are shorter than ",
          options.minLength, " m; check --scale, or lower --min-length");

  const std::size_t left = file.strands.strandCount();
  const auto chosen = chooseStrands(left, options.strands == 0 ? left : options.strands);
  if (options.strands > left) std::cout << "there are only " << left << " strands: all are kept\n";
  const ResamplePlan plan = planResampling(file.strands, chosen, options.points);
  file.thickness = resample(plan, file.thickness);
  file.transparency = resample(plan, file.transparency);
  file.colours = resample(plan, file.colours);
  file.strands.points = resample(plan, file.strands.points);
  file.strands.first = plan.first;

  writeStrands(options.out, file);
  std::cout << options.out.string() << ": " << file.strands.strandCount() << " strands, "
            << file.strands.pointCount() << " points; metres, +Y up, +Z face\n";
}

}  // namespace hair
