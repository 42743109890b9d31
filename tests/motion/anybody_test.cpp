// One person in every spelling of a motion file that the generator knows: always the same person.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/motion/body.h>
#include <libhair/motion/motion.h>

#include "bvh_generator.h"

namespace hair {
namespace {

using test::Act;
using test::Rig;
using test::Spelling;

constexpr double kNobodysUnit = test::kStature / 45;  // 45 units a person

double degreesApart(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(
      std::acos(glm::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0)));
}

glm::dvec3 turnedAboutUp(glm::dvec3 p, double angle) {
  return {std::cos(angle) * p.x + std::sin(angle) * p.z, p.y,
          std::cos(angle) * p.z - std::sin(angle) * p.x};
}

/// How far a motion is from what the generator meant, up to a turn about the vertical.
struct Off {
  double metres = 0, headDegrees = 0, limbDegrees = 0;
};

Off offOf(const Motion& motion, const Spelling& s, double scale) {
  const auto& names = motion.clip().skeleton.names;
  std::vector<int> jointOf;
  for (int part = 0; part < test::kParts; ++part) {
    const auto found = std::find(names.begin(), names.end(), test::nameOf(s, test::Part(part)));
    jointOf.push_back(found == names.end() ? -1 : static_cast<int>(found - names.begin()));
  }
  double yaw = 0;
  Off off;
  for (int f = static_cast<int>(motion.droppedFrames()); f < test::kFrames; ++f) {
    const test::PersonPose want = test::poseOf(s.act, f);
    const BodyPose got =
        motion.pose((f - static_cast<int>(motion.droppedFrames())) * motion.clip().frameTime);
    const auto at = [&](int part) {
      return glm::dvec3(
          got.worldFromJoint[static_cast<std::size_t>(jointOf[static_cast<std::size_t>(part)])]
              .translation);
    };
    if (f == static_cast<int>(motion.droppedFrames())) {
      const glm::dvec3 a = want.places[test::kLeftHip] - want.places[test::kRightHip];
      const glm::dvec3 b = at(test::kLeftHip) - at(test::kRightHip);
      yaw = std::atan2(a.z, a.x) - std::atan2(b.z, b.x);
    }
    for (int part = 0; part < test::kParts; ++part)
      if (jointOf[static_cast<std::size_t>(part)] >= 0)
        off.metres = std::max(
            off.metres,
            glm::distance(at(part),
                          turnedAboutUp(scale * want.places[static_cast<std::size_t>(part)], yaw)));
    for (int part = test::kLeftShoulder; part < test::kParts; ++part) {
      // How each part of the body is turned from its rest stance, a T.
      const int j = jointOf[static_cast<std::size_t>(part)];
      if (part == test::kRightCollar || j < 0) continue;
      const glm::quat turn =
          got.worldFromJoint[static_cast<std::size_t>(j)].rotation *
          glm::conjugate(motion.body().rest[static_cast<std::size_t>(j)].rotation);
      for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
        off.limbDegrees = std::max(
            off.limbDegrees,
            degreesApart(
                glm::dvec3(turn * axis),
                turnedAboutUp(want.turns[static_cast<std::size_t>(part)] * glm::dvec3(axis), yaw)));
    }
    const glm::dvec3 up(got.worldFromHead.vector({0, 1, 0})),
        front(got.worldFromHead.vector({0, 0, 1}));
    off.headDegrees = std::max({off.headDegrees, degreesApart(up, turnedAboutUp(want.headUp, yaw)),
                                degreesApart(front, turnedAboutUp(want.headFront, yaw))});
  }
  return off;
}

void expectTheSamePerson(const Spelling& s) {
  SCOPED_TRACE(
      s.what + " act " + std::to_string(int(s.act)) + " rig " + std::to_string(int(s.rig)) +
      " names " + std::to_string(s.names) + " up " + std::to_string(s.up) + " text " +
      std::to_string(int(s.text)) + " positions " + std::to_string(int(s.positions)) + " unit " +
      std::to_string(s.unit) + (s.noNeck ? " no neck" : "") + (s.rootAbove ? " root above" : "") +
      (s.moreSpine ? " more spine" : "") + (s.eyes ? " eyes" : "") + (s.hairBones ? " hair" : "") +
      (s.noTips ? " no tips" : "") + (s.rigStandsSo ? " rig stands so" : ""));
  const std::string bytes = test::bvhOf(s);
  try {
    const Motion motion(parseBvh(bytes, "a.bvh"));
    const BodyMap& map = motion.body().map;
    const auto& names = motion.clip().skeleton.names;
    const auto expectJoint = [&](int joint, test::Part part) {
      EXPECT_EQ(joint < 0 ? "none" : names[static_cast<std::size_t>(joint)], test::nameOf(s, part));
    };
    ASSERT_TRUE(map.complete()) << motion.notes().front();
    expectJoint(map.head, test::kHead);
    for (int side : {0, 1}) {
      const auto of = [&](test::Part left, test::Part right) { return side == 0 ? left : right; };
      const auto i = static_cast<std::size_t>(side);
      expectJoint(map.upperArm[i], of(test::kLeftShoulder, test::kRightShoulder));
      expectJoint(map.foreArm[i], of(test::kLeftElbow, test::kRightElbow));
      expectJoint(map.hand[i], of(test::kLeftWrist, test::kRightWrist));
      expectJoint(map.thigh[i], of(test::kLeftHip, test::kRightHip));
      expectJoint(map.shin[i], of(test::kLeftKnee, test::kRightKnee));
      expectJoint(map.foot[i], of(test::kLeftAnkle, test::kRightAnkle));
    }
    EXPECT_EQ(motion.clip().frameCount() + motion.droppedFrames(), std::size_t(test::kFrames));
    EXPECT_NEAR(motion.clip().frameTime, 1.0 / 30, 1e-6);
    // A unit that nobody uses is that of a person of 1.7 m.
    const bool known = s.unit != kNobodysUnit;
    const Off off = offOf(motion, s, known ? 1.0 : 1.7 / test::kStature);
    EXPECT_LT(off.metres, known ? 1e-4 : 0.01);
    EXPECT_LT(off.headDegrees, 3.0);
    // Where the zero pose stands with its arms down, that is the rest stance.
    if (s.rig != Rig::A && s.rig != Rig::ArmsDown) {
      EXPECT_LT(off.limbDegrees, 3.0);
    }
    EXPECT_EQ(motion.notes().front(), "person " + motion.person());
  } catch (const Error& error) {
    ADD_FAILURE() << error.what();
  }
}

const double kUnits[] = {0.01, 1, 0.001, 0.0254, 0.0254 / 0.45, kNobodysUnit};

TEST(Anybody, OfEveryUnitIsAPerson) {
  for (double unit : kUnits) expectTheSamePerson({.what = "unit", .unit = unit});
}

TEST(Anybody, StandsAlongEveryAxis) {
  for (int up = 0; up < 6; ++up)
    for (bool rig : {false, true})
      for (double yaw : {0.0, 100.0})
        expectTheSamePerson({.what = "axis", .up = up, .rigStandsSo = rig, .yaw = yaw});
}

TEST(Anybody, IsKnownByEveryName) {
  for (int names = 0; names < test::kNameCount; ++names) {
    expectTheSamePerson({.what = "names", .names = names});
    expectTheSamePerson({.what = "names",
                         .names = names,
                         .fingers = true,
                         .eyes = true,
                         .twists = true,
                         .toes = true});
  }
}

TEST(Anybody, LooksWhereTheRigLooksWhateverItDoes) {
  for (int act = 0; act < test::kActCount; ++act)
    for (int rig = 0; rig < test::kRigCount; ++rig)
      expectTheSamePerson({.what = "rig", .act = Act(act), .rig = Rig(rig), .seed = 5});
}

TEST(Anybody, SpeaksEveryDialect) {
  for (int t = 0; t < test::kTextCount; ++t)
    expectTheSamePerson({.what = "text", .text = Spelling::Text(t)});
  for (int p = 0; p < 4; ++p)
    expectTheSamePerson({.what = "positions", .positions = Spelling::Positions(p)});
  for (int order = 0; order < 6; ++order)
    expectTheSamePerson({.what = "order", .rotationOrder = order});
}

TEST(Anybody, HasWhatOthersHaveNot) {
  expectTheSamePerson({.what = "root", .rootAbove = true});
  expectTheSamePerson({.what = "targets", .targets = true});
  expectTheSamePerson({.what = "hair", .hairBones = true});
  expectTheSamePerson({.what = "spine", .moreSpine = true});
  expectTheSamePerson({.what = "no neck", .noNeck = true});
  expectTheSamePerson({.what = "no tips", .noTips = true});
  expectTheSamePerson({.what = "no tips", .rig = Rig::XBones, .noTips = true});
}

// Everything at once, by chance.
TEST(Anybody, InRandomSpellingsIsTheSame) {
  std::uint32_t use = 0;
  const auto below = [&](std::uint32_t n) {
    std::uint32_t h = (++use) * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28) + 4)) ^ h) * 277803737u;
    return ((h >> 22) ^ h) % n;
  };
  for (std::uint32_t i = 0; i < 150; ++i) {
    Spelling s{.what = "random " + std::to_string(i)};
    s.act = Act(below(test::kActCount));
    s.unit = kUnits[below(6)];
    s.rig = Rig(below(test::kRigCount));
    s.names = int(below(test::kNameCount));
    s.seed = below(1000);
    s.rotationOrder = int(below(6));
    // On all fours, in a rig that lies as well, nobody can tell another axis from another way to
    // be.
    if (s.act == Act::Crawl && s.rig == Rig::Lying) s.rig = Rig::T;
    if (s.act == Act::Walk || s.act == Act::Bow) {
      s.up = int(below(6));
      s.rigStandsSo = below(2) == 0;
    }
    s.yaw = below(360);
    s.rootAbove = below(3) == 0;
    s.fingers = below(2) == 0;
    s.eyes = below(2) == 0;
    s.twists = below(3) == 0 && s.names < test::kTellingNames;
    s.targets = below(3) == 0;
    s.toes = below(2) == 0;
    s.moreSpine = below(3) == 0;
    s.positions = Spelling::Positions(below(4));
    s.text = Spelling::Text(below(test::kTextCount));
    expectTheSamePerson(s);
  }
}

