#include "bad_inputs.h"

#include <cmath>
#include <cstring>

#include <libhair/core/error.h>

namespace hair::extremes {

namespace {

KajiyaKaySettings& lookOf(Inputs& inputs) {
  return std::get<KajiyaKaySettings>(inputs.settings.appearance);
}

}  // namespace

const std::vector<BadInput>& badInputs() {
  using I = Inputs;
  constexpr bool kStart = true, kFrame = false;
  static const std::vector<BadInput> all = {
      {"guides.linearDensity", kStart,
       [](I& i) -> float& { return i.settings.guides.linearDensity; }},
      {"guides.bendingStiffness", kStart,
       [](I& i) -> float& { return i.settings.guides.bendingStiffness; }},
      {"guides.tipStiffness", kStart,
       [](I& i) -> float& { return i.settings.guides.tipStiffness; }},
      {"guides.bendDamping", kStart, [](I& i) -> float& { return i.settings.guides.bendDamping; }},
      {"guides.airDrag", kStart, [](I& i) -> float& { return i.settings.guides.airDrag; }},
      {"guides.carriedAir", kStart, [](I& i) -> float& { return i.settings.guides.carriedAir; }},
      {"guides.friction", kStart, [](I& i) -> float& { return i.settings.guides.friction; }},
      {"guides.skin", kStart, [](I& i) -> float& { return i.settings.guides.skin; }},
      {"guides.gravity.y", kStart, [](I& i) -> float& { return i.settings.guides.gravity.y; }},
      {"guides.substep", kStart, [](I& i) -> float& { return i.settings.guides.substep; }},
      {"repulsion.cellSize", kStart, [](I& i) -> float& { return i.settings.repulsion.cellSize; }},
      {"repulsion.threshold", kStart,
       [](I& i) -> float& { return i.settings.repulsion.threshold; }},
      {"repulsion.tolerance", kStart,
       [](I& i) -> float& { return i.settings.repulsion.tolerance; }},
      {"repulsion.strength", kStart, [](I& i) -> float& { return i.settings.repulsion.strength; }},
      {"repulsion.limit", kStart, [](I& i) -> float& { return i.settings.repulsion.limit; }},
      {"groom root", kStart, [](I& i) -> float& { return i.groom.guidePoints[0].x; }},
      {"groom point", kStart, [](I& i) -> float& { return i.groom.guidePoints[4].z; }},
      {"groom tip", kStart, [](I& i) -> float& { return i.groom.guidePoints.back().y; }},
      {"groom weight", kStart, [](I& i) -> float& { return i.groom.weights[3].y; }},
      {"groom offset", kStart, [](I& i) -> float& { return i.groom.offsets[20].x; }},
      {"fibre.width", kStart, [](I& i) -> float& { return i.groom.fibre.width; }},
      {"fibre.opacity", kStart, [](I& i) -> float& { return i.groom.fibre.opacity; }},
      {"fibre.hairsPerStrand", kStart, [](I& i) -> float& { return i.groom.fibre.hairsPerStrand; }},
      {"wisps.clearance", kStart, [](I& i) -> float& { return i.wisps.clearance; }},
      {"head at the start", kStart, [](I& i) -> float& { return i.head.translation.z; }},
      {"seconds", kFrame, [](I& i) -> float& { return i.seconds; }},
      {"head position", kFrame, [](I& i) -> float& { return i.head.translation.x; }},
      {"head rotation", kFrame, [](I& i) -> float& { return i.head.rotation.y; }},
      {"capsule end", kFrame, [](I& i) -> float& { return i.capsules[0].a.x; }},
      {"capsule radius", kFrame, [](I& i) -> float& { return i.capsules[0].radius; }},
      {"push", kFrame, [](I& i) -> float& { return i.push.x; }},
      {"wind.velocity", kFrame, [](I& i) -> float& { return i.settings.wind.velocity.x; }},
      {"wind.gust", kFrame, [](I& i) -> float& { return i.settings.wind.gust; }},
      {"wind.gustLength", kFrame, [](I& i) -> float& { return i.settings.wind.gustLength; }},
      {"light.direction", kFrame, [](I& i) -> float& { return i.settings.lights[0].direction.y; }},
      {"light.position", kFrame, [](I& i) -> float& { return i.settings.lights[1].position.y; }},
      {"light.colour", kFrame, [](I& i) -> float& { return i.settings.lights[0].colour.r; }},
      {"map.cellSize", kFrame, [](I& i) -> float& { return i.settings.map.cellSize; }},
      {"map.footprint", kFrame, [](I& i) -> float& { return i.settings.map.footprint; }},
      {"map.pointExtinction", kFrame,
       [](I& i) -> float& { return i.settings.map.pointExtinction; }},
      {"eye", kFrame, [](I& i) -> float& { return i.settings.eye.x; }},
      {"appearance.rootColour", kFrame, [](I& i) -> float& { return lookOf(i).rootColour.r; }},
      {"appearance.variation", kFrame, [](I& i) -> float& { return lookOf(i).variation; }},
      {"appearance.ambient", kFrame, [](I& i) -> float& { return lookOf(i).ambient; }},
      {"appearance.specular", kFrame, [](I& i) -> float& { return lookOf(i).specular; }},
      {"appearance.exponent", kFrame, [](I& i) -> float& { return lookOf(i).exponent; }},
      {"appearance.firstShift", kFrame, [](I& i) -> float& { return lookOf(i).firstShift; }},
  };
  return all;
}

const BadInput& badInput(const char* name) {
  for (const BadInput& input : badInputs())
    if (std::strcmp(input.name, name) == 0) return input;
  throw Error(text("no input is called ", name));
}

const std::vector<BadValue>& badValues() {
  static const std::vector<BadValue> all = {
      {"NaN", NAN},           {"+Inf", INFINITY}, {"-Inf", -INFINITY},
      {"a denormal", 1e-42f}, {"-0.5", -0.5f},    {"1e12", 1e12f},
      {"3e38", 3e38f},        {"-3e38", -3e38f},  {"1e-20", 1e-20f},
  };
  return all;
}

}  // namespace hair::extremes
