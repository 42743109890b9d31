#include <cmath>
#include <iostream>

#include <apps/hair/commands.h>
#include <libhair/core/error.h>
#include <libhair/files/strand_sequence.h>
#include <libhair/model/resample.h>

namespace hair {

namespace {

// Which strands of the first frame stay, and where their points come from in every frame.
ResamplePlan planOf(const ConvertOptions& options, const StrandFile& file) {
  const std::size_t read = file.strands.strandCount();
  auto sound = soundStrands(file.strands, options.minLength);
  if (sound.size() < read)
    std::cout << "dropped " << read - sound.size()
              << " strands of fewer than 2 points or shorter than " << options.minLength << " m\n";
  require(!sound.empty(), options.in.string(), ": all ", read, " strands are shorter than ",
          options.minLength, " m; check --scale, or lower --min-length");
  if (options.strands > sound.size())
    std::cout << "there are only " << sound.size() << " strands: all are kept\n";
  if (options.strands > 0) {
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t s : chooseStrands(sound.size(), options.strands)) chosen.push_back(sound[s]);
    sound = std::move(chosen);
  }
  return planResampling(file.strands, sound, options.points);
}

void apply(const ResamplePlan& plan, StrandFile& file) {
  file.thickness = resample(plan, file.thickness);
  file.transparency = resample(plan, file.transparency);
  file.colours = resample(plan, file.colours);
  file.strands.points = resample(plan, file.strands.points);
  file.strands.first = plan.first;
}

std::string unitsOf(const WriteOptions& write) {
  const UpAxis up = write.up == UpAxis::AsFile ? UpAxis::Y : write.up;
  return text(write.scale, " m per unit, ", upAxisMeaning(up));
}

void printLoss(const ConvertOptions& options, const StrandFile& file) {
  if (const std::string lost = lossOf(options.out, file); !lost.empty())
    std::cout << options.out.extension().string() << " has no room for: " << lost << '\n';
  if (file.format == "tfx")
    std::cout << "not carried over: strand UV, and held points other than roots\n";
}

}  // namespace

void runConvert(const ConvertOptions& options) {
  StrandSequenceReader in(options.in, options.read);
  const std::size_t frames = in.frameCount();
  const std::size_t begin = options.frame.value_or(0);
  require(begin < frames, options.in.string(), ": --frame ", begin, ": there are ", frames,
          ", from 0");
  const bool moving = holdsSequence(options.out) && (frames > 1 || isNumbered(options.out));
  const std::size_t end = moving && !options.frame ? frames : begin + 1;

  StrandFile file;
  in.read(begin, file);
  std::cout << options.in.string() << ": " << file.strands.strandCount() << " strands, "
            << file.strands.pointCount() << " points; " << file.scale << " m per unit, "
            << upAxisMeaning(file.up);
  if (frames > 1) std::cout << "; frames " << begin << " to " << end - 1 << " of " << frames;
  std::cout << '\n';
  const ResamplePlan plan = planOf(options, file);
  const std::vector<std::uint32_t> first = file.strands.first;
  apply(plan, file);
  printLoss(options, file);

  if (!moving) {
    writeStrands(options.out, file, options.write);
  } else {
    SequenceOptions sequence{.write = options.write};
    if (const double seconds = in.seconds(frames - 1) - in.seconds(0); seconds > 0)
      sequence.fps = std::round(1000 * static_cast<double>(frames - 1) / seconds) / 1000;
    StrandSequenceWriter out(options.out, sequence);
    out.add(file);
    for (std::size_t f = begin + 1; f < end; ++f) {
      in.read(f, file);
      require(file.strands.first == first, options.in.string(), ": frame ", f,
              " has other strands than frame ", begin, "; convert one at a time (--frame)");
      apply(plan, file);
      out.add(file);
    }
    out.close();
  }
  std::cout << options.out.string() << ": " << plan.first.size() - 1 << " strands, "
            << plan.samples.size() << " points; " << unitsOf(options.write);
  if (end > begin + 1) std::cout << "; " << end - begin << " frames";
  std::cout << '\n';
}

}  // namespace hair
