#include <libhair/c/convert.h>

#include <libhair/c/boundary.h>
#include <libhair/geometry/mesh_sdf.h>

namespace hair::c {

namespace {

glm::vec3 vectorOf(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

template <HasWords Enum>
Enum choiceOf(std::uint32_t value, std::string_view name) {
  const std::size_t count = wordsOf(Enum{}).size();  // values are 0, 1, 2 ...
  require(value < count, name, ": ", value, " is not in 0 to ", count - 1, " (", allWords<Enum>(),
          ")");
  return static_cast<Enum>(value);
}

bool switchOf(std::uint32_t value, std::string_view name) {
  require(value <= 1, name, ": ", value, " is neither 0 nor 1");
  return value == 1;
}

int countOf(std::uint32_t value, std::string_view name) {
  require(value <= 1'000'000, name, ": ", value, " is beyond 1000000");
  return static_cast<int>(value);
}

// From the library to C.
struct ToC {
  void operator()(float& c, float own, const char*) const { c = own; }
  void operator()(float (&c)[3], glm::vec3 own, const char*) const {
    c[0] = own.x, c[1] = own.y, c[2] = own.z;
  }
  template <class T>
  void operator()(std::uint32_t& c, T own, const char*) const {
    c = static_cast<std::uint32_t>(own);
  }
};

// From C to the library.
struct FromC {
  void operator()(float c, float& own, const char*) const { own = c; }
  void operator()(const float (&c)[3], glm::vec3& own, const char*) const { own = vectorOf(c); }
  void operator()(std::uint32_t c, bool& own, const char* name) const { own = switchOf(c, name); }
  void operator()(std::uint32_t c, int& own, const char* name) const { own = countOf(c, name); }
  void operator()(std::uint32_t c, std::uint32_t& own, const char*) const { own = c; }
  template <HasWords Enum>
  void operator()(std::uint32_t c, Enum& own, const char* name) const {
    own = choiceOf<Enum>(c, name);
  }
};

// Pairs of corresponding fields, listed once for both directions.
template <class C, class Own, class Copy>
void forPairs(C& c, Own& own, Copy copy) {
  auto& guides = own.guides;
  copy(c.linear_density, guides.linearDensity, "linear_density");
  copy(c.bending_stiffness, guides.bendingStiffness, "bending_stiffness");
  copy(c.tip_stiffness, guides.tipStiffness, "tip_stiffness");
  copy(c.bend_damping, guides.bendDamping, "bend_damping");
  copy(c.air_drag, guides.airDrag, "air_drag");
  copy(c.carried_air, guides.carriedAir, "carried_air");
  copy(c.friction, guides.friction, "friction");
  copy(c.skin, guides.skin, "skin");
  copy(c.gravity, guides.gravity, "gravity");
  copy(c.substep, guides.substep, "substep");
  copy(c.link_solver, guides.linkSolver, "link_solver");
  copy(c.iterations, guides.iterations, "iterations");

  auto& repulsion = own.repulsion;
  copy(c.self_collision, own.selfCollision, "self_collision");
  copy(c.repulsion_kind, repulsion.kind, "repulsion_kind");
  copy(c.repulsion_cell_size, repulsion.cellSize, "repulsion_cell_size");
  copy(c.repulsion_cells, repulsion.cells, "repulsion_cells");
  copy(c.repulsion_stride, repulsion.strandStride, "repulsion_stride");
  copy(c.repulsion_threshold, repulsion.threshold, "repulsion_threshold");
  copy(c.repulsion_tolerance, repulsion.tolerance, "repulsion_tolerance");
  copy(c.repulsion_strength, repulsion.strength, "repulsion_strength");
  copy(c.repulsion_limit, repulsion.limit, "repulsion_limit");
  copy(c.repulsion_interval, repulsion.interval, "repulsion_interval");

  copy(c.wind, own.wind.velocity, "wind");
  copy(c.gust, own.wind.gust, "gust");
  copy(c.gust_length, own.wind.gustLength, "gust_length");
  copy(c.wind_shelter, own.wind.occlusion, "wind_shelter");

  copy(c.shadow, own.shadow, "shadow");
  copy(c.body_shadow, own.bodyShadow, "body_shadow");
  copy(c.map_cells, own.map.cells, "map_cells");
  copy(c.map_cell_size, own.map.cellSize, "map_cell_size");
  copy(c.map_deposit, own.map.deposit, "map_deposit");
  copy(c.map_filter, own.map.filter, "map_filter");
  copy(c.map_footprint, own.map.footprint, "map_footprint");

  auto& look = std::get<KajiyaKaySettings>(own.appearance);  // the only model in the C interface
  copy(c.shade, own.shade, "shade");
  copy(c.eye, own.eye, "eye");
  copy(c.root_colour, look.rootColour, "root_colour");
  copy(c.tip_colour, look.tipColour, "tip_colour");
  copy(c.variation, look.variation, "variation");
  copy(c.ambient, look.ambient, "ambient");
  copy(c.diffuse, look.diffuse, "diffuse");
  copy(c.specular, look.specular, "specular");
  copy(c.exponent, look.exponent, "exponent");
  copy(c.second_specular, look.secondSpecular, "second_specular");
  copy(c.second_exponent, look.secondExponent, "second_exponent");
  copy(c.first_shift, look.firstShift, "first_shift");
  copy(c.second_shift, look.secondShift, "second_shift");
  copy(c.encode, own.encode, "encode");
  copy(c.radiance, own.radiance, "radiance");
}

}  // namespace

hair_settings settingsOf(const FrameSettings& settings) {
  hair_settings c{};
  forPairs(c, settings, ToC{});
  return c;
}

FrameSettings frameSettings(const hair_settings* settings, FrameSettings base) {
  if (!settings) return base;
  const hair_settings c = taken(settings, settingsOf(base), "hair_settings");
  forPairs(c, base, FromC{});
  return base;
}

DensityMapSettings mapSettings(const hair_map& map) {
  DensityMapSettings settings;
  settings.cells = countOf(map.cells, "hair_map: cells");
  settings.cellSize = map.cell_size;
  settings.deposit = choiceOf<Deposit>(map.deposit, "hair_map: deposit");
  settings.filter = choiceOf<Filter>(map.filter, "hair_map: filter");
  settings.footprint = map.footprint;
  return settings;
}

Light lightOf(const hair_light& light) {
  return {choiceOf<Light::Kind>(light.kind, "hair_light: kind"), vectorOf(light.direction),
          vectorOf(light.position), vectorOf(light.colour)};
}

Fibre fibreOf(const hair_fibre& fibre) {
  const Fibre own{fibre.width, fibre.opacity, fibre.hairs_per_strand};
  validateFields(own, "hair_fibre");
  return own;
}

RigidTransform transformOf(const hair_transform& transform) {
  const auto& q = transform.rotation;
  return {{q[0], q[1], q[2], q[3]}, vectorOf(transform.translation)};
}

StyleSettings styleOf(const hair_style* style) {
  given(style, "hair_style");
  const hair_style c = taken(style, hair_style{}, "hair_style");
  StyleSettings settings = styleSettings(choiceOf<Style>(c.kind, "hair_style: kind"));
  settings.strands = c.strands;
  settings.points = c.points;
  settings.wisps = c.wisps;
  settings.pointsPerGuide = c.points_per_guide;
  settings.seed = c.seed;
  settings.hairs = c.hairs;
  return settings;
}

std::span<const glm::vec3> pointsOf(const float* points, std::size_t count, std::string_view name) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && alignof(glm::vec3) == alignof(float));
  require(points != nullptr || count == 0, name, ": points is null");
  return {reinterpret_cast<const glm::vec3*>(points), count};
}

