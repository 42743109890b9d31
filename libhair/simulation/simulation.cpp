#include <libhair/simulation/saved_state.h>
#include <libhair/simulation/simulation.h>

#include <utility>

#include <libhair/core/error.h>
#include <libhair/guides/validate.h>
#include <libhair/simulation/frame.h>
#include <libhair/simulation/stages.h>

namespace hair {

namespace {

const Groom& checked(const std::shared_ptr<const Groom>& groom) {
  require(groom != nullptr, "simulation: no groom");
  validate(*groom);
  return *groom;
}

const FrameSettings& checked(const FrameSettings& settings) {
  validate(settings);
  return settings;
}

// What only the place of the head tells about lights (lightSpaceOf).
void requireLights(const FrameSettings& settings, glm::vec3 pivot) {
  for (const Light& light : settings.lights) lightSpaceOf(light, pivot);
}

// What neither settings nor groom tell alone: `occlude` counts the body in points of the hair.
void requireFit(const FrameSettings& settings, const Groom& groom) {
  const Fibre& f = groom.fibre;
  require(!settings.bodyShadow || settings.map.deposit != Deposit::Points ||
              settings.map.pointExtinction > 0 || f.width * f.opacity * f.hairsPerStrand > 0,
          "frame settings: bodyShadow with Deposit::Points needs hair that casts a shadow; take "
          "Deposit::Columns, or fibres of some width and opacity");
}

}  // namespace

void Simulation::OwnedBody::assign(const BodyState& body) {
  worldFromHead = body.worldFromHead;
  assignSpan(body.capsules, capsules);
  assignSpan(body.scenery.planes, planes);
  assignSpan(body.scenery.meshes, meshes);
}

Simulation::Simulation(std::shared_ptr<const Groom> groom, const FrameSettings& settings,
                       const BodyState& body, std::shared_ptr<const MeshSdf> head,
                       const WispSettings& wisps)
    : groom_(std::move(groom)),
      head_(std::move(head)),
      settings_(checked(settings)),
      hair_(checked(groom_), settings_, body, head_.get(), wisps) {
  requireFrame(body);
  requireFit(settings_, *groom_);
  body_.assign(body);
  relight();
}

// Each of these refuses what the call would throw for later, before anything changes.

// Of light(), and of a level that it draws first.
void Simulation::requireLight(const RigidTransform& worldFromHead) const {
  requireLights(settings_, worldFromHead.translation);
  requireLevel(hair_);
  // A pending level change discards the visibility.
  const std::size_t known = hair_.level == hair_.wisps.drawn.level ? hair_.visibility.size() : 0;
  require(known == 0 || known == settings_.lights.size() * hair_.wisps.points.size(),
          "visibility: ", known, " values for ", settings_.lights.size(), " lights and ",
          hair_.wisps.points.size(), " points; give it anew after a change of lights or groom");
}

// Of hair whose head is there.
void Simulation::requireHead(const RigidTransform& worldFromHead) const {
  validate(worldFromHead);
  requirePrecision(hair_.guides, worldFromHead);
  hair_.guides.longestSubstep(worldFromHead);
  requireLight(worldFromHead);
}

// Of a frame.
void Simulation::requireFrame(const BodyState& body) const {
  require(body.capsules.size() <= kMaxCapsules, "body: ", body.capsules.size(),
          " capsules; at most ", kMaxCapsules);
  validate(body.capsules);
  validate(body.scenery);
  requireHead(body.worldFromHead);
}

const FrameProfile& Simulation::step(const BodyState& body, float seconds) {
  require(seconds >= 1e-6f && seconds <= 1, "step: ", seconds, " s are not in 1e-6 to 1");
  requireFrame(body);
  profile_ = {};
  frame(body, settings_, seconds, hair_, profile_);
  body_.assign(body);
  return profile_;
}

const FrameProfile& Simulation::relight() {
  requireLight(hair_.worldFromHead);
  profile_ = {};
  if (hair_.level != hair_.wisps.drawn.level) redraw(hair_);
  light(settings_, hair_, profile_);
  return profile_;
}

void Simulation::restart(const BodyState& body, float settle) {
  requireFrame(body);
  hair::restart(body, settings_, settle, hair_);
  body_.assign(body);
  relight();
}

void Simulation::teleport(const RigidTransform& worldFromHead) {
  requireHead(worldFromHead);
  hair::teleport(worldFromHead, hair_);
  body_.worldFromHead = worldFromHead;
  body_.capsules = hair_.capsules;
  relight();
}

void Simulation::moveOrigin(glm::vec3 origin) {
  hair::moveOrigin(origin, hair_);
  body_.worldFromHead = hair_.worldFromHead;
  body_.capsules = hair_.capsules;
  for (Plane& plane : body_.planes) plane.point -= origin;
  for (MeshCollider& mesh : body_.meshes) mesh.worldFromMesh.translation -= origin;
}

void Simulation::changeColliders(const BodyState& body) {
  hair::changeColliders(body, settings_, hair_);
  body_.assign({hair_.worldFromHead, body.capsules, body.scenery});
}

void Simulation::setSettings(const FrameSettings& settings) {
  validate(settings);
  requireLights(settings, hair_.pivot());
  requireFit(settings, *groom_);
  settings_ = settings;
}

bool Simulation::setGroom(std::shared_ptr<const Groom> groom) {
  requireFit(settings_, checked(groom));
  requireLights(settings_, hair_.pivot());
  const bool goesOn = changeGroom(*groom, settings_, hair_);
  groom_ = std::move(groom);
  detail_.reset();
  relight();
  return goesOn;
}

void Simulation::setLevel(const LevelOfDetail& level) {
  validate(level);
  if (level != LevelOfDetail{} || detail_) detail();
  hair_.level = level;
}

void Simulation::setDetail(std::shared_ptr<const GroomDetail> detail) {
  require(!detail || detail->strandCount() == groom_->strandCount(), "detail: of a groom of ",
          detail ? detail->strandCount() : 0, " strands, but this one has ", groom_->strandCount());
  require(detail || (hair_.level == LevelOfDetail{} && hair_.wisps.drawn.level == LevelOfDetail{}),
          "detail: none, but the level needs one");
  detail_ = std::move(detail);
  hair_.detail = detail_.get();
}

const std::shared_ptr<const GroomDetail>& Simulation::detail() {
  if (!detail_) detail_ = std::make_shared<GroomDetail>(*groom_);
  hair_.detail = detail_.get();
  return detail_;
}

void Simulation::save(std::ostream& out) const {
  saveState(hair_, out);
}

void Simulation::restore(std::istream& in) {
  SavedState state = readState(in, hair_);
  requireHead(state.worldFromHead);
  assignState(std::move(state), hair_);
  body_.worldFromHead = hair_.worldFromHead;
  body_.capsules = hair_.capsules;
  // A state saved after a teleport has no scenery. Meshes are known only if their number matched.
  if (!hair_.planes.empty()) body_.planes = hair_.planes;
  if (body_.meshes.size() == hair_.meshes.size()) body_.meshes = hair_.meshes;
  relight();
}

GuideStats Simulation::stats() const {
  return measureGuides(hair_.guides, settings_.guides, body_.capsules, head_.get(),
                       {body_.planes, body_.meshes});
}

}  // namespace hair
