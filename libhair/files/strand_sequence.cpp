#include <libhair/files/strand_sequence.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>

#include <libhair/core/error.h>
#include <libhair/files/atomic_write.h>
#include <libhair/files/byte_reader.h>
#include <libhair/files/strand_formats.h>
#include <libhair/files/usda/usda_file.h>
#include <libhair/files/usda/usda_write.h>

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
  return files;
}

// Whether a time code can be the number of a file.
bool isNumber(double timeCode) {
  return timeCode == std::floor(timeCode) && std::abs(timeCode) < 1e15;
}

// A stream that has to be opened, and has to be good in the end.
void expectGood(const std::ios& stream, const fs::path& file) {
  require(stream.good(), file.string(),
          ": cannot write: ", errno != 0 ? std::strerror(errno) : "unknown cause");
}

// A hidden file in the same folder, with a unique name.
fs::path scratchName(const fs::path& file, const PendingFile& whole) {
  return fs::path(file).replace_filename(whole.path().stem() += ".extent");
}

// One .usda file with a time sample a frame. The samples of points go straight into it, those of
// extent, which come after all of them, into a second file in the meantime.
class UsdaSequence {
 public:
  UsdaSequence(const fs::path& file, const SequenceOptions& options)
      : file_(file),
        times_{.perSecond = options.fps},
        whole_(file),
        extents_(scratchName(file, whole_)) {
    errno = 0;
    out_.open(whole_.path(), std::ios::binary);
    expectGood(out_, file_);
    extentOut_.open(extents_.path(), std::ios::binary);
    expectGood(extentOut_, file_);
  }

  void addAt(double timeCode, const StrandFile& frame) {
    times_.last = timeCode;
    if (!writer_) {
      begin(frame);
    } else {
      require(frame.strands.first == still_.strands.first, file_.string(), ": the frame at ",
              timeCodeText(timeCode),
              " has other strands than the first; write numbered files (shot.####.hair)");
      compareWithFirst(frame);
    }
    writeSample(*writer_, frame.strands.points, false);
    writeSample(*extentWriter_, frame.strands.points, true);
    expectGood(out_, file_);
    expectGood(extentOut_, file_);
  }

