/* Hair made, moved, read, saved, restored. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

int broken = 0;

hair_instance* small_hair(void) {
  hair_style style;
  hair_instance* hair = NULL;
  OK(hair_style_init(&style, sizeof style, HAIR_STYLE_CURLY));
  style.wisps = 40;
  style.strands = 240;
  OK(hair_create_from_style(&style, NULL, body_at(0), &hair));
  return hair;
}

const hair_body* body_at(double seconds) {
  static hair_capsule shoulder = {{-0.2f, -0.2f, 0}, {0.2f, -0.2f, 0}, 0.06f};
  static hair_body body;
  const double angle = 0.5 * sin(8 * seconds);
  OK(hair_body_init(&body, sizeof body));
  body.world_from_head.rotation[0] = (float)cos(angle / 2);
  body.world_from_head.rotation[2] = (float)sin(angle / 2);
  body.world_from_head.translation[1] = (float)(0.02 * sin(5 * seconds));
  body.capsules = &shoulder;
  body.capsule_count = 1;
  return &body;
}

uint64_t hash_of(const hair_instance* hair) {
  uint64_t hash = 0;
  OK(hair_state_hash(hair, &hash));
  return hash;
}

static hair_view view_of(const hair_instance* hair) {
  hair_view view;
  memset(&view, 0, sizeof view);
  view.size = sizeof view;
  OK(hair_read(hair, &view));
  return view;
}

static void dance(hair_instance* hair, int from, int to) {
  for (int f = from + 1; f <= to; ++f) OK(hair_step(hair, body_at(f / 60.0), 1.0f / 60));
}

static void hair_moves_and_is_read(void) {
  hair_instance* hair = small_hair();
  const uint64_t before = hash_of(hair);
  dance(hair, 0, 30);
  CHECK(hash_of(hair) != before);
  const hair_view view = view_of(hair);
  CHECK(view.strand_count == 240 && view.first[0] == 0);
  CHECK(view.first[240] == view.point_count && view.light_count == 1);
  CHECK(fabs(view.time - 0.5) < 1e-5);
  float least = 1, most = 0;
  for (uint32_t p = 0; p < view.point_count; ++p) {
    CHECK(isfinite(view.points[3 * p]) && view.colours[4 * p + 3] == 255);
    least = fminf(least, view.transmittance[p]), most = fmaxf(most, view.transmittance[p]);
  }
  CHECK(least >= 0 && least < 0.1f && most > 0.7f && most <= 1);
  hair_destroy(hair);
  hair_destroy(NULL);
}

static void self_collision_that_comes_late_is_that_from_the_start(void) {
  hair_style style;
  hair_settings settings;
  hair_instance* hair[2];
  OK(hair_style_init(&style, sizeof style, HAIR_STYLE_CURLY));
  OK(hair_settings_init(&settings, sizeof settings));
  style.wisps = 40;
  style.strands = 240;
  for (int i = 0; i < 2; ++i) {
    settings.self_collision = i == 0;
    OK(hair_create_from_style(&style, &settings, body_at(0), &hair[i]));
    settings.self_collision = 1;
    OK(hair_set_settings(hair[i], &settings));
    dance(hair[i], 0, 30);
  }
  CHECK(hash_of(hair[0]) == hash_of(hair[1]));
  for (int i = 0; i < 2; ++i) hair_destroy(hair[i]);
}

static void settings_and_lights_take_effect(void) {
  hair_instance* hair = small_hair();
  hair_settings settings;
  OK(hair_settings_init(&settings, sizeof settings));
  settings.shade = 0;
  settings.wind[0] = 5;
  const hair_light two[2] = {{HAIR_LIGHT_PARALLEL, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}},
                             {HAIR_LIGHT_POINT, {0, 0, 0}, {0, 2, 1}, {1, 0.5f, 0}}};
  OK(hair_set_lights(hair, two, 2));
  OK(hair_relight(hair));
  CHECK(view_of(hair).light_count == 2 && view_of(hair).colours != NULL);
  OK(hair_set_settings(hair, &settings));
  OK(hair_step(hair, NULL, 1.0f / 60));
  CHECK(view_of(hair).colours == NULL);
  settings.shadow = 0;
  OK(hair_set_settings(hair, &settings));
  OK(hair_relight(hair));
  CHECK(view_of(hair).light_count == 0 && view_of(hair).transmittance == NULL);
  /* A wind of 5 m/s takes the hair with it. */
  for (int f = 0; f < 60; ++f) OK(hair_step(hair, NULL, 1.0f / 60));
  const hair_view view = view_of(hair);
  double x = 0;
  for (uint32_t p = 0; p < view.point_count; ++p) x += view.points[3 * p] / view.point_count;
  CHECK(x > 0.02);
  hair_destroy(hair);
}

