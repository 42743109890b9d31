#include <cmath>

#include <libhair/core/random.h>

#include "bad_inputs.h"
#include "setup.h"

namespace hair::extremes {

namespace {

void lampAt(Setup& s, glm::vec3 position) {
  s.settings.lights = {Light::point(s.place + position)};
}

std::vector<Dimension> listed() {
  using S = Setup;
  return {
      {"place of the head",
       {{"origin", [](S&) {}},
        {"1 m", [](S& s) { s.place = {0.6f, 0.8f, 0.1f}; }},
        {"30 m", [](S& s) { s.place = {-18, 24, 3}; }},
        {"1 km", [](S& s) { s.place = {600, 0, -800}; }},
        {"10 km", [](S& s) { s.place = {6e3f, 1, 8e3f}; }},
        {"1e7 m", [](S& s) { s.place = {1e7f, 0, 0}; }}},
       1},
      {"frame",
       {{"1/60 s", [](S&) {}},
        {"1e-5 s", [](S& s) { s.frame = 1e-5f; }},
        {"1e-3 s", [](S& s) { s.frame = 1e-3f; }},
        {"1/240 s", [](S& s) { s.frame = 1.0f / 240; }},
        {"0.1 s", [](S& s) { s.frame = 0.1f; }},
        {"0.5 s", [](S& s) { s.frame = 0.5f; }}}},
      {"substeps",
       {{"1/480 s each", [](S&) {}},
        {"1", [](S& s) { s.substeps = 1; }},
        {"2", [](S& s) { s.substeps = 2; }},
        {"16", [](S& s) { s.substeps = 16; }},
        {"64", [](S& s) { s.substeps = 64; }}}},
      {"gravity",
       {{"1 g", [](S&) {}},
        {"0", [](S& s) { s.gravity = 0; }},
        {"50 g", [](S& s) { s.gravity = 490; }},
        {"1 g, any way", [](S& s) { s.anyGravity = true; }},
        {"50 g, any way", [](S& s) { s.gravity = 490, s.anyGravity = true; }},
        {"50 g, reversing", [](S& s) { s.gravity = 490, s.reversingGravity = true; }}}},
      {"head",
       {{"still", [](S&) {}},
        {"spins, 10 rad/s", [](S& s) { s.motion = {10, false, 0}; }},
        {"spins, 100 rad/s", [](S& s) { s.motion = {100, false, 0}; }},
        {"jerks, 100 rad/s", [](S& s) { s.motion = {100, true, 0}; }},
        {"jumps 0.1 mm", [](S& s) { s.motion = {0, false, 1e-4f}; }},
        {"jumps 1 cm to and fro", [](S& s) { s.motion = {0, true, 1e-2f}; }},
        {"jumps 1 m", [](S& s) { s.motion = {0, false, 1}; }},
        {"jumps 1 m to and fro, spins", [](S& s) { s.motion = {30, true, 1}; }},
        {"jumps 50 m", [](S& s) { s.motion = {0, false, 50}; }},
        {"jumps 1 km", [](S& s) { s.motion = {0, false, 1000}; }}}},
      {"longest link",
       {{"2 cm", [](S&) {}},
        {"0.01 mm", [](S& s) { s.longestLink = 1e-5f; }},
        {"0.1 mm", [](S& s) { s.longestLink = 1e-4f; }},
        {"1 mm", [](S& s) { s.longestLink = 1e-3f; }},
        {"10 cm", [](S& s) { s.longestLink = 0.1f; }},
        {"1 m", [](S& s) { s.longestLink = 1; }},
        {"10 m", [](S& s) { s.longestLink = 10; }}}},
      {"ratio of links",
       {{"1", [](S&) {}},
        {"10", [](S& s) { s.ratio = 10; }},
        {"100", [](S& s) { s.ratio = 100; }},
        {"1e3", [](S& s) { s.ratio = 1e3f; }},
        {"1e4", [](S& s) { s.ratio = 1e4f; }}}},
      {"links",
       {{"15", [](S&) {}},
        {"1", [](S& s) { s.links = 1; }},
        {"2", [](S& s) { s.links = 2; }},
        {"3", [](S& s) { s.links = 3; }},
        {"31", [](S& s) { s.links = 31; }},
        {"63", [](S& s) { s.links = 63; }},
        {"0", [](S& s) { s.links = 0; }},
        {"64", [](S& s) { s.links = 64; }},
        {"1000", [](S& s) { s.links = 1000; }}},
       3},
      {"strands",
       {{"17", [](S&) {}},
        {"1", [](S& s) { s.strands = 1; }},
        {"200", [](S& s) { s.strands = 200; }},
        {"200 in one cell", [](S& s) { s.strands = 200, s.spread = 1e-6f; }}}},
      {"stiffness",
       {{"8e-8 N m2", [](S&) {}},
        {"0", [](S& s) { s.settings.guides.bendingStiffness = 0; }},
        {"1e-14 N m2", [](S& s) { s.settings.guides.bendingStiffness = 1e-14f; }},
        {"1e-5 N m2", [](S& s) { s.settings.guides.bendingStiffness = 1e-5f; }},
        {"rigid, 0.9 N m2", [](S& s) { s.settings.guides.bendingStiffness = 0.9f; }},
        {"none at the tip", [](S& s) { s.settings.guides.tipStiffness = 1e-6f; }}}},
      {"damping",
       {{"8 / s and 4 ms", [](S&) {}},
        {"0", [](S& s) { s.settings.guides.airDrag = s.settings.guides.bendDamping = 0; }},
        {"air only, 14 / s",
         [](S& s) { s.settings.guides.airDrag = 14, s.settings.guides.bendDamping = 0; }},
        {"bending only, 0.9 s",
         [](S& s) { s.settings.guides.airDrag = 0, s.settings.guides.bendDamping = 0.9f; }},
        {"air, 9000 / s", [](S& s) { s.settings.guides.airDrag = 9e3f; }}}},
      {"friction",
       {{"0.3", [](S&) {}},
        {"0", [](S& s) { s.settings.guides.friction = 0; }},
        {"10", [](S& s) { s.settings.guides.friction = 10; }}}},
      {"colliders",
       {{"none", [](S&) {}},
        {"one ball", [](S& s) { s.body = Body::Ball; }},
        {"inside each other", [](S& s) { s.body = Body::Overlap; }},
        {"shrinking to nothing", [](S& s) { s.body = Body::Shrinking; }},
        {"swallowing the roots", [](S& s) { s.body = Body::Swallowing; }},
        {"flying through at 300 m/s", [](S& s) { s.body = Body::Shot; }},
        {"64 in a heap", [](S& s) { s.body = Body::Crowd; }}}},
      {"self-collision",
       {{"cells of 2 cm", [](S&) {}},
        {"off", [](S& s) { s.settings.selfCollision = false; }},
        {"cells of 0.01 mm", [](S& s) { s.settings.repulsion.cellSize = 1e-5f; }},
        {"cells of 1 km", [](S& s) { s.settings.repulsion.cellSize = 1e3f; }},
        {"any density pushes",
         [](S& s) {
           s.settings.repulsion.threshold = 0, s.settings.repulsion.tolerance = 1;
           s.settings.repulsion.kind = RepulsionKind::CellCentre;
         }}}},
      {"map",
       {{"cells of 7.5 mm", [](S&) {}},
        {"cells of 0.01 mm", [](S& s) { s.settings.map.cellSize = 1e-5f; }},
        {"cells of 0.01 mm, segments",
         [](S& s) { s.settings.map.cellSize = 1e-5f, s.settings.map.deposit = Deposit::Segments; }},
        {"cells of 1 m", [](S& s) { s.settings.map.cellSize = 1; }},
        {"cells of 1 km", [](S& s) { s.settings.map.cellSize = 1e3f; }},
        {"2 cells", [](S& s) { s.settings.map.cells = 2; }},
        {"points, the paper's filter",
         [](S& s) {
           s.settings.map.deposit = Deposit::Points, s.settings.map.filter = Filter::Paper;
         }},
        {"footprint of 10 cells",
         [](S& s) {
           s.settings.map.filter = Filter::Footprint;
           s.settings.map.footprint = 10 * s.settings.map.cellSize;
         }}}},
      {"light",
       {{"from above", [](S&) {}},
        {"none", [](S& s) { s.settings.lights.clear(); }},
        {"lamp 1 km away", [](S& s) { lampAt(s, {600, 800, 0}); }},
        {"lamp in the hair", [](S& s) { lampAt(s, {0.01f, -0.15f, 0}); }},
        {"lamp 0.01 mm from the pivot", [](S& s) { lampAt(s, {1e-5f, 0, 0}); }},
        {"three",
         [](S& s) {
           lampAt(s, {1, 1, 1});
           s.settings.lights.push_back(Light::parallel({1e-10f, 0, 0}, glm::vec3(1e6f)));
           s.settings.lights.push_back(Light{});
         }}}},
      {"wind",
       {{"still", [](S&) {}},
        {"10 m/s", [](S& s) { s.settings.wind.velocity = {8, 0, 6}; }},
        {"190 m/s, gusts of 1 mm", [](S& s) { s.settings.wind = {{-190, 0, 0}, 1, 1e-3f}; }}}},
      {"body's shadow", {{"off", [](S&) {}}, {"on", [](S& s) { s.settings.bodyShadow = true; }}}},
  };
}

}  // namespace

const std::vector<Dimension>& dimensions() {
  static const std::vector<Dimension> all = listed();
  return all;
}

bool wrongOnPurpose(std::uint32_t number) {
  return number % 3 == 2;
}

std::vector<std::size_t> draw(std::uint32_t number, std::uint32_t seed) {
  const std::size_t fields = badInputs().size(), count = dimensions().size();
  const auto random = [&](std::size_t use) {
    return uniform(number, static_cast<std::uint32_t>(use), seed);
  };
  const auto below = [&](std::size_t n, std::size_t use) {
    return static_cast<std::size_t>(random(use) * static_cast<float>(n));
  };
  std::vector<std::size_t> values(count + 2, 0);
  // What is wrong is so in an ordinary scene: its refusal says no more where other things are
  // extreme too.
  if (wrongOnPurpose(number)) {
    const std::size_t d = below(count, 2 * count + 2);
    if (const Dimension& some = dimensions()[d]; some.refused > 0) {
      values[d] = some.values.size() - 1 - below(some.refused, 2 * count + 3);
      return values;
    }
    values[count] = 1 + below(fields, 2 * count);
    values[count + 1] = below(badValues().size(), 2 * count + 1);
    return values;
  }
  // In half of the others few things are extreme, so that what a value does is seen alone.
  const float share = number % 3 == 0 ? 1.5f / static_cast<float>(count) : 0.4f;
  for (std::size_t d = 0; d < count; ++d)
    if (random(d) < share)
      values[d] = 1 + below(dimensions()[d].values.size() - dimensions()[d].refused - 1, count + d);
  return values;
}

Setup setupOf(const std::vector<std::size_t>& values) {
  const std::size_t count = dimensions().size();
  Setup setup;
  for (std::size_t d = 0; d < count; ++d) {
    dimensions()[d].values[values[d]].apply(setup);
    setup.refused |= dimensions()[d].refuses(values[d]);
  }
  if (values[count] > 0) {
    setup.badField = badInputs()[values[count] - 1].name;
    setup.badValue = badValues()[values[count + 1]].value;
  }
  return setup;
}

}  // namespace hair::extremes
