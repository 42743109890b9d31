#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "libhair/shade/kajiya_kay.cpp"
#include <hwy/foreach_target.h>
#include <libhair/core/simd-inl.h>

#include <libhair/shade/encode-inl.h>
#include <libhair/shade/kajiya_kay.h>
#include <libhair/shade/shaded_points.h>

HWY_BEFORE_NAMESPACE();
namespace hair {
namespace HWY_NAMESPACE {

constexpr std::size_t kBatch = 64;
constexpr float kNearest = 0.01f;  // metres; the falloff is clamped at this distance

// x^y for x in [0, 1]; by squaring for integer y, the usual case.
HWY_INLINE Floats power(Floats x, float y) {
  const auto whole = static_cast<std::uint32_t>(std::min(std::max(y, 0.0f), 1024.0f));
  if (static_cast<float>(whole) != y) return powApproximate(x, Floats(y));
  Floats p(1.0f);
  for (std::uint32_t rest = whole; rest != 0; rest >>= 1, x = x * x)
    if (rest & 1) p = p * x;
  return p;
}

// Consecutive points waiting to be shaded, across strand boundaries.
struct Batch {
  float red[kBatch + kLanes], green[kBatch + kLanes], blue[kBatch + kLanes];  // of the hair
  std::uint64_t roots = 0, tips = 0;  // bit i: point i is the first (the last) of its strand
  std::size_t first = 0;              // index of the first point
  std::size_t count = 0;
};

// Sixteen points and their reflected light, summed over the lights: the part that the hair's colour
// multiplies, and the part that keeps the light's colour.
struct Points {
  Vec3 here, toEye, tangent;
  Floats tangent2, perTangent, cosB, sinB;
  Vec3 own, white;
};

struct Shader {
  StrandView strands;
  const Illumination& illumination;
  const KajiyaKaySettings& settings;
  PointWriter to;
  float cosFirst, sinFirst, cosSecond, sinSecond;

  Shader(StrandView s, const Illumination& i, const KajiyaKaySettings& look, ShadedPoints out)
      : strands(s),
        illumination(i),
        settings(look),
        to{out},
        cosFirst(std::cos(look.firstShift)),
        sinFirst(std::sin(look.firstShift)),
        cosSecond(std::cos(look.secondShift)),
        sinSecond(std::sin(look.secondShift)) {}

  // n values, copied to a padded array unless they fill the lanes: the source may end there.
  template <class T>
  static HWY_INLINE const T* padded(const T* from, std::size_t n, T (&room)[kLanes]) {
    if (n == kLanes) return from;
    std::fill_n(room, kLanes, T(1));
    std::copy_n(from, n, room);
    return room;
  }

  // Loads n points from p on, with their neighbours.
  HWY_INLINE void load(std::size_t p, std::size_t n, std::uint64_t roots, std::uint64_t tips,
                       Points& x) const {
    const glm::vec3* from = strands.points.data() + p;
    glm::vec3 room[kLanes + 2];
    if (p == 0 || p + kLanes >= strands.points.size()) {
      std::fill_n(room, kLanes + 2, glm::vec3(0));
      const std::size_t before = p > 0 ? 1 : 0, after = p + n < strands.points.size() ? 1 : 0;
      std::copy_n(from - before, before + n + after, room + 1 - before);
      from = room + 1;
    }
    x.here = loadPoints(from);
    // The tangent of the Catmull-Rom curve through the points: half of next - previous.
    const Vec3 next =
        select(maskOf(static_cast<std::uint32_t>(tips)), x.here, loadPoints(from + 1));
    const Vec3 previous =
        select(maskOf(static_cast<std::uint32_t>(roots)), x.here, loadPoints(from - 1));
    x.tangent = next - previous;
    const Vec3 toEye = Vec3(illumination.eye) - x.here;
    const Floats least(1e-30f), one(1.0f), zero(0.0f);
    x.tangent2 = dot(x.tangent, x.tangent);
    x.perTangent = one / sqrt(max(x.tangent2, least));
    const Floats perE = x.perTangent / sqrt(max(dot(toEye, toEye), least));
    x.cosB = dot(x.tangent, toEye) * perE;
    x.sinB = sqrt(max(one - x.cosB * x.cosB, zero));
    const Floats ambient(settings.ambient);
    x.own = {ambient, ambient, ambient};
    x.white = {zero, zero, zero};
  }

