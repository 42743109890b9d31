#pragma once

#include <iosfwd>
#include <string_view>

#include <benchmarks/scenes.h>
#include <benchmarks/targets.h>

namespace hair::bench {

/// What is promised of a figure.
struct Bound {
  enum class Kind { AtLeast, AtMost, None } kind = Kind::None;
  double value = 0;
};
constexpr Bound atLeast(double value) {
  return {Bound::Kind::AtLeast, value};
}
constexpr Bound atMost(double value) {
  return {Bound::Kind::AtMost, value};
}
/// For the reader only.
inline constexpr Bound kNoBound{};

/// The rows, written as they are measured.
class TargetTable {
 public:
  explicit TargetTable(std::ostream& out);
  void row(std::string_view name, double measured, Bound bound, std::string_view unit);
  /// There is no figure, because.
  void missing(std::string_view name, Bound bound, std::string_view unit, std::string_view why);
  void comment(std::string_view words);

 private:
  std::ostream& out_;
};

/// What the groups of rows share.
struct TargetRun {
  TargetTable table;
  Scenes scenes;
  bool quick = false;

  /// Times to do something.
  int repeats(int wanted) const { return quick ? 2 : wanted; }
  /// `options`, with hardly any hair in a quick run. Tells the state's hash when it is new.
  Scene& scene(SceneOptions options);

  std::string told;  // the last scene whose hash was told
};

// The groups. Each row has a name that needs no other to be understood.
void addMemoryRows(TargetRun& run);
void addShadowRows(TargetRun& run);
void addErrorRows(TargetRun& run);
void addCellRows(TargetRun& run);
void addFrameRows(TargetRun& run);
void addFloorRows(TargetRun& run);
void addThreadRows(TargetRun& run);
void addManyRows(TargetRun& run);
void addGuideRows(TargetRun& run);

}  // namespace hair::bench
