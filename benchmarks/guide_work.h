#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/transform.h>
#include <libhair/guides/settings.h>
#include <libhair/model/groom.h>

namespace hair::bench {

/// The work G(strands, links) that hair solvers are compared on. Strands rooted at Fibonacci points
/// on the upper 60 % of a sphere of 0.10 m radius, each a chain of equal links, 0.30 m long in all,
/// straight out at the start; gravity 9.81 m/s². The roots turn about Y (1 rad, 1 Hz) and move up
/// and down (0.05 m, 2 Hz), and the sphere, which is the collider, with them; 60 frames a second.
struct GuideWork {
  std::uint32_t strands = 402;
  std::uint32_t links = 16;
  int warmUp = 30;  ///< frames before the first that counts
  int frames = 120;

  std::size_t pointCount() const { return std::size_t{strands} * (links + 1); }
};

inline constexpr float kSphereRadius = 0.1f, kGuideLength = 0.3f, kFrameSeconds = 1.0f / 60;

/// Where sphere and roots are `seconds` after the start.
RigidTransform sphereAt(double seconds);
/// The strands at the start.
Groom sphereGroom(const GuideWork& work);

/// Whoever does the work.
class GuideSolver {
 public:
  virtual ~GuideSolver() = default;
  /// One frame on, at the end of which the sphere is there.
  virtual void step(const RigidTransform& sphere) = 0;
  /// [strands · (links + 1)], roots first.
  virtual void copyPoints(std::span<glm::vec3> out) const = 0;
};

/// This library, the sphere in place of head and body.
std::unique_ptr<GuideSolver> makeOwnGuides(const GuideWork& work,
                                           const GuideSettings& settings = {});

/// A solver at its work.
class GuideRun {
 public:
  /// Warmed up.
  GuideRun(std::unique_ptr<GuideSolver> solver, const GuideWork& work);
  /// Seconds that one more frame takes; the figures below take account of it.
  double step();
  std::string figures() const;  ///< of the hair, as words
  double stretchRms() const;

  float stretchMax = 0;   ///< |l - l0| / l0
  float penetration = 0;  ///< of the deepest point in the sphere, roots left out, metres
  double tipHeight = 0;   ///< of tips above the sphere's middle, mean, metres, in the last frame

 private:
  void measure();

  std::unique_ptr<GuideSolver> solver_;
  GuideWork work_;
  int frame_ = 0;
  double squares_ = 0, links_ = 0;
  std::vector<glm::vec3> points_;
};

}  // namespace hair::bench
