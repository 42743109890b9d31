#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace hair {

/// 64 bits over the exact bits of a simulation's state: equal on every machine and thread count,
/// or something is wrong. A multiply-and-rotate hash over 8-byte words; not cryptographic.
class StateHash {
 public:
  /// Adds the bytes of these values, in their order. How they are split into calls may matter.
  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    addBytes(reinterpret_cast<const unsigned char*>(values.data()), values.size_bytes());
  }
  /// The hash of all that was added so far; more may be added afterwards.
  std::uint64_t value() const { return finish(state_ ^ length_); }

 private:
  static std::uint64_t finish(std::uint64_t h) {
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
    return h ^ (h >> 33);
  }
  void addWord(std::uint64_t word) {
    state_ ^= finish(word);
    state_ = ((state_ << 27) | (state_ >> 37)) * 0x9e3779b97f4a7c15ull + 0x52dce729ull;
  }
  void addBytes(const unsigned char* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + i, count - i < 8 ? count - i : 8);
      addWord(word);
    }
    length_ += count;
  }

  std::uint64_t state_ = 0x6c6962686169722full;
  std::uint64_t length_ = 0;
};

/// 16 hexadecimal digits: how programs print a hash.
inline std::string hexText(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
  return text;
}

}  // namespace hair
