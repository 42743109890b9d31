#include <libhair/shadow/deposit.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/shadow/cell_batch.h>
#include <libhair/shadow/cell_walk.h>
#include <libhair/shadow/cell_writer.h>
#include <libhair/shadow/extinction.h>

namespace hair {

namespace {

std::uint32_t toCount(float amount) {
  return amount >= 4294967040.0f ? kFull
                                 : static_cast<std::uint32_t>(static_cast<std::int64_t>(amount));
}

/// Rounds the amounts of one strand to counts, handing what rounding took or gave on to the next:
/// a strand's sum is right to half a count however many segments it has.
class Rounder {
 public:
  std::uint32_t take(float amount) {
    const float wanted = amount + rest_;
    const std::uint32_t count = toCount(std::max(wanted, 0.0f) + 0.5f);
    rest_ = count == kFull ? 0.0f : wanted - static_cast<float>(count);
    return count;
  }

 private:
  float rest_ = 0;
};

/// Walks the cells between two points, all in unwrapped cell coordinates, and leaves in each the
/// part of `count` that lies inside. Amanatides and Woo 1987. What falls into the last cell is kept
/// in `pending`, because the next segment most often goes on there.
template <class Writer>
void depositSegment(glm::vec3 a, glm::vec3 b, std::uint32_t count, glm::ivec3& cell,
                    glm::ivec3 last, std::uint32_t& pending, Writer& writer) {
  AxisWalk x(a.x, b.x, cell.x, last.x), y(a.y, b.y, cell.y, last.y), z(a.z, b.z, cell.z, last.z);
  const auto whole = static_cast<float>(count);
  std::uint32_t left = 0;  // behind us
  for (int walls = x.left + y.left + z.left; walls > 0; --walls) {
    const float wall = std::min(std::min(x.next, y.next), z.next);
    // Differences of a rounded running sum: the parts add up to the count.
    const std::uint32_t reached =
        std::min(std::max(toCount(std::max(whole * wall, 0.0f)), left), count);
    writer.add(cell, addSaturating(pending, reached - left));
    pending = 0;
    left = reached;
    const bool alongX = x.next == wall;
    const bool alongY = !alongX & (y.next == wall);
    x.cross(alongX, cell.x);
    y.cross(alongY, cell.y);
    z.cross(!(alongX | alongY), cell.z);
  }
  pending = addSaturating(pending, count - left);
}

/// Spreads a count over the eight cells whose centres surround u. Halved, halved and halved again
/// in integers: the parts always sum to the count.
template <class Writer>
void spread(glm::vec3 u, std::uint32_t count, Writer& writer) {
  const glm::vec3 v = u - 0.5f;
  const glm::ivec3 c = floorToCell(v);
  const glm::vec3 f = v - glm::vec3(c);
  const auto upperPart = [](std::uint32_t whole, float part) {
    return std::min(whole, toCount(static_cast<float>(whole) * part + 0.5f));
  };
  const std::uint32_t x1 = upperPart(count, f.x);
  for (int x = 0; x < 2; ++x) {
    const std::uint32_t nx = x ? x1 : count - x1;
    const std::uint32_t z1 = upperPart(nx, f.z);
    for (int z = 0; z < 2; ++z) {
      const std::uint32_t nz = z ? z1 : nx - z1;
      const std::uint32_t y1 = upperPart(nz, f.y);
      writer.add(c + glm::ivec3(x, 0, z), nz - y1);
      writer.add(c + glm::ivec3(x, 1, z), y1);
    }
  }
}

/// What a segment adds per cell that it advances: across the light for optical depth (length times
/// sine of the angle to the light), in all directions for length. Under a light at a point a fibre
/// looks wider by the magnification.
struct SegmentScale {
  float perCell;
  bool acrossOnly;
  const CellFrame& frame;
  float amount(glm::vec3 a, glm::vec3 b) const {
    const glm::vec3 d = b - a;
    const float across = d.y * d.y + d.z * d.z;
    const float amount = perCell * std::sqrt(acrossOnly ? across : across + d.x * d.x);
    return frame.curvature > 0 ? amount * frame.magnification(0.5f * (a + b)) : amount;
  }
};

/// Calls visit(u, cell) for the points of one strand in turn, and tells the writer their bounds,
/// widened by `margin` cells.
template <class Writer, class Visit>
void forCells(std::span<const glm::vec3> points, float margin, const CellFrame& frame,
              Writer& writer, Visit&& visit) {
  if (points.empty()) return;
  CellBatch batch;
  Bounds box;
  for (std::size_t begin = 0; begin < points.size(); begin += CellBatch::kSize) {
    const std::size_t count = std::min(points.size() - begin, CellBatch::kSize);
    batch.fill(frame, points.subspan(begin, count), glm::vec3(0));
    for (std::size_t l = 0; l < count; ++l) {
      const glm::vec3 u(batch.x[l], batch.y[l], batch.z[l]);
      box.extend(u);
      visit(u, glm::ivec3(batch.i[l], batch.j[l], batch.k[l]));
    }
  }
  writer.extend(floorToCell(box.lower - margin), floorToCell(box.upper + margin));
}

template <class Writer>
void depositPoints(std::span<const glm::vec3> points, std::uint32_t count, const CellFrame& frame,
                   Writer& writer) {
  forCells(points, 0.0f, frame, writer,
           [&](glm::vec3, glm::ivec3 cell) { writer.add(cell, count); });
}

/// As depositSegment, but cut only where the segment leaves a column of cells; a piece is left
/// whole in the cell of its middle. A piece that is long in depth covers little of its column.
template <class Writer>
void depositColumns(glm::vec3 a, glm::vec3 b, std::uint32_t count, glm::ivec3 cell, glm::ivec3 last,
                    Writer& writer) {
  AxisWalk y(a.y, b.y, cell.y, last.y), z(a.z, b.z, cell.z, last.z);
  const auto whole = static_cast<float>(count);
  const float middle = 0.5f * (b.x - a.x);
  // Between the two nearest slices, so that nothing jumps as hair or light move.
  const auto leave = [&](glm::ivec3 in, float depth, std::uint32_t amount) {
    const float x = depth - 0.5f;
    in.x = floorToInt(x);
    const std::uint32_t far =
        std::min(toCount(static_cast<float>(amount) * (x - static_cast<float>(in.x))), amount);
    writer.add(in, amount - far);
    ++in.x;
    writer.add(in, far);
  };
  float behind = 0;
  std::uint32_t left = 0;
  for (int walls = y.left + z.left; walls > 0; --walls) {
    const float wall = std::min(std::max(std::min(y.next, z.next), behind), 1.0f);
    const std::uint32_t reached = std::min(std::max(toCount(whole * wall), left), count);
    leave(cell, a.x + middle * (behind + wall), reached - left);
    left = reached;
    behind = wall;
    const bool alongY = y.next <= z.next;
    y.cross(alongY, cell.y);
    z.cross(!alongY, cell.z);
  }
  leave(cell, a.x + middle * (behind + 1), count - left);
}

template <class Writer>
void depositSegments(std::span<const glm::vec3> points, SegmentScale scale, float longest,
                     bool wholeColumns, const CellFrame& frame, Writer& writer) {
  glm::vec3 a(0);
  glm::ivec3 at(0);
  std::uint32_t pending = 0;
  Rounder rounder;
  bool first = true;
  forCells(points, wholeColumns ? 0.5f : 0.0f, frame, writer, [&](glm::vec3 b, glm::ivec3 cell) {
    const glm::vec3 d = b - a;
    if (first) {
      at = cell;
      first = false;
    } else if (std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > longest) {
      // Longer than the map: the map is aliased, and will say so; don't walk a billion cells.
      writer.add(at, addSaturating(pending, rounder.take(scale.amount(a, b))));
      pending = 0;
      at = cell;
    } else if (wholeColumns) {
      depositColumns(a, b, rounder.take(scale.amount(a, b)), at, cell, writer);
      at = cell;
    } else {
      depositSegment(a, b, rounder.take(scale.amount(a, b)), at, cell, pending, writer);
    }
    a = b;
  });
  writer.add(at, pending);
}

template <class Writer>
void depositTrilinear(std::span<const glm::vec3> points, SegmentScale scale, float longest,
                      const CellFrame& frame, Writer& writer) {
  glm::vec3 a(0);
  Rounder rounder;
  bool first = true;
  forCells(points, 0.5f, frame, writer, [&](glm::vec3 b, glm::ivec3) {
    const glm::vec3 d = b - a;
    // One sample a cell: the spread is as wide as that.
    const float way = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const int samples = first ? 0 : static_cast<int>(std::min(way, longest)) + 1;
    const float each = 1.0f / static_cast<float>(std::max(samples, 1));
    for (int s = 0; s < samples; ++s)
      spread(a + d * ((static_cast<float>(s) + 0.5f) * each),
             rounder.take(scale.amount(a, b) * each), writer);
    a = b;
    first = false;
  });
}

/// The width over which a fibre is smeared out, metres. Trilinear spreads it by another half of a
/// cell: its peaks are as low as those of fibres that fill one and a half.
float smearedOver(const DensityMapSettings& settings) {
  return settings.deposit == Deposit::Trilinear ? 1.5f * settings.cellSize : settings.cellSize;
}

/// Length of hair that a point stands for: the mean over at most 256 strands in a fixed order.
float lengthOfPoint(StrandView strands) {
  const std::size_t step = (strands.strandCount() + 255) / 256;
  double length = 0;
  std::size_t count = 0;
  for (std::size_t s = 0; s < strands.strandCount(); s += step) {
    const auto points = strands.strand(s);
    length += static_cast<double>(arcLength(points));
    count += points.size();
  }
  return count > 0 ? static_cast<float>(length / static_cast<double>(count)) : 0.0f;
}

/// What one point of Deposit::Points is worth: f · ds, or metres.
float pointQuantum(StrandView strands, const Fibre& fibre, const DensityMapSettings& settings) {
  const float ds = settings.cellSize;
  if (settings.quantity == Quantity::Length) return lengthOfPoint(strands) * fibre.hairsPerStrand;
  if (settings.pointExtinction > 0) return settings.pointExtinction * ds;
  // Over all directions the sine of the angle to the light is pi / 4 on average.
  constexpr float kMeanSine = 0.785398163f;
  return lengthOfPoint(strands) * kMeanSine * fibre.width * fibre.hairsPerStrand * fibre.opacity /
         (ds * ds);
}

void run(StrandView strands, const Fibre& fibre, DensityMap& map, std::uint32_t stride) {
  const DensityMapSettings& settings = map.settings;
  const CellFrame& frame = map.frame;
  const float ds = settings.cellSize;
  const auto longest = static_cast<float>(settings.cells);
  const bool length = settings.quantity == Quantity::Length;
  // Deviation: extinctionOf, not -ln(1 - opacity).
  const float perStrand =
      length ? fibre.hairsPerStrand * ds
             : fibre.width * fibre.hairsPerStrand * extinctionOf(fibre, smearedOver(settings)) / ds;
  const SegmentScale scale{perStrand * static_cast<float>(stride) / kQuantum, !length, frame};
  const std::size_t read = (strands.strandCount() + stride - 1) / stride;
  writeCells(read, 32, map, [&](CellWriter& writer, std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      const auto points = strands.strand(r * stride);
      switch (settings.deposit) {
        case Deposit::Points:
          depositPoints(points, stride, frame, writer);
          break;
        case Deposit::Segments:
        case Deposit::Columns:
          depositSegments(points, scale, longest, settings.deposit == Deposit::Columns, frame,
                          writer);
          break;
        case Deposit::Trilinear:
          depositTrilinear(points, scale, longest, frame, writer);
          break;
      }
    }
  });
}

}  // namespace

