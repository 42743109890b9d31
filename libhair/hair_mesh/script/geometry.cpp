// Script operations that move vertices, or switch automatic placement.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/hair_mesh/interior_placement.h>
#include <libhair/hair_mesh/script/workshop.h>

namespace hair {

namespace {

// move(p, weight) for each vertex of the target.
template <class Move>
void moveVertices(Workshop& w, const Target& target, const Move& move) {
  for (const TargetVertex& t : verticesOf(w, target)) {
    glm::vec3& p = w.mesh().layers[t.layer].positions[t.vertex];
    p = move(p, t.weight);
    require(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e4f, "layer ", t.layer, ", vertex ",
            t.vertex, " would be ", glm::length(p), " m away");
  }
  w.afterGeometry();
}

// move TARGET DX DY DZ
ScriptStep readMove(ScriptWords& words) {
  const Target target = readTarget(words);
  const glm::vec3 by = words.point("way");
  return [=](Workshop& w) {
    moveVertices(w, target, [&](glm::vec3 p, float weight) { return p + weight * by; });
  };
}

// scale TARGET about X Y Z by SX SY SZ
ScriptStep readScale(ScriptWords& words) {
  const Target target = readTarget(words);
  glm::vec3 about(0), by(1);
  words.options({{"about", [&] { about = words.point("about"); }},
                 {"by", [&] { by = words.point("by", 100); }}});
  return [=](Workshop& w) {
    moveVertices(w, target, [&](glm::vec3 p, float weight) {
      return about + glm::mix(glm::vec3(1), by, weight) * (p - about);
    });
  };
}

// About a unit axis (Rodrigues).
glm::vec3 turned(glm::vec3 v, glm::vec3 axis, float radians) {
  const float c = std::cos(radians), s = std::sin(radians);
  return c * v + s * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}

// rotate TARGET DEGREES [about X Y Z] [axis X Y Z]
ScriptStep readRotate(ScriptWords& words) {
  const Target target = readTarget(words);
  const float radians = words.number("degrees", -3600, 3600) * std::numbers::pi_v<float> / 180;
  glm::vec3 about(0), axis(0, 1, 0);
  words.options({{"about", [&] { about = words.point("about"); }},
                 {"axis", [&] { axis = words.direction("axis"); }}});
  return [=](Workshop& w) {
    moveVertices(w, target, [&](glm::vec3 p, float weight) {
      return about + turned(p - about, axis, weight * radians);
    });
  };
}

// gather TARGET X Y Z SHARE
ScriptStep readGather(ScriptWords& words) {
  const Target target = readTarget(words);
  const glm::vec3 to = words.point("point");
  const float share = words.number("share", -1, 1);
  return [=](Workshop& w) {
    moveVertices(w, target,
                 [&](glm::vec3 p, float weight) { return glm::mix(p, to, weight * share); });
  };
}

// fall TARGET SHARE: towards hanging down from the vertex below; steps keep their lengths
ScriptStep readFall(ScriptWords& words) {
  const Target target = readTarget(words);
  const float share = words.number("share", 0, 1);
  return [=](Workshop& w) {
    const HairMesh before = w.mesh();
    for (const TargetVertex& t : verticesOf(w, target)) {  // from below upwards
      const std::uint32_t on = before.layers[t.layer].below[t.vertex];
      const glm::vec3 step =
          before.layers[t.layer].positions[t.vertex] - before.layers[t.layer - 1].positions[on];
      const float length = glm::length(step);
      const glm::vec3 wanted = glm::mix(step, {0, -length, 0}, t.weight * share);
      const float got = glm::length(wanted);
      w.mesh().layers[t.layer].positions[t.vertex] =
          w.mesh().layers[t.layer - 1].positions[on] +
          (got > 0 ? wanted * (length / got) : glm::vec3(0, -length, 0));
    }
    w.afterGeometry();
  };
}

struct Neighbours {
  std::vector<glm::vec3> sum;
  std::vector<float> count;
};

// Of each vertex: those beside it in its layer, below it and above it.
std::vector<Neighbours> neighboursOf(const HairMesh& mesh) {
  std::vector<Neighbours> all(mesh.layerCount());
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].sum.assign(mesh.layers[k].vertexCount(), glm::vec3(0));
    all[k].count.assign(mesh.layers[k].vertexCount(), 0);
  }
  const auto add = [&](std::size_t k, std::uint32_t v, glm::vec3 p) {
    all[k].sum[v] += p;
    ++all[k].count[v];
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    const HairMesh::Layer& layer = mesh.layers[k];
    for (std::uint32_t v = 0; k > 0 && v < layer.vertexCount(); ++v) {
      add(k, v, mesh.layers[k - 1].positions[layer.below[v]]);
      add(k - 1, layer.below[v], layer.positions[v]);
    }
    for (std::uint32_t j = 0; j < mesh.bundleCount(); ++j)
      for (std::uint32_t c = mesh.firstCorner[j];
           mesh.lastLayer[j] >= k && c < mesh.firstCorner[j + 1]; ++c) {
        const std::uint32_t a = layer.corners[c], b = layer.corners[mesh.nextCorner(j, c)];
        add(k, a, layer.positions[b]);
        add(k, b, layer.positions[a]);
      }
  }
  return all;
}

