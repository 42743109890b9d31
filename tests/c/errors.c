/* What is refused, with a word and without a change. */
#include <math.h>
#include <string.h>

#include "check.h"

static void null_pointers_are_refused(void) {
  hair_instance* const made = small_hair();
  hair_instance* hair = made;
  hair_view view;
  uint64_t hash;
  size_t size;
  float value = 0;
  view.size = sizeof view;
  REFUSED(hair_settings_init(NULL, sizeof(hair_settings)), "null");
  REFUSED(hair_style_init(NULL, sizeof(hair_style), 0), "null");
  REFUSED(hair_create_from_style(NULL, NULL, NULL, &hair), "null");
  CHECK(hair == NULL);
  REFUSED(hair_create_from_style(NULL, NULL, NULL, NULL), "null");
  REFUSED(hair_create_from_strands(NULL, NULL, NULL, NULL, NULL, NULL, &hair), "null");
  REFUSED(hair_create_from_guides(NULL, 1, 2, NULL, NULL, NULL, NULL, &hair), "null");
  REFUSED(hair_step(NULL, NULL, 0.1f), "null");
  REFUSED(hair_relight(NULL), "null");
  REFUSED(hair_restart(NULL, NULL, 0), "null");
  REFUSED(hair_set_settings(NULL, NULL), "null");
  REFUSED(hair_set_lights(NULL, NULL, 0), "null");
  REFUSED(hair_teleport(NULL, NULL), "null");
  REFUSED(hair_read(NULL, &view), "null");
  REFUSED(hair_state_hash(NULL, &hash), "null");
  REFUSED(hair_save(NULL, NULL, 0, &size), "null");
  REFUSED(hair_restore(NULL, NULL, 0), "null");
  REFUSED(hair_shadow_create(NULL), "null");
  REFUSED(hair_shadow_compute(NULL, NULL, NULL, NULL, NULL, NULL), "null");
  REFUSED(hair_shadow_sample(NULL, &value, 1, &value), "null");
  hair_do_task(NULL, 0);
  hair_destroy(made);
}

/* Each is refused, and changes nothing. */
static void numbers_out_of_range_are_refused(void) {
  hair_instance* hair = small_hair();
  const uint64_t before = hash_of(hair);
  hair_body body = *body_at(0);
  const float bad[] = {NAN, INFINITY, 0, -1, 2};
  for (int i = 0; i < 5; ++i) REFUSED(hair_step(hair, NULL, bad[i]), "are not in");
  body.world_from_head.translation[1] = NAN;
  REFUSED(hair_step(hair, &body, 0.1f), "head");
  body = *body_at(0);
  body.world_from_head.rotation[0] = 0;
  REFUSED(hair_step(hair, &body, 0.1f), "rotation");
  body = *body_at(0);
  body.capsule_count = 65;
  REFUSED(hair_step(hair, &body, 0.1f), "65 capsules");
  hair_capsule two[2] = {{{0, 0, 0}, {0, 1, 0}, 0.1f}, {{0, 0, 0}, {0, NAN, 0}, 0.1f}};
  body.capsules = two;
  body.capsule_count = 2;
  REFUSED(hair_step(hair, &body, 0.1f), "capsule");
  hair_plane plane = {{0, 0, 0}, {0, 2, 0}};
  body = *body_at(0);
  body.planes = &plane;
  body.plane_count = 1;
  REFUSED(hair_step(hair, &body, 0.1f), "normal");
  REFUSED(hair_restart(hair, NULL, NAN), "are not in");
  hair_style style;
  OK(hair_style_init(&style, sizeof style, HAIR_STYLE_CURLY));
  const float hairs[] = {NAN, INFINITY, 0, -5, 1e30f};
  for (int i = 0; i < 5; ++i) {
    hair_instance* none = hair;
    style.hairs = hairs[i];
    REFUSED(hair_create_from_style(&style, NULL, NULL, &none), "hairs");
    CHECK(none == NULL);
  }

  hair_light light = {HAIR_LIGHT_PARALLEL, {0, 0, 0}, {0, 0, 0}, {1, 1, 1}};
  REFUSED(hair_set_lights(hair, &light, 1), "direction");
  light.kind = 7;
  REFUSED(hair_set_lights(hair, &light, 1), "kind");
  /* A lamp that the head is moved into. */
  light.kind = HAIR_LIGHT_POINT;
  light.position[0] = 1;
  OK(hair_set_lights(hair, &light, 1));
  body = *body_at(0);
  body.world_from_head.translation[0] = 1;
  REFUSED(hair_step(hair, &body, 0.1f), "point light");

  hair_settings settings;
  OK(hair_settings_init(&settings, sizeof settings));
#define BAD(field, value, word)                 \
  do {                                          \
    hair_settings s = settings;                 \
    s.field = value;                            \
    REFUSED(hair_set_settings(hair, &s), word); \
  } while (0)
  BAD(substep, NAN, "substep");
  BAD(iterations, 0, "iterations");
  BAD(iterations, 4000000000u, "iterations");
  BAD(link_solver, 2, "link_solver");
  BAD(shadow, 2, "shadow");
  BAD(map_cells, 1, "cells");
  BAD(map_cell_size, -1, "cellSize");
  BAD(wind[0], 1e9f, "wind");
  BAD(repulsion_interval, 0, "interval");
  BAD(ambient, NAN, "ambient");
  BAD(eye[2], INFINITY, "eye");
  CHECK(hash_of(hair) == before);
  OK(hair_step(hair, body_at(0), 0.1f));
  hair_destroy(hair);
}

