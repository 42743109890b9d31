#include <algorithm>

#include <libhair/core/error.h>
#include <libhair/guides/substep_memory.h>
#include <libhair/measure/motion/feature_cost.h>
#include <libhair/simulation/stages.h>
#include <libhair/wisps/guide_curves.h>
#include <libhair/wisps/obstacles.h>

namespace hair {

namespace {

using Scene = MeasuredScene;

// Strands without a shape of their own: no curls, no deviations.
void dropOffsets(Scene& scene) {
  auto groom = std::make_shared<Groom>(*scene.groom);
  groom->offsets = {};
  scene.groom = std::move(groom);
}

// Draws the guides themselves; each represents an equal part of the hairs.
void dropWisps(Scene& scene) {
  auto groom = std::make_shared<Groom>(*scene.groom);
  const auto guides = static_cast<std::uint32_t>(groom->guideCount());
  groom->fibre.hairsPerStrand =
      std::max(1.0f, groom->fibre.hairsPerStrand * static_cast<float>(groom->strandCount()) /
                         static_cast<float>(guides));
  groom->offsets = {};
  groom->first = {0};
  groom->parents.clear();
  for (std::uint32_t g = 0; g < guides; ++g) {
    groom->first.push_back((g + 1) * groom->pointsPerGuide);
    groom->parents.emplace_back(g);
  }
  groom->weights.assign(guides, {1, 0, 0});
  scene.groom = std::move(groom);
}

bool drawsGuidesAlone(const Groom& groom) {
  return groom.offsets.empty() && groom.strandCount() == groom.guideCount() &&
         std::ranges::all_of(groom.weights, [](glm::vec3 w) { return w.x == 1; });
}

void dropContact(Scene& scene) {
  scene.bodyContact = false;
  scene.head = nullptr;
}

std::string adviseSelfCollision(const SceneWatch& watch) {
  return watch.pushed == 0 ? "never pushes: leave it out" : "";
}

std::string adviseMap(const SceneWatch& watch) {
  if (watch.darkest == 1) return "every transmittance is 1: leave it out";
  if (watch.enlargedFrames > 0)
    return text("the hair was larger than the map in ", watch.enlargedFrames, " of ", watch.frames,
                " frames: take more or larger cells");
  if (watch.saturatedCells > 0)
    return text(watch.saturatedCells,
                " cells hold more than they can count: take smaller cells, or thinner fibres");
  // The worst case the map is made for (mapExtentNeeded) may be far from this scene's.
  const int used = std::max({watch.cellsUsed.x, watch.cellsUsed.y, watch.cellsUsed.z});
  const int enough = used + used / 8 + 1;
  if (4 * enough <= 3 * watch.cells)
    return text("the hair spanned ", used, " of ", watch.cells, " cells: ", enough,
                " of the same size would do, or as many smaller ones");
  return "";
}

}  // namespace

std::vector<Feature> featuresOf(const MeasuredScene& scene) {
  // One entry a feature: name, stages of its own, whether it is on, how to turn it off, advice.
  std::vector<Feature> all = {
      {"contact", {}, [](const Scene& s) { return s.head || s.bodyContact; }, dropContact},
      {"wind",
       {},
       [](const Scene& s) { return !s.settings.wind.still(); },
       [](Scene& s) { s.settings.wind = {}; }},
      {"wisps",
       {Stage::Wisps},
       [](const Scene& s) { return !drawsGuidesAlone(*s.groom); },
       dropWisps},
      {"offsets and curls",
       {},
       [](const Scene& s) { return !s.groom->offsets.empty(); },
       dropOffsets},
      {"strands avoid body",
       {},
       [](const Scene& s) { return s.wisps.avoidColliders; },
       [](Scene& s) { s.wisps.avoidColliders = false; }},
      {"self-collision",
       {Stage::SelfCollision},
       [](const Scene& s) { return s.settings.selfCollision; },
       [](Scene& s) { s.settings.selfCollision = false; },
       adviseSelfCollision},
      {scene.settings.lights.size() > 1 ? "all lights' maps" : "light's map",
       {Stage::Deposit, Stage::Transmittance, Stage::Filter},
       [](const Scene& s) { return s.settings.shadow; },
       [](Scene& s) { s.settings.shadow = false; },
       adviseMap},
      {"map's filter",
       {},
       [](const Scene& s) { return s.settings.shadow && s.settings.map.filter != Filter::None; },
       [](Scene& s) { s.settings.map.filter = Filter::None; }},
      {"shading",
       {Stage::Shade},
       [](const Scene& s) { return s.settings.shade; },
       [](Scene& s) { s.settings.shade = false; }},
      {"second highlight",
       {},
       [](const Scene& s) {
         const auto* look = std::get_if<KajiyaKaySettings>(&s.settings.appearance);
         return s.settings.shade && look && look->secondSpecular > 0;
       },
       [](Scene& s) { std::get<KajiyaKaySettings>(s.settings.appearance).secondSpecular = 0; }},
  };
  all.push_back({"body's shadow in the map",
                 {},
                 [](const Scene& s) { return s.settings.shadow && s.settings.bodyShadow; },
                 [](Scene& s) { s.settings.bodyShadow = false; }});
  for (std::size_t l = 0; l < scene.settings.lights.size(); ++l)
    all.push_back({text("light ", l + 1, ", its map and shine"),
                   {},
                   [](const Scene& s) { return s.settings.lights.size() > 1; },
                   [l](Scene& s) {
                     s.settings.lights.erase(s.settings.lights.begin() +
                                             static_cast<std::ptrdiff_t>(l));
                   }});
  std::erase_if(all, [&](const Feature& f) { return !f.isOn(scene); });
  return all;
}

namespace {

template <class T>
std::size_t bytesOf(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

std::size_t bytesOf(const DensityGrid& grid) {
  return grid.bytes();
}

std::size_t bytesOf(const std::vector<DensityMap>& maps) {
  std::size_t sum = 0;
  for (const DensityMap& map : maps) sum += map.bytes();
  return sum;
}

template <class... Arrays>
std::size_t bytesOfAll(const Arrays&... arrays) {
  return (bytesOf(arrays) + ...);
}

}  // namespace

std::size_t hairBytes(const Hair& hair) {
  const GuideStrands& g = hair.guides;
  const Wisps& w = hair.wisps;
  const Groom& groom = *hair.groom;
  const SubstepMemory& scratch = HairScratch::guides(hair).memory();
  return bytesOfAll(g.position, g.velocity, g.tension, g.restPosition, g.rootTangent, g.rootNormal,
                    g.linkLength, g.restTension, g.curvature, g.jointStiffness, g.pointMass,
                    g.clearance) +
         bytesOfAll(scratch.bending.inverseD, scratch.bending.below1, scratch.bending.below2,
                    scratch.heads, scratch.capsules) +
         bytesOfAll(groom.guidePoints, groom.first, groom.parents, groom.weights, groom.offsets) +
         bytesOfAll(w.points, w.curves->basis, w.curves->rows, w.curves->lower, w.curves->upper,
                    w.rootOffsets, w.clearance, w.sampleTable, w.tableOf, w.obstacles->axes,
                    w.obstacles->near, w.obstacles->room) +
         bytesOfAll(hair.repulsion.density, hair.repulsion.allowed, hair.repulsion.push) +
         bytesOfAll(hair.maps, hair.transmittance, hair.visibility, hair.radiance, hair.colours,
                    hair.capsules);
}

}  // namespace hair
