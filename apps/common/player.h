#pragma once

#include <iosfwd>
#include <vector>

#include <apps/common/character.h>
#include <libhair/core/profile.h>
#include <libhair/simulation/simulation.h>

namespace hair {

/// The light there is where nobody says otherwise: from above, in front, and one side.
inline const Light kDefaultLight = Light::parallel({0.45f, -0.8f, -0.4f});

/// What of a player the command line sets.
struct PlayerOptions {
  double fps = 60;  ///< --fps, frames a second of the picture
  int cells = 128;  ///< --cells of each light's map along each axis
  /// --light and --point, in the order of the command line; none: kDefaultLight alone.
  std::vector<Light> lights;
  bool shadow = true;                               ///< --no-shadow
  bool selfCollision = true;                        ///< --no-self-collision
  glm::vec3 wind{0};                                ///< --wind X,Y,Z, m/s
  LinkSolver linkSolver = LinkSolver::Direct;       ///< --solver, of the guides' links
  int linkIterations = GuideSettings{}.iterations;  ///< --solver-iterations
  float settle = 1;        ///< --settle, seconds in the first pose before the first frame
  double motionSpeed = 1;  ///< --motion-speed, seconds of the motion a second of the hair
};

/// Settings of a frame for this character: the map is as large as its hair needs (mapExtentNeeded).
FrameSettings frameSettings(const Character& character, const PlayerOptions& options);

/// Plays a character: moves its body and its hair, frame after frame.
class Player {
 public:
  Player(const Character& character, const PlayerOptions& options);

  /// To the first pose, settled.
  void restart();
  /// Goes on from a saved state of this hair (restoreState), at the frame of its time; at another
  /// --fps than it was saved at, at the nearest one. Throws Error as restoreState does.
  void resume(std::istream& state);
  /// One frame on: body, hair, shadows, shading. Starts again after a motion that is no loop ends.
  void step();
  /// Shadows and shades again without moving (camera, light or settings have changed).
  void relight();
  /// Where head and body are at the end of the last frame.
  BodyState body() const { return {pose.worldFromHead, pose.capsules}; }

  const Character& character;
  FrameSettings settings;  ///< may be changed between frames
  BodyPose pose;           ///< at the end of the last frame
  Simulation simulation;   ///< takes over `settings` with every call
  Hair& hair;              ///< the simulation's
  FrameProfile profile{};  ///< of the last frame
  ProfileLog log;          ///< of all frames since the restart
  double time = 0;         ///< seconds of the motion

 private:
  void begin();

  double frame_ = 0;  // since the motion began; whole, so that time does not drift
  double fps_, settle_, motionSpeed_;
};

/// Writes per-frame figures:
/// frame,stretch_max,stretch_rms,penetration_max_m,kinetic_energy_J,speed_max
class StatsLog {
 public:
  void add(const Player& player);
  std::string csv() const;

 private:
  std::string rows_ =
      "frame,stretch_max,stretch_rms,penetration_max_m,kinetic_energy_J,speed_max\n";
  std::size_t frames_ = 0;
};

}  // namespace hair
