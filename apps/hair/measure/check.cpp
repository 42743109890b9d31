#include <apps/hair/measure/check.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <libhair/core/error.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/shadow_trial.h>

namespace hair {

void checkOptions(const MeasureOptions& options) {
  for (const glm::vec3 light : options.lights) makeLightSpace(light);
  for (const float footprint : options.footprints)
    require(std::isfinite(footprint) && footprint > 0, "--footprint: ", footprint,
            " m is not positive");
  require(options.flickerSteps != 1,
          "--flicker-steps: 1 step shows no flicker; 0 for none, or 2 or more");
  const std::size_t cases = std::max<std::size_t>(options.lights.size() + options.lamps.size(), 1) *
                            options.footprints.size();
  require(options.dump.empty() || cases == 1, "--dump: ", cases,
          " pairs of light and footprint do not fit into one table; give one light and one "
          "footprint, or run once for each");
}

std::set<std::string> methodsWanted(const std::string& option) {
  std::set<std::string> wanted;
  if (option == "all" || option == "quick") return wanted;
  std::istringstream words(option);
  for (std::string word; std::getline(words, word, ',');) {
    std::string name = word;
    std::replace(name.begin(), name.end(), '-', ' ');
    const auto known = candidateMethods();
    std::string choices = "all, quick";
    for (std::string method : known) {
      std::replace(method.begin(), method.end(), ' ', '-');
      choices += ", " + method;
    }
    require(std::find(known.begin(), known.end(), name) != known.end(), "--methods: no method '",
            word, "'; there are ", choices);
    wanted.insert(name);
  }
  require(!wanted.empty(), "--methods: no method in '", option, "'");
  return wanted;
}

std::optional<ShadowBudget> budgetOf(const MeasureOptions& options) {
  if (!options.maxError && !options.budgetMs) return std::nullopt;
  ShadowBudget budget;
  if (options.maxError) budget.maxError = *options.maxError;
  if (options.budgetMs) budget.milliseconds = *options.budgetMs;
  require(budget.maxError > 0, "--max-error: ", budget.maxError, " is not positive");
  require(budget.milliseconds > 0, "--budget-ms: ", budget.milliseconds, " is not positive");
  return budget;
}

}  // namespace hair
