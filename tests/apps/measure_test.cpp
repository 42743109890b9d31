// `hair measure` as scripts see it: columns, the same figures twice, a page that needs nothing
// else.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <libhair/files/strand_file.h>
#include <tests/apps/outcome.h>
#include <tests/files/samples.h>
#include <tests/measure/scene.h>

namespace hair {
namespace {

using Row = std::vector<std::string>;

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Row> table(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    Row row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (line.ends_with(',')) row.emplace_back();
    rows.push_back(row);
  }
  return rows;
}

class Measure : public testing::Test {
 protected:
  Measure() { writeStrands(folder / "hair.hair", hair); }
  Outcome measure(const std::string& arguments) const {
    return run("measure --hair " + (folder / "hair.hair").string() +
               " --width 0.5e-3 --samples 60 --rays 64 --repeats 1 --methods quick " + arguments);
  }
  std::string name(const std::string& file) const { return (folder / file).string(); }

  const TemporaryFolder folder;
  const StrandSet hair = hangingHair(200);
};

TEST_F(Measure, TheDumpHasTheColumnsThatItPromises) {
  ASSERT_EQ(measure("--flicker-steps 0 --dump " + name("d.csv")).code, 0);
  const auto rows = table(folder / "d.csv");
  ASSERT_EQ(rows.size(), 61u);
  const Row& head = rows[0];
  const Row fixed = {"strand", "point", "x", "y", "z", "truth", "truth_se"};
  ASSERT_EQ(head.size(), 14u);
  EXPECT_TRUE(std::equal(fixed.begin(), fixed.end(), head.begin()));
  EXPECT_EQ(head[7], "auto");
  EXPECT_TRUE(head[8].starts_with("density map ")) << head[8];
  EXPECT_TRUE(head[13].starts_with("deep shadow map ")) << head[13];
  for (std::size_t r = 1; r < rows.size(); ++r) {
    ASSERT_EQ(rows[r].size(), head.size());
    // The point is the one that strand and point name in the file, to the last bit.
    const auto strand = static_cast<std::size_t>(std::stoul(rows[r][0]));
    const auto point = static_cast<std::size_t>(std::stoul(rows[r][1]));
    EXPECT_GT(point, hair.first[strand]);
    EXPECT_LT(point, hair.first[strand + 1]);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(std::stof(rows[r][2 + c]), hair.points[point][static_cast<int>(c)]);
    for (std::size_t c = 5; c < rows[r].size(); ++c) {
      EXPECT_GE(std::stof(rows[r][c]), 0);
      EXPECT_LE(std::stof(rows[r][c]), 1);
    }
  }
}

TEST_F(Measure, StrandsOfTheDumpCountThoseThatWereDropped) {
  StrandSet withStub;
  withStub.append(std::vector<glm::vec3>{{0, 0, 0}});  // no strand, but it counts in the file
  for (std::size_t s = 0; s < hair.strandCount(); ++s) withStub.append(hair.strand(s));
  writeStrands(folder / "hair.hair", withStub);
  ASSERT_EQ(measure("--flicker-steps 0 --strands 50 --dump " + name("d.csv")).code, 0);
  const auto rows = table(folder / "d.csv");
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const auto strand = static_cast<std::size_t>(std::stoul(rows[r][0]));
    const auto point = static_cast<std::size_t>(std::stoul(rows[r][1]));
    EXPECT_GT(point, withStub.first[strand]);
    EXPECT_LT(point, withStub.first[strand + 1]);
    EXPECT_EQ(std::stof(rows[r][2]), withStub.points[point].x);
  }
}

TEST_F(Measure, TheTableHasARowAMethodSettingLightAndFootprint) {
  ASSERT_EQ(measure("--light 0,-1,0 --light 0.5,-0.8,0.35 --point 0.3,0.5,0.2 --footprint 3e-3 "
                    "--footprint 6e-3 --flicker-steps 0 --csv " +
                    name("t.csv"))
                .code,
            0);
  const auto rows = table(folder / "t.csv");
  ASSERT_EQ(rows.size(), 1u + 3 * 2 * 7);
  const Row head = {
      "light",    "light_x",  "light_y",     "light_z",  "footprint_m", "method",
      "settings", "mean_abs", "mean_abs_se", "rms",      "rms_se",      "p99",
      "p99_se",   "bias",     "bias_se",     "build_ms", "sample_ms",   "sample_ns_per_point",
      "bytes",    "pareto",   "shimmer",     "swim"};
  EXPECT_EQ(rows[0], head);
  for (const Row& row : rows) EXPECT_EQ(row.size(), head.size());
  EXPECT_EQ((Row{rows[1].begin(), rows[1].begin() + 6}),
            (Row{"parallel", "0", "-1", "0", "0.003", "auto"}));
  EXPECT_EQ((Row{rows[42].begin(), rows[42].begin() + 6}),
            (Row{"point", "0.3", "0.5", "0.2", "0.006", "deep shadow map"}));
}

