#include <libhair/c/boundary.h>
#include <libhair/c/convert.h>
#include <libhair/shadow/density_map.h>

using namespace hair::c;
using hair::require;

struct hair_shadow {
  hair::DensityMap map;
  bool computed = false;
};

namespace {

hair_map mapDefaults() {
  const hair::DensityMapSettings s;
  return {0,
          static_cast<uint32_t>(s.cells),
          s.cellSize,
          static_cast<uint32_t>(s.deposit),
          static_cast<uint32_t>(s.filter),
          s.footprint,
          {0, 0, 0}};
}

}  // namespace

hair_status hair_map_init(hair_map* map, size_t size) {
  return guarded([&] { hand(mapDefaults(), map, size, "hair_map"); });
}

hair_status hair_shadow_create(hair_shadow** out) {
  return guarded([&] {
    hair_shadow*& to = given(out, "hair_shadow");  // validates before allocating
    to = new hair_shadow;
  });
}

void hair_shadow_destroy(hair_shadow* shadow) {
  delete shadow;
}

hair_status hair_shadow_compute(hair_shadow* shadow, const hair_strands* strands,
                                const hair_fibre* fibre, const hair_light* light,
                                const hair_map* map, float* transmittance) {
  return computed([&] {
    given(shadow, "hair_shadow");
    const hair::StrandView view = strandsOf(strands, 1);
    const hair::Fibre thickness = fibreOf(given(fibre, "hair_fibre"));
    const hair::Light from = lightOf(given(light, "hair_light"));
    hair_map m = mapDefaults();
    if (map) m = taken(map, m, "hair_map");
    const auto space = lightSpaceOf(from, {m.pivot[0], m.pivot[1], m.pivot[2]});
    clear(shadow->map, mapSettings(m), space);
    shadow->computed = false;
    deposit(view, thickness, shadow->map);
    computeTransmittance(shadow->map);
    shadow->computed = true;
    if (transmittance)
      sampleStrandTransmittance(shadow->map, view, {transmittance, view.pointCount()});
  });
}

hair_status hair_shadow_sample(const hair_shadow* shadow, const float* points, size_t count,
                               float* transmittance) {
  return computed([&] {
    require(given(shadow, "hair_shadow").computed,
            "hair_shadow_sample: hair_shadow_compute is still to come");
    const auto at = pointsOf(points, count, "hair_shadow_sample");
    require(transmittance || count == 0, "hair_shadow_sample: transmittance is null");
    sampleTransmittance(shadow->map, at, {transmittance, count});
  });
}
