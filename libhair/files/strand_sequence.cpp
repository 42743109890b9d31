#include <libhair/files/strand_sequence.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>

#include <libhair/core/error.h>
#include <libhair/files/atomic_write.h>
#include <libhair/files/byte_reader.h>
#include <libhair/files/strand_formats.h>
#include <libhair/files/usda_file.h>
#include <libhair/files/usda_write.h>

namespace hair {

namespace {

namespace fs = std::filesystem;

// Where the run of # in a file's name is; the last one.
struct Digits {
  std::size_t begin = 0, count = 0;
};

Digits digitsOf(const std::string& name) {
  const std::size_t last = name.rfind('#');
  if (last == std::string::npos) return {};
  std::size_t begin = last;
  while (begin > 0 && name[begin - 1] == '#') --begin;
  return {begin, last + 1 - begin};
}

// Numbers of the files that are there, in order.
std::map<long long, fs::path> numberedFiles(const fs::path& pattern) {
  const std::string name = pattern.filename().string();
  const Digits digits = digitsOf(name);
  const std::string before = name.substr(0, digits.begin);
  const std::string after = name.substr(digits.begin + digits.count);
  const fs::path folder = pattern.parent_path();
  std::map<long long, fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string other = entry.path().filename().string();
    if (other.size() < name.size() || !other.starts_with(before) || !other.ends_with(after))
      continue;
    const char* const begin = other.data() + before.size();
    const char* const end = other.data() + other.size() - after.size();
    long long number = 0;
    const auto [stop, wrong] = std::from_chars(begin, end, number);
    if (wrong == std::errc() && stop == end && numberedFile(pattern, number).filename() == other)
      files[number] = folder / other;
  }
  require(!files.empty(), pattern.string(), ": there are no files of that name with a number");
  return files;
}

// A stream that has to be opened, and has to be good in the end.
void expectGood(const std::ios& stream, const fs::path& file) {
  require(stream.good(), file.string(),
          ": cannot write: ", errno != 0 ? std::strerror(errno) : "unknown cause");
}

// One .usda file with a time sample a frame. The samples of points go straight into it, those of
// extent, which come after all of them, into a second file in the meantime.
class UsdaSequence {
 public:
  UsdaSequence(const fs::path& file, const SequenceOptions& options)
      : file_(file),
        times_{options.firstFrame, options.firstFrame, options.fps},
        whole_(file),
        extents_(fs::path(file).replace_extension(".extent")) {
    errno = 0;
    out_.open(whole_.path(), std::ios::binary);
    expectGood(out_, file_);
    extentOut_.open(extents_.path(), std::ios::binary);
    expectGood(extentOut_, file_);
  }

  void add(const StrandFile& frame) {
    if (frames_ == 0)
      begin(frame);
    else
      require(frame.strands.first == first_, file_.string(), ": frame ", frames_,
              " has other strands than the first; write numbered files (shot.####.hair)");
    times_.last = times_.first + frames_++;
    writeSample(*writer_, frame.strands.points, false);
    writeSample(*extentWriter_, frame.strands.points, true);
    expectGood(out_, file_);
    expectGood(extentOut_, file_);
  }

  void close() {
    *writer_ << "    }\n";
    writer_.reset();
    extentWriter_.reset();
    extentOut_.close();
    expectGood(extentOut_, file_);
    out_ << "    float3[] extent.timeSamples = {\n";
    out_ << std::ifstream(extents_.path(), std::ios::binary).rdbuf();
    out_ << "    }\n" << usdaEnd();
    out_.seekp(0);
    out_ << usdaHeader(scale_, up_, times_);
    out_.close();
    expectGood(out_, file_);
    whole_.commit();
  }

 private:
  void begin(const StrandFile& frame) {
    first_ = frame.strands.first;
    scale_ = frame.scale;
    up_ = frame.up;
    widest_ = widestOf(frame);
    writer_.emplace(out_);
    extentWriter_.emplace(extentOut_);
    *writer_ << usdaHeader(scale_, up_, times_);
    writeUsdaStill(*writer_, frame);
    *writer_ << "    point3f[] points.timeSamples = {\n";
  }

  void writeSample(TextWriter& out, std::span<const glm::vec3> points, bool extent) {
    out << "        " << times_.last << ": ";
    if (extent)
      writeUsdaExtent(out, points, widest_);
    else
      writeUsdaVectors(out, points);
    out << ",\n";
  }

