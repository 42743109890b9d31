#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/files/text_reader.h>

namespace hair {

/// The words of one line of a script; every failure is an Error that names file, line and cause.
class ScriptWords {
 public:
  /// The rest of the reader's line, up to a comment. `in` must outlive the words.
  explicit ScriptWords(TextReader& in) : in_(in) {
    while (!in.lineDone()) {
      const std::string_view word = in.word();
      if (word.starts_with('#')) break;
      words_.push_back(word);
    }
  }

  bool done() const { return at_ == words_.size(); }

  /// The next word; `what` names it in messages.
  std::string_view word(std::string_view what) {
    expect(!done(), what, " is missing at the end of the line");
    return words_[at_++];
  }

  /// Takes the next word if it is this one.
  bool take(std::string_view wanted) {
    if (done() || words_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  bool nextIsNumber() const { return !done() && words_[at_].find_first_of("0123456789+-.") == 0; }

  /// A name made by the script: a letter, then letters, digits, `-` and `_`.
  std::string name(std::string_view what) {
    const std::string_view w = word(what);
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    bool good = w.size() <= 64 && letter(w.front());
    for (const char c : w) good &= letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
    expect(good, what, ": '", TextReader::shown(w), "' is no name");
    return std::string(w);
  }

  float number(std::string_view what, float lowest, float highest) {
    const float value = in_.toNumber(word(what), what);
    expect(value >= lowest && value <= highest, what, ": ", value, " is not in ", lowest, " to ",
           highest);
    return value;
  }

  std::uint32_t whole(std::string_view what, std::uint32_t lowest, std::uint32_t highest) {
    return toWhole(word(what), what, lowest, highest);
  }

  std::uint32_t toWhole(std::string_view w, std::string_view what, std::uint32_t lowest,
                        std::uint32_t highest) const {
    const long long value = in_.toInteger(w, what);
    expect(value >= lowest && value <= highest, what, ": ", value, " is not in ", lowest, " to ",
           highest);
    return static_cast<std::uint32_t>(value);
  }

  /// "3" or "2..5".
  std::pair<std::uint32_t, std::uint32_t> range(std::string_view what, std::uint32_t lowest,
                                                std::uint32_t highest) {
    const std::string_view w = word(what);
    const std::size_t dots = w.find("..");
    const std::uint32_t first = toWhole(w.substr(0, dots), what, lowest, highest);
    if (dots == std::string_view::npos) return {first, first};
    return {first, toWhole(w.substr(dots + 2), what, first, highest)};
  }

  /// Three coordinates, metres.
  glm::vec3 point(std::string_view what, float farthest = 10) {
    glm::vec3 p;
    for (int c = 0; c < 3; ++c) p[c] = number(what, -farthest, farthest);
    return p;
  }

  glm::vec3 direction(std::string_view what) {
    const glm::vec3 d = point(what, 1e3f);
    expect(glm::length(d) > 1e-6f, what, ": a direction has a length");
    return glm::normalize(d);
  }

  /// Reads the rest of the line: keywords in any order, each at most once, each with the function
  /// that reads its arguments.
  void options(std::initializer_list<std::pair<std::string_view, std::function<void()>>> options) {
    std::vector<std::string_view> seen;
    while (!done()) {
      const std::string_view w = words_[at_++];
      const auto* const option =
          std::find_if(options.begin(), options.end(), [&](const auto& o) { return o.first == w; });
      std::string choices;
      for (const auto& o : options) (choices += choices.empty() ? "" : ", ") += o.first;
      expect(option != options.end(), "'", TextReader::shown(w), "' is not understood here",
             choices.empty() ? "" : "; there are: ", choices);
      expect(std::find(seen.begin(), seen.end(), w) == seen.end(), "'", w, "' is there twice");
      seen.push_back(w);
      option->second();
    }
  }

  void end() { options({}); }

  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    in_.expect(condition, parts...);
  }
  template <class... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    in_.fail(parts...);
  }

 private:
  const TextReader& in_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

}  // namespace hair
