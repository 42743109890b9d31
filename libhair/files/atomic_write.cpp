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

PendingFile::PendingFile(const fs::path& file) : file_(file) {
  require(!file.empty(), "the name of the file to write is empty");
  std::error_code error;
  const bool link = fs::is_symlink(fs::symlink_status(file, error));
  target_ = link ? fs::weakly_canonical(file) : file;
  const fs::file_status old = fs::status(target_, error);
  require(!fs::is_directory(old), file.string(), ": cannot write: is a folder");
  path_ = target_;
  // Devices and pipes have no half-written state to protect.
  if (fs::exists(old) && !fs::is_regular_file(old)) return;
  temporary_ = true;
  std::random_device random;
  do {
    path_ = target_.parent_path() / text(".", target_.stem().string(), ".", std::hex, random(),
                                         target_.extension().string());
  } while (fs::exists(path_));
}

PendingFile::~PendingFile() {
  std::error_code ignored;
  if (temporary_) fs::remove(path_, ignored);
}

void PendingFile::commit() {
  if (!temporary_) return;
  std::error_code error;
  const fs::file_status old = fs::status(target_, error);
  if (fs::exists(old)) fs::permissions(path_, old.permissions(), error);
  fs::rename(path_, target_, error);
  require(!error, file_.string(), ": cannot write: ", error.message());
  temporary_ = false;
}

void writePathAtomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  PendingFile pending(file);
  write(pending.path());
  pending.commit();
}

void writeAtomically(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  writePathAtomically(file, [&](const fs::path& path) { writeStream(path, file, write); });
}

}  // namespace hair
