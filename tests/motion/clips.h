#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/files/bvh_file.h>
#include <libhair/motion/motion.h>

namespace hair {

inline const std::vector<std::string> kRealClips = {"jesse_dance", "05_06", "05_11",
                                                    "05_12",       "05_20", "13_39"};

inline std::filesystem::path realClip(const std::string& name) {
  return std::filesystem::path(HAIR_DATA_DIR) / "motion" / (name + ".bvh");
}

/// A chain of `joints` joints, 0.1 m apart along Y, no frames yet.
inline Clip chainClip(std::size_t joints) {
  Clip clip;
  for (std::size_t j = 0; j < joints; ++j) {
    clip.skeleton.names.push_back("joint" + std::to_string(j));
    clip.skeleton.parents.push_back(static_cast<int>(j) - 1);
    clip.skeleton.offsets.emplace_back(0, 0.1f, 0);
    clip.skeleton.tips.emplace_back(0);
  }
  return clip;
}

inline glm::quat turned(glm::vec3 axis, float degrees) {
  return glm::angleAxis(glm::radians(degrees), glm::normalize(axis));
}

}  // namespace hair

/// Ends a test that needs a real recording where there is none.
#define SKIP_WITHOUT_CLIP(name)                 \
  if (!std::filesystem::exists(realClip(name))) \
  GTEST_SKIP() << "real data not found at " << realClip(name)
