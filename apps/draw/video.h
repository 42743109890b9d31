#pragma once

#include <filesystem>
#include <memory>

#include <apps/draw/picture.h>

namespace hair::draw {

/// Frames to an H.264 file (yuv420p, so that every player shows it) through the program ffmpeg.
/// The file gets its name only when `finish` has succeeded; an unfinished one is removed.
class VideoWriter {
 public:
  /// Sides are even numbers of pixels. Throws Error when ffmpeg is missing (and what to install),
  /// or the folder cannot be written.
  VideoWriter(const std::filesystem::path& file, int width, int height, double framesPerSecond,
              int quality = 18);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  /// Throws Error when the size differs or ffmpeg has given up (with what it said).
  void add(const Picture& frame);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state;
};

/// Whether the program ffmpeg is found.
bool videoAvailable();

}  // namespace hair::draw
