#include "targets.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/files/data_file.h>
#include <libhair/files/hair_file.h>
#include <libhair/files/numpy/npz_strands.h>
#include <libhair/files/obj_strands.h>
#include <libhair/files/pbrt_file.h>
#include <libhair/files/ply_file.h>
#include <libhair/files/tfx_file.h>
#include <libhair/files/usda/usda_file.h>
#include <libhair/files/usda/usda_write.h>
#include <libhair/motion/motion.h>
#ifdef HAIR_WITH_MODEL
#include <libhair/files/obj.h>
#endif
#ifdef HAIR_WITH_HAIR_MESH
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <libhair/hair_mesh/script/script.h>
#endif

#include "promise.h"

namespace hair {

namespace {

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

// In the file's units, which are not the library's yet.
void promiseStrandFile(const StrandFile& file, std::size_t minPoints) {
  promiseStrands(file.strands, minPoints);
  promise(file.scale > 0 && file.up != UpAxis::AsFile, "units are known");
  for (std::size_t n : {file.thickness.size(), file.transparency.size(), file.colours.size()})
    promise(n == 0 || n == file.strands.pointCount(), "one item a point");
}

std::string bytesOf(void (*write)(std::ostream&, const StrandFile&), const StrandFile& file) {
  std::ostringstream out;
  write(out, file);
  return out.str();
}

// What was read is written and read again; but coordinates that are beyond all scales are not
// written.
void promiseTheWayBack(const HairFile& hair) {
  std::string bytes;
  try {
    bytes = hairBytes(hair);
  } catch (const Error& e) {
    promise(std::string_view(e.what()).find("check the scale") != std::string_view::npos,
            "only a wrong scale is no .hair file");
    return;
  }
  promise(hairBytes(parseHair(bytes, "fuzz")) == bytes, "what is written is read");
}

}  // namespace

bool fuzzHair(std::string_view bytes) {
  return readOrError([&] {
    const HairFile hair = parseHair(bytes, "fuzz");
    promiseStrands(hair.strands, 1);
    promiseTheWayBack(hair);
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

bool fuzzPly(std::string_view bytes) {
  return readOrError([&] {
    const StrandFile file = parsePly(bytes, "fuzz");
    promiseStrandFile(file, 1);
    const std::string written = bytesOf(writePly, file);
    promise(bytesOf(writePly, parsePly(written, "fuzz")) == written, "what is written is read");
  });
}

bool fuzzLines(std::string_view bytes) {
  return readOrError([&] {
    const StrandFile file = parseObjStrands(bytes, "fuzz");
    promiseStrandFile(file, 1);
    const std::string written = bytesOf(writeObjStrands, file);
    promise(bytesOf(writeObjStrands, parseObjStrands(written, "fuzz")) == written,
            "what is written is read");
  });
}

bool fuzzUsda(std::string_view bytes) {
  return readOrError([&] {
    std::istringstream stream{std::string(bytes)};
    UsdaReader reader(stream, "fuzz");
    StrandFile file;
    for (std::size_t f = 0; f < std::min<std::size_t>(reader.frameCount(), 20); ++f) {
      promise(!std::isnan(reader.seconds(f)), "a frame is some time");
      reader.read(f, file);
      promiseStrandFile(file, 0);
    }
    const std::string written = bytesOf(writeUsda, file);
    std::istringstream again(written);
    UsdaReader rereader(again, "fuzz");
    StrandFile reread;
    rereader.read(0, reread);
    promise(
        reread.strands.first == file.strands.first && reread.strands.points == file.strands.points,
        "what is written is read");
  });
}

bool fuzzNumpy(std::string_view bytes) {
  return readOrError([&] { promiseStrandFile(parseNumpy(bytes, "fuzz"), 0); });
}

bool fuzzPbrt(std::string_view bytes) {
  return readOrError([&] { promiseStrandFile(parsePbrt(bytes, "fuzz"), 2); });
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

bool fuzzClip(std::string_view bytes) {
  const auto finite = [](glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  const auto promiseFrame = [&](const RigidTransform& t) {
    promise(finite(t.translation) && std::abs(glm::length(t.rotation) - 1) < 1e-3f,
            "joints are somewhere and turned somehow");
  };
  try {
    const Bvh bvh = parseBvh(bytes, "fuzz");
    // In centimetres, and in the unit and axes that are recognised.
    for (const Motion& motion : {Motion(clipFromBvh(bvh)), Motion(bvh)})
      for (const double part : {0.0, 0.4, 1.0}) {
        const BodyPose pose = motion.pose(part * motion.duration());
        promiseFrame(pose.worldFromHead);
        for (const RigidTransform& joint : pose.worldFromJoint) promiseFrame(joint);
        for (const Capsule& c : pose.capsules)
          promise(finite(c.a) && finite(c.b) && c.radius >= 0, "capsules have a size");
      }
    return true;
  } catch (const Error&) {
    return false;
  }
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

#ifdef HAIR_WITH_HAIR_MESH
bool fuzzMesh(std::string_view bytes) {
  return readOrError([&] {
    const HairMesh mesh = parseHairMesh(bytes, "fuzz");
    promise(whyInvalid(mesh).empty(), "a mesh that is read is valid");
    const std::string written = hairMeshBytes(mesh);
    promise(hairMeshBytes(parseHairMesh(written, "fuzz")) == written, "what is written is read");
  });
}

bool fuzzScript(std::string_view bytes) {
  const auto file = [](const std::string&) {
    return std::string("v 0 0.3 0\nv 0 0.3 1\nv 1 0.3 0\nv 1 0.3 1\nf 1 2 3\nf 3 2 4\n");
  };
  return readOrError([&] {
    const Hairstyle style = applyScript(parseHairMeshScript(bytes, "fuzz"), file,
                                        {.lines = 30, .corners = 400, .work = 8000});
    promise(whyInvalid(style.mesh).empty(), "a mesh that a script makes is valid");
  });
}
#endif

}  // namespace hair
