#include <libhair/files/numpy/zip.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include <libhair/files/byte_reader.h>
#include <libhair/files/numpy/inflate.h>

namespace hair {

namespace {

constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50;
constexpr std::string_view kEnd("PK\x05\x06", 4);

std::uint32_t checkSum(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> sums{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      sums[i] = i;
      for (int k = 0; k < 8; ++k) sums[i] = (sums[i] >> 1) ^ (sums[i] & 1 ? 0xedb88320u : 0u);
    }
    return sums;
  }();
  std::uint32_t sum = ~0u;
  for (const char c : bytes) sum = table[(sum ^ static_cast<unsigned char>(c)) & 0xff] ^ (sum >> 8);
  return ~sum;
}

}  // namespace

// Layout: PKWARE's APPNOTE.TXT, 4.3. The directory at the end says where the files are.
std::vector<ZipEntry> unzip(std::string_view bytes, std::string_view name,
                            std::string_view ending) {
  constexpr std::size_t kEndSize = 22, kLongestComment = 65535;
  ByteReader in(bytes, name);
  const std::size_t from =
      bytes.size() > kEndSize + kLongestComment ? bytes.size() - kEndSize - kLongestComment : 0;
  const std::size_t end = bytes.rfind(kEnd);
  in.expect(end != std::string_view::npos && end >= from && end + kEndSize <= bytes.size(),
            "the directory at the end of a zip file is missing (truncated, or no .npz)");
  in.seek(end + 10, "directory");
  const auto count = in.read<std::uint16_t>("number of files");
  in.read<std::uint32_t>("size of the directory");
  const auto directory = in.read<std::uint32_t>("place of the directory");
  in.expect(count != 0xffff && directory != 0xffffffffu,
            "a zip file of more than 4 GB is not read; save single arrays (.npy)");

  std::vector<ZipEntry> entries;
  std::size_t at = directory, unpacked = 0;
  for (std::uint16_t i = 0; i < count; ++i) {
    in.seek(at, "directory");
    in.expect(in.read<std::uint32_t>("directory") == kCentral, "the directory has no entry here");
    in.seek(at + 8, "directory");
    const auto flags = in.read<std::uint16_t>("flags"), method = in.read<std::uint16_t>("method");
    in.read<std::uint32_t>("time");
    const auto sum = in.read<std::uint32_t>("check sum");
    const std::size_t packedSize = in.read<std::uint32_t>("size"),
                      size = in.read<std::uint32_t>("size");
    const std::size_t nameSize = in.read<std::uint16_t>("name"),
                      rest = std::size_t{in.read<std::uint16_t>("extra field")} +
                             in.read<std::uint16_t>("comment");
    in.seek(at + 42, "directory");
    const std::size_t local = in.read<std::uint32_t>("place");
    in.expectLeft(nameSize, 1, "name");
    const std::string entry(bytes.substr(at + 46, nameSize));
    at += 46 + nameSize + rest;
    if (!entry.ends_with(ending)) continue;
    in.expect((flags & 1) == 0, "an encrypted file");
    in.expect(method == 0 || method == 8, "a file packed by method ", method,
              "; stored and deflated ones are read");
    in.expect(size != 0xffffffffu, "a file of more than 4 GB is not read; save it as .npy");

    in.seek(local, "file");
    in.expect(in.read<std::uint32_t>("file") == kLocal,
              "no file begins here, as the directory says");
    in.seek(local + 26, "file");
    const std::size_t begin = std::size_t{in.read<std::uint16_t>("name")} +
                              in.read<std::uint16_t>("extra field") + local + 30;
    in.expect(begin <= bytes.size() && packedSize <= bytes.size() - begin,
              "the file ends within its contents (truncated)");
    // Each entry may point at the same bytes: what is unpacked is bounded in all.
    unpacked += size;
    in.expect(unpacked / 1032 <= bytes.size(),
              "more is announced than a file of this size can hold");
    const std::string_view packed = bytes.substr(begin, packedSize);
    in.expect(method == 8 || size == packedSize, "two sizes of a file that is not packed");
    ZipEntry& file = entries.emplace_back();
    file.name = entry;
    file.bytes = method == 8 ? inflate(packed, size, name) : std::string(packed);
    in.expect(checkSum(file.bytes) == sum, "the check sum is wrong (damaged)");
  }
  return entries;
}

}  // namespace hair
