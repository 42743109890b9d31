#include <libhair/core/profile.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace hair {

std::string_view stageName(Stage stage) {
  static constexpr std::array<std::string_view, kStageCount> names = {
      "motion", "guides", "wisps", "self-collision", "deposit", "transmittance",
      "filter", "shade",  "draw"};
  return names[static_cast<std::size_t>(stage)];
}

void ProfileLog::add(const FrameProfile& frame) {
  if (frameCount_++ % stride_ != 0) return;
  if (frames_.size() == kMostFrames) {
    for (std::size_t f = 0; f < kMostFrames / 2; ++f) frames_[f] = frames_[2 * f];
    frames_.resize(kMostFrames / 2);
    stride_ *= 2;
  }
  frames_.push_back(frame);
}

double ProfileLog::milliseconds(Stage from, Stage to, double q) const {
  if (frames_.empty()) return 0;
  std::vector<double> times;
  times.reserve(frames_.size());
  for (const FrameProfile& frame : frames_) {
    std::int64_t sum = 0;
    for (auto s = static_cast<std::size_t>(from); s <= static_cast<std::size_t>(to); ++s)
      sum += frame[s].nanoseconds;
    times.push_back(static_cast<double>(sum) * 1e-6);
  }
  const auto rank = static_cast<std::ptrdiff_t>(
      std::lround(std::clamp(q, 0.0, 1.0) * static_cast<double>(times.size() - 1)));
  std::nth_element(times.begin(), times.begin() + rank, times.end());
  return times[static_cast<std::size_t>(rank)];
}

double ProfileLog::milliseconds(Stage stage, double q) const {
  return milliseconds(stage, stage, q);
}

void ProfileLog::writeCsv(std::ostream& out) const {
  out << "stage,items,ms_median,ms_p95\n";
  std::int64_t totalItems = 0;
  for (std::size_t s = 0; s < kStageCount; ++s) {
    std::int64_t items = 0;
    for (const FrameProfile& frame : frames_) items = std::max(items, frame[s].items);
    if (items == 0) continue;
    const auto stage = static_cast<Stage>(s);
    out << stageName(stage) << ',' << items << ',' << milliseconds(stage, 0.5) << ','
        << milliseconds(stage, 0.95) << '\n';
    totalItems = std::max(totalItems, items);
  }
  out << "total," << totalItems << ',' << milliseconds(Stage::Motion, Stage::Draw, 0.5) << ','
      << milliseconds(Stage::Motion, Stage::Draw, 0.95) << '\n';
}

}  // namespace hair
