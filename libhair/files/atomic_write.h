#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Writes a whole file or nothing: `write` fills a stream on a temporary file in the same folder,
/// which then takes the file's name. Where anything fails the temporary file is removed, whatever
/// stood under the name stays, and Error says why.
void writeAtomically(const std::filesystem::path& file,
                     const std::function<void(std::ostream&)>& write);

/// The same for a library that insists on opening a path itself (pictures, video): `write` gets
/// the temporary path, which keeps the file's extension.
void writePathAtomically(const std::filesystem::path& file,
                         const std::function<void(const std::filesystem::path&)>& write);

}  // namespace hair