static void strands_that_are_none_are_refused(void) {
  float points[12] = {0, 0, 0, 0, 0.1f, 0, 1, 0, 0, 1, 0.1f, 0};
  uint32_t first[3] = {0, 2, 4};
  hair_strands s = {points, first, 4, 2};
  const hair_fibre fibre = {1e-4f, 0.5f, 1};
  const hair_fibre none = {1e-4f, 0, 1};
  const hair_light light = {HAIR_LIGHT_PARALLEL, {0, -1, 0}, {0, 0, 0}, {1, 1, 1}};
  hair_instance* hair = NULL;
  hair_shadow* shadow = NULL;
  OK(hair_shadow_create(&shadow));
  OK(hair_shadow_compute(shadow, &s, &fibre, &light, NULL, NULL));
  REFUSED(hair_shadow_compute(shadow, &s, &none, &light, NULL, NULL), "opacity");
  first[1] = 3; /* a strand of one point has a shadow, but does not move */
  OK(hair_shadow_compute(shadow, &s, &fibre, &light, NULL, NULL));
  REFUSED(hair_create_from_strands(&s, NULL, NULL, NULL, NULL, NULL, &hair), "strand 1");
  first[1] = 5;
  REFUSED(hair_shadow_compute(shadow, &s, &fibre, &light, NULL, NULL), "hair_strands");
  first[1] = 2;
  s.point_count = 3;
  REFUSED(hair_shadow_compute(shadow, &s, &fibre, &light, NULL, NULL), "hair_strands");
  s.point_count = 4;
  points[5] = NAN;
  REFUSED(hair_shadow_compute(shadow, &s, &fibre, &light, NULL, NULL), "strand 0 point 1");
  REFUSED(hair_create_from_guides(points, 2, 2, NULL, NULL, NULL, NULL, &hair), "point 1");
  REFUSED(hair_create_from_guides(points, 1, 1, NULL, NULL, NULL, NULL, &hair), "of 2 to 64");
  CHECK(hair == NULL);
  hair_shadow_destroy(shadow);
}

void errors(void);
void errors(void) {
  null_pointers_are_refused();
  numbers_out_of_range_are_refused();
  strands_that_are_none_are_refused();
}
