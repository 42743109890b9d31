#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <libhair/core/error.h>

namespace hair {

/// The file, opened for reading. Throws Error where it is not found, not readable, no regular file,
/// empty, or a pointer of Git LFS or git-annex.
std::ifstream openFile(const std::filesystem::path& file);

/// The whole file. Throws Error as openFile does.
std::string readWholeFile(const std::filesystem::path& file);

/// Reads little-endian numbers from bytes in memory. Checks every read against the end, and every
/// count of a header against the bytes left, so that a bad file cannot cause a large allocation.
/// Throws Error that names file, byte and cause.
class ByteReader {
 public:
  /// `name` names the file in messages; `bytes` must outlive the reader.
  ByteReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  std::size_t offset() const { return offset_; }
  std::size_t size() const { return bytes_.size(); }
  std::size_t left() const { return bytes_.size() - offset_; }

  template <class... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    throw Error(text(name_, ": byte ", offset_, ": ", parts...));
  }
  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    if (!condition) fail(parts...);
  }

  /// `what` names the array or field in messages.
  void seek(std::size_t to, std::string_view what) {
    expect(to < size(), what, " would start at byte ", to, ", past the end of the file (", size(),
           " bytes)");
    offset_ = to;
  }

  template <class T>
  T read(std::string_view what) {
    static_assert(std::is_trivially_copyable_v<T>);
    expect(left() >= sizeof(T), what, ": the file ends here (truncated)");
    T value;
    std::memcpy(&value, bytes_.data() + offset_, sizeof(T));
    offset_ += sizeof(T);
    return value;
  }

  /// Throws unless `count` items of `itemSize` bytes are left.
  void expectLeft(std::size_t count, std::size_t itemSize, std::string_view what) const {
    expect(count <= left() / itemSize, what, ": ", count, " times ", itemSize,
           " bytes are announced but ", left(), " bytes are left (truncated, or a bad count)");
  }

  /// Appends `count` items to `out`.
  template <class T>
  void append(std::vector<T>& out, std::size_t count, std::string_view what) {
    static_assert(std::is_trivially_copyable_v<T>);
    expectLeft(count, sizeof(T), what);
    if (count == 0) return;
    const std::size_t old = out.size();
    out.resize(old + count);
    std::memcpy(static_cast<void*>(out.data() + old), bytes_.data() + offset_, count * sizeof(T));
    offset_ += count * sizeof(T);
  }

  /// The same for floats and vectors of floats, none of which may be NaN or infinite.
  template <class T>
  void appendFinite(std::vector<T>& out, std::size_t count, std::string_view what) {
    static_assert(sizeof(T) % sizeof(float) == 0);
    const std::size_t start = offset_;
    append(out, count, what);
    for (std::size_t at = start; at < offset_; at += sizeof(float)) {
      float value;
      std::memcpy(&value, bytes_.data() + at, sizeof(float));
      if (std::isfinite(value)) continue;
      offset_ = at;
      fail(what, " ", (at - start) / sizeof(T), " of ", count, " is ", value, ", not finite");
    }
  }

 private:
  static_assert(std::endian::native == std::endian::little, "the formats are little-endian");

  std::string_view bytes_;
  std::string name_;
  std::size_t offset_ = 0;
};

}  // namespace hair
