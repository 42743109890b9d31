#include <libhair/files/byte_reader.h>

#include <cerrno>
#include <system_error>

namespace hair {

std::ifstream openFile(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  require(fs::exists(status), file.string(), ": no such file");
  require(!fs::is_directory(status), file.string(), ": is a folder, not a file");
  // Devices and pipes have no size that a count could be compared with.
  require(fs::is_regular_file(status), file.string(), ": is not a regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  require(!error, file.string(), ": cannot tell its size: ", error.message());
  require(size > 0, file.string(), ": byte 0: the file is empty");

  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  require(stream.is_open(), file.string(), ": cannot open: ", std::strerror(errno));
  return stream;
}

std::string readWholeFile(const std::filesystem::path& file) {
  std::ifstream stream = openFile(file);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  require(!error, file.string(), ": cannot tell its size: ", error.message());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  require(stream.gcount() == static_cast<std::streamsize>(size), file.string(), ": byte ",
          stream.gcount(), ": cannot read on (", size, " bytes were expected)");
  return bytes;
}

}  // namespace hair
