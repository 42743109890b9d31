#include <libhair/shadow/methods/deep_shadow_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <libhair/core/approximate.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/methods/image_method.h>
#include <libhair/shadow/methods/read_image.h>
#include <libhair/shadow/methods/shadow_method.h>

namespace hair {

namespace {

struct Slopes {
  double steepest = -std::numeric_limits<double>::infinity();
  double flattest = 0;  // transmittance never increases

  bool none() const { return steepest > flattest; }
};

/// The current piece: from `origin`, with any of `slopes`, up to `reached`.
struct Piece {
  VisibilityVertex origin;
  float reached;
  double tolerance;
  Slopes slopes = {};

  /// The slopes of `s` that are within the tolerance of the transmittance at the depth.
  Slopes through(Slopes s, float depth, float transmittance) const {
    const double way = double{depth} - double{origin.depth};
    const double t = double{transmittance}, from = double{origin.transmittance};
    s.steepest = std::max(s.steepest, (std::max(t - tolerance, 0.0) - from) / way);
    s.flattest = std::min(s.flattest, (t + tolerance - from) / way);
    return s;
  }

  /// Ends it at a depth; the next begins there.
  void end(float depth, Slopes s, std::vector<VisibilityVertex>& vertices) {
    const double slope = 0.5 * (s.steepest + s.flattest);
    const double t = double{origin.transmittance} + slope * (double{depth} - double{origin.depth});
    begin({depth, std::clamp(static_cast<float>(t), 0.0f, origin.transmittance)}, vertices);
  }
  void begin(VisibilityVertex vertex, std::vector<VisibilityVertex>& vertices) {
    vertices.push_back(vertex);
    origin = vertex;
    reached = vertex.depth;
    slopes = {};
  }
};

}  // namespace

void compressVisibility(std::span<const PixelFragment> fragments, float tolerance,
                        std::vector<VisibilityVertex>& vertices) {
  if (fragments.empty()) return;
  Piece piece{{fragments.front().depth, 1.0f}, fragments.front().depth, double{tolerance}};
  vertices.push_back(piece.origin);

  double opticalDepth = 0;
  float after = 1.0f;
  for (std::size_t i = 0; i < fragments.size();) {
    // The step at the next depth, of all fragments there.
    const float depth = fragments[i].depth, before = after;
    for (; i < fragments.size() && fragments[i].depth == depth; ++i)
      opticalDepth += double{fragments[i].opticalDepth};
    after = std::min(before, expMinusApproximate(static_cast<float>(opticalDepth)));
    const double height = double{before} - double{after};

    // At its origin the piece has no length: its value there is fixed.
    if (depth == piece.origin.depth) {
      if (height > double{tolerance}) piece.begin({depth, after}, vertices);
      continue;
    }
    Slopes toStep = piece.through(piece.slopes, depth, before);
    Slopes pastStep = piece.through(toStep, depth, after);
    const bool bridgeable = height <= 2 * double{tolerance};
    if (pastStep.none() && (bridgeable || toStep.none()) && piece.reached > piece.origin.depth) {
      piece.end(piece.reached, piece.slopes, vertices);
      toStep = piece.through({}, depth, before);
      pastStep = piece.through(toStep, depth, after);
    }
    if (pastStep.none()) {
      piece.end(depth, toStep, vertices);
      piece.begin({depth, after}, vertices);
    } else {
      piece.slopes = pastStep;
      piece.reached = depth;
    }
  }
  if (piece.reached > piece.origin.depth) piece.end(piece.reached, piece.slopes, vertices);
}

float transmittanceAt(std::span<const VisibilityVertex> vertices, float depth) {
  const auto b =
      std::lower_bound(vertices.begin(), vertices.end(), depth,
                       [](const VisibilityVertex& vertex, float d) { return vertex.depth < d; });
  if (b == vertices.begin()) return 1.0f;
  const VisibilityVertex& a = b[-1];
  if (b == vertices.end()) return a.transmittance;
  const float part = (depth - a.depth) / (b->depth - a.depth);
  // Rounding must not take it below the start of the next piece.
  return std::max(a.transmittance + part * (b->transmittance - a.transmittance), b->transmittance);
}

namespace {

class DeepShadowMap final : public ImageMethod {
 public:
  explicit DeepShadowMap(const DeepShadowMapSettings& settings) : settings_(settings) {}

  void build(StrandView strands, const Fibre& fibre, const LightSpace& light) override {
    // Deviation: fragments have the pixel's mean optical depth. The paper traces many rays a pixel,
    // on which fibres are opaque, and averages their functions.
    const LightImage image = startBuild(strands, fibre, light, settings_, "deep shadow map");
    buildFragmentLists(strands, fibre, settings_.extinction, image, lists_);
    image_ = image;
    const std::size_t pixels = image_.pixelCount();
    blocks_.resize((pixels + kBlock - 1) / kBlock);
    parallelFor(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        Block& block = blocks_[b];
        block.vertices.clear();
        for (std::size_t p = 0; p < kBlock; ++p) {
          if (b * kBlock + p < pixels)
            compressVisibility(lists_.pixel(b * kBlock + p), settings_.tolerance, block.vertices);
          block.end[p] = static_cast<std::uint32_t>(block.vertices.size());
        }
      }
    });
  }

  void sample(std::span<const glm::vec3> points, std::span<float> out) const override {
    require(out.size() == points.size(), "deep shadow map: ", out.size(), " values for ",
            points.size(), " points");
    parallelFor(points.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        out[i] = readImage(image_, settings_.filter, image_.frame.cellCoordinates(points[i]),
                           [&](std::size_t p, float depth) {
                             return transmittanceAt(blocks_[p / kBlock].pixel(p % kBlock), depth);
                           });
    });
  }

  std::size_t bytes() const override {
    std::size_t sum = lists_.bytes() + blocks_.capacity() * sizeof(Block);
    for (const Block& block : blocks_) sum += block.vertices.capacity() * sizeof(VisibilityVertex);
    return sum;
  }

 private:
  static constexpr std::size_t kBlock = 256;

  /// The functions of a block of pixels, of a length unknown in advance.
  struct Block {
    std::vector<VisibilityVertex> vertices;
    std::array<std::uint32_t, kBlock> end;

    std::span<const VisibilityVertex> pixel(std::size_t p) const {
      const std::uint32_t first = p == 0 ? 0 : end[p - 1];
      return std::span(vertices).subspan(first, end[p] - first);
    }
  };

  DeepShadowMapSettings settings_;
  LightImage image_;
  FragmentLists lists_;
  std::vector<Block> blocks_;
};

}  // namespace

std::unique_ptr<ShadowMethod> makeDeepShadowMap(const DeepShadowMapSettings& settings) {
  validateFields(settings, "deep shadow map");
  return std::make_unique<DeepShadowMap>(settings);
}

}  // namespace hair
