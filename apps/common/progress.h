#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace hair {

/// How far a long work is and how long it will still take, on a stream that people look at.
/// On a terminal one line is rewritten; elsewhere (a log) there is a line every few seconds, none
/// at all for work that is done before the first is due.
///
///   Progress progress("simulate", frameCount);
///   for (...) { ...; progress.step(); }
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// On the error stream, so that results can be piped.
  Progress(std::string what, std::int64_t total);
  /// On any stream, as if it were a terminal or not, with a clock of one's own (tests).
  Progress(std::string what, std::int64_t total, std::ostream& out, bool terminal,
           Clock::time_point (*now)());
  /// Ends the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// So many more items are done.
  void step(std::int64_t items = 1);
  /// Ends the line before its time, so that something else can be printed.
  void finish();

 private:
  void print(Clock::time_point time);

  std::string what_;
  std::int64_t total_, done_ = 0;
  std::ostream& out_;
  bool terminal_;
  Clock::time_point (*now_)();
  Clock::time_point start_, due_;
  std::size_t width_ = 0;  // characters of the line on the terminal
  bool finished_ = false;
};

}  // namespace hair