  fs::path file_;
  UsdaTimes times_;
  PendingFile whole_, extents_;
  std::ofstream out_, extentOut_;
  std::optional<TextWriter> writer_, extentWriter_;
  std::vector<std::uint32_t> first_;  // of all frames
  float scale_ = 1, widest_ = 0;
  UpAxis up_ = UpAxis::Y;
  long long frames_ = 0;
};

}  // namespace

bool isNumbered(const fs::path& file) {
  return digitsOf(file.filename().string()).count > 0;
}

bool holdsSequence(const fs::path& file) {
  const StrandFormat* format = findFormat(file);
  return format && (format->name == "usda" || isNumbered(file));
}

fs::path numberedFile(const fs::path& pattern, long long number) {
  std::string name = pattern.filename().string();
  const Digits digits = digitsOf(name);
  require(digits.count > 0, pattern.string(), ": there is no # where the number would go");
  std::string digitsText = std::to_string(number < 0 ? -number : number);
  if (digitsText.size() < digits.count) digitsText.insert(0, digits.count - digitsText.size(), '0');
  if (number < 0) digitsText.insert(0, 1, '-');
  name.replace(digits.begin, digits.count, digitsText);
  return pattern.parent_path() / name;
}

struct StrandSequenceWriter::State {
  fs::path file;
  SequenceOptions options;
  const StrandFormat& format;
  std::optional<UsdaSequence> usda;
  long long frames = 0;
  StrandFile scratch, points;  // used again by every frame
};

StrandSequenceWriter::StrandSequenceWriter(const fs::path& file, const SequenceOptions& options)
    : state_(new State{file, options, formatOf(file), {}, 0, {}, {}}) {
  require(std::isfinite(options.fps) && options.fps > 0, file.string(), ": ", options.fps,
          " frames a second: must be above zero");
  if (isNumbered(file)) return;
  require(holdsSequence(file), file.string(), ": a .", state_->format.name,
          " file holds one frame; put #### where the number of each goes, or write .usda");
  state_->usda.emplace(file, options);
}

StrandSequenceWriter::~StrandSequenceWriter() = default;

void StrandSequenceWriter::add(const StrandFile& frame) {
  State& s = *state_;
  if (s.usda)
    s.usda->add(prepared(s.format, s.options.write, s.file.string(), frame, s.scratch));
  else
    writeStrands(numberedFile(s.file, s.options.firstFrame + s.frames), frame, s.options.write);
  ++s.frames;
}

void StrandSequenceWriter::add(StrandView frame) {
  StrandSet& strands = state_->points.strands;
  strands.points.assign(frame.points.begin(), frame.points.end());
  strands.first.assign(frame.first.begin(), frame.first.end());
  add(state_->points);
}

void StrandSequenceWriter::close() {
  require(state_->frames > 0, state_->file.string(), ": a sequence without frames");
  if (state_->usda) state_->usda->close();
  state_->usda.reset();
}

struct StrandSequenceReader::State {
  fs::path file;
  ReadOptions options;
  std::vector<fs::path> files;  // a frame each; or none
  std::ifstream stream;
  std::optional<UsdaReader> usda;
};

StrandSequenceReader::StrandSequenceReader(const fs::path& file, const ReadOptions& options)
    : state_(std::make_unique<State>()) {
  state_->file = file;
  state_->options = options;
  const StrandFormat& format = formatOf(file);
  if (isNumbered(file)) {
    for (const auto& [number, path] : numberedFiles(file)) state_->files.push_back(path);
  } else if (format.name == "usda") {
    state_->stream = openFile(file);
    state_->usda.emplace(state_->stream, file.string());
  } else {
    state_->files.push_back(file);
  }
}

StrandSequenceReader::~StrandSequenceReader() = default;

std::size_t StrandSequenceReader::frameCount() const {
  return state_->usda ? state_->usda->frameCount() : state_->files.size();
}

double StrandSequenceReader::seconds(std::size_t frame) const {
  return state_->usda ? state_->usda->seconds(frame) : 0;
}

void StrandSequenceReader::read(std::size_t frame, StrandFile& strands) {
  require(frame < frameCount(), state_->file.string(), ": frame ", frame, ": there are ",
          frameCount());
  if (!state_->usda) {
    strands = readStrands(state_->files[frame], state_->options);
    return;
  }
  state_->usda->read(frame, strands);
  finishReading(state_->options, state_->file.string(), strands);
}

}  // namespace hair
