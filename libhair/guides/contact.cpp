#include <libhair/guides/contact.h>

namespace hair {

void appendBoxes(std::span<const Capsule> capsules, float reach, std::vector<CapsuleBoxes>& boxes) {
  for (std::size_t first = 0; first < capsules.size(); first += kLanes) {
    const Lanes far = lanes(INFINITY);
    CapsuleBoxes box{{far, far, far}, {-far, -far, -far}};
    for (std::size_t l = 0; l < kLanes && first + l < capsules.size(); ++l) {
      const Capsule& c = capsules[first + l];
      setLane(box.lower, l, glm::min(c.a, c.b) - (c.radius + reach));
      setLane(box.upper, l, glm::max(c.a, c.b) + (c.radius + reach));
    }
    boxes.push_back(box);
  }
}

}  // namespace hair
