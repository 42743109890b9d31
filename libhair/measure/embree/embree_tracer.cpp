#include <libhair/measure/embree/embree_tracer.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/measure/shadow/ribbon.h>

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
  EmbreeTracer(StrandView strands, const Fibre& fibre)
      : ribbons_(makeRibbonPoints(strands, fibre)) {
    for (std::size_t i = 0; i < ribbons_.points.size(); ++i) {
      if (ribbons_.isSegment(i)) segments_.push_back(static_cast<std::uint32_t>(i));
    }
    device_.reset(rtcNewDevice(nullptr));
    require(device_ != nullptr, "Embree: no device");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    if (!segments_.empty()) {
      RTCGeometry curves = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
      auto* vertices = static_cast<glm::vec4*>(
          rtcSetNewGeometryBuffer(curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                  sizeof(glm::vec4), ribbons_.points.size()));
      auto* indices = static_cast<std::uint32_t*>(
          rtcSetNewGeometryBuffer(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                  sizeof(std::uint32_t), segments_.size()));
      // No neighbours: each segment is a tube of its own, with round ends. (With neighbours Embree
      // leaves out what of a joint is inside of the other tube, but now and then neither or both.)
      auto* flags = static_cast<std::uint8_t*>(rtcSetNewGeometryBuffer(
          curves, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, segments_.size()));
      require(vertices && indices && flags, "Embree: no memory for ", segments_.size(),
              " segments");
      // Somewhat thicker than the fibres are, for Embree's rounding: what is crossed is decided by
      // the law of ribbons.
      const float radius = 1.01f * static_cast<float>(ribbons_.halfWidth);
      for (std::size_t i = 0; i < ribbons_.points.size(); ++i)
        vertices[i] = glm::vec4(ribbons_.points[i], radius);
      std::copy(segments_.begin(), segments_.end(), indices);
      std::fill_n(flags, segments_.size(), std::uint8_t{0});
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

  /// All that lies along the ray: nothing is taken for a hit, so that the ray goes on. A tube is
  /// left once, and ahead of the origin if what the ray crosses of it is: of its two hits this is
  /// the one to count.
  static void filter(const RTCFilterFunctionNArguments* arguments) {
    arguments->valid[0] = 0;
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    auto& context = *static_cast<Context*>(arguments->context);
    if (hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z <= 0) return;
    const RibbonPoints& ribbons = context.tracer->ribbons_;
    const std::size_t i = context.tracer->segments_[hit.primID];
    if (ribbons.strand[i] != context.strand && crossingBegins(ribbons, i, *context.frame))
      ++context.crossings;
  }

  std::uint32_t count(const ShadowRay& ray) const {
    const RayFrame frame(ray);
    Context context;
    rtcInitIntersectContext(&context);
    context.filter = filter;
    context.tracer = this;
    context.frame = &frame;
    context.strand = ray.strand;
    context.crossings = 0;
    RTCRayHit hit{};
    hit.ray.org_x = ray.origin.x, hit.ray.org_y = ray.origin.y, hit.ray.org_z = ray.origin.z;
    hit.ray.dir_x = ray.toLight.x, hit.ray.dir_y = ray.toLight.y, hit.ray.dir_z = ray.toLight.z;
    hit.ray.tfar = INFINITY;  // a tube before the light may be left behind it
    hit.ray.mask = 0xffffffffu;
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
