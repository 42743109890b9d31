#include "report.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iomanip>
#include <map>
#include <ostream>

#include "bad_inputs.h"

namespace hair::extremes {

namespace {

/// What a set of combinations came to.
struct Sum {
  std::size_t count = 0, refused = 0, violations = 0;
  float stretch = 0;
  double recovery = -1;

  void add(const Outcome& o) {
    ++count;
    refused += o.refused.empty() ? 0 : 1;
    violations += o.violations.empty() ? 0 : 1;
    stretch = std::max(stretch, o.stretch);
    recovery = std::max(recovery, o.recovery);
  }
};

void writeLine(const std::string& name, const Sum& sum, std::ostream& out) {
  out << "| " << name << " | " << sum.count << " | " << sum.refused << " | " << sum.violations
      << " | " << std::setprecision(2) << 100 * sum.stretch << " % | ";
  if (sum.recovery >= 0)
    out << std::fixed << std::setprecision(2) << sum.recovery << " s" << std::defaultfloat;
  out << " |\n";
}

void writeHead(const std::string& name, std::ostream& out) {
  out << "\n| " << name
      << " | combinations | refused | violations | worst stretch | worst recovery |\n"
         "|---|---|---|---|---|---|\n";
}

template <class Matches>
Sum sumOf(const std::vector<Done>& all, Matches&& matches) {
  Sum sum;
  for (const Done& d : all)
    if (matches(d)) sum.add(d.outcome);
  return sum;
}

/// An Error's message without its figures and advice.
std::string reasonOf(const std::string& message) {
  const std::string what = message.substr(0, message.find(';'));
  const auto isOf = [](char c, const char* more) {
    return (c >= '0' && c <= '9') || (c != '\0' && std::strchr(more, c));
  };
  std::string reason;
  for (std::size_t i = 0; i < what.size();) {
    const std::size_t start = i;
    const std::size_t unsign = what[i] == '-' ? i + 1 : i;
    if (what.compare(unsign, 3, "nan") == 0 || what.compare(unsign, 3, "inf") == 0)
      i = unsign + 3;
    else if (isOf(what.c_str()[unsign], ""))
      for (i = unsign + 1; isOf(what.c_str()[i], what[i - 1] == 'e' ? "+-" : ".e");) ++i;
    reason += i > start ? "…" : std::string(1, what[i++]);
  }
  return reason;
}

void writeReasons(const std::vector<Done>& all, std::ostream& out) {
  std::map<std::string, std::array<std::size_t, 2>> reasons;
  std::array<std::size_t, 2> refused{}, count{};
  for (const Done& d : all) {
    const bool wrong = wrongOnPurpose(d.number);
    ++count[wrong];
    if (d.outcome.refused.empty()) continue;
    ++refused[wrong], ++reasons[reasonOf(d.outcome.refused)][wrong];
  }
  out << "\n| refused because | combinations | with something wrong on purpose |\n|---|---|---|\n";
  for (const auto& [reason, times] : reasons)
    out << "| " << reason << " | " << times[0] << " | " << times[1] << " |\n";
  out << "| all | " << refused[0] << " of " << count[0] << " | " << refused[1] << " of " << count[1]
      << " |\n";
}

std::string quoted(std::string text) {
  std::ranges::replace(text, '"', '\'');
  std::ranges::replace(text, '\n', ' ');
  return '"' + text + '"';
}

}  // namespace

std::string nameOf(const std::vector<std::size_t>& values) {
  const std::size_t count = dimensions().size();
  std::string name;
  const auto add = [&](const std::string& part) { name += (name.empty() ? "" : "; ") + part; };
  for (std::size_t d = 0; d < count; ++d)
    if (values[d] > 0)
      add(std::string(dimensions()[d].name) + ": " + dimensions()[d].values[values[d]].name);
  if (values[count] > 0)
    add(std::string(badInputs()[values[count] - 1].name) + " = " +
        badValues()[values[count + 1]].name);
  return name.empty() ? "ordinary" : name;
}

void writeCsv(const std::vector<Done>& all, std::ostream& out) {
  out << "number,combination,refused,violations,stretch,energy of allowed,growth,recovery s\n";
  for (const Done& d : all) {
    std::string violations;
    for (const std::string& v : d.outcome.violations) violations += v + ". ";
    out << d.number << ',' << quoted(nameOf(d.values)) << ',' << quoted(d.outcome.refused) << ','
        << quoted(violations) << ',' << d.outcome.stretch << ',' << d.outcome.energy << ','
        << d.outcome.growth << ',' << d.outcome.recovery << '\n';
  }
}

void writeTables(const std::vector<Done>& all, std::ostream& out) {
  const std::size_t count = dimensions().size();
  writeReasons(all, out);
  for (std::size_t d = 0; d < count; ++d) {
    writeHead(dimensions()[d].name, out);
    for (std::size_t v = 0; v < dimensions()[d].values.size(); ++v)
      writeLine(dimensions()[d].values[v].name,
                sumOf(all,
                      [&](const Done& done) {
                        return done.values[d] == v &&
                               (!wrongOnPurpose(done.number) || dimensions()[d].refuses(v));
                      }),
                out);
  }
  writeHead("bad input", out);
  for (std::size_t f = 0; f < badInputs().size(); ++f)
    writeLine(badInputs()[f].name,
              sumOf(all, [&](const Done& done) { return done.values[count] == f + 1; }), out);
  writeHead("what it was", out);
  for (std::size_t v = 0; v < badValues().size(); ++v)
    writeLine(badValues()[v].name,
              sumOf(all,
                    [&](const Done& done) {
                      return done.values[count] > 0 && done.values[count + 1] == v;
                    }),
              out);
}

}  // namespace hair::extremes
