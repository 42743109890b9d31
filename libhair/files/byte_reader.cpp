#include <libhair/files/byte_reader.h>

#include <cerrno>
#include <system_error>

namespace hair {

namespace {

// Repositories keep large files elsewhere, and a few lines of text in their place.
void expectContents(std::ifstream& stream, const std::filesystem::path& file) {
  char start[64] = {};
  stream.read(start, sizeof start);
  const std::string_view words(start, static_cast<std::size_t>(stream.gcount()));
  require(!words.starts_with("version https://git-lfs"), file.string(),
          ": byte 0: is a Git LFS pointer, not the file it stands for; fetch that (git lfs pull)");
  require(
      !words.starts_with("/annex/objects/"), file.string(),
      ": byte 0: is a git-annex pointer, not the file it stands for; fetch that (git annex get)");
  stream.clear();
  stream.seekg(0);
}

}  // namespace

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
  expectContents(stream, file);
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
