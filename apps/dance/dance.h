#pragma once

#include <filesystem>
#include <string>

#include <apps/common/player.h>
#include <apps/common/results.h>
#include <apps/common/scene_view.h>

namespace hair {

/// What the command line of `dance` says.
struct DanceOptions {
  CharacterOptions character;
  PlayerOptions player;
  int threads = 0;
  bool headless = false;           ///< --headless, or no display
  int frames = 0;                  ///< --frames; 0: the whole motion, or while the window is open
  int width = 1280, height = 720;  ///< --width, --height, pixels
  double videoFps = 30;            ///< --video-fps, pictures a second of the video
  bool sideBySide = false;         ///< --side-by-side
  float yaw = 35, pitch = 4, distance = 1.5f;  ///< --yaw, --pitch (degrees), --distance (metres)
  std::filesystem::path out = "dance.mp4";     ///< --out; the contact sheet has its name and .png
  ResultFiles results;                         ///< --profile, --stats, --hash
};

/// What draws, in words for drawingTimes: "the CPU (llvmpipe ...)", or the graphics card's name.
std::string drawnBy();

/// Simulates the motion and leaves a video and a contact sheet. Returns the exit code.
int runHeadless(const DanceOptions& options);

/// Opens the window; returns the exit code when it is closed, or `frames` are done.
int runInteractive(const DanceOptions& options);

}  // namespace hair
