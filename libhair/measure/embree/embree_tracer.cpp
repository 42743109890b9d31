#include <libhair/measure/embree/embree_tracer.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <embree3/rtcore.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/ribbon.h>

namespace hair {

namespace {

struct Deleter {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Deleter>;

class EmbreeTracer final : public FibreTracer {
 public:
  EmbreeTracer(StrandView strands, const Fibre& fibre) : ribbons_(makeRibbonPoints(strands, fibre)) {
    std::vector<std::uint8_t> flags;
    for (std::size_t i = 0; i < ribbons_.points.size(); ++i) {
      if (!ribbons_.isSegment(i)) continue;
      const bool left = i > 0 && ribbons_.isSegment(i - 1), right = ribbons_.isSegment(i + 1);
      segments_.push_back(static_cast<std::uint32_t>(i));
      flags.push_back(static_cast<std::uint8_t>((left ? RTC_CURVE_FLAG_NEIGHBOR_LEFT : 0) |
                                                (right ? RTC_CURVE_FLAG_NEIGHBOR_RIGHT : 0)));
    }
    device_.reset(rtcNewDevice(nullptr));
    require(device_ != nullptr, "Embree: no device");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                              RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    if (!segments_.empty()) {
      RTCGeometry curves = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
      auto* vertices = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
          curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4),
          ribbons_.points.size()));
      auto* indices = static_cast<std::uint32_t*>(
          rtcSetNewGeometryBuffer(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                  sizeof(std::uint32_t), segments_.size()));
      auto* neighbours = static_cast<std::uint8_t*>(rtcSetNewGeometryBuffer(
          curves, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, flags.size()));
      require(vertices && indices && neighbours, "Embree: no memory for ", segments_.size(),
              " segments");
      const float radius = static_cast<float>(ribbons_.halfWidth);
      for (std::size_t i = 0; i < ribbons_.points.size(); ++i)
        vertices[i] = glm::vec4(ribbons_.points[i], radius);
      std::copy(segments_.begin(), segments_.end(), indices);
      std::copy(flags.begin(), flags.end(), neighbours);
      rtcCommitGeometry(curves);
      rtcAttachGeometry(scene_.get(), curves);
      rtcReleaseGeometry(curves);
    }
    rtcCommitScene(scene_.get());
    const RTCError error = rtcGetDeviceError(device_.get());
    require(error == RTC_ERROR_NONE, "Embree: error ", static_cast<int>(error));
  }

  void countCrossings(std::span<const ShadowRay> rays,
                      std::span<std::uint32_t> out) const override {
    checkRays(rays, out.size());
    parallelFor(rays.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) out[r] = count(rays[r]);
    });
  }

 private:
  struct Context : RTCIntersectContext {
    const EmbreeTracer* tracer;
    const RayFrame* frame;
    std::uint32_t strand;
    std::uint32_t crossings;
  };

  /// All that lies along the ray: each entry is counted, and none is taken, so that the ray goes on.
  static void filter(const RTCFilterFunctionNArguments* arguments) {
    arguments->valid[0] = 0;
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    auto& context = *static_cast<Context*>(arguments->context);
    if (hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z >= 0) return;
    const RibbonPoints& ribbons = context.tracer->ribbons_;
    const std::size_t i = context.tracer->segments_[hit.primID];
    if (ribbons.strand[i] != context.strand && isCrossing(ribbons, i, *context.frame))
      ++context.crossings;
  }

  /// Of a ray that enters the tube of segment i: whether that is in front of the origin, before the
  /// light, and not at the round cap that the tube has at the strand's end.
  static bool isCrossing(const RibbonPoints& ribbons, std::size_t i, const RayFrame& frame) {
    const glm::dvec3 a = frame.see(ribbons.points[i]), way = frame.see(ribbons.points[i + 1]) - a;
    const double square = way.x * way.x + way.y * way.y;
    const double foot = square > 0 ? -(a.x * way.x + a.y * way.y) / square : 0.5;
    const double depth = a.z + std::clamp(foot, 0.0, 1.0) * way.z;
    return depth > 0 && depth < frame.length &&
           (foot >= 0 || (i > 0 && ribbons.isSegment(i - 1))) &&
           (foot <= 1 || ribbons.isSegment(i + 1));
  }

  std::uint32_t count(const ShadowRay& ray) const {
    const RayFrame frame(ray);
    // A ray that begins inside of a tube enters it behind its origin: it starts early enough for
    // all tubes but those that run within a degree along it.
    const double early = 64 * ribbons_.halfWidth;
    const glm::dvec3 origin = frame.origin - early * frame.along;
    Context context;
    rtcInitIntersectContext(&context);
    context.filter = filter;
    context.tracer = this;
    context.frame = &frame;
    context.strand = ray.strand;
    context.crossings = 0;
    RTCRayHit hit{};
    hit.ray = {static_cast<float>(origin.x),
               static_cast<float>(origin.y),
               static_cast<float>(origin.z),
               0.0f,
               static_cast<float>(frame.along.x),
               static_cast<float>(frame.along.y),
               static_cast<float>(frame.along.z),
               0.0f,
               static_cast<float>(frame.length + early),
               0xffffffffu,
               0,
               0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &hit);
    return context.crossings;
  }

  RibbonPoints ribbons_;
  std::vector<std::uint32_t> segments_;  // primitive -> its first point
  Owned<RTCDevice> device_;
  Owned<RTCScene> scene_;
};

}  // namespace

std::unique_ptr<FibreTracer> makeEmbreeTracer(StrandView strands, const Fibre& fibre) {
  return std::make_unique<EmbreeTracer>(strands, fibre);
}

}  // namespace hair
