#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace hair {

/// A file that is replaced as a whole: written under a temporary name in the same folder until
/// `commit` renames it. Without that the temporary file is removed, and an existing file of the
/// name is kept. Follows symbolic links to their targets, so that links are kept; devices and
/// pipes, which cannot be replaced, are written directly.
class PendingFile {
 public:
  /// Throws Error where the name is empty or a folder's.
  explicit PendingFile(const std::filesystem::path& file);
  /// Removes the temporary file, unless it was committed.
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// The temporary path to write to; keeps the file's extension.
  const std::filesystem::path& path() const { return path_; }
  /// Renames the file; call it once, when all is written and closed. Throws Error.
  void commit();

 private:
  std::filesystem::path file_, target_, path_;
  bool temporary_ = false;
};

/// Writes a whole file or nothing: `write` fills a stream on a temporary file in the same folder,
/// which is then renamed. Where anything fails, the temporary file is removed, an existing file of
/// the name is kept, and Error says why.
void writeAtomically(const std::filesystem::path& file,
                     const std::function<void(std::ostream&)>& write);

/// The same for a library that insists on opening a path itself (pictures, video): `write` gets
/// the temporary path, which keeps the file's extension.
void writePathAtomically(const std::filesystem::path& file,
                         const std::function<void(const std::filesystem::path&)>& write);

}  // namespace hair
