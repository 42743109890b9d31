// hair-extremes: thousands of combinations of extreme inputs, each of which hair either survives
// with what is promised of it, or refuses with a clear Error. docs/measurements.md has the results.

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include <libhair/core/error.h>

#include "report.h"

namespace hair::extremes {
namespace {

constexpr std::string_view kHelp =
    R"(hair-extremes [--quick] [--count N] [--only N] [--seed N] [--csv FILE] [--tables FILE]

Thousands of combinations of extreme inputs, each of which hair either survives with what is promised
of it, or refuses with a clear error.

  --quick        the first 150 combinations
  --count N      the first N (1500)
  --only N       combination N alone, with all that is known of it
  --seed N       others (1)
  --csv FILE     one line a combination
  --tables FILE  a table for each dimension, in Markdown
  -h, --help     this

Its last line is "combinations N, violations N, refused N". Exit codes: 0 done, 1 a violation,
2 bad usage.
)";

struct Options {
  std::uint32_t first = 0, count = 1500, seed = 1;
  std::string csv, tables;
  bool help = false;
};

Options parse(int argc, char** argv) {
  Options o;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--help" || option == "-h") {
      o.help = true;
      return o;
    }
    if (option == "--quick") {
      o.count = 150;
      continue;
    }
    require(i + 1 < argc, option, " wants a value, or is no option; --help tells which there are");
    const std::string value = argv[++i];
    const auto number = [&] { return static_cast<std::uint32_t>(std::stoul(value)); };
    if (option == "--count")
      o.count = number();
    else if (option == "--only")
      o.first = number(), o.count = 1;
    else if (option == "--seed")
      o.seed = number();
    else if (option == "--csv")
      o.csv = value;
    else if (option == "--tables")
      o.tables = value;
    else
      throw Error(option + " is no option; --help tells which there are");
  }
  return o;
}

void tell(const Done& done, bool everything) {
  const Outcome& o = done.outcome;
  if (!everything && o.violations.empty()) return;
  if (!everything) std::cout << done.number << ": " << nameOf(done.values) << '\n';
  for (const std::string& v : o.violations) std::cout << "  violation: " << v << '\n';
  if (!o.refused.empty()) std::cout << "  refused: " << o.refused << '\n';
  if (everything)
    std::cout << "  stretch " << o.stretch << ", energy of what is allowed " << o.energy
              << ", growth " << o.growth << ", recovery " << o.recovery << " s\n";
  std::cout.flush();
}

int main(const Options& options) {
  if (options.help) {
    std::cout << kHelp;
    return EXIT_SUCCESS;
  }
  std::vector<Done> all;
  std::size_t violations = 0, refused = 0;
  for (std::uint32_t i = 0; i < options.count; ++i) {
    const std::uint32_t number = options.first + i;
    Done done{number, draw(number, options.seed), {}};
    if (options.count == 1) std::cout << number << ": " << nameOf(done.values) << std::endl;
    done.outcome = run(setupOf(done.values));
    violations += done.outcome.violations.empty() ? 0 : 1;
    refused += done.outcome.refused.empty() ? 0 : 1;
    tell(done, options.count == 1);
    all.push_back(std::move(done));
  }
  if (!options.csv.empty()) {
    std::ofstream file(options.csv);
    writeCsv(all, file);
  }
  if (!options.tables.empty()) {
    std::ofstream file(options.tables);
    writeTables(all, file);
  }
  std::cout << "combinations " << all.size() << ", violations " << violations << ", refused "
            << refused << '\n';
  return violations > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}

}  // namespace
}  // namespace hair::extremes

int main(int argc, char** argv) {
  try {
    return hair::extremes::main(hair::extremes::parse(argc, argv));
  } catch (const std::exception& e) {
    std::cerr << "hair-extremes: " << e.what() << '\n';
    return 2;
  }
}
