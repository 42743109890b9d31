#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// A bad file or argument. The message says what is wrong, where (file and byte or line, or the
/// argument) and which knob to turn; broken invariants of the library itself are assertions
/// instead.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The parts, streamed one after another into one string.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/// Throws Error with the parts as its message unless the condition holds.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
  if (!condition) throw Error(text(parts...));
}

}  // namespace hair
