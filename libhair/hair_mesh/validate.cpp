#include <libhair/hair_mesh/hair_mesh.h>

namespace hair {

std::string whyInvalid(const HairMesh&) {
  return {};
}

}  // namespace hair
