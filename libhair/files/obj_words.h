#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <libhair/files/text_reader.h>

namespace hair {

/// What a reader of OBJ files does with a line after its first word. Coordinates from here on are
/// beyond all scales.
inline constexpr float kObjFarthest = 1e8f;

/// The rest of a `v` line; what follows the third number (w, colours) is left alone.
inline glm::vec3 objVertex(TextReader& in) {
  glm::vec3 p;
  for (int c = 0; c < 3; ++c) {
    p[c] = in.number("vertex");
    in.expect(std::abs(p[c]) < kObjFarthest, "vertex: ", p[c], " is beyond 1e8 (check the scale)");
  }
  return p;
}

/// The vertex, from 0, of a corner "7", "7/1", "7//3" or "-1" (counted back from the last so far).
inline std::uint32_t objCorner(const TextReader& in, std::string_view word,
                               std::size_t vertexCount) {
  const long long index = in.toInteger(word.substr(0, word.find('/')), "face");
  const auto count = static_cast<long long>(vertexCount);
  in.expect(index != 0 && index >= -count && index <= count, "face: vertex ", index,
            " does not exist (", count, " vertices so far)");
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
}

inline void expectObjFace(const TextReader& in, std::size_t corners) {
  in.expect(corners >= 3, "face: ", corners, " corners, needs at least 3");
}

}  // namespace hair
