#include <libhair/files/numpy/inflate.h>

#include <array>
#include <cstdint>
#include <span>

#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr std::size_t kLongestCode = 15, kSymbols = 288;

// RFC 1951, 3.2.5: least length or distance of a symbol, and how many bits say what is added.
constexpr std::array<std::uint16_t, 29> kLengths = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                    15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                    67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<std::uint8_t, 29> kLengthBits = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                      2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<std::uint16_t, 30> kDistances = {
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
constexpr std::array<std::uint8_t, 30> kDistanceBits = {0, 0, 0,  0,  1,  1,  2,  2,  3,  3,
                                                        4, 4, 5,  5,  6,  6,  7,  7,  8,  8,
                                                        9, 9, 10, 10, 11, 11, 12, 12, 13, 13};

class Inflater {
 public:
  Inflater(std::string_view packed, std::size_t size, std::string_view name)
      : in_(packed), size_(size), name_(name) {}

  std::string run() {
    // A byte of deflate stands for at most 1032 (258 for two bits).
    expect(size_ / 1032 <= in_.size(), "is too short for its size");
    out_.reserve(size_);
    bool last = false;
    while (!last) {
      last = bits(1) == 1;
      const std::uint32_t kind = bits(2);
      expect(kind < 3, "has a block of no kind");
      if (kind == 0)
        stored();
      else
        coded(kind == 2);
    }
    expect(out_.size() == size_, "is shorter than it says");
    return std::move(out_);
  }

 private:
  // Canonical Huffman codes, decoded bit by bit behind a table for short ones.
  struct Codes {
    static constexpr std::size_t kShort = 9;
    std::array<std::uint16_t, kLongestCode + 1> count{};
    std::array<std::uint16_t, kSymbols> symbol{};                 // in the order of their codes
    std::array<std::uint16_t, std::size_t{1} << kShort> quick{};  // symbol * 16 + length; 0: longer
  };

  void expect(bool condition, std::string_view what) const {
    require(condition, name_, ": the packed data ", what, " (damaged)");
  }

  void fill(std::uint32_t count) {
    while (held_ < count && at_ < in_.size()) {
      hold_ |= std::uint64_t{static_cast<unsigned char>(in_[at_++])} << held_;
      held_ += 8;
    }
  }
  std::uint32_t bits(std::uint32_t count) {
    fill(count);
    expect(held_ >= count, "ends early");
    const auto value = static_cast<std::uint32_t>(hold_ & ((std::uint64_t{1} << count) - 1));
    hold_ >>= count;
    held_ -= count;
    return value;
  }

  // A code that is not complete is damage, but for one of a single symbol.
  Codes codesOf(std::span<const std::uint8_t> lengths) const {
    Codes codes;
    for (const std::uint8_t length : lengths) ++codes.count[length];
    codes.count[0] = 0;
    std::int32_t left = 1;
    std::array<std::uint16_t, kLongestCode + 2> place{}, code{};
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      left = 2 * left - codes.count[length];
      expect(left >= 0, "has too many codes");
      place[length + 1] = static_cast<std::uint16_t>(place[length] + codes.count[length]);
      code[length + 1] = static_cast<std::uint16_t>((code[length] + codes.count[length]) << 1);
    }
    for (std::size_t s = 0; s < lengths.size(); ++s) {
      const std::size_t length = lengths[s];
      if (length == 0) continue;
      codes.symbol[place[length]++] = static_cast<std::uint16_t>(s);
      const std::uint32_t value = code[length]++;
      if (length > Codes::kShort) continue;
      // The stream has a code's first bit lowest.
      std::uint32_t turned = 0;
      for (std::size_t b = 0; b < length; ++b) turned |= ((value >> b) & 1u) << (length - 1 - b);
      for (std::size_t k = turned; k < codes.quick.size(); k += std::size_t{1} << length)
        codes.quick[k] = static_cast<std::uint16_t>(s * 16 + length);
    }
    return codes;
  }

  std::uint32_t symbol(const Codes& codes) {
    fill(kLongestCode);
    const std::uint16_t quick = codes.quick[hold_ & (codes.quick.size() - 1)];
    if (quick != 0 && quick % 16u <= held_) {
      hold_ >>= quick % 16u;
      held_ -= quick % 16u;
      return quick / 16u;
    }
    std::int32_t code = 0, first = 0, place = 0;
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      code |= static_cast<std::int32_t>(bits(1));
      const std::int32_t count = codes.count[length];
      if (code - first < count) return codes.symbol[static_cast<std::size_t>(place + code - first)];
      place += count;
      first = (first + count) << 1;
      code <<= 1;
    }
    expect(false, "has a code of no symbol");
    return 0;
  }

  void stored() {
    hold_ >>= held_ % 8;
    held_ -= held_ % 8;
    const std::uint32_t length = bits(16), check = bits(16);
    expect((length ^ check) == 0xffff, "has a block of no length");
    expect(out_.size() + length <= size_, "is longer than it says");
    for (std::uint32_t i = 0; i < length; ++i) out_ += static_cast<char>(bits(8));
  }

  void coded(bool withCodes) {
    std::array<std::uint8_t, 320> lengths{};
    std::size_t literals = 288, distances = 30;
    if (withCodes) {
      literals = bits(5) + 257;
      distances = bits(5) + 1;
      readLengths(std::span(lengths).first(literals + distances));
      expect(lengths[256] != 0, "has a block without an end");
    } else {
      for (std::size_t s = 0; s < literals; ++s)
        lengths[s] = static_cast<std::uint8_t>(s < 144 ? 8 : s < 256 ? 9 : s < 280 ? 7 : 8);
      for (std::size_t s = 0; s < distances; ++s) lengths[literals + s] = 5;
    }
    expect(literals <= 288, "has too many codes");
    const Codes literal = codesOf(std::span(lengths).first(literals)),
                distance = codesOf(std::span(lengths).subspan(literals, distances));
    for (;;) {
      const std::uint32_t s = symbol(literal);
      if (s == 256) return;
      if (s < 256) {
        expect(out_.size() < size_, "is longer than it says");
        out_ += static_cast<char>(s);
        continue;
      }
      expect(s - 257 < kLengths.size(), "has a length of no kind");
      const std::size_t length = kLengths[s - 257] + bits(kLengthBits[s - 257]);
      const std::uint32_t d = symbol(distance);
      expect(d < kDistances.size(), "has a distance of no kind");
      const std::size_t back = kDistances[d] + bits(kDistanceBits[d]);
      expect(back <= out_.size(), "goes back before its start");
      expect(out_.size() + length <= size_, "is longer than it says");
      // One by one: a copy may reach into itself.
      for (std::size_t i = 0, from = out_.size() - back; i < length; ++i) out_ += out_[from + i];
    }
  }

  // Lengths of codes, themselves coded (3.2.7).
  void readLengths(std::span<std::uint8_t> lengths) {
    constexpr std::array<std::uint8_t, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                     11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::array<std::uint8_t, 19> own{};
    const std::uint32_t count = bits(4) + 4;
    for (std::uint32_t i = 0; i < count; ++i) own[kOrder[i]] = static_cast<std::uint8_t>(bits(3));
    const Codes codes = codesOf(own);
    for (std::size_t i = 0; i < lengths.size();) {
      const std::uint32_t s = symbol(codes);
      std::size_t times = 1;
      std::uint8_t value = 0;
      if (s < 16) {
        value = static_cast<std::uint8_t>(s);
      } else if (s == 16) {
        expect(i > 0, "repeats a length before the first");
        value = lengths[i - 1];
        times = 3 + bits(2);
      } else {
        times = s == 17 ? 3 + bits(3) : 11 + bits(7);
      }
      expect(i + times <= lengths.size(), "has too many lengths of codes");
      for (; times > 0; --times) lengths[i++] = value;
    }
  }

  std::string_view in_;
  std::size_t size_, at_ = 0;
  std::string_view name_;
  std::string out_;
  std::uint64_t hold_ = 0;  // bits that are taken from the stream, the next one lowest
  std::uint32_t held_ = 0;
};

}  // namespace

std::string inflate(std::string_view packed, std::size_t size, std::string_view name) {
  return Inflater(packed, size, name).run();
}

}  // namespace hair
