#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "run.h"

namespace hair::extremes {

struct Done {
  std::uint32_t number;
  std::vector<std::size_t> values;  ///< draw()
  Outcome outcome;
};

/// Which values are not the ordinary ones, as words.
std::string nameOf(const std::vector<std::size_t>& values);

/// One line a combination.
void writeCsv(const std::vector<Done>& all, std::ostream& out);

/// A table for each dimension, one line a value.
void writeTables(const std::vector<Done>& all, std::ostream& out);

}  // namespace hair::extremes
