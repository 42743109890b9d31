// Script operations that gather hair and shape it: tails, knots, buns.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <libhair/core/error.h>
#include <libhair/core/rotations.h>
#include <libhair/core/transform.h>
#include <libhair/hair_mesh/operations.h>
#include <libhair/hair_mesh/script/growth.h>
#include <libhair/model/comb.h>
#include <libhair/model/guide_curve.h>
#include <libhair/model/head.h>

namespace hair {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr std::uint32_t kMostLayers = 1000;

struct Sweep {
  float scale = 1;  // of the section at the end
  float twist = 0;  // radians, all the way
};

struct Section {
  glm::vec3 centre{0}, normal{0};
};

Section sectionOf(const HairMesh& mesh, std::span<const std::uint32_t> bundles) {
  Section section;
  float count = 0;
  for (const std::uint32_t j : bundles) {
    const auto& positions = mesh.layers[mesh.lastLayer[j]].positions;
    const auto face = mesh.face(mesh.lastLayer[j], j);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const glm::vec3 a = positions[face[i]], b = positions[face[(i + 1) % face.size()]];
      section.centre += a;
      section.normal += glm::cross(a, b);
      ++count;
    }
  }
  section.centre /= count;
  return section;
}

// Carries the tips of the bundles along a dense polyline that starts in their middle.
void sweepAlong(Workshop& w, std::span<const std::uint32_t> bundles, std::uint32_t layers,
                const Section& section, std::span<const glm::vec3> dense, const Sweep& sweep) {
  HairMesh& mesh = w.mesh();
  std::size_t corners = 0;
  std::vector<std::uint32_t> tip;
  std::vector<std::vector<glm::vec3>> offsets;
  for (const std::uint32_t j : bundles) {
    tip.push_back(mesh.lastLayer[j]);
    corners += std::size_t{mesh.sides(j)} * layers;
    offsets.emplace_back();
    for (const std::uint32_t v : mesh.face(tip.back(), j))
      offsets.back().push_back(mesh.layers[tip.back()].positions[v] - section.centre);
  }
  w.requireRoom(corners, layers);

  std::vector<glm::vec3> path(layers + 1);
  equalLinks(dense, path);
  const auto towards = [&](std::size_t i) {
    const glm::vec3 d = path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0];
    return glm::length(d) > 1e-9f ? glm::normalize(d) : glm::vec3(0, -1, 0);
  };
  glm::vec3 tangent =
      glm::length(section.normal) > 1e-12f ? glm::normalize(section.normal) : towards(0);
  glm::quat turned(1, 0, 0, 0);
  for (std::uint32_t i = 1; i <= layers; ++i) {
    w.spend();
    extrudeFaces(bundles, 1e-3f, mesh);
    const glm::vec3 next = towards(i);
    turned = turnBetween(tangent, next) * turned;
    tangent = next;
    const float share = static_cast<float>(i) / static_cast<float>(layers);
    const float angle = share * sweep.twist, size = glm::mix(1.0f, sweep.scale, share);
    const glm::mat3 place = size * glm::mat3_cast(glm::angleAxis(angle, tangent) * turned);
    for (std::size_t b = 0; b < bundles.size(); ++b) {
      const auto face = mesh.face(tip[b] + i, bundles[b]);
      for (std::size_t corner = 0; corner < face.size(); ++corner)
        mesh.layers[tip[b] + i].positions[face[corner]] = path[i] + place * offsets[b][corner];
    }
  }
}

std::vector<glm::vec3> smoothPath(std::span<const glm::vec3> points) {
  std::vector<glm::vec3> dense(32 * (points.size() - 1) + 1);
  sampleGuide(points, dense);
  return dense;
}

// sweep SEL LAYERS [scale S] [twist DEGREES] through X Y Z [X Y Z ...]
ScriptStep readSweep(ScriptWords& words) {
  const std::string name = words.name("a selection");
  const std::uint32_t layers = words.whole("layers", 1, kMostLayers);
  Sweep sweep;
  std::vector<glm::vec3> points;
  words.options(
      {{"scale", [&] { sweep.scale = words.number("scale", 0.01f, 10); }},
       {"twist", [&] { sweep.twist = words.number("twist", -36'000, 36'000) * kPi / 180; }},
       {"through", [&] {
          do {
            points.push_back(words.point("way-point"));
            words.expect(points.size() <= 200, "a sweep may have 200 way-points");
          } while (words.nextIsNumber());
        }}});
  words.expect(!points.empty(), "`through X Y Z ...` is missing");
  return [=](Workshop& w) {
    const std::vector<std::uint32_t> bundles = w.bundles(name);
    const Section section = sectionOf(w.mesh(), bundles);
    std::vector<glm::vec3> way{section.centre};
    way.insert(way.end(), points.begin(), points.end());
    for (std::size_t i = 1; i < way.size(); ++i)
      require(glm::distance(way[i - 1], way[i]) > 1e-5f, "way-point ", i,
              " is where the one before it is");
    sweepAlong(w, bundles, layers, section, smoothPath(way), sweep);
  };
}

