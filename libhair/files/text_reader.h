#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <libhair/core/error.h>
#include <libhair/files/number_text.h>

namespace hair {

/// Reads words from text in memory, line by line. Lines end with LF, CR LF or CR, in any mixture;
/// spaces and tabs separate words. Throws Error that names file, line and cause.
class TextReader {
 public:
  /// `name` names the file in messages; `bytes` must outlive the reader.
  TextReader(std::string_view bytes, std::string_view name) : rest_(bytes), name_(name) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // byte order mark of UTF-8
  }

  /// Goes on to the next line that holds a word; false at the end.
  bool nextLine() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find_first_of("\r\n");
      line_ = rest_.substr(0, end);
      lineEnded_ = end != std::string_view::npos;
      if (end == std::string_view::npos) {
        rest_ = {};
      } else {
        const bool crlf = rest_.substr(end, 2) == "\r\n";
        rest_.remove_prefix(end + (crlf ? 2 : 1));
      }
      ++lineNumber_;
      skipBlanks();
      if (!line_.empty()) return true;
    }
    line_ = {};
    return false;
  }

  std::size_t lineNumber() const { return lineNumber_; }
  /// Bytes after this line.
  std::size_t left() const { return rest_.size(); }
  bool lineDone() const { return line_.empty(); }
  /// Whether the line ends with a line end, which the last of a file may lack.
  bool lineEnded() const { return lineEnded_; }
  /// First character of what is left of the line; 0 at its end.
  char front() const { return line_.empty() ? '\0' : line_.front(); }
  /// What is left of the line, without blanks around it.
  std::string_view restOfLine() const {
    std::string_view t = line_;
    while (!t.empty() && isBlank(t.back())) t.remove_suffix(1);
    return t;
  }

  /// The next word of the line; empty at its end.
  std::string_view word() {
    std::size_t end = 0;
    while (end < line_.size() && !isBlank(line_[end])) ++end;
    const std::string_view w = line_.substr(0, end);
    line_.remove_prefix(end);
    skipBlanks();
    return w;
  }

  /// The next word of the line as a finite number; `what` names it in messages.
  float number(std::string_view what) {
    const std::string_view w = word();
    expect(!w.empty(), what, ": a number is missing at the end of the line");
    return toNumber(w, what);
  }

  float toNumber(std::string_view w, std::string_view what) const {
    const std::optional<float> value = floatFromText(w);
    expect(value.has_value(), what, ": '", shown(w), "' is no finite number");
    return value.value_or(0.0f);
  }

  double toDouble(std::string_view w, std::string_view what) const {
    double value = 0;
    const std::string_view digits = w.starts_with('+') ? w.substr(1) : w;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    expect(error == std::errc() && end == digits.data() + digits.size() &&
               std::abs(value) <= std::numeric_limits<float>::max(),
           what, ": '", shown(w), "' is no finite number");
    return value;
  }

  long long toInteger(std::string_view w, std::string_view what) const {
    long long value = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    expect(error == std::errc() && end == w.data() + w.size(), what, ": '", shown(w),
           "' is no whole number");
    return value;
  }

  /// A piece of the file fit for a message: short, without control characters.
  static std::string shown(std::string_view w) {
    std::string s(w.substr(0, 40));
    for (char& c : s)
      if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
    return w.size() > 40 ? s + "..." : s;
  }

  template <class... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    failAt(lineNumber_, parts...);
  }
  /// The same for an earlier line.
  template <class... Parts>
  [[noreturn]] void failAt(std::size_t line, const Parts&... parts) const {
    throw Error(text(name_, ": line ", line, ": ", parts...));
  }
  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    if (!condition) fail(parts...);
  }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  void skipBlanks() {
    std::size_t i = 0;
    while (i < line_.size() && isBlank(line_[i])) ++i;
    line_.remove_prefix(i);
  }

  std::string_view rest_, line_;
  std::string name_;
  std::size_t lineNumber_ = 0;
  bool lineEnded_ = false;
};

}  // namespace hair
