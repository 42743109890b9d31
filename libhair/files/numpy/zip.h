#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hair {

/// A file in a zip file.
struct ZipEntry {
  std::string name;
  std::string bytes;  ///< unpacked
};

/// The files of a zip file whose names end in `ending`, stored or deflated; `name` names the zip
/// file in messages. Check sums are compared. Throws Error (file, byte, cause), also for encrypted
/// files and those of more than 4 GB (zip64).
std::vector<ZipEntry> unzip(std::string_view bytes, std::string_view name, std::string_view ending);

}  // namespace hair
