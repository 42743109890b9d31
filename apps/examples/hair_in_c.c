/* The library from C: a head of curly hair, turned, shadowed and read.
 *
 *   example_hair_in_c
 *
 * Look at: twelve lines of work, from `hair_style_init` on; one header, one library, no C++. */
#include <libhair/c/hair.h>
#include <math.h>
#include <stdio.h>

static int failed(void) {
  printf("failed: %s\n", hair_last_error());
  return 1;
}

int main(void) {
  hair_style style;
  hair_body body;
  hair_instance* hair;
  const hair_light sun = {HAIR_LIGHT_PARALLEL, {-0.5f, -1, -1}, {0, 0, 0}, {1, 1, 1}};
  hair_view view;

  view.size = sizeof view;
  hair_style_init(&style, sizeof style, HAIR_STYLE_CURLY);
  hair_body_init(&body, sizeof body);
  if (hair_create_from_style(&style, NULL, &body, &hair) != HAIR_OK) return failed();
  hair_set_lights(hair, &sun, 1);
  for (int frame = 1; frame <= 60; ++frame) {
    const double turn = 0.8 * sin(0.1 * frame); /* about the vertical, radians */
    body.world_from_head.rotation[0] = (float)cos(turn / 2);
    body.world_from_head.rotation[2] = (float)sin(turn / 2);
    if (hair_step(hair, &body, 1.0f / 60) != HAIR_OK) return failed();
  }
  hair_read(hair, &view);

  uint32_t lit = 0;
  for (uint32_t p = 0; p < view.point_count; ++p) lit += view.transmittance[p] > 0.5f;
  printf("%u strands, %u points after %.1f s\n", view.strand_count, view.point_count, view.time);
  printf("%u of them in the sun, first tip at %.2f %.2f %.2f m\n", lit,
         view.points[3 * view.first[1] - 3], view.points[3 * view.first[1] - 2],
         view.points[3 * view.first[1] - 1]);
  hair_destroy(hair);
  return lit > 0 ? 0 : 1;
}
