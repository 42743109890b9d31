#include <libhair/files/atomic_write.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>

#include <libhair/core/error.h>

namespace hair {

namespace fs = std::filesystem;

namespace {

// Of an error that a stream met, where the system says one.
std::string cause() {
  return errno != 0 ? std::strerror(errno) : "unknown cause";
}

// Removes the temporary file unless it took its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    std::random_device random;
    do {
      path_ = target.parent_path() / text(".", target.stem().string(), ".", std::hex, random(),
                                          target.extension().string());
    } while (fs::exists(path_));
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }
  void rename(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    require(!error, target.string(), ": cannot write: ", error.message());
    path_.clear();
  }

 private:
  fs::path path_;
};

void writeStream(const fs::path& path, const fs::path& named,
                 const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  require(out.is_open(), named.string(), ": cannot write: ", cause());
  write(out);
  out.close();
  require(out.good(), named.string(), ": cannot write: ", cause());
}

}  // namespace

void writePathAtomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  require(!file.empty(), "the name of the file to write is empty");
  std::error_code error;
  // Through a symbolic link to what it points at, so that the link stays one.
  const bool link = fs::is_symlink(fs::symlink_status(file, error));
  const fs::path target = link ? fs::weakly_canonical(file) : file;
  const fs::file_status old = fs::status(target, error);
  require(!fs::is_directory(old), file.string(), ": cannot write: is a folder");
  // Devices and pipes cannot be replaced and have no half-written state to protect.
  if (fs::exists(old) && !fs::is_regular_file(old)) return write(target);

  TemporaryFile temporary(target);
  write(temporary.path());
  if (fs::exists(old)) fs::permissions(temporary.path(), old.permissions(), error);
  temporary.rename(target);
}

void writeAtomically(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  writePathAtomically(file, [&](const fs::path& path) { writeStream(path, file, write); });
}

}  // namespace hair