  std::string keptAsFirst() const {
    std::string names;
    const auto add = [&](bool moves, std::string_view name) {
      if (moves) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    add(thicknessMoves_, "thickness");
    add(transparencyMoves_, "transparency");
    add(coloursMove_, "colours");
    return names;
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
    out_ << usdaHeader(still_.scale, still_.up, times_);
    out_.close();
    expectGood(out_, file_);
    whole_.commit();
  }

 private:
  void begin(const StrandFile& frame) {
    still_ = frame;
    still_.strands.points = {};
    times_.first = times_.last;
    widest_ = widestOf(frame);
    writer_ = std::make_unique<TextWriter>(out_);
    extentWriter_ = std::make_unique<TextWriter>(extentOut_);
    *writer_ << usdaHeader(still_.scale, still_.up, times_);
    writeUsdaStill(*writer_, frame);
    *writer_ << "    point3f[] points.timeSamples = {\n";
  }

  void compareWithFirst(const StrandFile& frame) {
    const StrandFile& first = still_;
    thicknessMoves_ = thicknessMoves_ || frame.thickness != first.thickness ||
                      frame.defaultThickness != first.defaultThickness;
    transparencyMoves_ = transparencyMoves_ || frame.transparency != first.transparency ||
                         frame.defaultTransparency != first.defaultTransparency;
    coloursMove_ = coloursMove_ || frame.colours != first.colours ||
                   frame.defaultColour != first.defaultColour;
  }

  void writeSample(TextWriter& out, std::span<const glm::vec3> points, bool extent) {
    out << "        " << timeCodeText(times_.last) << ": ";
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
  std::unique_ptr<TextWriter> writer_, extentWriter_;
  StrandFile still_;  // what all frames have of the first: all but its points
  float widest_ = 0;
  bool thicknessMoves_ = false, transparencyMoves_ = false, coloursMove_ = false;
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
  std::unique_ptr<UsdaSequence> usda;
  std::optional<double> last;      // time code
  std::vector<long long> numbers;  // of files that are written
  std::string kept;                // of the .usda file that is closed
  StrandFile scratch, points;      // used again by every frame
};

StrandSequenceWriter::StrandSequenceWriter(const fs::path& file, const SequenceOptions& options)
    : state_(new State{file, options, formatOf(file), {}, {}, {}, {}, {}, {}}) {
  require(std::isfinite(options.fps) && options.fps > 0, file.string(), ": ", options.fps,
          " frames a second: must be above zero");
  require(state_->format.write != nullptr, file.string(), ": .", state_->format.name,
          " files are read, not written; write .usda, or .hair with #### in its name");
  if (isNumbered(file)) return;
  require(holdsSequence(file), file.string(), ": a .", state_->format.name,
          " file holds one frame; put #### where the number of each goes, or write .usda");
  state_->usda = std::make_unique<UsdaSequence>(file, options);
}

StrandSequenceWriter::~StrandSequenceWriter() = default;

void StrandSequenceWriter::addAt(double timeCode, const StrandFile& frame) {
  State& s = *state_;
  require(std::isfinite(timeCode) && (!s.last || timeCode > *s.last), s.file.string(),
          ": a frame at the time code ", timeCodeText(timeCode), " after one at ",
          timeCodeText(s.last.value_or(timeCode)), ": they must rise");
  if (s.usda) {
    s.usda->addAt(timeCode, prepared(s.format, s.options.write, s.file.string(), frame, s.scratch));
  } else {
    require(isNumber(timeCode), s.file.string(), ": a frame at the time code ",
            timeCodeText(timeCode), ": the number of a file is whole; write .usda");
    const auto number = static_cast<long long>(timeCode);
    writeStrands(numberedFile(s.file, number), frame, s.options.write);
    s.numbers.push_back(number);
  }
  s.last = timeCode;
}

void StrandSequenceWriter::add(const StrandFile& frame) {
  const State& s = *state_;
  addAt(s.last ? *s.last + 1 : static_cast<double>(s.options.firstFrame), frame);
}

void StrandSequenceWriter::add(StrandView frame) {
  StrandSet& strands = state_->points.strands;
  strands.points.assign(frame.points.begin(), frame.points.end());
  strands.first.assign(frame.first.begin(), frame.first.end());
  add(state_->points);
}

void StrandSequenceWriter::close() {
  State& s = *state_;
  require(s.last.has_value(), s.file.string(), ": a sequence without frames");
  if (s.usda) {
    s.kept = s.usda->keptAsFirst();
    s.usda->close();
  }
  s.usda.reset();
}

std::string StrandSequenceWriter::keptAsFirst() const {
  return state_->usda ? state_->usda->keptAsFirst() : state_->kept;
}

std::vector<fs::path> StrandSequenceWriter::otherFrames() const {
  std::vector<fs::path> others;
  if (!isNumbered(state_->file)) return others;
  for (const auto& [number, path] : numberedFiles(state_->file))
    if (!std::binary_search(state_->numbers.begin(), state_->numbers.end(), number))
      others.push_back(path);
  return others;
}

struct StrandSequenceReader::State {
  fs::path file;
  ReadOptions options;
  std::vector<fs::path> files;     // a frame each; or none
  std::vector<long long> numbers;  // theirs, or none
  std::ifstream stream;
  std::unique_ptr<UsdaReader> usda;
};

StrandSequenceReader::StrandSequenceReader(const fs::path& file, const ReadOptions& options)
    : state_(std::make_unique<State>()) {
  state_->file = file;
  state_->options = options;
  const StrandFormat& format = formatOf(file);
  if (isNumbered(file)) {
    for (const auto& [number, path] : numberedFiles(file)) {
      state_->files.push_back(path);
      state_->numbers.push_back(number);
    }
    require(!state_->files.empty(), file.string(),
            ": there are no files of that name with a number");
  } else if (format.name == "usda") {
    state_->stream = openFile(file);
    state_->usda = std::make_unique<UsdaReader>(state_->stream, file.string(), options.prim);
  } else {
    state_->files.push_back(file);
  }
}

StrandSequenceReader::~StrandSequenceReader() = default;

std::size_t StrandSequenceReader::frameCount() const {
  return state_->usda ? state_->usda->frameCount() : state_->files.size();
}

double StrandSequenceReader::timeCode(std::size_t frame) const {
  const State& s = *state_;
  if (s.usda) return s.usda->timeCode(frame);
  return s.numbers.empty() ? 0 : static_cast<double>(s.numbers[frame]);
}

double StrandSequenceReader::codesPerSecond() const {
  return state_->usda ? state_->usda->codesPerSecond() : 0;
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
