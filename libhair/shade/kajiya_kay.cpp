#include <libhair/shade/kajiya_kay.h>

#include <algorithm>
#include <cmath>

#include <libhair/core/approximate.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/core/random.h>
#include <libhair/shade/srgb.h>

namespace hair {

namespace {

constexpr std::size_t kBatch = 64;
constexpr std::uint32_t kUseVariation = 0x5aade;

constexpr float kNearest = 0.01f;  // no light is smaller: closer to one it grows no brighter

/// Points waiting to be shaded, one array a component, whatever strands they come from: the
/// arithmetic below is then the same for all of them, in straight loops that vectorise.
struct Batch {
  float px[kBatch], py[kBatch], pz[kBatch];  // position, metres
  float tx[kBatch], ty[kBatch], tz[kBatch];  // along the strand towards the tip, any length
  float r[kBatch], g[kBatch], b[kBatch];     // colour of the hair; at last, of the point
  float lit[kBatch];                         // T · visibility of the light at hand
  // Sums over the lights: what the hair's colour multiplies, and what is reflected as it came.
  float ownR[kBatch], ownG[kBatch], ownB[kBatch];
  float whiteR[kBatch], whiteG[kBatch], whiteB[kBatch];
  std::size_t first = 0;  // the first of them among all points
  std::size_t count = 0;
};

/// A light, with what does not change from point to point worked out.
struct Rays {
  glm::vec3 direction;  // unit; of a light at a point, at the pivot
  glm::vec3 pivot;
  float curvature;  // 1 / (distance of light and pivot); 0: at infinity
  glm::vec3 colour;

  Rays(const Light& light, glm::vec3 p)
      : direction(light.direction), pivot(p), curvature(0), colour(light.colour) {
    if (light.kind == Light::Kind::Point) {
      direction = pivot - light.position;
      curvature = 1.0f / glm::length(direction);
    }
    direction = glm::normalize(direction);
  }
};

/// The settings, with what does not change from point to point worked out.
struct Shader {
  const Illumination& illumination;
  const KajiyaKaySettings& settings;
  std::size_t pointCount;
  std::uint32_t* out;
  float cosFirst, sinFirst, cosSecond, sinSecond;
  const SrgbTable& srgb;

  Shader(const Illumination& i, const KajiyaKaySettings& s, std::span<std::uint32_t> o)
      : illumination(i),
        settings(s),
        pointCount(o.size()),
        out(o.data()),
        cosFirst(std::cos(s.firstShift)),
        sinFirst(std::sin(s.firstShift)),
        cosSecond(std::cos(s.secondShift)),
        sinSecond(std::sin(s.secondShift)),
        srgb(SrgbTable::get()) {}

  void lightUp(Batch& batch, std::size_t light) const {
    const std::size_t at = light * pointCount + batch.first;
    std::fill_n(batch.lit, kBatch, 1.0f);
    if (!illumination.transmittance.empty())
      std::copy_n(illumination.transmittance.data() + at, batch.count, batch.lit);
    if (illumination.visibility.empty()) return;
    const float* visibility = illumination.visibility.data() + at;
    for (std::size_t i = 0; i < batch.count; ++i) batch.lit[i] *= visibility[i];
  }

  /// With a and b the angles of the tangent to the light and to the eye:
  ///
  ///   diffuse  = k_d · sin a
  ///   specular = k_s · cos(pi - a - b)^p      cos(pi - a - b) = sin a sin b - cos a cos b
  ///
  /// (Kajiya and Kay 1989): light leaves a fibre on the cone about the tangent that holds the
  /// mirrored ray. A highlight shifted by s has its peak at a + b = pi + s.
  template <bool kAtPoint, bool kTwoHighlights>
  void add(Batch& batch, const Rays& rays) const {
    const glm::vec3 d = rays.direction, pivot = rays.pivot, c = rays.colour;
    const glm::vec3 eye = illumination.eye;
    const float curvature = rays.curvature, least = curvature * kNearest;
    const float diffuse = settings.diffuse;
    const float firstStrength = settings.specular, firstExponent = settings.exponent;
    const float secondStrength = settings.secondSpecular, secondExponent = settings.secondExponent;
    for (std::size_t i = 0; i < kBatch; ++i) {
      const float x = batch.px[i], y = batch.py[i], z = batch.pz[i];
      const float ex = eye.x - x, ey = eye.y - y, ez = eye.z - z;
      const float tx = batch.tx[i], ty = batch.ty[i], tz = batch.tz[i];
      const float tt = tx * tx + ty * ty + tz * tz;
      const float ee = ex * ex + ey * ey + ez * ez;
      const float perT = 1.0f / std::sqrt(std::max(tt, 1e-30f));
      const float perE = perT / std::sqrt(std::max(ee, 1e-30f));
      float cosA, full = batch.lit[i];
      if constexpr (kAtPoint) {
        // In units of the distance from light to pivot (LightSpace::directionAt).
        const float wx = d.x + curvature * (x - pivot.x), wy = d.y + curvature * (y - pivot.y),
                    wz = d.z + curvature * (z - pivot.z);
        const float ww = wx * wx + wy * wy + wz * wz;
        cosA = -(tx * wx + ty * wy + tz * wz) * perT / std::sqrt(std::max(ww, 1e-30f));
        full /= std::max(ww, least * least);
      } else {
        cosA = -(tx * d.x + ty * d.y + tz * d.z) * perT;
      }
      const float cosB = (tx * ex + ty * ey + tz * ez) * perE;
      const float sinA = std::sqrt(std::max(1.0f - cosA * cosA, 0.0f));
      const float sinB = std::sqrt(std::max(1.0f - cosB * cosB, 0.0f));
      const float cosX = sinA * sinB - cosA * cosB;  // x = a + b - pi
      const float sinX = -sinA * cosB - cosA * sinB;
      const float lit = tt > 1e-30f ? full : 0.0f;
      const float x1 = std::min(std::max(cosX * cosFirst + sinX * sinFirst, 0.0f), 1.0f);
      const float white = firstStrength * lit * powApproximate(x1, firstExponent);
      float own = diffuse * lit * sinA;
      batch.ownR[i] += c.x * own, batch.ownG[i] += c.y * own, batch.ownB[i] += c.z * own;
      if constexpr (kTwoHighlights) {
        const float x2 = std::min(std::max(cosX * cosSecond + sinX * sinSecond, 0.0f), 1.0f);
        own = secondStrength * lit * powApproximate(x2, secondExponent);
        batch.ownR[i] += c.x * own, batch.ownG[i] += c.y * own, batch.ownB[i] += c.z * own;
      }
      batch.whiteR[i] += c.x * white, batch.whiteG[i] += c.y * white,
          batch.whiteB[i] += c.z * white;
    }
  }