  // With a and b the angles of the tangent to the light and to the eye:
  //
  //   diffuse  = k_d · sin a
  //   specular = k_s · cos(pi - a - b)^p      cos(pi - a - b) = sin a sin b - cos a cos b
  //
  // (Kajiya and Kay 1989): a fibre reflects light into the cone about its tangent that contains the
  // mirrored ray. A highlight shifted by s peaks at a + b = pi + s.
  HWY_INLINE void add(const Light& light, Floats full, Points& x) const {
    const Floats least(1e-30f), one(1.0f), zero(0.0f);
    Floats cosA;
    if (light.kind == Light::Kind::Point) {
      // In units of the distance from light to pivot (LightSpace::directionAt).
      const glm::vec3 way = illumination.pivot - light.position;
      const float curvature = 1.0f / glm::length(way), lamp = curvature * kNearest;
      const Vec3 w =
          Vec3(glm::normalize(way)) + Floats(curvature) * (x.here - Vec3(illumination.pivot));
      const Floats ww = dot(w, w);
      cosA = -dot(x.tangent, w) * x.perTangent / sqrt(max(ww, least));
      full = full / max(ww, Floats(lamp * lamp));
    } else {
      cosA = -dot(x.tangent, Vec3(glm::normalize(light.direction))) * x.perTangent;
    }
    const Floats sinA = sqrt(max(one - cosA * cosA, zero));
    const Floats cosX = sinA * x.sinB - cosA * x.cosB;  // x = a + b - pi
    const Floats sinX = -sinA * x.cosB - cosA * x.sinB;
    const Floats lit = select(x.tangent2 > least, full, zero);
    const Vec3 colour(light.colour);
    const auto highlight = [&](float c, float s, float strength, float exponent) HWY_ATTR {
      const Floats cosine = min(max(cosX * Floats(c) + sinX * Floats(s), zero), one);
      return Floats(strength) * lit * power(cosine, exponent);
    };
    x.own = x.own + Floats(settings.diffuse) * lit * sinA * colour;
    if (settings.secondSpecular > 0)
      x.own = x.own +
              highlight(cosSecond, sinSecond, settings.secondSpecular, settings.secondExponent) *
                  colour;
    x.white =
        x.white + highlight(cosFirst, sinFirst, settings.specular, settings.exponent) * colour;
  }

  HWY_INLINE void shade(const Batch& batch, std::size_t i) const {
    const std::size_t p = batch.first + i, n = std::min(kLanes, batch.count - i);
    Points x;
    load(p, n, batch.roots >> i & 0xffff, batch.tips >> i & 0xffff, x);
    for (std::size_t l = 0; l < illumination.lights.size(); ++l) {
      const std::size_t at = l * strands.points.size() + p;
      float room[kLanes];
      Floats full(1.0f);
      if (!illumination.transmittance.empty())
        full = loadFloats(padded(illumination.transmittance.data() + at, n, room));
      if (!illumination.visibility.empty())
        full = full * loadFloats(padded(illumination.visibility.data() + at, n, room));
      add(illumination.lights[l], full, x);
    }
    to.put({loadFloats(batch.red + i) * x.own.x + x.white.x,
            loadFloats(batch.green + i) * x.own.y + x.white.y,
            loadFloats(batch.blue + i) * x.own.z + x.white.z},
           p, n);
  }

  HWY_INLINE void flush(Batch& batch) const {
    for (std::size_t i = 0; i < batch.count; i += kLanes) shade(batch, i);
    batch.first += batch.count;
    batch.count = 0;
    batch.roots = batch.tips = 0;
  }

  void run(std::size_t begin, std::size_t end) const {
    Batch batch;
    batch.first = strands.first[begin];
    for (std::size_t s = begin; s < end; ++s) {
      const std::size_t n = strands.first[s + 1] - strands.first[s];
      const float lightness = settings.lightnessOf(static_cast<std::uint32_t>(s));
      const glm::vec3 root = lightness * settings.rootColour;
      const glm::vec3 perPoint = (lightness * settings.tipColour - root) /
                                 static_cast<float>(std::max<std::size_t>(n, 2) - 1);
      for (std::size_t k = 0; k < n;) {
        const std::size_t taken = std::min(n - k, kBatch - batch.count);
        if (k == 0) batch.roots |= std::uint64_t{1} << batch.count;
        for (std::size_t i = 0; i < taken; i += kLanes) {
          const Floats number = toFloats(laneNumbers() + Ints(static_cast<std::int32_t>(k + i)));
          store(Floats(root.x) + number * Floats(perPoint.x), batch.red + batch.count + i);
          store(Floats(root.y) + number * Floats(perPoint.y), batch.green + batch.count + i);
          store(Floats(root.z) + number * Floats(perPoint.z), batch.blue + batch.count + i);
        }
        batch.count += taken;
        k += taken;
        if (k == n) batch.tips |= std::uint64_t{1} << (batch.count - 1);
        if (batch.count == kBatch) flush(batch);
      }
    }
    flush(batch);
  }
};

void shadeRange(StrandView strands, std::size_t begin, std::size_t end,
                const Illumination& illumination, const KajiyaKaySettings& settings,
                ShadedPoints out) {
  Shader(strands, illumination, settings, out).run(begin, end);
}

}  // namespace HWY_NAMESPACE
}  // namespace hair
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <libhair/core/error.h>
#include <libhair/core/random.h>

namespace hair {

namespace {

HWY_EXPORT(shadeRange);

}  // namespace

void validate(const KajiyaKaySettings& s) {
  validateFields(s, "appearance");
}

float KajiyaKaySettings::lightnessOf(std::uint32_t strand) const {
  constexpr std::uint32_t kUse = 0x5aade;  // seed of this use of uniform()
  return 1.0f + variation * (2.0f * uniform(strand, kUse) - 1.0f);
}

KajiyaKaySettings KajiyaKaySettings::plain() {
  KajiyaKaySettings settings;
  settings.variation = 0;
  settings.secondSpecular = 0;
  settings.firstShift = 0;
  return settings;
}

void shadeStrands(StrandView strands, std::size_t begin, std::size_t end,
                  const Illumination& illumination, const KajiyaKaySettings& settings,
                  ShadedPoints out) {
  if (begin < end)
    HWY_DYNAMIC_DISPATCH(shadeRange)(strands, begin, end, illumination, settings, out);
}

}  // namespace hair

#endif  // HWY_ONCE
