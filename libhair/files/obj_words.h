#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <libhair/files/text_reader.h>

namespace hair {

/// Helpers to parse lines of OBJ files. Coordinates of this magnitude or more are rejected.
inline constexpr float kObjFarthest = 1e8f;

/// The next word of a line, which may go on in the next one behind a `\`; empty at its end.
inline std::string_view objWord(TextReader& in) {
  std::string_view word = in.word();
  while (word.ends_with('\\') && in.lineDone()) {
    word.remove_suffix(1);
    const bool more = in.nextLine();
    if (!word.empty() || !more) break;
    word = in.word();
  }
  return word;
}

/// The rest of a `v` line; what follows the third number (w, colours) is left alone.
inline glm::vec3 objVertex(TextReader& in) {
  glm::vec3 p;
  for (int c = 0; c < 3; ++c) {
    const std::string_view word = objWord(in);
    in.expect(!word.empty(), "vertex: a number is missing at the end of the line");
    p[c] = in.toNumber(word, "vertex");
    in.expect(std::abs(p[c]) < kObjFarthest, "vertex: ", p[c], " is beyond 1e8 (check the scale)");
  }
  return p;
}

/// The vertex, from 0, of a corner "7", "7/1", "7//3" or "-1" (counted back from the last so far).
/// `what` it is a corner of, in messages.
inline std::uint32_t objCorner(const TextReader& in, std::string_view word, std::size_t vertexCount,
                               std::string_view what = "face") {
  const long long index = in.toInteger(word.substr(0, word.find('/')), what);
  const auto count = static_cast<long long>(vertexCount);
  in.expect(index != 0 && index >= -count && index <= count, what, ": vertex ", index,
            " does not exist (", count, " vertices so far)");
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

inline void expectObjFace(const TextReader& in, std::size_t corners) {
  in.expect(corners >= 3, "face: ", corners, " corners, needs at least 3");
}

}  // namespace hair
