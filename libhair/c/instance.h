#pragma once

#include <memory>

#include <libhair/c/convert.h>
#include <libhair/simulation/simulation.h>

/// A hair and all that it refers to; not movable.
struct hair_instance {
  template <class... Arguments>
  explicit hair_instance(Arguments&&... arguments)
      : simulation(std::forward<Arguments>(arguments)...) {}

  hair::Simulation simulation;
  hair::c::OwnBody body;  ///< scratch for the arrays of a call's body
};

namespace hair::c {

/// Null for settings or body: the defaults.
std::unique_ptr<hair_instance> makeInstance(std::shared_ptr<const Groom> groom,
                                            std::shared_ptr<const MeshSdf> head,
                                            const hair_settings* settings, const hair_body* body);

/// A groom that draws each guide itself.
Groom groomOfGuides(std::span<const glm::vec3> points, std::uint32_t pointsPerGuide);

}  // namespace hair::c
