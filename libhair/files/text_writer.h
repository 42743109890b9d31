#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <ostream>
#include <string_view>

#include <glm/glm.hpp>

namespace hair {

/// Buffered text output to a stream. Numbers have the fewest digits that read back to the same
/// bits, independent of the locale. The owner of the stream checks it for errors.
class TextWriter {
 public:
  explicit TextWriter(std::ostream& out) : out_(out) {}
  ~TextWriter() { flush(); }
  TextWriter(const TextWriter&) = delete;
  TextWriter& operator=(const TextWriter&) = delete;

  TextWriter& operator<<(std::string_view words) {
    if (words.size() > left()) flush();
    if (words.size() > left()) {
      out_.write(words.data(), static_cast<std::streamsize>(words.size()));
      return *this;
    }
    words.copy(block_.data() + used_, words.size());
    used_ += words.size();
    return *this;
  }
  TextWriter& operator<<(char c) { return *this << std::string_view(&c, 1); }
  template <class T>
    requires std::floating_point<T> || (std::integral<T> && !std::same_as<T, char>)
  TextWriter& operator<<(T number) {
    if (left() < kMostDigits) flush();
    char* const at = block_.data() + used_;
    used_ += static_cast<std::size_t>(std::to_chars(at, at + left(), number).ptr - at);
    return *this;
  }

  void flush() {
    out_.write(block_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kMostDigits = 64;
  std::size_t left() const { return block_.size() - used_; }

  std::ostream& out_;
  std::array<char, 1 << 15> block_;
  std::size_t used_ = 0;
};

}  // namespace hair