static void radiance_is_what_colours_are_made_of(void) {
  hair_instance* hair = small_hair();
  dance(hair, 0, 2);
  const hair_view before = view_of(hair);
  CHECK(before.radiance == NULL && before.colours != NULL);
  uint8_t* bytes = malloc(4 * (size_t)before.point_count);
  memcpy(bytes, before.colours, 4 * (size_t)before.point_count);
  hair_settings settings;
  OK(hair_settings_init(&settings, sizeof settings));
  CHECK(settings.encode == 1 && settings.radiance == 0);
  settings.radiance = 1;
  OK(hair_set_settings(hair, &settings));
  OK(hair_relight(hair));
  const hair_view both = view_of(hair);
  CHECK(both.radiance != NULL);
  CHECK(memcmp(bytes, both.colours, 4 * (size_t)both.point_count) == 0);
  for (uint32_t p = 0; p < both.point_count; ++p)
    for (int c = 0; c < 3; ++c) {
      const float light = both.radiance[3 * p + c];
      const double shown = light <= 0.0031308f ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
      CHECK(light >= 0 && fabs(fmin(255 * shown, 255) - both.colours[4 * p + c]) < 0.75);
    }
  settings.encode = 0;
  OK(hair_set_settings(hair, &settings));
  OK(hair_relight(hair));
  CHECK(view_of(hair).radiance != NULL && view_of(hair).colours == NULL);
  settings.shade = 0;
  OK(hair_set_settings(hair, &settings));
  OK(hair_relight(hair));
  CHECK(view_of(hair).radiance == NULL && view_of(hair).colours == NULL);
  settings.encode = 2;
  REFUSED(hair_set_settings(hair, &settings), "encode");
  free(bytes);
  hair_destroy(hair);
}

static void a_restored_run_goes_on_with_the_same_bits(void) {
  hair_instance *hair = small_hair(), *other = small_hair();
  dance(hair, 0, 10);
  size_t size = 0, same = 0;
  OK(hair_save(hair, NULL, 0, &size));
  void* bytes = malloc(size);
  REFUSED(hair_save(hair, bytes, size - 1, &same), "room for");
  CHECK(same == 0);
  OK(hair_save(hair, bytes, size, &same));
  CHECK(same == size);
  const uint64_t saved = hash_of(hair);
  dance(hair, 10, 20);
  OK(hair_restore(other, bytes, size));
  CHECK(hash_of(other) == saved);
  dance(other, 10, 20);
  CHECK(hash_of(other) == hash_of(hair));
  CHECK(memcmp(view_of(hair).colours, view_of(other).colours, 4 * view_of(hair).point_count) == 0);
  const uint64_t before = hash_of(other);
  REFUSED(hair_restore(other, bytes, size / 2), "truncated");
  ((char*)bytes)[size / 2] ^= 1;
  REFUSED(hair_restore(other, bytes, size), "damaged");
  REFUSED(hair_restore(other, NULL, 0), "truncated");
  CHECK(hash_of(other) == before);
  free(bytes);
  hair_destroy(hair), hair_destroy(other);
}

static void a_restart_is_the_start_and_a_teleport_is_not_seen(void) {
  hair_instance* hair = small_hair();
  const uint64_t start = hash_of(hair);
  dance(hair, 0, 5);
  hair_transform far = body_at(5 / 60.0)->world_from_head;
  far.translation[0] += 8;
  const float x = view_of(hair).points[0];
  OK(hair_teleport(hair, &far));
  CHECK(fabsf(view_of(hair).points[0] - x - 8) < 1e-4f);
  OK(hair_restart(hair, body_at(0), 0));
  CHECK(hash_of(hair) == start);
  hair_destroy(hair);
}

