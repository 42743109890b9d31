#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/lanes.h>
#include <libhair/core/state_hash.h>
#include <libhair/core/transform.h>
#include <libhair/guides/rest_shape.h>
#include <libhair/guides/settings.h>
#include <libhair/model/groom.h>

namespace HAIR_API hair {

class MeshSdf;

/// Guide strands as rigid links: state and rest shape.
///
/// Sixteen strands lie side by side ("a group"), so that every pass works on all of them at once;
/// element [group · points + i] holds point i of guides 16·group .. 16·group + 15:
///
///                lane 0    lane 1   ...  lane 15
///     point 0    guide 0   guide 1       guide 15    } group 0, read from root to tip
///     point 1    guide 0   guide 1       guide 15    }
///     ...
///     point 0    guide 16  guide 17      guide 31    } group 1
///
/// Lanes beyond the last guide repeat it. Link i joins points i and i + 1.
///
/// Shape. With d_i the direction of link i and d_-1 that of the root, bending has the energy
///     E = sum_i kappa_i / 2 · |d_i - d_(i-1) - c_i|²,    kappa_i = stiffness / length of the
///     joint,
/// where the rest curvature c_i is fixed in the frame of link i - 1, and frames are carried along
/// the chain from the root by parallel transport. c_i holds the torque that gravity asks for at
/// rest (computed from tip to root), so the groom is an equilibrium. What is in the bars is the
/// *strain* of joint i; its rate of change is damped.
class GuideStrands {
 public:
  /// At rest in the groom, on a head at `worldFromHead`. `head` (may be null) is the collider of
  /// the head in head space: points groomed closer to it than the skin may stay as close.
  /// Throws Error: fewer than 2 or more than kMaxGuidePoints points, one that is not finite, a link
  /// without length, and as validate(RigidTransform) and requirePrecision do (validate.h).
  GuideStrands(const Groom& groom, const GuideSettings& settings,
               const RigidTransform& worldFromHead = {}, const MeshSdf* head = nullptr);

  /// How many guides there are.
  std::size_t guideCount() const { return guideCount_; }
  /// Groups of sixteen guides, the last one filled up.
  std::size_t groupCount() const { return (guideCount_ + kLanes - 1) / kLanes; }
  /// Points of each guide, the root included.
  std::uint32_t pointsPerGuide() const { return points_; }
  /// Links of each guide.
  std::uint32_t linksPerGuide() const { return points_ - 1; }

  float shortestLink() const { return shortestLink_; }  ///< metres
  /// How far from the head's joint a point can be, as no link stretches, metres.
  float reach() const { return reach_; }
  float restGravity() const { return restGravity_; }  ///< that its rest shape holds against, m/s²
  /// What substep its shortest and stiffest joints bear on a head at `worldFromHead`, seconds;
  /// stepGuides takes none longer. Rounding turns a link by r / l, with r the spacing of floats,
  /// and with it the torque g that it carries: its ends, of mass m, are thrown by g r h² / (m l²),
  /// which must be no more than a few times l for the link to find back. Measured: up to 4 times it
  /// does; at 20 a strand shakes. Throws Error, that names the link, where that takes less than
  /// 1/20000 s.
  ///
  /// Strands of uneven links take substeps for what pulls on them, too: `weight` times that of the
  /// hair at rest, >= 1. But where it is 1 none below 1/6000 s, or in which gravity moves a point
  /// by less than 25 times the spacing of floats: half of a spacing is lost, and hair would stick
  /// where a fiftieth of gravity no longer moves it.
  float longestSubstep(const RigidTransform& worldFromHead, float weight = 1) const;

  /// Back to the groom at rest on a head at `worldFromHead`, without speed. Throws Error for one
  /// that is not finite or too far from the origin (validate.h).
  void reset(const RigidTransform& worldFromHead);
  /// World position of one point.
  glm::vec3 point(std::size_t guide, std::uint32_t i) const;
  /// All points, strand after strand: [guideCount · pointsPerGuide].
  void copyPoints(std::span<glm::vec3> out) const;
  /// Positions and velocities, bit for bit.
  void addTo(StateHash& hash) const;

  // State; [groupCount · pointsPerGuide], tension [groupCount · linksPerGuide].
  std::vector<LaneVec3> position;  ///< metres, world
  std::vector<LaneVec3> velocity;  ///< m/s
  std::vector<Lanes> tension;      ///< of the last substep, per linear density (m²/s²)
  RigidTransform worldFromHead;    ///< where the roots are now

  // Rest shape, head space.
  std::vector<LaneVec3> restPosition;  ///< [groupCount · pointsPerGuide]
  std::vector<LaneVec3> rootTangent;   ///< [groupCount], unit
  std::vector<LaneVec3> rootNormal;    ///< [groupCount], unit, at a right angle to the tangent
  std::vector<Lanes> linkLength;       ///< [groupCount · linksPerGuide]
  std::vector<Lanes> inverseLength;    ///< [groupCount · linksPerGuide], 1 / linkLength
  std::vector<Lanes> restTension;      ///< [groupCount · linksPerGuide]
  std::vector<LaneVec3>
      curvature;  ///< [groupCount · linksPerGuide], c_i in the frame of link i - 1
  std::vector<Lanes> jointStiffness;  ///< [groupCount · linksPerGuide], kappa_i per linear density
  std::vector<Lanes> pointMass;     ///< [groupCount · pointsPerGuide], per linear density (metres)
  std::vector<Lanes> inverseMass;   ///< [groupCount · pointsPerGuide], 1 / pointMass; 0 for the
                                    ///< root and what is tied (Groom::tied)
  std::vector<std::uint32_t> tied;  ///< [groupCount], points that are tied in some strand, >= 1
  std::vector<Lanes> clearance;     ///< [groupCount · pointsPerGuide], least distance to the head
  /// [groupCount], whether a strand has uneven links (kEven).
  std::vector<std::uint8_t> uneven;

 private:
  std::size_t guideCount_;
  std::uint32_t points_;
  float shortestLink_ = INFINITY, reach_ = 0, longestSubstep_ = INFINITY,
        longestUnderTension_ = INFINITY;
  float restGravity_;
  float leastBorne_ = INFINITY;  ///< of RestShape::borne
  std::size_t weakestGuide_ = 0, weakestLink_ = 0;
};

/// Normal of the frame at a strand's root: any, but a fixed function of the root direction.
glm::vec3 rootNormalOf(glm::vec3 rootDirection);

}  // namespace hair
