#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <libhair/c/hair.h>
#include <libhair/model/styles.h>
#include <libhair/simulation/frame.h>

namespace hair::c {

/// Structs of C to the library's own, and back. They throw Error for null pointers, for sizes and
/// for values that are none of an enum; ranges are the business of whoever takes the result.

hair_settings settingsOf(const FrameSettings& settings);
/// Null: the defaults. Lights and what the C interface has no field for are those of `base`.
FrameSettings frameSettings(const hair_settings* settings, FrameSettings base = {});

DensityMapSettings mapSettings(const hair_map& map);
Light lightOf(const hair_light& light);
Fibre fibreOf(const hair_fibre& fibre);
RigidTransform transformOf(const hair_transform& transform);
StyleSettings styleOf(const hair_style* style);

/// Points of the caller, [3 · count].
std::span<const glm::vec3> pointsOf(const float* points, std::size_t count, std::string_view name);
/// Checked: any strands of at least `minPoints` points.
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
