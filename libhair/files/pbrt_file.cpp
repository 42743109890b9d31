#include <libhair/files/pbrt_file.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include <libhair/core/error.h>
#include <libhair/files/number_text.h>
#include <libhair/files/text_reader.h>
#include <libhair/files/usda/usda_curves.h>

namespace hair {

namespace {

struct Token {
  enum class Kind : std::uint8_t { End, Word, String, Open, Close } kind = Kind::End;
  std::string_view text;  // a word is a directive, a number, true or false
};

// Words, strings in quotes and brackets; # begins a comment.
class Scanner {
 public:
  Scanner(std::string_view bytes, std::string_view name) : rest_(bytes), name_(name) { advance(); }
  const Token& peek() const { return token_; }
  Token next() {
    const Token token = token_;
    advance();
    return token;
  }
  template <class... Parts>
  void expect(bool condition, const Parts&... parts) const {
    require(condition, name_, ": line ", line_, ": ", parts...);
  }

 private:
  void advance() {
    skipBlanks();
    if (rest_.empty()) {
      token_ = {};
      return;
    }
    const char c = rest_[0];
    if (c == '"') {
      const std::size_t end = rest_.find_first_of("\"\n", 1);
      expect(end != std::string_view::npos && rest_[end] == '"',
             "a string does not end in its line");
      token_ = {Token::Kind::String, rest_.substr(1, end - 1)};
      rest_.remove_prefix(end + 1);
    } else if (c == '[' || c == ']') {
      token_ = {c == '[' ? Token::Kind::Open : Token::Kind::Close, rest_.substr(0, 1)};
      rest_.remove_prefix(1);
    } else {
      const std::size_t end = std::min(rest_.find_first_of(" \t\r\n\"[]#"), rest_.size());
      token_ = {Token::Kind::Word, rest_.substr(0, end)};
      rest_.remove_prefix(end);
    }
  }
  void skipBlanks() {
    while (!rest_.empty()) {
      const char c = rest_[0];
      if (c == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
        line_ += c == '\n';
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  std::string_view rest_;
  std::string name_;
  Token token_;
  std::size_t line_ = 1;
};

bool isNumber(std::string_view word) {
  return !word.empty() &&
         (word[0] == '-' || word[0] == '+' || word[0] == '.' || (word[0] >= '0' && word[0] <= '9'));
}

class Reader {
 public:
  Reader(std::string_view bytes, std::string_view name) : in_(bytes, name) {}

  StrandFile read() {
    while (in_.peek().kind != Token::Kind::End) {
      const Token token = in_.next();
      if (token.kind == Token::Kind::Word && !isNumber(token.text)) directive(token.text);
    }
    endStrand();
    in_.expect(file_.strands.strandCount() > 0, "the file ends without any Shape \"curve\"",
               includes_ ? "; files that it includes are not followed: read those" : "");
    // What no curve states is 1 in pbrt, which is no hair's.
    if (!anyWidth_) file_.thickness.clear();
    file_.format = "pbrt";
    return std::move(file_);
  }

 private:
  void directive(std::string_view word) {
    if (word == "Shape") return shape();
    if (word == "Include" || word == "Import") includes_ = true;
    if (word == "AttributeBegin" || word == "TransformBegin" || word == "ObjectBegin") {
      in_.expect(saved_.size() < 100'000, "too many blocks inside one another");
      saved_.push_back(now_);
    } else if (word == "AttributeEnd" || word == "TransformEnd" || word == "ObjectEnd") {
      in_.expect(!saved_.empty(), word, " ends nothing");
      now_ = saved_.back();
      saved_.pop_back();
    } else if (word == "Identity" || word == "WorldBegin") {
      now_ = glm::dmat4(1);
    } else if (word == "Translate") {
      const auto v = numbers<3>(word);
      now_ = glm::translate(now_, {v[0], v[1], v[2]});
    } else if (word == "Scale") {
      const auto v = numbers<3>(word);
      now_ = glm::scale(now_, {v[0], v[1], v[2]});
    } else if (word == "Rotate") {
      const auto v = numbers<4>(word);
      const glm::dvec3 axis(v[1], v[2], v[3]);
      in_.expect(glm::length(axis) > 0, "Rotate: an axis of length 0");
      now_ = glm::rotate(now_, glm::radians(v[0]), glm::normalize(axis));
    } else if (word == "LookAt") {
      const auto v = numbers<9>(word);
      lookAt({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]});
    } else if (word == "Transform" || word == "ConcatTransform") {
      const auto v = numbers<16>(word);
      glm::dmat4 m;  // column by column
      std::size_t next = 0;
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) m[c][r] = v[next++];
      now_ = word == "Transform" ? m : now_ * m;
    }
  }

  // pbrt's camera looks along +z in a left-handed space.
  void lookAt(glm::dvec3 eye, glm::dvec3 at, glm::dvec3 up) {
    const glm::dvec3 z = glm::normalize(at - eye), x = glm::normalize(glm::cross(up, z)),
                     y = glm::cross(z, x);
    const glm::dmat4 m(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(eye, 1));
    in_.expect(std::abs(glm::determinant(m)) > 0, "LookAt: no direction");
    now_ = now_ * glm::inverse(m);
  }

  template <std::size_t count>
  std::array<double, count> numbers(std::string_view what) {
    std::array<double, count> values{};
    if (in_.peek().kind == Token::Kind::Open) in_.next();
    for (double& value : values) value = number(what);
    return values;
  }

  double number(std::string_view what) {
    const Token token = in_.next();
    double value = 0;
    std::string_view word = token.text;
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    in_.expect(token.kind == Token::Kind::Word && error == std::errc() &&
                   end == word.data() + word.size() && std::abs(value) < 1e30,
               what, ": '", TextReader::shown(token.text), "' is no number");
    return value;
  }

  // Numbers in brackets, or one without.
  void values(std::string_view what, std::vector<double>& out) {
    out.clear();
    if (in_.peek().kind != Token::Kind::Open) {
      out.push_back(number(what));
      return;
    }
    in_.next();
    while (in_.peek().kind != Token::Kind::Close) out.push_back(number(what));
    in_.next();
  }

  void shape() {
    const bool curve = in_.next().text == "curve";
    std::string_view basis = "bezier";
    double degree = 3;
    std::optional<double> width0, width1;
    points_.clear();
    while (in_.peek().kind == Token::Kind::String) {
      const std::string_view parameter = in_.next().text;
      const std::string_view name = parameter.substr(parameter.find_last_of(' ') + 1);
      const bool isText = parameter.starts_with("string");
      if (!curve ||
          (name != "P" && name != "basis" && name != "degree" && !name.starts_with("width"))) {
        skipValue();
      } else if (isText) {
        const bool bracket = in_.peek().kind == Token::Kind::Open;
        if (bracket) in_.next();
        basis = in_.next().text;
        if (bracket) in_.next();
      } else {
        values(name, name == "P" ? points_ : scratch_);
        if (name == "P") continue;
        in_.expect(!scratch_.empty(), name, ": a number is missing");
        if (name == "degree") degree = scratch_[0];
        if (name == "width" || name == "width0") width0 = scratch_[0];
        if (name == "width" || name == "width1") width1 = scratch_[0];
      }
    }
    if (curve) addCurve(basis, degree, width0, width1);
  }

  void skipValue() {
    if (in_.next().kind != Token::Kind::Open) return;
    while (in_.peek().kind != Token::Kind::Close) {
      in_.expect(in_.peek().kind != Token::Kind::End, "the file ends within brackets (truncated)");
      in_.next();
    }
    in_.next();
  }

  // Any curve of pbrt is a row of cubic Bezier curves.
  void addCurve(std::string_view basis, double degree, std::optional<double> width0,
                std::optional<double> width1) {
    const bool bspline = basis == "bspline", square = degree == 2;
    in_.expect(bspline || basis == "bezier", "a curve of basis '", TextReader::shown(basis),
               "'; bezier and bspline are read");
    in_.expect(square || degree == 3, "a curve of degree ", degree, "; 2 and 3 are read");
    const std::size_t step = bspline ? 1 : square ? 2 : 3, corners = square ? 3 : 4;
    const std::size_t n = points_.size() / 3;
    in_.expect(points_.size() % 3 == 0 && n >= corners && (n - corners) % step == 0,
               "a curve with ", points_.size(),
               " numbers in P, which does not fit its basis and degree");
    std::vector<glm::dvec3> p(n);
    for (std::size_t i = 0; i < n; ++i)
      p[i] =
          glm::dvec3(now_ * glm::dvec4(points_[3 * i], points_[3 * i + 1], points_[3 * i + 2], 1));
    const std::size_t segments = (n - corners) / step + 1;
    std::vector<glm::vec3> bezier;
    for (std::size_t s = 0; s < segments; ++s) {
      const glm::dvec3* q = p.data() + s * step;
      std::array<glm::dvec3, 4> b;
      if (square) {
        const glm::dvec3 from = bspline ? (q[0] + q[1]) / 2.0 : q[0],
                         to = bspline ? (q[1] + q[2]) / 2.0 : q[2];
        b = {from, (from + 2.0 * q[1]) / 3.0, (to + 2.0 * q[1]) / 3.0, to};
      } else if (bspline) {
        b = {(q[0] + 4.0 * q[1] + q[2]) / 6.0, (2.0 * q[1] + q[2]) / 3.0, (q[1] + 2.0 * q[2]) / 3.0,
             (q[1] + 4.0 * q[2] + q[3]) / 6.0};
      } else {
        b = {q[0], q[1], q[2], q[3]};
      }
      for (std::size_t k = s == 0 ? 0 : 1; k < 4; ++k) bezier.emplace_back(b[k]);
    }
    for (const glm::vec3& v : bezier)
      in_.expect(std::isfinite(v.x + v.y + v.z), "a transform takes a curve beyond all numbers");
    append(bezier, width0, width1);
  }

  void append(const std::vector<glm::vec3>& bezier, std::optional<double> width0,
              std::optional<double> width1) {
    anyWidth_ = anyWidth_ || width0 || width1;
    const double larger = std::cbrt(std::abs(glm::determinant(glm::dmat3(now_))));
    const auto from = static_cast<float>(larger * width0.value_or(1)),
               to = static_cast<float>(larger * width1.value_or(1));
    // Near enough: text has few digits.
    const bool goesOn = !strand_.empty() && glm::distance(strand_.back(), bezier.front()) <=
                                                1e-4f * glm::distance(bezier.front(), bezier[1]);
    if (!goesOn) endStrand();
    strand_.insert(strand_.end(), bezier.begin() + (goesOn ? 1 : 0), bezier.end());
    const std::size_t segments = (bezier.size() - 1) / 3;
    for (std::size_t s = goesOn ? 1 : 0; s <= segments; ++s)
      widths_.push_back(glm::mix(from, to, static_cast<float>(s) / static_cast<float>(segments)));
  }

  void endStrand() {
    if (strand_.empty()) return;
    require(strand_.size() < (std::size_t{1} << 28), "a curve of more than 2^28 vertices");
    const auto samples =
        pointsOfCurve({UsdaCurveKind::Basis::Bezier, UsdaCurveKind::Wrap::Nonperiodic},
                      static_cast<std::uint32_t>(strand_.size()));
    placed_.clear();
    for (const UsdaCurvePoint& sample : samples) {
      glm::vec3 p(0);
      for (std::size_t k = 0; k < 4; ++k) p += sample.weight[k] * strand_[sample.vertex[k]];
      placed_.push_back(p);
      file_.thickness.push_back(
          glm::mix(widths_[sample.varying], widths_[sample.nextVarying], sample.t));
    }
    file_.strands.append(placed_);
    strand_.clear();
    widths_.clear();
  }

  Scanner in_;
  glm::dmat4 now_{1};
  std::vector<glm::dmat4> saved_;
  std::vector<double> points_, scratch_;
  std::vector<glm::vec3> strand_, placed_;  // vertices of Bezier curves; points of a strand
  std::vector<float> widths_;               // where Bezier curves of the strand meet
  bool includes_ = false, anyWidth_ = false;
  StrandFile file_;
};

}  // namespace

StrandFile parsePbrt(std::string_view bytes, std::string_view name) {
  return Reader(bytes, name).read();
}

}  // namespace hair
