#include <apps/draw/mesh_visibility.h>

#include <algorithm>
#include <cmath>

#include <apps/draw/light_view.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair::draw {
namespace {

constexpr int kSize = 512;
// A hair's root lies on the very surface that casts the shadow: look from this far towards the
// light, metres.
constexpr float kTowardsLight = 0.004f;

/// Share of the nine pixels around (u, v) whose depth is not nearer to the light than z, weighted
/// by a box of two pixels around (u, v): no steps in u and v.
float litShare(const std::vector<float>& depth, float u, float v, float z) {
  const float fu = std::floor(u), fv = std::floor(v);
  if (!(fu >= 1 && fv >= 1 && fu + 1 < kSize && fv + 1 < kSize)) return 1;
  const int x = int(fu) - 1, y = int(fv) - 1;
  const float a = u - fu, b = v - fv;
  const float across[] = {0.5f - 0.5f * a, 0.5f, 0.5f * a};
  const float down[] = {0.5f - 0.5f * b, 0.5f, 0.5f * b};
  float lit = 0;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const float nearest = depth[std::size_t((y + j) * kSize + x + i)];
      lit += z <= nearest ? across[i] * down[j] : 0.0f;
    }
  }
  return lit;
}

}  // namespace

MeshVisibility::MeshVisibility() : fetched(std::size_t(kSize * kSize)) {
  glBindTexture(GL_TEXTURE_2D, depth);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, kSize, kSize, 0, GL_DEPTH_COMPONENT,
               GL_FLOAT, nullptr);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  gl::requireComplete("mesh visibility");
}

void MeshVisibility::compute(const Scene& scene, const Light& light, const MeshStore& meshes,
                             std::span<const glm::vec3> points, std::span<float> visibility) {
  require(points.size() == visibility.size(), "mesh visibility of ", points.size(),
          " points wanted in an array of ", visibility.size());
  const Bounds casters = meshes.worldBounds(scene);
  if (points.empty() || casters.lower.x > casters.upper.x) {
    std::ranges::fill(visibility, 1.0f);
    return;
  }
  const Bounds receivers = bounds(points);
  const LightView view = lightView(light, receivers.centre(), receivers, casters, kSize);

  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glViewport(0, 0, kSize, kSize);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_SCISSOR_TEST);
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  meshes.drawDepth(scene, view.clipFromWorld);
  glReadPixels(0, 0, kSize, kSize, GL_DEPTH_COMPONENT, GL_FLOAT, fetched.data());

  // To pixels across the light, and depth in [0, 1]; w is 1 for parallel light.
  const bool atPoint = light.kind == Light::Kind::Point;
  const glm::vec3 parallel =
      atPoint ? glm::vec3(0) : kTowardsLight * -glm::normalize(light.direction);
  const glm::vec3 scale(0.5f * kSize, 0.5f * kSize, 0.5f);
  const glm::vec4 wRow = glm::transpose(view.clipFromWorld)[3];
  const glm::mat3 turn = glm::mat3(view.clipFromWorld);
  const glm::vec3 shift(view.clipFromWorld[3]);
  parallelFor(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      glm::vec3 offset = parallel;
      if (atPoint) {
        offset = light.position - points[i];
        const float distance = glm::length(offset);
        offset *= std::min(0.5f, kTowardsLight / std::max(distance, 1e-6f));
      }
      const glm::vec3 clip = turn * (points[i] + offset) + shift;
      const float w = glm::dot(wRow, glm::vec4(points[i] + offset, 1));
      const glm::vec3 p = scale * (clip / w + 1.0f);
      visibility[i] = w > 0 ? litShare(fetched, p.x, p.y, p.z) : 1.0f;  // else behind the light
    }
  });
}

}  // namespace hair::draw
