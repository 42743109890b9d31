#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hair {

/// Unpacks a deflate stream (RFC 1951), as in zip files, to exactly `size` bytes. Throws Error that
/// begins with `name` for damaged streams, and for those of another size; never takes more memory
/// than the stream's length allows.
std::string inflate(std::string_view packed, std::size_t size, std::string_view name);

}  // namespace hair
