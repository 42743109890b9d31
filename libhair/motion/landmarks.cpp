#include <libhair/motion/landmarks.h>

#include <libhair/core/transform.h>

namespace hair {
namespace {

std::size_t index(int joint) {
  return static_cast<std::size_t>(joint);
}

/// Mean position of a joint's children and tip, relative to the joint; zero if it has none.
glm::vec3 childrenOf(const Body& body, int joint) {
  glm::vec3 sum = body.rest[index(joint)].rotation * body.skeleton.tips[index(joint)];
  float count = glm::length(sum) > 0 ? 1.0f : 0.0f;
  for (std::size_t j = 0; j < body.skeleton.jointCount(); ++j) {
    if (body.skeleton.parents[j] != joint) continue;
    sum += body.rest[j].translation - body.rest[index(joint)].translation;
    count += 1.0f;
  }
  return count > 0 ? sum / count : sum;
}

/// Of unit length; `otherwise` where v is no direction (a bone without length).
glm::vec3 directionOf(glm::vec3 v, glm::vec3 otherwise) {
  const float length = glm::length(v);
  return length > 1e-12f ? v / length : otherwise;
}

}  // namespace

glm::vec3 Landmarks::trunk(float t) const {
  // The spine's joints run along the back; flesh lies to both sides of a line before them.
  return glm::mix(pelvis, neck, t) + glm::vec3(0, 0, 0.012f * size);
}

Landmarks landmarksOf(const Body& body) {
  const auto at = [&](int j) { return body.rest[index(j)].translation; };
  Landmarks m;
  const BodyMap& map = body.map;
  m.size = body.size;
  m.neck = at(map.neck);
  m.head = at(map.head);
  if (map.neck == map.head) m.neck.y -= 0.09f * m.size;  // a rig without one
  for (std::size_t s = 0; s < 2; ++s) {
    m.shoulder[s] = at(map.upperArm[s]);
    m.elbow[s] = at(map.foreArm[s]);
    m.wrist[s] = at(map.hand[s]);
    glm::vec3 along = childrenOf(body, map.hand[s]);
    const glm::vec3 outwards(s == 0 ? 1.0f : -1.0f, 0, 0);  // as arms in the rest stance
    const glm::vec3 forearm = directionOf(m.wrist[s] - m.elbow[s], outwards);
    along = glm::length(along) > 0.01f * m.size ? glm::normalize(along) : forearm;
    // Thumbs pull the mean of the fingers aside.
    along = directionOf(along + forearm, forearm);
    m.knuckles[s] = m.wrist[s] + 0.085f * m.size * along;
    m.fingertips[s] = m.wrist[s] + 0.165f * m.size * along;
    const glm::vec3 flat(0, 0, 1);
    m.handFlat[s] = directionOf(flat - glm::dot(flat, along) * along, anyNormal(along));

    m.toes[s] = map.foot[s];
    for (std::size_t j = body.skeleton.jointCount(); j-- > 0;)
      if (body.skeleton.parents[j] == map.foot[s]) m.toes[s] = static_cast<int>(j);

    m.hip[s] = at(map.thigh[s]);
    m.knee[s] = at(map.shin[s]);
    m.ankle[s] = at(map.foot[s]);
    glm::vec3 front = childrenOf(body, map.foot[s]);
    front.y = 0;
    front = glm::length(front) > 0.02f * m.size ? glm::normalize(front) : glm::vec3(0, 0, 1);
    const float sole = m.ankle[s].y - 0.078f * m.size;
    const auto onSole = [&](float forward, float height) {
      glm::vec3 p = m.ankle[s] + forward * m.size * front;
      p.y = sole + height * m.size;
      return p;
    };
    m.heel[s] = onSole(-0.035f, 0.034f);
    m.ball[s] = onSole(0.118f, 0.028f);
    m.toe[s] = onSole(0.172f, 0.022f);
  }
  m.pelvis = 0.5f * (m.hip[0] + m.hip[1]);
  return m;
}

int trunkJointAt(const Body& body, glm::vec3 place) {
  int joint = body.map.hips;
  for (int j : body.map.spine)
    if (body.rest[index(j)].translation.y <= place.y) joint = j;
  return joint;
}

}  // namespace hair