// smooth TARGET SHARE [times N]
ScriptStep readSmooth(ScriptWords& words) {
  const Target target = readTarget(words);
  const float share = words.number("share", 0, 1);
  std::uint32_t times = 1;
  words.options({{"times", [&] { times = words.whole("times", 1, 100); }}});
  return [=](Workshop& w) {
    const std::vector<TargetVertex> vertices = verticesOf(w, target);
    for (std::uint32_t i = 0; i < times; ++i) {
      w.spend();
      const std::vector<Neighbours> near = neighboursOf(w.mesh());
      for (const TargetVertex& t : vertices) {
        glm::vec3& p = w.mesh().layers[t.layer].positions[t.vertex];
        p = glm::mix(p, near[t.layer].sum[t.vertex] / near[t.layer].count[t.vertex],
                     t.weight * share);
      }
    }
    w.afterGeometry();
  };
}

// keep-out TARGET METRES: at least so far from the head
ScriptStep readKeepOut(ScriptWords& words) {
  const Target target = readTarget(words);
  const float least = words.number("distance", 0, 0.2f);
  return [=](Workshop& w) {
    moveVertices(w, target, [&](glm::vec3 p, float weight) {
      for (int i = 0; i < 8; ++i) {
        const float lacks = weight * least - w.obstacle(p);
        if (lacks <= 0) break;
        p += lacks * outwards(w.obstacle, p);
      }
      return p;
    });
  };
}

template <std::uint8_t kPinned>
ScriptStep readPin(ScriptWords& words) {
  const Target target = readTarget(words);
  return [=](Workshop& w) {
    for (const TargetVertex& t : verticesOf(w, target))
      w.mesh().layers[t.layer].pinned[t.vertex] = kPinned;
    w.afterGeometry();
  };
}

ScriptStep readPlace(ScriptWords&) {
  return [](Workshop& w) {
    w.selected("all");
    w.place();
  };
}

// auto-place on | off
ScriptStep readAutoPlace(ScriptWords& words) {
  const bool on = words.take("on");
  words.expect(on || words.take("off"), "auto-place is `on` or `off`");
  return [on](Workshop& w) { w.autoPlace = on; };
}

}  // namespace

std::span<const ScriptCommand> geometryCommands() {
  static constexpr ScriptCommand kCommands[] = {
      {"move", readMove},        {"scale", readScale},         {"rotate", readRotate},
      {"gather", readGather},    {"fall", readFall},           {"smooth", readSmooth},
      {"keep-out", readKeepOut}, {"pin", readPin<1>},          {"unpin", readPin<0>},
      {"place", readPlace},      {"auto-place", readAutoPlace}};
  return kCommands;
}

}  // namespace hair
