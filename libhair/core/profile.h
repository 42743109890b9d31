#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string_view>
#include <vector>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// The stages of a frame, in the order they run.
enum class Stage {
  Motion,         ///< posing the body: a program's own; the library leaves it zero
  Guides,         ///< simulation of the guide strands
  Wisps,          ///< drawn strands from the guides
  SelfCollision,  ///< density of the drawn hair, and its push
  Deposit,        ///< hair into the density map
  Transmittance,  ///< along the light, cell by cell
  Filter,         ///< transmittance at every point
  Shade,          ///< colours of all points
  Draw,           ///< a program's own drawing; the library leaves it zero
};
/// How many stages there are.
inline constexpr std::size_t kStageCount = 9;

/// The name a profile prints: "motion", "guides", ...
std::string_view stageName(Stage stage);

/// The cost of one stage in one frame.
struct StageTime {
  std::int64_t nanoseconds = 0;  ///< from its start to its end, however many threads it uses
  std::int64_t items = 0;        ///< points, cells, ... that the stage processes
};

/// The cost of one frame, by stage. Always filled; a stage that did not run stays zero.
using FrameProfile = std::array<StageTime, kStageCount>;

/// Scoped timer: adds its lifetime, and the items, to one stage of a profile.
class StageTimer {
 public:
  /// Starts to measure; `items` are added at once.
  StageTimer(FrameProfile& profile, Stage stage, std::int64_t items)
      : time_(profile[static_cast<std::size_t>(stage)]), start_(Clock::now()) {
    time_.items += items;
  }
  ~StageTimer() {
    time_.nanoseconds +=
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start_).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  StageTime& time_;
  Clock::time_point start_;
};

/// Profiles of many frames, and their statistics. A log of any length takes half a megabyte: of
/// more than kMostFrames it keeps every 2nd, then every 4th ..., evenly over all.
class ProfileLog {
 public:
  /// Largest number of frames that are kept.
  static constexpr std::size_t kMostFrames = 4096;

  /// Adds one frame.
  void add(const FrameProfile& frame);
  std::size_t frameCount() const { return frameCount_; }    ///< that were added
  std::size_t keptCount() const { return frames_.size(); }  ///< of these, <= kMostFrames
  /// Over the frames: quantile q in [0, 1] of a stage's time, milliseconds.
  double milliseconds(Stage stage, double q) const;
  /// The same for the sum of the stages `from` to `to` of each frame.
  double milliseconds(Stage from, Stage to, double q) const;
  /// CSV: stage,items,ms_median,ms_p95, one row a stage that ran, then `total`.
  void writeCsv(std::ostream& out) const;

 private:
  std::vector<FrameProfile> frames_;  // one of `stride_`
  std::size_t frameCount_ = 0, stride_ = 1;
};

}  // namespace hair
