#include <libhair/files/usda/usda_scanner.h>

#include <charconv>

#include <libhair/files/number_text.h>

namespace hair {

namespace {

bool isNumberByte(int c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-' || (c >= 'a' && c <= 'z') ||
         (c >= 'A' && c <= 'Z');
}

bool isWordByte(int c) {
  return isNumberByte(c) || c == '_' || c == ':' || c > 127;
}

constexpr std::size_t kLongestToken = 1 << 16;

}  // namespace

UsdaScanner::UsdaScanner(std::istream& stream, std::string_view name)
    : stream_(stream), name_(name) {}

bool UsdaScanner::fill() {
  blockOffset_ += size_;
  at_ = size_ = 0;
  if (!stream_) return false;
  stream_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
  size_ = static_cast<std::size_t>(stream_.gcount());
  return size_ > 0;
}

bool UsdaScanner::skipBlanks() {
  bool newLine = false;
  for (int c = look(); c >= 0; c = look()) {
    if (c == '#') {
      while (look() >= 0 && look() != '\n') take();
    } else if (c == '\n' || c == '\r' || c == ' ' || c == '\t') {
      newLine = newLine || c == '\n';
      take();
    } else {
      break;
    }
  }
  return newLine;
}

// From behind the opening quote that was taken; three of them begin a string of many lines.
void UsdaScanner::readQuoted(std::string* text) {
  const int quote = look();
  take();
  bool triple = false;
  if (look() == quote) {
    take();
    if (look() != quote) return;  // an empty string
    take();
    triple = true;
  }
  int closing = 0;
  for (int c = look(); c >= 0; c = look()) {
    take();
    if (c == quote) {
      if (++closing == (triple ? 3 : 1)) return;
      continue;
    }
    closing = 0;
    expect(triple || c != '\n', "a string does not end in its line");
    if (c == '\\' && look() >= 0) {
      c = look();
      take();
    }
    if (!text) continue;
    expect(text->size() < kLongestToken, "a string of more than ", kLongestToken, " bytes");
    *text += static_cast<char>(c);
  }
  fail("the file ends within a string (truncated)");
}

void UsdaScanner::readBetween(char close, std::string* text) {
  take();
  for (int c = look(); c >= 0; c = look()) {
    take();
    if (c == close) return;
    expect(c != '\n', "'", close, "' is missing at the end of the line");
    if (!text) continue;
    expect(text->size() < kLongestToken, "a path of more than ", kLongestToken, " bytes");
    *text += static_cast<char>(c);
  }
  fail("the file ends where '", close, "' was expected (truncated)");
}

const UsdaScanner::Token& UsdaScanner::peek() {
  if (peeked_) return token_;
  const bool start = blockOffset_ + at_ == 0;
  token_.firstOfLine = skipBlanks() || start;
  tokenPlace_ = {blockOffset_ + at_, line_};
  token_.text.clear();
  peeked_ = true;
  const int c = look();
  if (c < 0) {
    token_.kind = Token::Kind::End;
  } else if (c == '"' || c == '\'') {
    token_.kind = Token::Kind::String;
    readQuoted(&token_.text);
  } else if (c == '@' || c == '<') {
    token_.kind = Token::Kind::String;
    readBetween(c == '<' ? '>' : '@', &token_.text);
  } else if (isWordByte(c)) {
    token_.kind = Token::Kind::Word;
    while (isWordByte(look())) {
      expect(token_.text.size() < kLongestToken, "a word of more than ", kLongestToken, " bytes");
      token_.text += static_cast<char>(look());
      take();
    }
  } else {
    expect(std::string_view("=(){}[],;").find(static_cast<char>(c)) != std::string_view::npos, "'",
           TextReader::shown(std::string(1, static_cast<char>(c))), "' was not expected");
    token_.kind = Token::Kind::Sign;
    token_.text = static_cast<char>(c);
    take();
  }
  return token_;
}

UsdaScanner::Token UsdaScanner::next() {
  peek();
  peeked_ = false;
  return token_;
}

void UsdaScanner::expectSign(char sign, std::string_view where) {
  const Token token = next();
  if (token.isSign(sign)) return;
  expect(token.kind != Token::Kind::End, where, ": the file ends where '", sign,
         "' was expected (truncated)");
  fail(where, ": '", sign, "' expected, found '", TextReader::shown(token.text), "'");
}

void UsdaScanner::skipBrackets() {
  expect(!peeked_, "brackets are passed from their start");
  for (std::uint64_t depth = 1; depth > 0;) {
    skipBlanks();
    const int c = look();
    if (c == '"' || c == '\'') {
      readQuoted(nullptr);
    } else if (c == '@' || c == '<') {
      readBetween(c == '<' ? '>' : '@', nullptr);
    } else {
      expect(c >= 0, "the file ends within brackets (truncated)");
      if (c == '(' || c == '[' || c == '{') ++depth;
      if (c == ')' || c == ']' || c == '}') --depth;
      take();
    }
  }
}

void UsdaScanner::skipValue() {
  const Token token = next();
  if (token.isSign('(') || token.isSign('[') || token.isSign('{')) return skipBrackets();
  expect(token.kind == Token::Kind::Word || token.kind == Token::Kind::String,
         "a value is missing");
  // A reference has the path of a prim behind that of a file.
  if (token.kind == Token::Kind::String && look() == '<') readBetween('>', nullptr);
  while (token.kind == Token::Kind::String && look() == '@') readBetween('@', nullptr);
}

std::string_view UsdaScanner::numberWord(std::string_view what) {
  if (peeked_) goTo(tokenPlace_);
  skipBlanks();
  std::size_t size = 0;
  for (int c = look(); isNumberByte(c); c = look()) {
    expect(size < digits_.size(), what, ": a number of more than ", digits_.size(), " digits");
    digits_[size++] = static_cast<char>(c);
    take();
  }
  expect(size > 0, what, ": a number is missing");
  return {digits_.data(), size};
}

float UsdaScanner::number(std::string_view what) {
  const std::string_view word = numberWord(what);
  const std::optional<float> value = floatFromText(word);
  expect(value.has_value(), what, ": '", TextReader::shown(word), "' is no finite number");
  return value.value_or(0.0f);
}

double UsdaScanner::real(std::string_view what) {
  const std::string_view word = numberWord(what);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  expect(error == std::errc() && end == word.data() + word.size() && std::isfinite(value), what,
         ": '", TextReader::shown(word), "' is no finite number");
  return value;
}

long long UsdaScanner::integer(std::string_view what) {
  const std::string_view word = numberWord(what);
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  expect(error == std::errc() && end == word.data() + word.size(), what, ": '",
         TextReader::shown(word), "' is no whole number");
  return value;
}

bool UsdaScanner::takeSign(char sign) {
  if (peeked_) goTo(tokenPlace_);
  skipBlanks();
  if (look() != sign) return false;
  take();
  return true;
}

UsdaScanner::Place UsdaScanner::place() {
  peek();
  return tokenPlace_;
}

void UsdaScanner::goTo(Place place) {
  peeked_ = false;
  line_ = place.line;
  if (place.offset >= blockOffset_ && place.offset <= blockOffset_ + size_) {
    at_ = place.offset - blockOffset_;
    return;
  }
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(place.offset));
  expect(stream_.good(), "cannot go back in the file");
  blockOffset_ = place.offset;
  at_ = size_ = 0;
}

}  // namespace hair
