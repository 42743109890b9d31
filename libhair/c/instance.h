#pragma once

#include <memory>
#include <optional>

#include <libhair/c/convert.h>

/// A hair and all that it refers to, which stays where it is.
struct hair_instance {
  hair_instance(hair::Groom groom, std::shared_ptr<const hair::MeshSdf> head,
                const hair_settings* settings, const hair_body* body);

  hair::Groom groom;
  std::shared_ptr<const hair::MeshSdf> head;
  hair::FrameSettings settings;
  hair::c::OwnBody body;  ///< as the last call gave it
  hair::Hair hair;
  hair::FrameProfile profile{};
  std::optional<hair::GroomDetail> detail;  ///< made when a level is first asked for
};

namespace hair::c {

/// Throws Error for what a frame would refuse, before it changes anything.
void requireFrame(const BodyState& body, const std::vector<Light>& lights,
                  const GuideStrands& guides);

/// Throws Error for settings that some stage of a frame refuses.
void tryOut(const FrameSettings& settings);

/// Each guide drawn as it is.
Groom groomOfGuides(std::span<const glm::vec3> points, std::uint32_t pointsPerGuide);

}  // namespace hair::c
