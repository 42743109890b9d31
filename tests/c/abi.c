/* What version 1.0 promised to programs that are compiled: sizes and places, of 64-bit machines.
   What is here is never changed; a version that lets a struct grow adds its new fields below the
   old. */
#include <string.h>

#include "check.h"

#define SO(name, condition) typedef char so_##name[(condition) ? 1 : -1]
#define AT(type, field, offset) SO(type##_##field, offsetof(type, field) == (offset))

SO(pointers_of_8_bytes, sizeof(void*) == 8 && sizeof(size_t) == 8);
SO(status, sizeof(hair_status) == 4);
/* These never change. */
SO(transform, sizeof(hair_transform) == 28);
SO(capsule, sizeof(hair_capsule) == 28);
SO(plane, sizeof(hair_plane) == 24);
SO(light, sizeof(hair_light) == 40);
SO(fibre, sizeof(hair_fibre) == 12);
SO(strands, sizeof(hair_strands) == 24);
SO(head, sizeof(hair_head) == 32);
AT(hair_transform, translation, 16);
AT(hair_capsule, radius, 24);
AT(hair_plane, normal, 12);
AT(hair_light, position, 16);
AT(hair_light, colour, 28);
AT(hair_strands, point_count, 16);
AT(hair_head, cell, 24);
/* These grow: what they were at first stays where it is. */
enum {
  kSettings10 = 228,
  kStyle10 = 32,
  kBinding10 = 16,
  kBody10 = 56,
  kView10 = 64,
  kMap10 = 36,
  kPool10 = 24
};
SO(settings, sizeof(hair_settings) >= kSettings10);
SO(style, sizeof(hair_style) >= kStyle10);
SO(binding, sizeof(hair_binding) >= kBinding10);
SO(body, sizeof(hair_body) >= kBody10);
SO(view, sizeof(hair_view) >= kView10);
SO(map, sizeof(hair_map) >= kMap10);
SO(pool, sizeof(hair_pool) >= kPool10);
AT(hair_settings, linear_density, 4);
AT(hair_settings, gravity, 36);
AT(hair_settings, iterations, 56);
AT(hair_settings, self_collision, 60);
AT(hair_settings, repulsion_interval, 96);
AT(hair_settings, wind, 100);
AT(hair_settings, shadow, 124);
AT(hair_settings, map_footprint, 148);
AT(hair_settings, shade, 152);
AT(hair_settings, eye, 156);
AT(hair_settings, variation, 192);
AT(hair_settings, second_shift, 224);
AT(hair_style, hairs, 28);
AT(hair_binding, shape_weight, 12);
AT(hair_body, world_from_head, 12);
AT(hair_body, capsules, 40);
AT(hair_body, planes, 48);
AT(hair_view, points, 16);
AT(hair_view, colours, 40);
AT(hair_view, time, 48);
AT(hair_view, wider, 60);
AT(hair_map, pivot, 24);
AT(hair_pool, run, 8);
AT(hair_pool, user, 16);
/* Since version 1.1. */
AT(hair_settings, encode, 228);
AT(hair_settings, radiance, 232);
AT(hair_view, radiance, 64);
/* And numbers that programs have compiled in. */
SO(statuses, HAIR_BAD_ARGUMENT == 1 && HAIR_OUT_OF_MEMORY == 2 && HAIR_INTERNAL_ERROR == 3);
SO(deposits, HAIR_DEPOSIT_POINTS == 0 && HAIR_DEPOSIT_COLUMNS == 1 && HAIR_DEPOSIT_SEGMENTS == 2);
SO(filters, HAIR_FILTER_NONE == 0 && HAIR_FILTER_CENTRED == 2 && HAIR_FILTER_FOOTPRINT == 3);
SO(styles, HAIR_STYLE_SMOOTH == 0 && HAIR_STYLE_CURLY == 1 && HAIR_STYLE_LONG == 2);

/* A program that was compiled with a later header, whose structs are larger. */
struct Later {
  hair_settings settings;
  uint32_t more[4];
};

void abi(void);
void abi(void) {
  hair_instance* hair = small_hair();
  struct Later later;
  memset(&later, 255, sizeof later);
  OK(hair_settings_init(&later.settings, sizeof later));
  CHECK(later.settings.size == sizeof later && later.more[0] == 0 && later.more[3] == 0);
  OK(hair_set_settings(hair, &later.settings));
  later.more[2] = 1;
  REFUSED(hair_set_settings(hair, &later.settings), "later version");

  hair_settings settings;
  memset(&settings, 255, sizeof settings);
  REFUSED(hair_settings_init(&settings, kSettings10 - 4), "sizeof(hair_settings)");
  CHECK(settings.size == 0xffffffffu);
  OK(hair_settings_init(&settings, kSettings10));
  const uint32_t sizes[] = {0, 4, kSettings10 - 1, 5000, 0xffffffffu};
  for (int i = 0; i < 5; ++i) {
    settings.size = sizes[i];
    REFUSED(hair_set_settings(hair, &settings), "sizeof(hair_settings)");
  }
  hair_view view;
  view.size = 8;
  REFUSED(hair_read(hair, &view), "sizeof(hair_view)");
  hair_body body = *body_at(0);
  body.size = 12;
  REFUSED(hair_step(hair, &body, 0.1f), "sizeof(hair_body)");
  hair_destroy(hair);
}