// coil SEL LAYERS about X Y Z axis X Y Z turns T [radius R] [rise H] [scale S] [twist DEGREES]
ScriptStep readCoil(ScriptWords& words) {
  const std::string name = words.name("a selection");
  const std::uint32_t layers = words.whole("layers", 1, kMostLayers);
  Sweep sweep;
  glm::vec3 about(0), axis(0);
  float turns = 1, radius = NAN, rise = 0;
  words.options(
      {{"about", [&] { about = words.point("about"); }},
       {"axis", [&] { axis = words.direction("axis"); }},
       {"turns", [&] { turns = words.number("turns", -50, 50); }},
       {"radius", [&] { radius = words.number("radius", 1e-3f, 1); }},
       {"rise", [&] { rise = words.number("rise", -1, 1); }},
       {"scale", [&] { sweep.scale = words.number("scale", 0.01f, 10); }},
       {"twist", [&] { sweep.twist = words.number("twist", -36'000, 36'000) * kPi / 180; }}});
  words.expect(axis != glm::vec3(0), "`axis X Y Z` is missing");
  return [=](Workshop& w) {
    const std::vector<std::uint32_t> bundles = w.bundles(name);
    const Section section = sectionOf(w.mesh(), bundles);
    const glm::vec3 from = section.centre - about;
    const float height = glm::dot(from, axis);
    const glm::vec3 out = from - height * axis;
    const float start = glm::length(out), end = std::isnan(radius) ? start : radius;
    require(std::max(start, end) > 1e-3f,
            "the tips are on the axis already: give `radius`, metres");
    const glm::vec3 u = start > 1e-4f ? out / start : anyNormal(axis), v = glm::cross(axis, u);
    const int steps = 16 + static_cast<int>(64 * std::abs(turns));
    std::vector<glm::vec3> dense;
    for (int i = 0; i <= steps; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(steps), turn = 2 * kPi * turns * t;
      const float r = glm::mix(start, end, glm::smoothstep(0.0f, 0.3f, t));
      dense.push_back(about + (height + rise * t) * axis +
                      r * (std::cos(turn) * u + std::sin(turn) * v));
    }
    require(glm::distance(dense[0], dense[1]) > 1e-7f, "the coil has no length");
    sweepAlong(w, bundles, layers, section, dense, sweep);
  };
}

// Path over the head from a root to its position in a disc of radius `radius` around `to`, across
// `axis`: the farther the root, the farther out in the disc.
struct Pull {
  glm::vec3 to{0}, axis{0};
  float radius = 0.02f, volume = 0.01f, clearance = 0.003f;
  float farthest = 0;  // of all roots, radians

  static float angleTo(glm::vec3 root, glm::vec3 pole) {
    return std::acos(std::clamp(glm::dot(glm::normalize(root - kSkullMiddle), pole), -1.0f, 1.0f));
  }
  glm::vec3 pole() const { return glm::normalize(to - kSkullMiddle); }

  void way(glm::vec3 root, std::span<glm::vec3> curve) const {
    const glm::vec3 p = pole(), start = glm::normalize(root - kSkullMiddle);
    const float angle = angleTo(root, p);
    glm::vec3 side = start - glm::dot(start, p) * p;
    side = glm::length(side) > 1e-5f ? glm::normalize(side) : anyNormal(p);
    const glm::vec3 place =
        to + transport(side, p, axis) * (radius * angle / std::max(farthest, 1e-3f));
    constexpr int kSteps = 48;
    std::array<glm::vec3, kSteps + 1> dense{root};
    for (int i = 1; i <= kSteps; ++i) {
      const float t = static_cast<float>(i) / kSteps, left = angle * (1 - t), gone = angle * t;
      const glm::vec3 ray = std::cos(left) * p + std::sin(left) * side;
      const float clear =
          std::min(clearance, 0.03f * gone) + volume * gone / std::max(farthest, 1e-3f);
      const glm::vec3 onHead = onScalp(kSkullMiddle + ray) + clear * ray;
      const glm::vec3 arriving = place - 0.03f * (1 - t) * axis;
      dense[static_cast<std::size_t>(i)] =
          glm::mix(onHead, arriving, glm::smoothstep(0.45f, 1.0f, t));
    }
    equalLinks(dense, curve);
  }
};

// pull SEL LAYERS to X Y Z [axis X Y Z] [radius R] [volume V] [clearance C]
ScriptStep readPull(ScriptWords& words) {
  const std::string name = words.name("a selection");
  const std::uint32_t layers = words.whole("layers", 2, kMostLayers);
  Pull pull;
  bool there = false;
  words.options({{"to",
                  [&] {
                    pull.to = words.point("to", 1);
                    there = true;
                  }},
                 {"axis", [&] { pull.axis = words.direction("axis"); }},
                 {"radius", [&] { pull.radius = words.number("radius", 1e-3f, 0.2f); }},
                 {"volume", [&] { pull.volume = words.number("volume", 0, 0.1f); }},
                 {"clearance", [&] { pull.clearance = words.number("clearance", 0, 0.1f); }}});
  words.expect(there, "`to X Y Z` is missing");
  words.expect(headField(pull.to) > 0, "to: this point is inside of the head");
  if (pull.axis == glm::vec3(0)) pull.axis = pull.pole();
  return [=](Workshop& w) {
    const std::vector<std::uint32_t> bundles = w.bundles(name);
    require(w.onHead, "only hair of the built-in head is pulled over it");
    Pull p = pull;
    for (const std::uint32_t j : bundles)
      for (const std::uint32_t v : w.mesh().face(0, j))
        p.farthest = std::max(p.farthest, Pull::angleTo(w.mesh().layers[0].positions[v], p.pole()));
    layAlong(w, bundles, layers,
             [&](glm::vec3 root, glm::vec3, std::span<glm::vec3> curve) { p.way(root, curve); });
  };
}

}  // namespace

std::span<const ScriptCommand> sweepCommands() {
  static constexpr ScriptCommand kCommands[] = {
      {"pull", readPull}, {"sweep", readSweep}, {"coil", readCoil}};
  return kCommands;
}

}  // namespace hair