/* That strands cover, in widths of a strand of the whole hair. */
static double area_of(hair_view view) {
  double area = 0;
  for (uint32_t s = 0; s < view.strand_count; ++s)
    for (uint32_t p = view.first[s]; p + 1 < view.first[s + 1]; ++p) {
      double squares = 0;
      for (int i = 0; i < 3; ++i) {
        const double d = view.points[3 * (p + 1) + i] - view.points[3 * p + i];
        squares += d * d;
      }
      area += sqrt(squares) * view.colours[4 * p + 3] / 255 * view.wider;
    }
  return area;
}

static void a_small_head_is_drawn_with_less_and_moves_the_same(void) {
  hair_instance *whole = small_hair(), *small = small_hair();
  const hair_view all = view_of(whole);
  CHECK(all.drawn_count == all.strand_count && all.wider == 1);
  float pixels = 0;
  OK(hair_head_pixels(2, 0.5f, 1080, &pixels));
  CHECK(fabsf(pixels - 1080 * 0.225f / (4 * tanf(0.25f))) < 1e-2f);
  OK(hair_set_detail(small, 4, 0.5f));
  CHECK(hash_of(small) == hash_of(whole));
  OK(hair_relight(small));
  const hair_view less = view_of(small);
  CHECK(less.strand_count == 240 && less.drawn_count < 120 && less.drawn_count > 60);
  CHECK(less.point_count < all.point_count / 2 && less.first[240] == less.point_count);
  CHECK(less.wider > 2 && fabs(area_of(less) / area_of(all) - 1) < 0.02);
  uint32_t faint = 0;
  for (uint32_t p = 0; p < less.point_count; ++p) faint += less.colours[4 * p + 3] < 255;
  CHECK(faint > 0 && faint < less.point_count / 2);
  /* Another level every frame; back at all of it, it is the hair that was always whole. */
  for (int f = 1; f <= 10; ++f) {
    OK(hair_set_detail(small, (float)(2 + f % 3), 1));
    dance(small, f - 1, f);
  }
  dance(whole, 0, 10);
  CHECK(hash_of(small) != hash_of(whole));
  OK(hair_set_detail(small, 0, 1));
  OK(hair_relight(small));
  CHECK(hash_of(small) == hash_of(whole));
  CHECK(memcmp(view_of(small).colours, view_of(whole).colours, 4 * all.point_count) == 0);
  REFUSED(hair_set_detail(small, -1, 1), "pixels high");
  REFUSED(hair_set_detail(small, NAN, 1), "pixels high");
  REFUSED(hair_set_detail(small, 100, 0), "importance");
  REFUSED(hair_set_detail(small, 100, 1.5f), "importance");
  REFUSED(hair_set_detail(NULL, 100, 1), "hair_instance");
  REFUSED(hair_head_pixels(0, 1, 1, &pixels), "distance");
  hair_destroy(whole), hair_destroy(small);
}

/* Level strands, `across` times `layers`, 1 mm apart, of three points over 10 cm. */
static hair_strands wall(uint32_t across, uint32_t layers) {
  hair_strands s;
  const uint32_t strands = across * layers;
  float* points = malloc(9 * strands * sizeof(float));
  uint32_t* first = malloc((strands + 1) * sizeof(uint32_t));
  for (uint32_t i = 0; i <= strands; ++i) first[i] = 3 * i;
  for (uint32_t i = 0; i < 3 * strands; ++i) {
    points[3 * i] = 0.05f * (float)(i % 3);
    points[3 * i + 1] = -1e-3f * (float)(i / 3 / across);
    points[3 * i + 2] = 1e-3f * (float)(i / 3 % across);
  }
  s.points = points, s.first = first;
  s.point_count = 3 * strands, s.strand_count = strands;
  return s;
}

static void free_strands(hair_strands s) {
  free((void*)s.points);
  free((void*)s.first);
}

