#pragma once

#include <string_view>

namespace hair {

/// One reader each, fed with any bytes: it either reads what it promises or throws Error, which
/// is caught here; anything else is a defect. Shared by the fuzzers and the ordinary tests.
/// True where the bytes were read.

bool fuzzHair(std::string_view bytes);
bool fuzzTfx(std::string_view bytes);
bool fuzzData(std::string_view bytes);
bool fuzzBvh(std::string_view bytes);
bool fuzzObj(std::string_view bytes);

}  // namespace hair
