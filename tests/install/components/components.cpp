// One call into every library of the project, and an error that crosses from it to here.
#include <cstdio>
#include <vector>

#include <libhair/core/error.h>
#include <libhair/files/strand_file.h>
#ifdef WITH_MODEL
#include <libhair/files/obj.h>
#endif
#ifdef WITH_HAIR_MESH
#include <libhair/hair_mesh/grow.h>
#include <libhair/hair_mesh/operations.h>
#include <libhair/hair_mesh/scalp_patch.h>
#endif
#ifdef WITH_EMBREE
#include <libhair/measure/embree/embree_tracer.h>
#endif

namespace {

bool good = true;

void expect(bool condition, const char* what) {
  std::printf("%s: %s\n", what, condition ? "yes" : "NO");
  good = good && condition;
}

template <class Call>
bool throwsError(Call call) {
  try {
    call();
  } catch (const hair::Error&) {
    return true;
  }
  return false;
}

}  // namespace

int main() {
  hair::StrandSet strands;
  strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.1f, 0}});
  hair::writeStrands("two_points.data", strands);
  expect(hair::readStrands("two_points.data").strands.pointCount() == 2,
         "the core writes and reads strands");
  expect(throwsError([] { hair::readStrands("no such file.hair"); }),
         "errors of the core are caught");
#ifdef WITH_MODEL
  expect(hair::parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "text").triangles.size() == 1,
         "hair::model reads a triangle");
  expect(throwsError([] { hair::readObj("no such file"); }), "errors of hair::model are caught");
#endif
#ifdef WITH_HAIR_MESH
  hair::HairMesh mesh =
      hair::makeHairMesh(hair::sphereScalp({.rings = 2, .sectors = 8}, 0.095f, 100));
  const std::vector<std::uint32_t> faces{0, 1, 2};
  hair::extrudeFaces(faces, 0.05f, mesh);
  const std::vector<hair::StrandGroup> groups{{.strands = 20}};
  expect(hair::growHair(mesh, groups).strands.strandCount() > 0, "hair::hair_mesh grows strands");
  expect(throwsError([&] { hair::extrudeFaces(std::vector{1000u}, 0.05f, mesh); }),
         "errors of hair::hair_mesh are caught");
#endif
#ifdef WITH_EMBREE
  const auto tracer = hair::makeEmbreeTracer(strands, {.width = 1e-3f, .opacity = 1});
  const std::vector<hair::ShadowRay> rays{{{-1, 0.05f, 0}, {1, 0, 0}, 2, hair::kNoStrand}};
  std::vector<std::uint32_t> crossings(1);
  tracer->countCrossings(rays, crossings);
  expect(crossings[0] == 1, "hair::embree meets a strand");
  crossings.clear();
  expect(throwsError([&] { tracer->countCrossings(rays, crossings); }),
         "errors of hair::embree are caught");
#endif
  return good ? 0 : 1;
}
