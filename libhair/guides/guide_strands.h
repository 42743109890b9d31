#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <libhair/core/api.h>
#include <libhair/core/lanes.h>
#include <libhair/core/transform.h>
#include <libhair/geometry/colliders.h>
#include <libhair/guides/settings.h>
#include <libhair/model/groom.h>
#include <libhair/motion/wind.h>

namespace HAIR_API hair {

class MeshSdf;
class StateHash;
struct SubstepMemory;

/// Guide strands as rigid links: state and rest shape.
///
/// Strands are stored in groups of sixteen, one strand a SIMD lane, so that every pass works on
/// sixteen at once; element [group · points + i] holds point i of guides 16·group .. 16·group + 15:
///
///                lane 0    lane 1   ...  lane 15
///     point 0    guide 0   guide 1       guide 15    } group 0, read from root to tip
///     point 1    guide 0   guide 1       guide 15    }
///     ...
///     point 0    guide 16  guide 17      guide 31    } group 1
///
/// Lanes beyond the last guide repeat it. Link i joins points i and i + 1.
///
/// Rest shape. With d_i the direction of link i and d_-1 that of the root, bending has the energy
///     E = sum_i kappa_i / 2 · |d_i - d_(i-1) - c_i|²,    kappa_i = stiffness / length of the
///     joint,
/// where the rest curvature c_i is fixed in the frame of link i - 1, and frames are carried along
/// the chain from the root by parallel transport. c_i includes the torque that balances gravity at
/// rest (computed from tip to root), so that the groom is an equilibrium. The term in the bars is
/// the *strain* of joint i; its rate of change is damped.
class GuideStrands {
 public:
  /// At rest in the groom, on a head at `worldFromHead`. `head` (may be null) is the collider of
  /// the head in head space: points groomed closer to it than the skin may stay as close.
  /// Throws Error for no guides, fewer than 2 or more than kMaxGuidePoints points, points that are
  /// not finite, links not in 1e-6 to 1e5 m, settings out of range, ties of another number of
  /// guides, and as makeRestShape and reset do.
  GuideStrands(const Groom& groom, const GuideSettings& settings,
               const RigidTransform& worldFromHead = {}, const MeshSdf* head = nullptr);

  /// Number of guides.
  std::size_t guideCount() const { return guideCount_; }
  /// Number of groups of sixteen guides; the last group is padded.
  std::size_t groupCount() const { return (guideCount_ + kLanes - 1) / kLanes; }
  /// Points of each guide, the root included.
  std::uint32_t pointsPerGuide() const { return points_; }
  /// Links of each guide.
  std::uint32_t linksPerGuide() const { return points_ - 1; }

  float shortestLink() const { return shortestLink_; }  ///< metres
  /// Largest distance of a point from the head's origin, as no link stretches, metres.
  float reach() const { return reach_; }
  float restGravity() const { return restGravity_; }  ///< gravity of the rest shape, m/s²
  /// Longest substep, seconds, at which the solver is stable on a head at `worldFromHead`;
  /// stepGuides takes none longer. Rounding turns a link by r / l, with r the spacing of floats,
  /// and with it the torque g that it carries: this displaces its ends, of mass m, by
  /// g r h² / (m l²), which may be no more than a few times l if the link is to return. Measured:
  /// up to 4 times it does; at 20 a strand shakes. Throws Error, naming the link, where this
  /// requires substeps below 1/20000 s.
  ///
  /// For strands of uneven links tension limits the substep, too: `weight` is the load on the hair
  /// over that at rest, >= 1. At weight 1 this limit is no shorter than 1/6000 s, nor than the time
  /// in which gravity moves a point by 25 times the spacing of floats: half of a spacing is lost to
  /// rounding, and hair would stick where a fiftieth of gravity no longer moves it.
  float longestSubstep(const RigidTransform& worldFromHead, float weight = 1) const;

  /// Resets to the groom at rest on a head at `worldFromHead`, with zero velocity. Throws Error for
  /// a head that is not finite or too far from the origin (validate.h), and as longestSubstep.
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
  RigidTransform worldFromHead;    ///< head that carries the roots, now

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
                                    ///< root and tied points (Groom::tied)
  std::vector<std::uint32_t> tied;  ///< [groupCount], most tied points of a strand, >= 1
  std::vector<Lanes> clearance;     ///< [groupCount · pointsPerGuide], least distance to the head
  /// [groupCount], 1 if a strand has uneven links (kEven).
  std::vector<std::uint8_t> hasUnevenLinks;

