#include "targets.h"

#include <cstdlib>
#include <iostream>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/files/data_file.h>
#include <libhair/files/hair_file.h>
#include <libhair/files/tfx_file.h>
#ifdef HAIR_WITH_MODEL
#include <libhair/files/obj.h>
#endif

namespace hair {

namespace {

// What a reader promises of whatever it returns; a broken promise ends the program, as the
// sanitizers do.
void promise(bool kept, const char* what) {
  if (kept) return;
  std::cerr << "broken promise: " << what << '\n';
  std::abort();
}

template <class Read>
bool readOrError(Read&& read) {
  try {
    read();
    return true;
  } catch (const Error& e) {
    promise(std::string_view(e.what()).starts_with("fuzz: "), "an error names its file");
    return false;
  }
}

void promiseStrands(const StrandSet& strands, std::size_t minPoints) {
  promise(strands.strandCount() > 0, "there are strands");
  promise(strands.first.back() == strands.pointCount(), "offsets end at the point count");
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    promise(strands.first[s] + minPoints <= strands.first[s + 1], "offsets are monotone");
  for (glm::vec3 p : strands.points)
    promise(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "points are finite");
}

}  // namespace

bool fuzzHair(std::string_view bytes) {
  return readOrError([&] {
    const HairFile hair = parseHair(bytes, "fuzz");
    promiseStrands(hair.strands, 1);
    for (std::size_t n : {hair.thickness.size(), hair.transparency.size(), hair.colours.size()})
      promise(n == 0 || n == hair.strands.pointCount(), "one item a point");
  });
}

bool fuzzTfx(std::string_view bytes) {
  return readOrError([&] {
    const TfxFile tfx = parseTfx(bytes, "fuzz");
    promiseStrands(tfx.strands, 4);
    promise(tfx.pinned.size() == tfx.strands.pointCount(), "one flag a point");
    promise(tfx.strandUv.empty() || tfx.strandUv.size() == tfx.strands.strandCount(),
            "one UV a strand");
  });
}

bool fuzzData(std::string_view bytes) {
  return readOrError([&] { promiseStrands(parseData(bytes, "fuzz"), 0); });
}

bool fuzzBvh(std::string_view bytes) {
  return readOrError([&] {
    const Bvh bvh = parseBvh(bytes, "fuzz");
    std::size_t channels = 0;
    for (std::size_t j = 0; j < bvh.joints.size(); ++j) {
      const Bvh::Joint& joint = bvh.joints[j];
      promise(joint.parent < static_cast<int>(j), "parents come before children");
      promise(
          joint.channels.empty() || joint.firstChannel + joint.channels.size() <= bvh.channelCount,
          "channels lie in the row");
      channels += joint.channels.size();
    }
    promise(channels == bvh.channelCount, "channels are counted");
    promise(bvh.values.size() == bvh.frameCount() * bvh.channelCount, "rows are whole");
  });
}

#ifdef HAIR_WITH_MODEL
bool fuzzObj(std::string_view bytes) {
  return readOrError([&] {
    const TriangleMesh mesh = parseObj(bytes, "fuzz");
    promise(mesh.normals.size() == mesh.positions.size(), "one normal a vertex");
    for (glm::uvec3 t : mesh.triangles)
      for (int k = 0; k < 3; ++k) promise(t[k] < mesh.positions.size(), "corners exist");
  });
}
#endif

}  // namespace hair
