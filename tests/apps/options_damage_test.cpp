// Damaged command lines, through the same entry point as the fuzzer: each is understood or answered
// with one line that names what is wrong.
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <apps/common/command_line.h>
#include <apps/hair/options.h>
#include <tests/fuzz/seeds.h>
#include <tests/fuzz/targets.h>

namespace hair {
namespace {

std::vector<std::string> seeds() {
  for (FuzzSeeds& seeds : fuzzSeeds())
    if (seeds.name == std::string("options")) return seeds.inputs;
  return {};
}

// What `hair` says to words that it does not understand; "" where it does.
std::string complaintAbout(std::vector<const char*> words) {
  CLI::App app("", "hair");
  Run run;
  addCommands(app, run, "hair");
  words.insert(words.begin(), "hair");
  std::ostringstream out, err;
  exitCodeOfParsing(app, static_cast<int>(words.size()), words.data(), out, err);
  return err.str();
}

TEST(CommandLineDamage, EverySeedIsUnderstoodButThoseThatAskForHelp) {
  std::size_t understood = 0;
  const std::vector<std::string> all = seeds();
  for (const std::string& seed : all) {
    const bool asksForHelp = seed.find("--help") != std::string::npos;
    EXPECT_EQ(fuzzOptions(seed), !asksForHelp) << seed;
    understood += !asksForHelp;
  }
  EXPECT_GE(understood, 10u);
}

TEST(CommandLineDamage, BadUsageIsOneLineThatNamesTheOptionAndWhereHelpIs) {
  EXPECT_EQ(complaintAbout({"simulate", "--fps", "0"}),
            "hair simulate: --fps: 0 is not in 1 to 1000; hair simulate --help tells more\n");
  EXPECT_EQ(complaintAbout({"simulate", "--wind", "1,\n2"}),
            "hair simulate: --wind: wants X,Y,Z, three numbers; got 1,?2; hair simulate --help "
            "tells more\n");
  EXPECT_EQ(complaintAbout({}), "hair: A subcommand is required; hair --help tells more\n");
}

TEST(CommandLineDamage, LostDoubledAndForeignWordsAreUnderstoodOrNamed) {
  static const std::string kWords[] = {"",
                                       "-",
                                       "--",
                                       "-1",
                                       "nan",
                                       "inf",
                                       "-inf",
                                       "1e400",
                                       "1e-400",
                                       "0x10",
                                       "1,2,3",
                                       "1,,2",
                                       "[1]",
                                       "{}",
                                       "@a",
                                       "%s%n",
                                       "/",
                                       ".png",
                                       "a.csv",
                                       "\t",
                                       "\x7f",
                                       "\xff\xfe",
                                       "99999999999999999999",
                                       "--help",
                                       "--fps",
                                       "--fps=",
                                       "=",
                                       "smooth",
                                       std::string(5000, 'x')};
  std::size_t understood = 0, tried = 0;
  for (const std::string& seed : seeds()) {
    std::vector<std::string> words;
    std::istringstream in(seed);
    for (std::string word; std::getline(in, word);) words.push_back(word);
    const auto tryThem = [&](const std::vector<std::string>& some) {
      std::string lines;
      for (const std::string& word : some) lines += word + '\n';
      understood += fuzzOptions(lines);
      ++tried;
    };
    for (std::size_t at = 1; at < words.size(); ++at) {
      std::vector<std::string> some = words;
      some.erase(some.begin() + static_cast<std::ptrdiff_t>(at));
      tryThem(some);
      some = words;
      some.insert(some.begin() + static_cast<std::ptrdiff_t>(at), words[at]);
      tryThem(some);
      // Words in turn, so that each comes to many places in few runs.
      for (std::size_t k = at % 5; k < std::size(kWords); k += 5) {
        some = words;
        some[at] = kWords[k];
        tryThem(some);
      }
    }
  }
  EXPECT_GT(understood, tried / 50);
  EXPECT_LT(understood, tried / 2);
}

}  // namespace
}  // namespace hair