TEST_F(Measure, ARepeatGivesTheSameErrorsBitForBit) {
  ASSERT_EQ(
      measure("--flicker-steps 3 --threads 1 --csv " + name("a.csv") + " --dump " + name("ad.csv"))
          .code,
      0);
  ASSERT_EQ(
      measure("--flicker-steps 3 --threads 3 --csv " + name("b.csv") + " --dump " + name("bd.csv"))
          .code,
      0);
  EXPECT_EQ(contents(folder / "ad.csv"), contents(folder / "bd.csv"));
  auto a = table(folder / "a.csv"), b = table(folder / "b.csv");
  for (auto* rows : {&a, &b})
    for (Row& row : *rows)
      for (const std::size_t timed : {15u, 16u, 17u, 18u, 19u}) row[timed].clear();
  EXPECT_EQ(a, b);
  EXPECT_FALSE(a[1][20].empty()) << "flicker was not measured";
  ASSERT_EQ(measure("--flicker-steps 0 --seed 2 --dump " + name("cd.csv")).code, 0);
  EXPECT_NE(contents(folder / "ad.csv"), contents(folder / "cd.csv"));
}

TEST_F(Measure, ThePageNeedsNothingElseAndHoldsEverySection) {
  const Outcome outcome = measure("--flicker-steps 2 --html " + name("r.html"));
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  const std::string page = contents(folder / "r.html");
  for (const char* foreign : {"http", "<script", "src=", "@import", "url("})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
  for (const char* section :
       {"<h3>Error against time</h3>", "<h3>All settings</h3>", "<h3>Visibility along one ray</h3>",
        "<h3>Differences from the truth</h3>", "<h3>Temporal flicker</h3>", "How to repeat it</h2>",
        "Pareto front", "hair measure --hair", "<dt>Version</dt>", "<dt>CPU</dt>",
        "<dt>Threads</dt>", "<dt>Seed</dt>"})
    EXPECT_NE(page.find(section), std::string::npos) << section;
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_EQ(page.find("nan"), std::string::npos);
  // Every element that is opened is closed.
  for (const std::string tag : {"svg", "table", "tr", "td", "g", "text", "p", "div", "dl"}) {
    const auto count = [&](const std::string& word) {
      std::size_t n = 0;
      for (std::size_t at = page.find(word); at != std::string::npos; at = page.find(word, at + 1))
        ++n;
      return n;
    };
    EXPECT_EQ(count('<' + tag + '>') + count('<' + tag + ' '), count("</" + tag + '>')) << tag;
  }
}

TEST_F(Measure, OneMethodAndOneSampleAreEnoughForAPage) {
  const Outcome outcome =
      run("measure --hair " + name("hair.hair") +
          " --samples 1 --rays 2 --repeats 1 --methods deep-shadow-map --html " + name("r.html"));
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_EQ(contents(folder / "r.html").find("opacity map"), std::string::npos);
}

TEST_F(Measure, ALightAmidTheHairLeavesWhatCanShadowIt) {
  const Outcome outcome =
      measure("--point 0.03,-0.05,0.03 --flicker-steps 0 --html " + name("r.html"));
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_NE(contents(folder / "r.html").find("Light at (0.03, -0.05, 0.03)"), std::string::npos);
}

TEST_F(Measure, BadArgumentsAreToldBeforeAnyWork) {
  const struct {
    std::string arguments;
    int code;
    std::string word;
  } cases[] = {
      {"--light 0,0,0", 1, "zero"},
      {"--light nan,0,1", 2, "--light"},
      {"--light 1,2", 2, "--light"},
      {"--light inf,0,1", 2, "--light"},
      {"--footprint 0", 2, "--footprint"},
      {"--footprint -1e-3", 2, "--footprint"},
      {"--footprint nan", 2, "--footprint"},
      {"--alpha 0", 2, "--alpha"},
      {"--alpha 1.5", 2, "--alpha"},
      {"--width 0", 2, "--width"},
      {"--samples 0", 2, "--samples"},
      {"--rays 1", 2, "--rays"},
      {"--rays 5000000", 2, "--rays"},
      {"--repeats 0", 2, "--repeats"},
      {"--flicker-steps 1", 1, "--flicker-steps"},
      {"--csv /nowhere/t.csv", 1, "/nowhere"},
      {"--dump /nowhere/t.csv", 1, "/nowhere"},
      {"--html /nowhere/t.html", 1, "/nowhere"},
      {"--html t.txt", 2, ".html"},
      {"--dump d.csv --footprint 1e-3 --footprint 2e-3", 1, "one light and one footprint"},
      {"--dump d.csv --light 0,-1,0 --point 1,1,1", 1, "one light and one footprint"},
      {"--style smooth", 2, "--style"},
  };
  for (const auto& [arguments, code, word] : cases) {
    const Outcome outcome = measure(arguments);
    EXPECT_EQ(outcome.code, code) << arguments << '\n' << outcome.out;
    EXPECT_NE(outcome.out.find(word), std::string::npos) << arguments << '\n' << outcome.out;
    EXPECT_EQ(outcome.out.find("footprint 0.00"), std::string::npos) << arguments << '\n'
                                                                     << outcome.out;
  }
  const Outcome unknown = run("measure --hair " + name("hair.hair") + " --methods voxels");
  EXPECT_EQ(unknown.code, 1);
  EXPECT_NE(unknown.out.find("deep-opacity-map"), std::string::npos) << unknown.out;
  EXPECT_EQ(run("measure --hair " + name("nothing.hair")).code, 1);
}

}  // namespace
}  // namespace hair
