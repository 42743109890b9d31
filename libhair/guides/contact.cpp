#include <libhair/guides/contact.h>

#include <cmath>

namespace hair {

void appendBoxes(std::span<const Capsule> capsules, std::span<const Capsule> before, float reach,
                 std::vector<CapsuleBoxes>& boxes) {
  for (std::size_t first = 0; first < capsules.size(); first += kLanes) {
    const Lanes far = lanes(INFINITY);
    CapsuleBoxes box{{far, far, far}, {-far, -far, -far}, {far, far, far}, {-far, -far, -far}};
    for (std::size_t l = 0; l < kLanes && first + l < capsules.size(); ++l) {
      const Capsule &c = capsules[first + l], &b = before[first + l];
      const glm::vec3 moveA = c.a - b.a, moveB = c.b - b.b;
      const float growth = std::abs(c.radius - b.radius);
      setLane(box.lower, l, glm::min(c.a, c.b) - (c.radius + reach));
      setLane(box.upper, l, glm::max(c.a, c.b) + (c.radius + reach));
      setLane(box.leastMove, l, glm::min(moveA, moveB) - growth);
      setLane(box.mostMove, l, glm::max(moveA, moveB) + growth);
    }
    boxes.push_back(box);
  }
}

}  // namespace hair
