#pragma once

#include <cstdlib>
#include <iostream>

namespace hair {

/// What a target promises of whatever its input made; a broken promise ends the program, as the
/// sanitizers do.
inline void promise(bool kept, const char* what) {
  if (kept) return;
  std::cerr << "broken promise: " << what << '\n';
  std::abort();
}

}  // namespace hair
