#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <libhair/c/hair.h>
#include <libhair/model/styles.h>
#include <libhair/simulation/frame.h>

namespace hair::c {

/// Convert C structs to the library's own, and back. Throw Error for null pointers, wrong sizes and
/// invalid enum values; ranges are validated by the functions that use the results.

hair_settings settingsOf(const FrameSettings& settings);
/// Null: the defaults. Lights and fields missing in the C interface come from `base`.
FrameSettings frameSettings(const hair_settings* settings, FrameSettings base = {});

DensityMapSettings mapSettings(const hair_map& map);
Light lightOf(const hair_light& light);
Fibre fibreOf(const hair_fibre& fibre);
RigidTransform transformOf(const hair_transform& transform);
StyleSettings styleOf(const hair_style* style);

/// Points of the caller, [3 · count].
std::span<const glm::vec3> pointsOf(const float* points, std::size_t count, std::string_view name);
/// Validated strands of at least `minPoints` points each.
StrandView strandsOf(const hair_strands* strands, std::size_t minPoints);

/// Distance field of a caller's head; null for none.
std::shared_ptr<const MeshSdf> headOf(const hair_head* head);

/// A body that owns its arrays.
struct OwnBody {
  RigidTransform worldFromHead;
  std::vector<Capsule> capsules;
  std::vector<Plane> planes;

  BodyState state() const { return {worldFromHead, capsules, {planes, {}}}; }
};
void take(const hair_body& body, OwnBody& out);

}  // namespace hair::c
