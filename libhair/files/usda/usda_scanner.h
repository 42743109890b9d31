#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include <libhair/core/error.h>
#include <libhair/files/text_reader.h>

namespace hair {

/// Tokeniser of USD text files (`.usda`). Reads a stream in blocks, so that memory does not grow
/// with the file, and can seek back. Throws Error that names file, line and cause.
class UsdaScanner {
 public:
  struct Place {
    std::uint64_t offset = 0;
    std::size_t line = 1;
  };
  struct Token {
    enum class Kind : std::uint8_t { End, Word, String, Sign };
    Kind kind = Kind::End;
    /// A word (names with their `:` and `.`, numbers, None); what a string, an asset or a path
    /// holds between its marks; or one sign: = ( ) { } [ ] , ;
    std::string text;
    bool firstOfLine = false;

    bool isSign(char c) const { return kind == Kind::Sign && text[0] == c; }
    bool isWord(std::string_view w) const { return kind == Kind::Word && text == w; }
  };

  /// `name` names the file in messages; `stream` must outlive the scanner.
  UsdaScanner(std::istream& stream, std::string_view name);

  /// Reads the next token; `peek` does not take it away.
  Token next();
  const Token& peek();
  /// The next token must be this sign.
  void expectSign(char sign, std::string_view where);
  /// Passes a value: a word, a string, or anything in brackets.
  void skipValue();
  /// From behind an opening bracket to behind the one that closes it.
  void skipBrackets();

  /// A finite number; fast path for arrays.
  float number(std::string_view what);
  double real(std::string_view what);
  long long integer(std::string_view what);
  /// Passes blanks and comments; true, and takes it, where this sign comes next.
  bool takeSign(char sign);

  /// Where the next token begins.
  Place place();
  void goTo(Place place);

  template <class... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    throw Error(text(name_, ": line ", line_, ": ", parts...));
  }
  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    if (!condition) fail(parts...);
  }

 private:
  // The next byte without taking it; -1 at the end.
  int look() {
    if (at_ == size_ && !fill()) return -1;
    return static_cast<unsigned char>(block_[at_]);
  }
  void take() {
    if (block_[at_] == '\n') ++line_;
    ++at_;
  }
  bool fill();
  // Passes blanks and comments; true where a line ended among them.
  bool skipBlanks();
  std::string_view numberWord(std::string_view what);
  void readQuoted(std::string* text);
  void readBetween(char close, std::string* text);

  std::istream& stream_;
  std::string name_;
  std::array<char, 1 << 16> block_;
  std::size_t at_ = 0, size_ = 0;
  std::uint64_t blockOffset_ = 0;
  std::size_t line_ = 1;
  bool peeked_ = false;
  Token token_;       // the one that was peeked
  Place tokenPlace_;  // where it begins
  std::array<char, 64> digits_;
};

}  // namespace hair