TEST(Anybody, IsAsTheUserSays) {
  const Bvh bvh = parseBvh(test::bvhOf({.what = "user"}), "a.bvh");
  MotionSettings settings;
  settings.scale = 0.02f;
  settings.up = ClipUp::Z;
  const Motion large(bvh, settings);
  EXPECT_EQ(large.person(), "3.41 m tall, 0.02 m per unit, +Z up, head joint Head");
  ASSERT_EQ(large.notes().size(), 2u);
  EXPECT_NE(large.notes()[1].find("0.01 m per unit"), std::string::npos) << large.notes()[1];
  EXPECT_EQ(Motion(bvh).person(), "1.71 m tall, 0.01 m per unit, +Y up, head joint Head");
  settings = {};
  settings.headJoint = "neck";  // any case
  EXPECT_EQ(Motion(bvh, settings).body().map.head, Motion(bvh).body().map.neck);
  settings.headJoint = "Helm";
  try {
    Motion wrong(bvh, settings);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Helm"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("LeftKnee"), std::string::npos) << error.what();
  }
  EXPECT_EQ(clipUpFromText("-Z"), ClipUp::ZDown);
  EXPECT_EQ(clipUpFromText("y-down"), ClipUp::YDown);
  EXPECT_EQ(clipUpFromText("X"), ClipUp::X);
  EXPECT_THROW(clipUpFromText("w"), Error);
}

}  // namespace
}  // namespace hair
