#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/files/strand_file.h>

namespace HAIR_API hair {

/// Moving strands in files, frame after frame, in the memory of one frame:
///   shot.usda       one file, a time sample a frame
///   shot.####.hair  a file a frame in any format of strands; #### is where its number goes, in at
///                   least as many digits

/// Whether a name stands for numbered files.
bool isNumbered(const std::filesystem::path& file);
/// Whether more than one frame goes under this name: it is numbered, or of a format that moves.
bool holdsSequence(const std::filesystem::path& file);
/// shot.####.hair, 7 -> shot.0007.hair
std::filesystem::path numberedFile(const std::filesystem::path& pattern, long long number);

/// How a sequence is written.
struct SequenceOptions {
  WriteOptions write{};  ///< units and axes of the file
  double fps = 60;       ///< time codes a second: frames, unless `addAt` says otherwise; in .usda
  long long firstFrame = 0;  ///< number, or time code, of the first frame
};

/// Writes one frame after another. Numbered files appear as they are written, each whole. One file
/// appears under its name at `close`: before that, or without it, what stood there stays.
class StrandSequenceWriter {
 public:
  /// Throws Error where the format is unknown, or holds one frame only and the name has no #.
  explicit StrandSequenceWriter(const std::filesystem::path& file,
                                const SequenceOptions& options = {});
  /// Without `close` before it, one file never appears.
  ~StrandSequenceWriter();
  StrandSequenceWriter(const StrandSequenceWriter&) = delete;
  StrandSequenceWriter& operator=(const StrandSequenceWriter&) = delete;

  /// The next frame. A .usda file has the strands, widths and colours of its first one: later
  /// strands must have as many points each, and only where these are is taken. Throws Error.
  void add(const StrandFile& frame);
  /// The same with points alone.
  void add(StrandView frame);
  /// A frame at a time code of its own, later than that of the frame before it; a numbered file's
  /// is its number, and whole. `add` goes on from there. Throws Error.
  void addAt(double timeCode, const StrandFile& frame);
  /// After the last frame; none is an Error. Throws Error.
  void close();

  /// What changed from frame to frame but is kept as in the first: "thickness, colours"; empty:
  /// nothing. Numbered files hold their own.
  std::string keptAsFirst() const;
  /// Numbered files of this name that are there and not of this writer, of an earlier run that was
  /// longer: whoever reads the sequence takes them for frames of it. In the order of their numbers.
  std::vector<std::filesystem::path> otherFrames() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads any frame of a sequence; a file that does not move is a sequence of one frame.
class StrandSequenceReader {
 public:
  /// Goes through a .usda file once, to learn where each frame is, and looks which numbered files
  /// there are. Throws Error.
  explicit StrandSequenceReader(const std::filesystem::path& file, const ReadOptions& options = {});
  /// Closes the file.
  ~StrandSequenceReader();
  StrandSequenceReader(const StrandSequenceReader&) = delete;
  StrandSequenceReader& operator=(const StrandSequenceReader&) = delete;

  /// At least 1.
  std::size_t frameCount() const;
  /// Of a frame: the time code that a .usda file states, the number of a numbered file, or 0.
  /// Always rising, not always evenly.
  double timeCode(std::size_t frame) const;
  /// What a .usda file that moves says; 0 in others, which do not say.
  double codesPerSecond() const;
  /// When a frame is, seconds: what a .usda file says; 0 in numbered files, which do not say.
  double seconds(std::size_t frame) const;
  /// Replaces `strands`, whose memory is used again. Throws Error.
  void read(std::size_t frame, StrandFile& strands);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hair