 private:
  std::size_t guideCount_;
  std::uint32_t points_;
  float shortestLink_ = INFINITY, reach_ = 0, longestSubstep_ = INFINITY,
        longestUnderTension_ = INFINITY;
  float restGravity_;
  float leastBorne_ = INFINITY;  ///< of RestShape::torqueLimit
  std::size_t weakestGuide_ = 0, weakestLink_ = 0;
};

/// Normal of the frame at a strand's root: arbitrary, but a fixed function of the root direction.
glm::vec3 rootNormalOf(glm::vec3 rootDirection);

/// What moves the guides over one frame. Roots and colliders are interpolated inside the frame,
/// from where they were at its start to where they are at its end.
struct GuideMotion {
  RigidTransform worldFromHead{};             ///< at the end of the frame
  std::span<const Capsule> capsules{};        ///< body at the end of the frame
  std::span<const Capsule> capsulesBefore{};  ///< at its start; same count and order
  const MeshSdf* head = nullptr;              ///< collider in head space; null: none
  Wind wind{};                                ///< still air by default
  double time = 0;                     ///< at the start of the frame, seconds; phase of the gusts
  std::span<const LaneVec3> push{};    ///< m/s² on every point, laid out as GuideStrands; or empty
  std::span<const Lanes> windShare{};  ///< fraction of the wind at every point; or empty: 1
  Scenery scenery{};                   ///< at the end of the frame
  Scenery sceneryBefore{};             ///< at its start; same counts and order, or empty: at rest
};

/// Working memory of stepGuides, opaque; kept by the caller, so that it is allocated once. Use one
/// per GuideStrands.
class GuideWorkspace {
 public:
  GuideWorkspace();
  ~GuideWorkspace();
  GuideWorkspace(GuideWorkspace&&) noexcept;             ///< moves all of it
  GuideWorkspace& operator=(GuideWorkspace&&) noexcept;  ///< moves all of it

  /// For the solver.
  SubstepMemory& memory() { return *memory_; }
  /// The same, read-only.
  const SubstepMemory& memory() const { return *memory_; }

 private:
  std::unique_ptr<SubstepMemory> memory_;
};

/// Moves the guides over one frame of `seconds`. Each substep of length h:
///   1. predict: velocity with drag, gravity, push, and the tension of the previous substep;
///   2. bend: implicit Euler on the bending energy, one solve;
///   3. contact: the nearest collider's plane for each point, with friction (contact-inl.h);
///   4. links: Newton iterations, all links of a strand at once (links-inl.h), then exact lengths;
///      or relaxation, one link after the other (relaxation-inl.h), which leaves some stretch;
///   5. velocity = movement / h.
/// Predicting with the last tension makes a groom at rest a fixed point of every substep, and
/// starts Newton close to its solution otherwise. (Relaxation does not change the tension.)
/// Throws Error for seconds not in [1e-6, 1], settings out of range, counts that differ, more than
/// kMaxCapsules capsules, invalid wind, head, capsules, scenery or pushes, and a head too far from
/// the origin (validate.h). Use one workspace per GuideStrands.
void stepGuides(const GuideMotion& motion, const GuideSettings& settings, float seconds,
                GuideWorkspace& workspace, GuideStrands& guides);

/// Stretch, penetration and speed of the guides at one moment.
struct GuideStats {
  float stretchMax = 0;      ///< max of |l - l0| / l0 over all links
  float stretchRms = 0;      ///< root mean square of the same
  float penetrationMax = 0;  ///< depth of the deepest guide point in a collider, metres; 0: none
  double kineticEnergy = 0;  ///< of the guides themselves, joules
  float speedMax = 0;        ///< m/s
};

/// Measures the guides against these colliders. Points groomed inside the head count by the depth
/// beyond that of the groom; points of a strand whose anchored points are covered by a collider, by
/// the depth beyond what contact allows there; roots not at all.
GuideStats measureGuides(const GuideStrands& guides, const GuideSettings& settings,
                         std::span<const Capsule> capsules, const MeshSdf* head,
                         const Scenery& scenery = {});

}  // namespace hair
