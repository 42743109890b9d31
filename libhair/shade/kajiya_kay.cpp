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

/// Points waiting to be shaded, one array a component, whatever strands they come from: the
/// arithmetic below is then the same for all of them, in straight loops that vectorise.
struct Batch {
  float px[kBatch], py[kBatch], pz[kBatch];  // position, metres
  float tx[kBatch], ty[kBatch], tz[kBatch];  // along the strand towards the tip, any length
  float r[kBatch], g[kBatch], b[kBatch];     // colour of the hair; after light(), of the point
  float lit[kBatch];                         // T · visibility
  std::uint32_t* out = nullptr;              // where the first of them goes
  std::size_t count = 0;
};

/// The settings, with what does not change from point to point worked out.
struct Shader {
  ShadeLight light;
  KajiyaKaySettings settings;
  float cosFirst, sinFirst, cosSecond, sinSecond;
  const SrgbTable& srgb;

  Shader(const ShadeLight& l, const KajiyaKaySettings& s)
      : light(l),
        settings(s),
        cosFirst(std::cos(s.firstShift)),
        sinFirst(std::sin(s.firstShift)),
        cosSecond(std::cos(s.secondShift)),
        sinSecond(std::sin(s.secondShift)),
        srgb(SrgbTable::get()) {
    light.direction = glm::normalize(light.direction);
  }

  /// With a and b the angles of the tangent to the light and to the eye:
  ///
  ///   diffuse  = k_d · sin a
  ///   specular = k_s · cos(pi - a - b)^p      cos(pi - a - b) = sin a sin b - cos a cos b
  ///
  /// (Kajiya and Kay 1989): light leaves a fibre on the cone about the tangent that holds the
  /// mirrored ray. A highlight shifted by s has its peak at a + b = pi + s.
  template <bool kTwoHighlights>
  void shade(Batch& batch) const {
    const glm::vec3 d = light.direction, eye = light.eye, c = light.colour;
    const float ambient = settings.ambient, diffuse = settings.diffuse;
    const float firstStrength = settings.specular, firstExponent = settings.exponent;
    const float secondStrength = settings.secondSpecular, secondExponent = settings.secondExponent;
    for (std::size_t i = 0; i < kBatch; ++i) {
      const float ex = eye.x - batch.px[i], ey = eye.y - batch.py[i], ez = eye.z - batch.pz[i];
      const float tx = batch.tx[i], ty = batch.ty[i], tz = batch.tz[i];
      const float tt = tx * tx + ty * ty + tz * tz;
      const float ee = ex * ex + ey * ey + ez * ez;
      const float perT = 1.0f / std::sqrt(std::max(tt, 1e-30f));
      const float perE = perT / std::sqrt(std::max(ee, 1e-30f));
      const float cosA = -(tx * d.x + ty * d.y + tz * d.z) * perT;
      const float cosB = (tx * ex + ty * ey + tz * ez) * perE;
      const float sinA = std::sqrt(std::max(1.0f - cosA * cosA, 0.0f));
      const float sinB = std::sqrt(std::max(1.0f - cosB * cosB, 0.0f));
      const float cosX = sinA * sinB - cosA * cosB;  // x = a + b - pi
      const float sinX = -sinA * cosB - cosA * sinB;
      const float full = batch.lit[i];
      const float lit = tt > 1e-30f ? full : 0.0f;
      const float x1 = std::min(std::max(cosX * cosFirst + sinX * sinFirst, 0.0f), 1.0f);
      const float white = firstStrength * lit * powApproximate(x1, firstExponent);
      float own = ambient + diffuse * lit * sinA;
      if constexpr (kTwoHighlights) {
        const float x2 = std::min(std::max(cosX * cosSecond + sinX * sinSecond, 0.0f), 1.0f);
        own += secondStrength * lit * powApproximate(x2, secondExponent);
      }
      batch.r[i] = c.x * (batch.r[i] * own + white);
      batch.g[i] = c.y * (batch.g[i] * own + white);
      batch.b[i] = c.z * (batch.b[i] * own + white);
    }
  }

  void flush(Batch& batch) const {
    if (settings.secondSpecular > 0)
      shade<true>(batch);
    else
      shade<false>(batch);
    for (std::size_t i = 0; i < batch.count; ++i)
      batch.out[i] = std::uint32_t{srgb(batch.r[i])} | std::uint32_t{srgb(batch.g[i])} << 8 |
                     std::uint32_t{srgb(batch.b[i])} << 16 | 0xff000000u;
    batch.out += batch.count;
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

void shadeKajiyaKay(StrandView strands, std::span<const float> transmittance,
                    std::span<const float> visibility, const ShadeLight& light,
                    const KajiyaKaySettings& settings, std::span<std::uint32_t> out) {
  const std::size_t points = strands.pointCount();
  require(transmittance.empty() || transmittance.size() == points, "shadeKajiyaKay: ", points,
          " points but ", transmittance.size(), " transmittances");
  require(visibility.empty() || visibility.size() == points, "shadeKajiyaKay: ", points,
          " points but ", visibility.size(), " visibilities");
  require(out.size() == points, "shadeKajiyaKay: ", points, " points but room for ", out.size(),
          " colours");
  require(glm::dot(light.direction, light.direction) > 0,
          "shadeKajiyaKay: the light direction is zero; set --light");
  const Shader shader(light, settings);
  parallelFor(strands.strandCount(), 64, [&](std::size_t begin, std::size_t end) {
    Batch batch{};
    batch.out = out.data() + strands.first[begin];
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
        batch.lit[i] = (transmittance.empty() ? 1.0f : transmittance[p]) *
                       (visibility.empty() ? 1.0f : visibility[p]);
        if (batch.count == kBatch) shader.flush(batch);
      }
    }
    if (batch.count > 0) shader.flush(batch);
  });
}

}  // namespace hair