void deposit(StrandView strands, const Fibre& fibre, DensityMap& map, std::uint32_t strandStride) {
  require(map.bricks.valid(), "deposit: clear() the density map first");
  require(strandStride > 0, "deposit: strand stride is 0");
  require(fibre.width >= 0 && fibre.opacity >= 0 && fibre.hairsPerStrand >= 0 &&
              std::isfinite(fibre.width * fibre.opacity * fibre.hairsPerStrand),
          "deposit: fibre width ", fibre.width, " m, opacity ", fibre.opacity, " or ",
          fibre.hairsPerStrand, " hairs a strand is negative or not finite");
  const DensityMapSettings& settings = map.settings;
  require(
      settings.quantity == Quantity::OpticalDepth || !map.light.atPoint(),
      "deposit: lengths are not told apart under a light at a point, whose cells differ in size; "
      "give the density map a parallel light");
  if (strands.pointCount() == 0) return;
  if (map.empty()) {
    map.frame = makeCellFrame(map.light, strands.points.front(), settings.cellSize, settings.cells);
    map.quantum =
        settings.deposit == Deposit::Points ? pointQuantum(strands, fibre, settings) : kQuantum;
  }
  map.fibreShadow =
      std::max(map.fibreShadow, fibre.width * extinctionOf(fibre, smearedOver(settings)));
  run(strands, fibre, map, strandStride);
}

}  // namespace hair
