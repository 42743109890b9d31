#include <libhair/files/usda/usda_transform.h>

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace hair {

namespace {

using Numbers = std::array<double, 16>;

constexpr std::string_view kInvert = "!invert!", kReset = "!resetXformStack!", kOp = "xformOp:";

// Numbers in any brackets.
Numbers numbersAt(UsdaScanner& in, UsdaScanner::Place place, std::size_t count,
                  std::string_view what) {
  in.goTo(place);
  Numbers numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    while (in.takeSign('(') || in.takeSign(')') || in.takeSign(',')) {
    }
    numbers[i] = in.real(what);
  }
  return numbers;
}

Numbers numbersNear(UsdaScanner& in, const UsdaLayer::Attribute& attribute, double time,
                    std::size_t count, std::string_view what) {
  const auto [before, after, t] = samplesAround(attribute, time);
  Numbers a = numbersAt(in, before, count, what);
  if (t == 0) return a;
  Numbers b = numbersAt(in, after, count, what);
  for (std::size_t i = 0; i < count; ++i) a[i] = (1 - t) * a[i] + t * b[i];
  return a;
}

glm::dmat4 orientation(UsdaScanner& in, const UsdaLayer::Attribute& attribute, double time) {
  const auto [before, after, t] = samplesAround(attribute, time);
  const auto at = [&](UsdaScanner::Place place) {
    const Numbers n = numbersAt(in, place, 4, "orient");
    const glm::dquat q(n[0], n[1], n[2], n[3]);
    in.expect(glm::length(q) > 1e-9, "orient: a quaternion of length 0");
    return glm::normalize(q);
  };
  const glm::dquat a = at(before);
  return glm::mat4_cast(t == 0 ? a : glm::slerp(a, at(after), t));
}

glm::dmat4 turned(int axis, double degrees) {
  glm::dvec3 about(0);
  about[axis] = 1;
  return glm::rotate(glm::dmat4(1), glm::radians(degrees), about);
}

// One operation: `word` is "xformOp:rotateXYZ" or "xformOp:translate:pivot".
glm::dmat4 operation(UsdaScanner& in, const UsdaLayer::Attribute& attribute, std::string_view word,
                     double time) {
  std::string_view kind = word.substr(kOp.size());
  kind = kind.substr(0, kind.find(':'));
  const auto numbers = [&](std::size_t count) {
    return numbersNear(in, attribute, time, count, kind);
  };
  if (kind == "transform") {
    const Numbers n = numbers(16);
    glm::dmat4 m;  // rows of the file, which multiplies from the left, are columns here
    std::size_t next = 0;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) m[r][c] = n[next++];
    return m;
  }
  if (kind == "orient") return orientation(in, attribute, time);
  if (kind == "translate" || kind == "scale") {
    const Numbers n = numbers(3);
    const glm::dvec3 v(n[0], n[1], n[2]);
    return kind == "scale" ? glm::scale(glm::dmat4(1), v) : glm::translate(glm::dmat4(1), v);
  }
  if (kind.starts_with("rotate")) {
    const std::string_view axes = kind.substr(6);
    const bool known = !axes.empty() && axes.find_first_not_of("XYZ") == std::string_view::npos;
    if (known && axes.size() == 1) return turned(axes[0] - 'X', numbers(1)[0]);
    if (known && axes.size() == 3) {
      // The first axis of the name is turned about first.
      const Numbers n = numbers(3);
      glm::dmat4 m(1);
      for (const char axis : axes)
        m = turned(axis - 'X', n[static_cast<std::size_t>(axis - 'X')]) * m;
      return m;
    }
  }
  in.fail("'", TextReader::shown(word), "' is no transform of USD");
}

// Calls `each` with every operation of a prim, the last one first; false where it says that
// transforms of parents do not count.
template <class Each>
bool forOperations(const UsdaLayer::Prim& prim, Each&& each) {
  for (std::size_t i = prim.ops.size(); i-- > 0;) {
    std::string_view word = prim.ops[i];
    if (word == kReset) return false;
    const bool inverted = word.starts_with(kInvert);
    if (inverted) word.remove_prefix(kInvert.size());
    if (!word.starts_with(kOp)) continue;
    if (const UsdaLayer::Attribute* attribute = prim.find(word)) each(*attribute, word, inverted);
  }
  return true;
}

}  // namespace

UsdaBetween samplesAround(const UsdaLayer::Attribute& attribute, double time) {
  const auto& samples = attribute.samples;
  const auto after =
      std::upper_bound(samples.begin(), samples.end(), time,
                       [](double t, const UsdaLayer::Sample& s) { return t < s.time; });
  if (after == samples.begin()) return {after->place, after->place, 0};
  const auto before = after - 1;
  if (after == samples.end() || before->time == time) return {before->place, before->place, 0};
  return {before->place, after->place, (time - before->time) / (after->time - before->time)};
}

glm::dmat4 stageFromPrim(UsdaScanner& in, const UsdaLayer& layer, std::size_t prim, double time) {
  glm::dmat4 stageFromPrim(1);
  for (std::size_t p = prim; p != UsdaLayer::kNone; p = layer.prims[p].parent) {
    const bool goOn = forOperations(layer.prims[p], [&](const UsdaLayer::Attribute& attribute,
                                                        std::string_view word, bool inverted) {
      glm::dmat4 m = operation(in, attribute, word, time);
      if (inverted) {
        in.expect(std::abs(glm::determinant(m)) > 0, TextReader::shown(word),
                  ": has no inverse, as !invert! asks");
        m = glm::inverse(m);
      }
      stageFromPrim = m * stageFromPrim;
    });
    if (!goOn) break;
  }
  return stageFromPrim;
}

void addTransformTimes(const UsdaLayer& layer, std::size_t prim, std::vector<double>& times) {
  for (std::size_t p = prim; p != UsdaLayer::kNone; p = layer.prims[p].parent) {
    const bool goOn = forOperations(
        layer.prims[p], [&](const UsdaLayer::Attribute& attribute, std::string_view, bool) {
          if (!attribute.animated) return;
          for (const UsdaLayer::Sample& sample : attribute.samples) times.push_back(sample.time);
        });
    if (!goOn) break;
  }
}

}  // namespace hair
