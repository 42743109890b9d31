// hair-bench as scripts use it: what its figures look like, not what they are.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tests/apps/outcome.h>  // run: the program HAIR_PROGRAM, here hair-bench

namespace hair {
namespace {

std::vector<std::string> split(const std::string& words, char at) {
  std::vector<std::string> parts;
  std::istringstream in(words);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  if (!words.empty() && words.back() == at && at != '\n') parts.emplace_back();
  return parts;
}

std::vector<std::string> rowsOf(const std::string& out, const std::string& start) {
  std::vector<std::string> rows = split(out, '\n');
  std::erase_if(rows, [&](const std::string& row) { return !row.starts_with(start); });
  return rows;
}

TEST(Targets, AreRowsOfFiveColumnsWithAFigureAndAVerdictOrAReason) {
  const Outcome outcome = run("--targets --quick");
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  std::vector<std::string> rows = rowsOf(outcome.out, "");
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().rfind("# copy ", 0), 0u) << rows.front();
  std::erase_if(rows, [](const std::string& row) { return row.starts_with("#"); });
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front(), "row,measured,target,unit,ok");
  std::size_t promised = 0;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const std::vector<std::string> cells = split(*row, ',');
    ASSERT_EQ(cells.size(), 5u) << *row;
    EXPECT_FALSE(cells[0].empty()) << *row;
    if (cells[4] == "peer missing") {
      ++promised;
      EXPECT_EQ(cells[1], "") << *row;
      continue;
    }
    EXPECT_TRUE(std::isfinite(std::stod(cells[1]))) << *row;
    if (cells[2].empty()) {
      EXPECT_EQ(cells[4], "") << *row;
      continue;
    }
    ++promised;
    const double bound = std::stod(cells[2].substr(2)), measured = std::stod(cells[1]);
    ASSERT_TRUE(cells[2].starts_with(">=") || cells[2].starts_with("<=")) << *row;
    if (measured == bound) continue;  // rounded for the table, and so not to be judged
    EXPECT_EQ(cells[4], (measured > bound) == cells[2].starts_with(">=") ? "yes" : "no") << *row;
  }
  EXPECT_EQ(promised, 18u) << outcome.out;
}

TEST(Targets, OnlyChosenRowsAreMeasured) {
  const Outcome outcome = run("--targets --quick --only=guides");
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_FALSE(rowsOf(outcome.out, "G(").empty());
  EXPECT_TRUE(rowsOf(outcome.out, "shadow").empty());
  const Outcome none = run("--targets --only=nothing");
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.out.find("--only"), std::string::npos) << none.out;
}

// Counters are columns behind the label, in the order of their names.
TEST(Benchmarks, TellFloorBandwidthAndStateBesideTheTime) {
  const Outcome outcome =
      run("--benchmark_filter='^shadow/smooth/(points_paper|literal_1_thread)/' "
          "--benchmark_min_time=0.01 --benchmark_format=csv");
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  const std::vector<std::string> head = rowsOf(outcome.out, "name,");
  ASSERT_EQ(head.size(), 1u) << outcome.out;
  EXPECT_TRUE(head[0].ends_with("\"copy_GBps\",\"floor_ms\",\"over_floor\"")) << head[0];
  const std::vector<std::string> rows = rowsOf(outcome.out, "\"shadow/smooth/");
  ASSERT_EQ(rows.size(), 2u) << outcome.out;
  std::vector<std::string> states;
  for (const std::string& row : rows) {
    const std::vector<std::string> cells = split(row, ',');
    ASSERT_EQ(cells.size(), split(head[0], ',').size()) << row;
    const double milliseconds = std::stod(cells[2]), floor = std::stod(cells[cells.size() - 2]);
    EXPECT_NEAR(std::stod(cells.back()), milliseconds / floor, 0.01 * milliseconds / floor) << row;
    states.push_back(row.substr(row.find("state "), 22));
  }
  EXPECT_EQ(states[0], states[1]);
}

TEST(Benchmarks, ArePicturesWhereTheyAreAskedFor) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "hair_bench_plots";
  std::filesystem::remove_all(folder);
  const Outcome outcome = run("--plots=" + folder.string() +
                              " --benchmark_filter='^(cells/shadow/(32|64)|peers/shadow_smooth/"
                              "(ours|literal_1_thread))/' --benchmark_min_time=0.01");
  ASSERT_EQ(outcome.code, 0) << outcome.out;
  for (const char* name : {"cells.svg", "peers.svg"}) {
    std::ifstream file(folder / name);
    std::stringstream svg;
    svg << file.rdbuf();
    EXPECT_TRUE(svg.str().starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"")) << name;
    EXPECT_TRUE(svg.str().ends_with("</svg>\n")) << name;
    EXPECT_EQ(svg.str().find("nan"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace hair
