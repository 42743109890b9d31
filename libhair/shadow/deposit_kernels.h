#pragma once

#include <cstdint>
#include <span>

#include <libhair/core/strands.h>
#include <libhair/shadow/cell_writer.h>
#include <libhair/shadow/segment_walk.h>

namespace hair {

// Sixteen points or segments at a time, on whatever vectors the CPU has. The counts are those of
// one after the other, on every CPU.

/// Adds `count` to the cell of each point.
void writePoints(std::span<const glm::vec3> points, std::uint32_t count, CellWriter& writer);

/// Deposit::Columns of strands that follow each other: strand s is [first[s], first[s + 1]) of
/// `points`. A segment that is longer than `longest` cells stays whole in its first cell.
void writeColumns(std::span<const glm::vec3> points, std::span<const std::uint32_t> first,
                  const SegmentScale& scale, float longest, CellWriter& writer);

/// Length of every step-th strand, summed up; metres.
double sumOfLengths(StrandView strands, std::size_t step);

}  // namespace hair
