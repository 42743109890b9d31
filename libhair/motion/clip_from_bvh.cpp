#include <algorithm>
#include <cmath>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/motion/clip_units.h>
#include <libhair/motion/motion.h>

namespace hair {
namespace {

using Channel = Bvh::Channel;

bool isPosition(Channel c) {
  return c <= Channel::Zposition;
}

int axisOf(Channel c) {
  return static_cast<int>(c) -
         static_cast<int>(isPosition(c) ? Channel::Xposition : Channel::Xrotation);
}

/// About 100 frames of all.
std::size_t sampleStep(const Bvh& bvh) {
  return bvh.frameCount() / 100 + 1;
}

/// Whether position channels below the root add to the offsets: most joints that have both stay
/// nearer to zero than to their offset.
bool positionsAdd(const Bvh& bvh) {
  int votes = 0;
  for (const Bvh::Joint& joint : bvh.joints) {
    if (joint.parent < 0 || joint.endSite || joint.offset == glm::vec3(0)) continue;
    double toOffset = 0, toZero = 0;
    for (std::size_t f = 0; f < bvh.frameCount(); f += sampleStep(bvh))
      for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (!isPosition(joint.channels[c])) continue;
        const double value = bvh.frame(f)[joint.firstChannel + c];
        const double offset = joint.offset[axisOf(joint.channels[c])];
        toOffset += (value - offset) * (value - offset);
        toZero += value * value;
      }
    votes += toZero < toOffset ? 1 : (toOffset < toZero ? -1 : 0);
  }
  return votes > 0;
}

/// Where the positions of a joint put it, component by component the median; the offset where it
/// has none, or they are about the same.
glm::vec3 offsetMeant(const Bvh& bvh, const Bvh::Joint& joint) {
  glm::vec3 median = joint.offset;
  std::vector<float> values;
  for (std::size_t c = 0; c < joint.channels.size(); ++c) {
    if (!isPosition(joint.channels[c])) continue;
    values.clear();
    for (std::size_t f = 0; f < bvh.frameCount(); f += sampleStep(bvh))
      values.push_back(bvh.frame(f)[joint.firstChannel + c]);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[axisOf(joint.channels[c])] = *middle;
  }
  const float most = std::max(glm::length(median), glm::length(joint.offset));
  return glm::distance(median, joint.offset) > 0.1f * most ? median : joint.offset;
}

// Farther away, single precision is too coarse for the lengths of a body.
constexpr float kFarthest = 1e6f;  // metres

void requireNear(glm::vec3 p, const std::string& joint) {
  for (int axis = 0; axis < 3; ++axis)
    require(std::abs(p[axis]) <= kFarthest, "clip: joint ", joint, " is ", p[axis],
            " m away from its parent, at most ", kFarthest, " m; check the scale");
}

}  // namespace

Clip clipInFileUnits(const Bvh& bvh) {
  require(!bvh.joints.empty(), "clip: the skeleton has no joints");
  require(bvh.frameCount() > 0, "clip: there are no frames");
  require(bvh.frameTime > 0, "clip: frame time ", bvh.frameTime, " s, must be above 0");

  Clip clip;
  clip.frameTime = bvh.frameTime;
  Skeleton& skeleton = clip.skeleton;
  const bool add = positionsAdd(bvh);
  std::vector<int> jointOf(bvh.joints.size(), -1);  // end sites are tips of joints here
  std::vector<std::size_t> source;
  for (std::size_t b = 0; b < bvh.joints.size(); ++b) {
    const Bvh::Joint& joint = bvh.joints[b];
    const int parent = joint.parent < 0 ? -1 : jointOf[static_cast<std::size_t>(joint.parent)];
    if (joint.endSite) {
      if (parent >= 0) skeleton.tips[static_cast<std::size_t>(parent)] = joint.offset;
      continue;
    }
    jointOf[b] = static_cast<int>(skeleton.jointCount());
    source.push_back(b);
    skeleton.names.push_back(joint.name);
    skeleton.parents.push_back(parent);
    skeleton.offsets.push_back(parent < 0 || add ? joint.offset : offsetMeant(bvh, joint));
    skeleton.tips.emplace_back(0);
  }

  clip.rotations.reserve(bvh.frameCount() * source.size());
  clip.positions.reserve(bvh.frameCount() * source.size());
  for (std::size_t f = 0; f < bvh.frameCount(); ++f) {
    const std::span<const float> row = bvh.frame(f);
    for (std::size_t j = 0; j < source.size(); ++j) {
      const Bvh::Joint& joint = bvh.joints[source[j]];
      glm::dquat rotation(1, 0, 0, 0);
      glm::vec3 position = skeleton.offsets[j];
      for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        const float value = row[joint.firstChannel + c];
        const int axis = axisOf(joint.channels[c]);
        if (isPosition(joint.channels[c])) {
          position[axis] = add && joint.parent >= 0 ? position[axis] + value : value;
        } else {
          // Channels turn the joint one after another about its own axes: first one outermost.
          glm::dvec3 direction(0);
          direction[axis] = 1;
          rotation = rotation * glm::angleAxis(glm::radians(static_cast<double>(value)), direction);
        }
      }
      clip.rotations.emplace_back(glm::normalize(rotation));
      clip.positions.push_back(position);
    }
  }
  return clip;
}

void toMetres(Clip& clip, float scale) {
  require(scale > 0 && std::isfinite(scale), "clip: scale ", scale, " is no length; metres a unit");
  const std::vector<std::string>& names = clip.skeleton.names;
  for (std::size_t j = 0; j < names.size(); ++j) {
    for (glm::vec3* p : {&clip.skeleton.offsets[j], &clip.skeleton.tips[j]}) {
      *p = scale * *p;
      requireNear(*p, names[j]);
    }
  }
  for (std::size_t i = 0; i < clip.positions.size(); ++i) {
    clip.positions[i] = scale * clip.positions[i];
    requireNear(clip.positions[i], names[i % names.size()]);
  }
}

Clip clipFromBvh(const Bvh& bvh, float scale) {
  Clip clip = clipInFileUnits(bvh);
  toMetres(clip, scale);
  return clip;
}

}  // namespace hair
