// One libFuzzer program a format: HAIR_FUZZ_TARGET is the function of targets.h it feeds.
#include <cstddef>
#include <cstdint>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hair::HAIR_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
