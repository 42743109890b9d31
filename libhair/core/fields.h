#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <glm/glm.hpp>

#include <libhair/core/api.h>
#include <libhair/core/error.h>

namespace HAIR_API hair {

/// Tables of settings. Beside each struct of settings stands the list of its fields,
///
///   constexpr auto fieldsOf(const GuideSettings*) {
///     using S = GuideSettings;
///     return std::tuple(Field("airDrag", &S::airDrag, "[0, 1e4) 1/s"), ...);
///   }
///
/// and beside each enumeration the words for its values,
///
///   constexpr auto wordsOf(LinkSolver) {
///     return std::array{Word("direct", LinkSolver::Direct), ...};
///   }
///
/// Validation, the Python package, and choices in the C interface and on command lines read them.

/// An interval of numbers, written as in mathematics: "[0, 1e4) 1/s". What follows the interval is
/// for readers; but a vector with "each" there has every component in it, else its length.
class Range {
 public:
  /// Any number.
  constexpr Range() = default;
  /// Ill-formed where `text` is no interval.
  consteval Range(const char* text) : text_(text) {
    std::string_view rest = text_;
    closedBelow_ = take(rest, "[(") == '[';
    least_ = number(rest);
    take(rest, ",");
    take(rest, " ");
    most_ = number(rest);
    closedAbove_ = take(rest, "])") == ']';
    each_ = rest.find("each") != std::string_view::npos;
  }

  /// Whether x is in it. For a float, the ends are rounded to floats. NaN is in no interval.
  template <class T>
  constexpr bool holds(T x) const {
    using Number = std::conditional_t<std::is_integral_v<T>, double, T>;
    if (text_.empty()) return true;
    const auto number = static_cast<Number>(x), least = static_cast<Number>(least_),
               most = static_cast<Number>(most_);
    return (closedBelow_ ? number >= least : number > least) &&
           (closedAbove_ ? number <= most : number < most);
  }
  /// Whether its length or, with "each", every component is in it.
  bool holds(glm::vec3 v) const {
    return each_ ? holds(v.x) && holds(v.y) && holds(v.z) : holds(glm::length(v));
  }

  constexpr double least() const { return least_; }          ///< its lower end
  constexpr double most() const { return most_; }            ///< its upper end
  constexpr std::string_view text() const { return text_; }  ///< as written; empty: any

 private:
  static consteval char take(std::string_view& rest, std::string_view oneOf) {
    if (rest.empty() || oneOf.find(rest[0]) == std::string_view::npos) throw "not an interval";
    const char first = rest[0];
    rest.remove_prefix(1);
    return first;
  }
  // Decimal digits, a point, an exponent; or inf.
  static consteval double number(std::string_view& rest) {
    const bool negative = rest.starts_with('-');
    if (negative) rest.remove_prefix(1);
    double value = 0;
    if (rest.starts_with("inf")) {
      rest.remove_prefix(3);
      value = std::numeric_limits<double>::infinity();
    } else {
      int exponent = 0;
      bool digits = false;
      for (bool fraction = false; !rest.empty(); rest.remove_prefix(1)) {
        if (rest[0] == '.') {
          fraction = true;
          continue;
        }
        if (rest[0] < '0' || rest[0] > '9') break;
        value = 10 * value + (rest[0] - '0');
        exponent -= fraction;
        digits = true;
      }
      if (!digits) throw "not a number";
      if (rest.starts_with('e')) {
        rest.remove_prefix(1);
        const bool down = rest.starts_with('-');
        if (down) rest.remove_prefix(1);
        int power = 0;
        for (; !rest.empty() && rest[0] >= '0' && rest[0] <= '9'; rest.remove_prefix(1))
          power = 10 * power + (rest[0] - '0');
        exponent += down ? -power : power;
      }
      double scale = 1;
      for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) scale *= 10;
      value = exponent < 0 ? value / scale : value * scale;
    }
    return negative ? -value : value;
  }

  std::string_view text_;
  double least_ = 0, most_ = 0;
  bool closedBelow_ = true, closedAbove_ = true, each_ = false;
};

/// A field of the settings S: its name in C++, its member, its range (numbers and vectors).
template <class S, class M>
struct Field {
  /// A row of a table.
  constexpr Field(std::string_view name_, M S::* member_, Range range_ = {})
      : name(name_), member(member_), range(range_) {}

  std::string_view name;  ///< in C++
  M S::* member;          ///< of S, or of what S is derived from
  Range range;            ///< of numbers and vectors
};

/// The word for a value of an enumeration.
template <class E>
struct Word {
  /// A row of a table.
  constexpr Word(std::string_view word_, E value_) : word(word_), value(value_) {}

  std::string_view word;  ///< on command lines and in Python
  E value;                ///< what it means
};

/// An enumeration with a table of words.
template <class E>
concept HasWords = std::is_enum_v<E> && requires { wordsOf(E{}); };
/// Settings with a table of fields.
template <class S>
concept HasFields = requires(const S* settings) { fieldsOf(settings); };

/// Calls visit(field) for every Field of S.
template <HasFields S, class Visit>
constexpr void forFields(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); },
             fieldsOf(static_cast<const S*>(nullptr)));
}

/// The range of one field, by its member: rangeOf(&GuideSettings::iterations). Ill-formed for a
/// member that is in no table.
template <class S, class M>
consteval Range rangeOf(M S::* member) {
  Range range;
  bool found = false;
  forFields<S>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.member), M S::*>)
      if (field.member == member) range = field.range, found = true;
  });
  if (!found) throw "no such field";
  return range;
}

/// The word for `value`; empty for a value that has none.
template <HasWords E>
constexpr std::string_view wordOf(E value) {
  for (const auto& word : wordsOf(E{}))
    if (word.value == value) return word.word;
  return {};
}

/// "direct, relaxation"
template <HasWords E>
std::string allWords() {
  std::string all;
  for (const auto& word : wordsOf(E{})) all.append(all.empty() ? "" : ", ").append(word.word);
  return all;
}

/// camelCase as snake_case, the spelling in C and Python.
std::string snakeCase(std::string_view name);

/// Throws Error unless every number of `settings` is in its range and every choice is one that
/// exists: "guide settings: airDrag = -1 is not in [0, 1e4) 1/s". Settings within settings are
/// validated by their own `validate`. `what`: the name in the message.
template <HasFields S>
void validateFields(const S& settings, std::string_view what) {
  forFields<S>([&](const auto& field) {
    const auto& value = settings.*field.member;
    using M = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<M, glm::vec3>) {
      require(field.range.holds(value), what, ": ", field.name, " = (", value.x, ", ", value.y,
              ", ", value.z, ") is not in ", field.range.text());
    } else if constexpr (std::is_arithmetic_v<M>) {
      require(field.range.holds(value), what, ": ", field.name, " = ", value, " is not in ",
              field.range.text());
    } else if constexpr (HasWords<M>) {
      if (wordOf(value).empty())
        throw Error(text(what, ": ", field.name, " = ", static_cast<long long>(value),
                         " is none of ", allWords<M>()));
    } else if constexpr (requires { validate(value); }) {
      validate(value);
    }
  });
}

}  // namespace hair
