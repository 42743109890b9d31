#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// A file in the making: written under a temporary name in the same folder until `commit` gives it
/// its own. Without that the temporary file goes away and whatever stood under the name stays.
/// Through a symbolic link to what it points at, so that the link stays one; devices and pipes,
/// which cannot be replaced, are written directly.
class PendingFile {
 public:
  /// Throws Error where the name is empty or a folder's.
  explicit PendingFile(const std::filesystem::path& file);
  /// Removes what has not taken its name.
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Where to write; keeps the file's extension.
  const std::filesystem::path& path() const { return path_; }
  /// Once, when all is written and closed. Throws Error.
  void commit();

 private:
  std::filesystem::path file_, target_, path_;
  bool temporary_ = false;
};

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
