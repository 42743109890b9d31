#include <benchmarks/floor.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include <benchmarks/timing.h>
#include <libhair/core/parallel.h>

namespace hair::bench {

namespace {

struct Array {
  Stage stage;
  double Counts::* count;
  double read, written;  // bytes each
  [[maybe_unused]] const char* what;
};

constexpr double kBrick = 1024;  // 256 cells of 4 bytes
constexpr Array kArrays[] = {
    {Stage::Guides, &Counts::guidePoints, 24, 24, "position, velocity"},
    {Stage::Guides, &Counts::guidePoints, 4, 4, "tension"},
    {Stage::Guides, &Counts::guidePoints, 24, 0, "rest curvature, push"},
    {Stage::Guides, &Counts::guidePoints, 16, 0, "mass, length, stiffness, clearance"},
    {Stage::Wisps, &Counts::guidePoints, 12, 0, "guide points"},
    {Stage::Wisps, &Counts::strands, 28, 0, "first, parents, weights"},
    {Stage::Wisps, &Counts::points, 12, 12, "offsets; points"},
    {Stage::SelfCollision, &Counts::countedPoints, 12, 0, "points that are counted"},
    {Stage::SelfCollision, &Counts::countedBricks, kBrick, kBrick, "density, looked up"},
    // Half of the guides a frame.
    {Stage::SelfCollision, &Counts::guidePoints, 8, 6, "position, density allowed; push"},
    {Stage::Deposit, &Counts::points, 12, 0, "points"},
    {Stage::Deposit, &Counts::bricks, 0, kBrick, "counts"},
    {Stage::Transmittance, &Counts::bricks, kBrick, kBrick, "counts; transmittance"},
    {Stage::Filter, &Counts::points, 12, 4, "points; transmittance"},
    {Stage::Filter, &Counts::bricks, kBrick, 0, "transmittance"},
    {Stage::Shade, &Counts::points, 16, 4, "points, transmittance; colours"},
};

}  // namespace

double leastBytes(Stage stage, const Counts& counts) {
  double bytes = 0;
  for (const Array& array : kArrays)
    if (array.stage == stage) bytes += counts.*array.count * (array.read + array.written);
  return bytes;
}

double leastBytes(Stage from, Stage to, const Counts& counts) {
  double bytes = 0;
  for (int stage = static_cast<int>(from); stage <= static_cast<int>(to); ++stage)
    bytes += leastBytes(static_cast<Stage>(stage), counts);
  return bytes;
}

double copyBandwidth(double workingSet) {
  const std::size_t half =
      std::max<std::size_t>(static_cast<std::size_t>(workingSet / 2) / 64 * 64, 4096);
  const std::vector<char> source(half, 1);
  std::vector<char> copy(half, 2);
  // Small sets are copied several times over, so that starting the threads does not count.
  const std::size_t turns = std::max<std::size_t>(1, (std::size_t{8} << 20) / half);
  const auto threads = static_cast<std::size_t>(threadCount());
  const double seconds = medianSeconds(7, [&] {
    parallelFor(threads, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const std::size_t from = half * t / threads, to = half * (t + 1) / threads;
        for (std::size_t turn = 0; turn < turns; ++turn)
          std::memcpy(copy.data() + from, source.data() + from, to - from);
      }
    });
  });
  return 2 * static_cast<double>(half * turns) / seconds;
}

}  // namespace hair::bench