static void shadows_keep_beers_law(void) {
  const hair_strands strands = wall(100, 100);
  const hair_fibre fibre = {1e-4f, 0.5f, 1};
  const hair_light light = {HAIR_LIGHT_PARALLEL, {0, -1, 0}, {0, 0, 0}, {1, 1, 1}};
  hair_map map;
  OK(hair_map_init(&map, sizeof map));
  map.cells = 64;
  map.cell_size = 5e-3f;
  float* light_left = malloc(strands.point_count * sizeof(float));
  hair_shadow* shadow = NULL;
  OK(hair_shadow_create(&shadow));
  REFUSED(hair_shadow_sample(shadow, strands.points, 1, light_left), "still to come");
  OK(hair_shadow_compute(shadow, &strands, &fibre, &light, &map, light_left));
  /* d metres deep exp(-d * width * opacity / spacing^2) of the light is left. */
  for (uint32_t layer = 0; layer < 100; layer += 11) {
    const double expected = exp(-1e-3 * layer * fibre.width * fibre.opacity / 1e-6);
    CHECK(fabs(light_left[(layer * 100 + 50) * 3 + 1] - expected) < 0.06);
  }
  /* The ground below is shadowed too, and what is beside is not. */
  const float ground[6] = {0.05f, -0.5f, 0.05f, 3, -0.5f, 3};
  float there[2];
  OK(hair_shadow_sample(shadow, ground, 2, there));
  CHECK(there[0] < 0.02f && there[1] == 1);
  hair_shadow_destroy(shadow);
  hair_shadow_destroy(NULL);
  free(light_left);
  free_strands(strands);
}

static void hair_is_made_of_own_strands_and_of_own_guides(void) {
  hair_strands strands = wall(30, 10);
  hair_instance* hair = NULL;
  hair_binding binding;
  hair_settings settings;
  OK(hair_binding_init(&binding, sizeof binding));
  OK(hair_settings_init(&settings, sizeof settings));
  binding.guides = 20;
  settings.wind[1] = 1;
  OK(hair_create_from_strands(&strands, NULL, &binding, NULL, &settings, NULL, &hair));
  /* At rest it is what was given. */
  hair_view view = view_of(hair);
  for (uint32_t i = 0; i < 3 * strands.point_count; ++i)
    CHECK(fabsf(view.points[i] - strands.points[i]) < 1e-5f);
  OK(hair_step(hair, NULL, 0.1f));
  hair_destroy(hair);

  OK(hair_create_from_guides(strands.points, 300, 3, NULL, NULL, &settings, NULL, &hair));
  view = view_of(hair);
  CHECK(view.strand_count == 300 && view.first[300] == 900);
  OK(hair_step(hair, NULL, 0.1f));
  /* The mesh of a head: hair that starts in the middle of a large tetrahedron comes out of none. */
  const float corners[12] = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
  const uint32_t triangles[12] = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
  hair_head head = {corners, triangles, 4, 4, 0.1f};
  hair_destroy(hair);
  OK(hair_create_from_guides(strands.points, 300, 3, NULL, &head, NULL, NULL, &hair));
  OK(hair_step(hair, NULL, 1.0f / 60));
  hair_destroy(hair);
  head.cell = -1;
  REFUSED(hair_create_from_guides(strands.points, 300, 3, NULL, &head, NULL, NULL, &hair), "cell");
  CHECK(hair == NULL);
  free_strands(strands);
}

void errors(void);
void threads(void);
void abi(void);

int main(void) {
  CHECK(hair_version() == (HAIR_C_VERSION_MAJOR << 16 | HAIR_C_VERSION_MINOR));
  CHECK(strlen(hair_library_version()) >= 5 && strcmp(hair_last_error(), "") == 0);
  hair_moves_and_is_read();
  self_collision_that_comes_late_is_that_from_the_start();
  settings_and_lights_take_effect();
  radiance_is_what_colours_are_made_of();
  a_restored_run_goes_on_with_the_same_bits();
  a_restart_is_the_start_and_a_teleport_is_not_seen();
  a_small_head_is_drawn_with_less_and_moves_the_same();
  shadows_keep_beers_law();
  hair_is_made_of_own_strands_and_of_own_guides();
  errors();
  threads();
  abi();
  printf(broken ? "%d laws broken\n" : "all laws kept\n", broken);
  return broken ? 1 : 0;
}
