#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <set>

#include <apps/hair/commands.h>
#include <apps/hair/interruption.h>
#include <apps/hair/sequence_notes.h>
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

std::string unitsOf(const WriteOptions& write) {
  const UpAxis up = write.up == UpAxis::AsFile ? UpAxis::Y : write.up;
  return text(write.scale, " m per unit, ", upAxisMeaning(up));
}

// Each line once, however many frames lose the same.
class Losses {
 public:
  explicit Losses(const ConvertOptions& options) : out_(options.out) {}
  void print(const StrandFile& file) {
    if (const std::string lost = lossOf(out_, file); !lost.empty())
      print(text(out_.extension().string(), " has no room for: ", lost, '\n'));
    if (file.format == "tfx")
      print("not carried over: strand UV, and held points other than roots\n");
  }

 private:
  void print(const std::string& line) {
    if (said_.insert(line).second) std::cout << line;
  }

  const std::filesystem::path& out_;
  std::set<std::string> said_;
};

// Time codes of the frames [begin, end) as OUT can hold them, and what there is to say about them.
struct Times {
  std::vector<double> codes;
  double perSecond = SequenceOptions{}.fps;
  std::string said;
};

Times timesOf(const StrandSequenceReader& in, const ConvertOptions& options, std::size_t begin,
              std::size_t end) {
  Times times;
  bool whole = true, even = true;
  for (std::size_t f = begin; f < end; ++f) {
    const double code = in.timeCode(f);
    whole = whole && code == std::floor(code);
    times.codes.push_back(code);
    const std::size_t n = times.codes.size();
    // Within what decimal fractions lose as binary ones.
    even = even && (n < 3 || std::abs(code - times.codes[n - 2] - times.codes[1] +
                                      times.codes[0]) <= 1e-9 * std::max(1.0, std::abs(code)));
  }
  const bool numbered = isNumbered(options.out), stated = in.codesPerSecond() > 0;
  if (stated) times.perSecond = in.codesPerSecond();
  if (numbered && !whole) {
    // The number of a file is whole: only the order of frames is left of such times.
    for (std::size_t k = 0; k < times.codes.size(); ++k)
      times.codes[k] = std::floor(times.codes[0]) + static_cast<double>(k);
    times.said = "times are not whole: files are numbered one after another; ";
  } else if (!even) {
    times.said = "times are uneven, and kept; ";
  }
  if (numbered && stated)
    times.said += text("numbered files do not state the rate: ", times.perSecond, " a second");
  else if (!numbered && !stated)
    times.said += text("the rate is not stated: taken as ", times.perSecond, " a second");
  if (times.said.ends_with("; ")) times.said.resize(times.said.size() - 2);
  return times;
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
  for (const std::string& note : file.notes) std::cout << note << '\n';
  const ResamplePlan plan = planOf(options, file);
  const std::vector<std::uint32_t> first = file.strands.first;
  resample(plan, file);
  Losses losses(options);
  losses.print(file);

  if (!moving) {
    writeStrands(options.out, file, options.write);
  } else {
    const Times times = timesOf(in, options, begin, end);
    if (!times.said.empty()) std::cout << times.said << '\n';
    const Interruption interruption;
    std::optional<StrandSequenceWriter> out(
        std::in_place, options.out,
        SequenceOptions{.write = options.write, .fps = times.perSecond});
    for (std::size_t f = begin; f < end; ++f) {
      if (f > begin) {
        in.read(f, file);
        require(file.strands.first == first, options.in.string(), ": frame ", f,
                " has other strands than frame ", begin, "; convert one at a time (--frame)");
        resample(plan, file);
        losses.print(file);
      }
      out->addAt(times.codes[f - begin], file);
      if (!interruption.asked()) continue;
      out.reset();  // half of a file is not what was asked for
      interruption.end();
    }
    out->close();
    printNotes(options.out, *out);
  }
  std::cout << options.out.string() << ": " << plan.first.size() - 1 << " strands, "
            << plan.samples.size() << " points; " << unitsOf(options.write);
  if (end > begin + 1) std::cout << "; " << end - begin << " frames";
  std::cout << '\n';
}

}  // namespace hair
