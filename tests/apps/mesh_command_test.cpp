// hair mesh: scripts to files, and what is said of them.
#include <gtest/gtest.h>

#include <libhair/files/strand_file.h>
#include <libhair/hair_mesh/hair_mesh_file.h>
#include <tests/apps/outcome.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

constexpr const char* kScript =
    "scalp sphere 0.1 2 8   # a cap\n"
    "drape all 5 length 0.2\n"
    "group strands 300 points 12\n"
    "group strands 50 points 12 seed 2 frizz 0.002\n";

TEST(MeshCommand, AScriptBecomesAMeshAndItsStrands) {
  const TemporaryFolder folder;
  const std::string script = folder.write("a.hairmesh", kScript).string();
  const std::string obj = (folder / "a.obj").string(), hair = (folder / "a.hair").string();
  const Outcome made = run("mesh apply " + script + " --out " + obj + " --hair " + hair);
  EXPECT_EQ(made.code, 0);
  EXPECT_EQ(made.out, obj + ": 16 bundles, 6 layers, 102 vertices\n" + hair +
                          ": 350 strands, 4200 points, groups: 2\n");
  const HairMesh mesh = readHairMesh(obj);
  EXPECT_EQ(mesh.bundleCount(), 16u);
  const StrandFile strands = readStrands(hair);
  EXPECT_EQ(strands.strands.strandCount(), 350u);

  const Outcome told = run("mesh info " + obj);
  EXPECT_EQ(told.code, 0);
  EXPECT_NE(told.out.find("bundles       16\n"), std::string::npos) << told.out;
  // All of five tips, of five rings of side quads of eight, and the scalp.
  EXPECT_NE(told.out.find("vertices      102: 66 exterior, 36 interior\n"), std::string::npos)
      << told.out;
  const Outcome ofScript = run("mesh info " + script);
  EXPECT_NE(ofScript.out.find("group         50 strands of 12 points\n"), std::string::npos)
      << ofScript.out;
}

TEST(MeshCommand, ErrorsAreOneLineAndLeaveNoFile) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("a.hairmesh", "scalp sphere 0.1 2 8\nextrude\n").string();
  const std::string obj = (folder / "a.obj").string();
  const Outcome broken = run("mesh apply " + bad + " --out " + obj);
  EXPECT_EQ(broken.code, 1);
  EXPECT_EQ(broken.out,
            "hair: " + bad + ": line 2: a selection is missing at the end of the line\n");
  const std::string none = folder.write("b.hairmesh", "scalp sphere 0.1 2 8\n").string();
  const Outcome bald =
      run("mesh apply " + none + " --out " + obj + " --hair " + (folder / "b.hair").string());
  EXPECT_EQ(bald.code, 1);
  EXPECT_NE(bald.out.find("`group strands N`"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(obj));
  const Outcome usage = run("mesh apply " + bad);
  EXPECT_EQ(usage.code, 2);
  EXPECT_EQ(usage.out, "hair mesh apply: --out is required; hair mesh apply --help tells more\n");
  EXPECT_EQ(run("mesh").code, 2);
}

}  // namespace
}  // namespace hair
