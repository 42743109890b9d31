#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/files/strand_file.h>

namespace HAIR_API hair {

/// Animated strands in files, read and written frame by frame in the memory of one frame:
///   shot.usda       one file, a time sample a frame
///   shot.####.hair  a file a frame in any format of strands; #### is where its number goes, in at
///                   least as many digits

/// Whether a name is a pattern for numbered files.
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

/// Writes frames in sequence. Each numbered file appears, complete, when it is written. A single
/// file appears at `close`; until then, or without it, an existing file is kept.
class StrandSequenceWriter {
 public:
  /// Throws Error where the format is unknown, or holds one frame only and the name has no #.
  explicit StrandSequenceWriter(const std::filesystem::path& file,
                                const SequenceOptions& options = {});
  /// Discards a single file that was not closed.
  ~StrandSequenceWriter();
  StrandSequenceWriter(const StrandSequenceWriter&) = delete;
  StrandSequenceWriter& operator=(const StrandSequenceWriter&) = delete;

  /// Adds the next frame. A .usda file has strands, widths and colours of its first frame: of later
  /// frames only points are written, and their numbers must match. Throws Error.
  void add(const StrandFile& frame);
  /// The same with points alone.
  void add(StrandView frame);
  /// Adds a frame at a time code later than the previous one's; for numbered files it is the file's
  /// number, an integer. `add` continues from there. Throws Error.
  void addAt(double timeCode, const StrandFile& frame);
  /// After the last frame; none is an Error. Throws Error.
  void close();

  /// Arrays that changed between frames but are written as in the first: "thickness, colours";
  /// empty: none. Numbered files have their own.
  std::string keptAsFirst() const;
  /// Existing numbered files of this name that this writer did not write, such as of a longer
  /// earlier run: readers would take them for frames of this sequence. In the order of their
  /// numbers.
  std::vector<std::filesystem::path> otherFrames() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads any frame of a sequence; a file that does not move is a sequence of one frame.
class StrandSequenceReader {
 public:
  /// Scans a .usda file once for the offset of each frame, or lists the numbered files. Throws
  /// Error.
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
  /// Time codes a second of an animated .usda file; 0 for others, which do not state it.
  double codesPerSecond() const;
  /// Time of a frame in a .usda file, seconds; 0 for numbered files, which do not state it.
  double seconds(std::size_t frame) const;
  /// Replaces `strands`, whose memory is used again. Throws Error.
  void read(std::size_t frame, StrandFile& strands);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hair
