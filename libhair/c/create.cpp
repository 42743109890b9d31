#include <libhair/c/boundary.h>
#include <libhair/c/instance.h>
#include <libhair/core/error.h>
#include <libhair/geometry/mesh_sdf.h>
#include <libhair/wisps/bind.h>

using namespace hair::c;
using hair::require;

namespace {

hair_style styleDefaults(std::uint32_t kind) {
  require(kind <= HAIR_STYLE_LONG, "hair_style: kind ", kind, " is not in 0 to ",
          int{HAIR_STYLE_LONG});
  const hair::StyleSettings s = hair::styleSettings(static_cast<hair::Style>(kind));
  return {0, kind, s.strands, s.points, s.wisps, s.pointsPerGuide, s.seed, s.hairs};
}

hair_binding bindingDefaults() {
  const hair::BindSettings s;
  return {0, s.guides, s.pointsPerGuide, s.shapeWeight};
}

template <class Make>
hair_status create(hair_instance** out, Make&& make) {
  return computed([&] {
    given(out, "hair_instance");
    *out = nullptr;
    *out = make().release();
  });
}

}  // namespace

hair_status hair_settings_init(hair_settings* settings, size_t size) {
  return guarded([&] { hand(settingsOf({}), settings, size, "hair_settings"); });
}

hair_status hair_style_init(hair_style* style, size_t size, uint32_t kind) {
  return guarded([&] { hand(styleDefaults(kind), style, size, "hair_style"); });
}

hair_status hair_binding_init(hair_binding* binding, size_t size) {
  return guarded([&] { hand(bindingDefaults(), binding, size, "hair_binding"); });
}

hair_status hair_body_init(hair_body* body, size_t size) {
  return guarded([&] {
    hair_body still{};
    still.world_from_head.rotation[0] = 1;
    hand(still, body, size, "hair_body");
  });
}

hair_status hair_create_from_style(const hair_style* style, const hair_settings* settings,
                                   const hair_body* body, hair_instance** out) {
  return create(out, [&] {
    const hair::StyleSettings grown = styleOf(style);
    const auto head = hair::sharedSdf(hair::builtinHead().mesh);
    return makeInstance(std::make_shared<hair::Groom>(makeGroom(grown, *head)), head, settings,
                        body);
  });
}

hair_status hair_create_from_strands(const hair_strands* strands, const hair_fibre* fibre,
                                     const hair_binding* binding, const hair_head* head,
                                     const hair_settings* settings, const hair_body* body,
                                     hair_instance** out) {
  return create(out, [&] {
    const hair::StrandView view = strandsOf(strands, 2);
    hair_binding b = bindingDefaults();
    if (binding) b = taken(binding, b, "hair_binding");
    require(b.shape_weight >= 0 && b.shape_weight < 1e6f, "hair_binding: shape_weight ",
            b.shape_weight, " is not in [0, 1e6)");
    auto groom = std::make_shared<hair::Groom>(
        bindGroom(view, {b.guides, b.points_per_guide, b.shape_weight}));
    if (fibre) groom->fibre = fibreOf(*fibre);
    return makeInstance(std::move(groom), headOf(head), settings, body);
  });
}

hair_status hair_create_from_guides(const float* points, uint32_t guide_count,
                                    uint32_t points_per_guide, const hair_fibre* fibre,
                                    const hair_head* head, const hair_settings* settings,
                                    const hair_body* body, hair_instance** out) {
  return create(out, [&] {
    require(guide_count >= 1 && guide_count <= 10'000'000 && points_per_guide >= 2 &&
                points_per_guide <= hair::kMaxGuidePoints,
            "hair_create_from_guides: ", guide_count, " guides of ", points_per_guide,
            " points are not 1 to 10000000 of 2 to ", hair::kMaxGuidePoints);
    const auto given = pointsOf(points, std::size_t{guide_count} * points_per_guide, "guides");
    auto groom = std::make_shared<hair::Groom>(groomOfGuides(given, points_per_guide));
    hair::validate({groom->guidePoints, groom->first}, "guides", 2);
    if (fibre) groom->fibre = fibreOf(*fibre);
    return makeInstance(std::move(groom), headOf(head), settings, body);
  });
}

void hair_destroy(hair_instance* hair) {
  delete hair;
}
