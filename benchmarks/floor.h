#pragma once

#include <cstddef>
#include <cstdint>

#include <libhair/core/profile.h>

namespace hair::bench {

/// What a stage's arrays grow with.
struct Counts {
  double strands = 0;        ///< drawn
  double points = 0;         ///< drawn
  double guidePoints = 0;    ///< simulated
  double bricks = 0;         ///< of the lights' maps that hold hair
  double countedPoints = 0;  ///< drawn, that self-collision reads
  double countedBricks = 0;  ///< of self-collision's map
};

/// Bytes that `stage` cannot do without: each input read once, each output written once, whatever
/// the layout and however clever the code. floor.cpp has the arrays in a table.
double leastBytes(Stage stage, const Counts& counts);
/// The same, summed over stages that follow each other.
double leastBytes(Stage from, Stage to, const Counts& counts);

/// Bytes a second, read and written both counted, at which the threads there are copy memory
/// between two arrays that take up `workingSet` bytes together. Measured, median. Bytes over this
/// are the floor of a stage that moves as many.
double copyBandwidth(double workingSet);

}  // namespace hair::bench
