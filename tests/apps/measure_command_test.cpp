// hair measure-motion, hair plan: what scripts read of them.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tests/apps/outcome.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

TEST(MeasureMotion, WritesARowASetting) {
  const TemporaryFolder folder;
  const auto csv = folder / "motion.csv", plot = folder / "motion.svg";
  const Outcome outcome =
      run("measure-motion --strands 200 --frames 3 --settle 0.05 --reference 4 --substeps 1,4 "
          "--iterations 3 --relaxation 5 --guide-counts 30,10 --csv " +
          csv.string() + " --plot " + plot.string());
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  const auto lines = linesOf(csv);
  ASSERT_EQ(lines.size(), 11u);
  EXPECT_EQ(lines[0],
            "what,substeps,iterations,guides,tip_early_mm,tip_rms_mm,tip_late_mm,tip_max_mm,"
            "stretch_max,penetration_max_mm,guides_ms,wisps_ms");
  const std::vector<std::string> starts = {"half of reference,4,2,402,",
                                           "twin,8,2,402,",
                                           "substeps,1,2,402,",
                                           "substeps,4,2,402,",
                                           "substeps,8,3,402,",
                                           "relaxation,8,5,402,",
                                           "all guides,8,2,402,0,0,0,0,",
                                           "all guides twin,8,2,402,",
                                           "bound to,8,2,30,",
                                           "bound to,8,2,10,"};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_TRUE(lines[i + 1].starts_with(starts[i])) << lines[i + 1];
    EXPECT_EQ(fieldsOf(lines[i + 1]).size(), 12u) << lines[i + 1];
  }
  // The same on the screen.
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 17) << outcome.out;
  // A marker a setting in each of two panels, and the legend's.
  const auto svg = linesOf(plot);
  EXPECT_EQ(std::ranges::count_if(
                svg, [](const auto& l) { return l.find("width=\"7\"") != std::string::npos; }),
            2 * 4 + 3);
}

TEST(Plan, WritesARowAFeature) {
  const TemporaryFolder folder;
  const auto csv = folder / "plan.csv";
  const std::string scene = "plan --strands 200 --frames 10 --settle 0.05 --cells 32 ";
  const Outcome outcome = run(scene + "--csv " + csv.string());
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  const auto lines = linesOf(csv);
  ASSERT_GE(lines.size(), 3u);
  EXPECT_EQ(lines[0],
            "feature,own_ms,saved_ms,saved_ms_error,saved_percent,saved_mb,moved_mm,recoloured,"
            "relit,advice");
  EXPECT_TRUE(lines[1].starts_with("everything,,")) << lines[1];
  const auto has = [&](const std::string& feature) {
    return std::ranges::any_of(lines, [&](const auto& l) { return l.starts_with(feature + ','); });
  };
  for (const char* feature : {"self-collision", "light's map", "wisps", "shading", "contact"})
    EXPECT_TRUE(has(feature)) << feature << '\n' << outcome.out;
  EXPECT_FALSE(has("wind"));
  for (std::size_t i = 2; i < lines.size(); ++i)
    EXPECT_GE(fieldsOf(lines[i]).size(), 10u) << lines[i];
  EXPECT_NE(outcome.out.find("recolours"), std::string::npos);

  // What the options leave out is not there to be left out.
  const Outcome less = run(scene + "--no-shadow --no-self-collision --wind 1,0,0");
  ASSERT_EQ(less.code, 0) << less.out;
  EXPECT_EQ(less.out.find("light's map"), std::string::npos) << less.out;
  EXPECT_NE(less.out.find("wind "), std::string::npos) << less.out;
}

TEST(MeasureCommands, ExitCodesTellBadInputFromBadUsage) {
  const std::pair<std::string, int> cases[] = {
      {"measure-motion --help", 0},
      {"plan --help", 0},
      {"measure-motion --substeps 0", 2},
      {"measure-motion --substeps 1,x", 2},
      {"measure-motion --iterations 33", 2},
      {"measure-motion --relaxation 0", 2},
      {"measure-motion --solver guess", 2},
      {"measure-motion --guide-counts 0", 2},
      {"measure-motion --frames 0", 2},
      {"measure-motion --csv motion.txt", 2},
      {"measure-motion --csv /nowhere/motion.csv", 1},
      {"measure-motion --reference 5 --frames 1 --settle 0", 1},
      {"measure-motion --hair /nowhere.hair", 1},
      {"plan --frames 9", 2},
      {"plan --csv plan.json", 2},
      {"plan --style bald", 2},
      {"plan --motion /nowhere.bvh", 1},
  };
  for (const auto& [arguments, code] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << "hair " << arguments << '\n' << outcome.out;
  }
}

}  // namespace
}  // namespace hair