StrandView strandsOf(const hair_strands* strands, std::size_t minPoints) {
  const hair_strands& c = given(strands, "hair_strands");
  require(c.first != nullptr, "hair_strands: first is null");
  const StrandView view{pointsOf(c.points, c.point_count, "hair_strands"),
                        {c.first, std::size_t{c.strand_count} + 1}};
  validate(view, "hair_strands", minPoints);
  return view;
}

std::shared_ptr<const MeshSdf> headOf(const hair_head* head) {
  if (!head) return nullptr;
  require(head->triangles != nullptr, "hair_head: triangles is null");
  TriangleMesh mesh;
  const auto positions = pointsOf(head->positions, head->position_count, "hair_head");
  mesh.positions.assign(positions.begin(), positions.end());
  for (std::size_t t = 0; t < head->triangle_count; ++t) {
    const std::uint32_t* corner = head->triangles + 3 * t;
    mesh.triangles.emplace_back(corner[0], corner[1], corner[2]);
  }
  return head->cell != 0 ? sharedSdf(mesh, head->cell) : sharedSdf(mesh);
}

void take(const hair_body& body, OwnBody& out) {
  require(body.capsule_count <= kMaxCapsules && body.plane_count <= kMaxPlanes,
          "hair_body: ", body.capsule_count, " capsules and ", body.plane_count,
          " planes; there may be ", kMaxCapsules, " and ", kMaxPlanes);
  require(body.capsules || body.capsule_count == 0, "hair_body: capsules is null");
  require(body.planes || body.plane_count == 0, "hair_body: planes is null");
  out.worldFromHead = transformOf(body.world_from_head);
  out.capsules.clear(), out.planes.clear();
  for (std::uint32_t i = 0; i < body.capsule_count; ++i)
    out.capsules.push_back(
        {vectorOf(body.capsules[i].a), vectorOf(body.capsules[i].b), body.capsules[i].radius});
  for (std::uint32_t i = 0; i < body.plane_count; ++i)
    out.planes.push_back({vectorOf(body.planes[i].point), vectorOf(body.planes[i].normal)});
}

}  // namespace hair::c