  void flush(Batch& batch) const {
    for (float* own : {batch.ownR, batch.ownG, batch.ownB})
      std::fill_n(own, kBatch, settings.ambient);
    for (float* white : {batch.whiteR, batch.whiteG, batch.whiteB})
      std::fill_n(white, kBatch, 0.0f);
    for (std::size_t l = 0; l < illumination.lights.size(); ++l) {
      const Rays rays(illumination.lights[l], illumination.pivot);
      const bool two = settings.secondSpecular > 0;
      lightUp(batch, l);
      if (rays.curvature > 0)
        two ? add<true, true>(batch, rays) : add<true, false>(batch, rays);
      else
        two ? add<false, true>(batch, rays) : add<false, false>(batch, rays);
    }
    for (std::size_t i = 0; i < kBatch; ++i) {
      batch.r[i] = batch.r[i] * batch.ownR[i] + batch.whiteR[i];
      batch.g[i] = batch.g[i] * batch.ownG[i] + batch.whiteG[i];
      batch.b[i] = batch.b[i] * batch.ownB[i] + batch.whiteB[i];
    }
    for (std::size_t i = 0; i < batch.count; ++i)
      out[batch.first + i] = std::uint32_t{srgb(batch.r[i])} |
                             std::uint32_t{srgb(batch.g[i])} << 8 |
                             std::uint32_t{srgb(batch.b[i])} << 16 | 0xff000000u;
    batch.first += batch.count;
    batch.count = 0;
  }
};

}  // namespace

KajiyaKaySettings KajiyaKaySettings::plain() {
  KajiyaKaySettings settings;
  settings.variation = 0;
  settings.secondSpecular = 0;
  settings.firstShift = 0;
  return settings;
}

void shadeKajiyaKay(StrandView strands, const Illumination& illumination,
                    const KajiyaKaySettings& settings, std::span<std::uint32_t> out) {
  const std::size_t points = strands.pointCount(), lights = illumination.lights.size();
  const auto fits = [&](std::span<const float> values, const char* what) {
    require(values.empty() || values.size() == lights * points, "shadeKajiyaKay: ", points,
            " points and ", lights, " lights but ", values.size(), ' ', what);
  };
  fits(illumination.transmittance, "transmittances");
  fits(illumination.visibility, "visibilities");
  require(out.size() == points, "shadeKajiyaKay: ", points, " points but room for ", out.size(),
          " colours");
  for (const Light& light : illumination.lights) lightSpaceOf(light, illumination.pivot);
  const Shader shader(illumination, settings, out);
  parallelFor(strands.strandCount(), 64, [&](std::size_t begin, std::size_t end) {
    Batch batch{};
    batch.first = strands.first[begin];
    for (std::size_t s = begin; s < end; ++s) {
      const std::size_t first = strands.first[s], count = strands.first[s + 1] - first;
      const float lightness =
          1.0f + settings.variation *
                     (2.0f * uniform(static_cast<std::uint32_t>(s), kUseVariation) - 1.0f);
      const glm::vec3 root = lightness * settings.rootColour;
      const glm::vec3 perPoint = (lightness * settings.tipColour - root) /
                                 static_cast<float>(std::max<std::size_t>(count, 2) - 1);
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t p = first + k;
        const glm::vec3 here = strands.points[p];
        // The tangent of the Catmull-Rom curve through the points: half of next - previous.
        const glm::vec3 t =
            strands.points[k + 1 < count ? p + 1 : p] - strands.points[k > 0 ? p - 1 : p];
        const glm::vec3 colour = root + static_cast<float>(k) * perPoint;
        const std::size_t i = batch.count++;
        batch.px[i] = here.x, batch.py[i] = here.y, batch.pz[i] = here.z;
        batch.tx[i] = t.x, batch.ty[i] = t.y, batch.tz[i] = t.z;
        batch.r[i] = colour.x, batch.g[i] = colour.y, batch.b[i] = colour.z;
        if (batch.count == kBatch) shader.flush(batch);
      }
    }
    if (batch.count > 0) shader.flush(batch);
  });
}

}  // namespace hair
