/* C interface of the hair library: simulates and shadows heads of hair, and shadows strands of the
   caller's own. docs/c_interface.md has the full contract. In short:

   - SI units: metres, kilograms, seconds, radians. Right-handed, +Y up. Points are three floats.
   - Functions return HAIR_OK or an error code; hair_last_error() has the message. A failed call
     changes nothing and writes no result (a handle to be created becomes null). No exceptions.
   - A struct that begins with `size` grows at its end in later versions. Its function hair_..._init
     sets the size and the defaults; programs compiled with an older header keep working. All other
     structs never change.
   - Pointers from hair_read belong to the library and are valid until the next call that changes
   the same hair. Input is copied, or used only during the call.
   - Use a hair from one thread at a time; different hairs may be used in parallel. */
#ifndef LIBHAIR_C_HAIR_H
#define LIBHAIR_C_HAIR_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define HAIR_C_EXPORT
#elif defined(__GNUC__)
#define HAIR_C_EXPORT __attribute__((visibility("default")))
#else
#define HAIR_C_EXPORT
#endif

/* Version of this header. hair_version() returns the library's. */
#define HAIR_C_VERSION_MAJOR 1
#define HAIR_C_VERSION_MINOR 1

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Errors ---- */

typedef int32_t hair_status;
enum {
  HAIR_OK = 0,
  HAIR_BAD_ARGUMENT = 1, /* a null pointer, a number out of range, an invalid state ... */
  HAIR_OUT_OF_MEMORY = 2,
  HAIR_INTERNAL_ERROR = 3 /* a bug in the library */
};

/* Major * 65536 + minor version of the library's interface. Compatible with a header of the same
   major and the same or a lower minor version. */
HAIR_C_EXPORT uint32_t hair_version(void);
/* Version of the library behind the interface: "0.1.0". */
HAIR_C_EXPORT const char* hair_library_version(void);
/* Message of this thread's last failed call; "" if none. Valid until the next failed call. */
HAIR_C_EXPORT const char* hair_last_error(void);

/* ---- Plain data; never changes ---- */

/* Rotation, then translation: p -> rotation(p) + translation. */
typedef struct hair_transform {
  float rotation[4];    /* unit quaternion: w, x, y, z */
  float translation[3]; /* metres */
} hair_transform;

/* A sphere swept from a to b. */
typedef struct hair_capsule {
  float a[3], b[3], radius; /* metres, world space */
} hair_capsule;

/* A half space: all behind the plane is solid. */
typedef struct hair_plane {
  float point[3];  /* any point of the plane, metres, world space; moves with the surface */
  float normal[3]; /* unit, towards the free side */
} hair_plane;

enum { HAIR_LIGHT_PARALLEL = 0, HAIR_LIGHT_POINT = 1 };
typedef struct hair_light {
  uint32_t kind;
  float direction[3]; /* parallel: direction of travel, any length but zero */
  float position[3];  /* point: metres, world space */
  float colour[3];    /* linear, >= 0; point: irradiance at the head's joint */
} hair_light;

/* Optical properties of a drawn strand, and the number of hairs that it represents. */
typedef struct hair_fibre {
  float width;            /* of one hair, metres; human hair: 50e-6 to 100e-6 */
  float opacity;          /* of one hair, (0, 1] */
  float hairs_per_strand; /* >= 1 */
} hair_fibre;

/* Strands of the caller, root first: strand s owns points first[s] .. first[s + 1] - 1. */
typedef struct hair_strands {
  const float* points;   /* [3 * point_count], metres */
  const uint32_t* first; /* [strand_count + 1], first[0] = 0, never decreasing */
  uint32_t point_count;
  uint32_t strand_count;
} hair_strands;

/* Collider: a closed mesh in head space (metres, +Y up, the face towards +Z, origin at the joint on
   which the head turns). */
typedef struct hair_head {
  const float* positions;    /* [3 * position_count], metres */
  const uint32_t* triangles; /* [3 * triangle_count], counter-clockwise from outside */
  uint32_t position_count;
  uint32_t triangle_count;
  float cell; /* cell size of its distance field, metres; 0: 0.004 */
} hair_head;

/* ---- Structs that grow ---- */

enum { HAIR_LINKS_DIRECT = 0, HAIR_LINKS_RELAXATION = 1 };
enum { HAIR_REPEL_FROM_CELL_CENTRE = 0, HAIR_REPEL_DOWN_GRADIENT = 1 };
enum { HAIR_DEPOSIT_POINTS = 0, HAIR_DEPOSIT_COLUMNS, HAIR_DEPOSIT_SEGMENTS };
enum { HAIR_FILTER_NONE = 0, HAIR_FILTER_PAPER, HAIR_FILTER_CENTRED, HAIR_FILTER_FOOTPRINT };

/* Settings of simulation, shadows and shading. Switches are 0 or 1. Fields, ranges and defaults are
   those of FrameSettings (libhair/simulation/frame.h), which explains each. Those marked R
   determine the rest state: a hair keeps the values that it was created with. */
typedef struct hair_settings {
  uint32_t size;
  float linear_density;    /* kg/m; R */
  float bending_stiffness; /* N m^2 at the root; R */
  float tip_stiffness;     /* fraction of it left at the tip, (0, 1]; R */
  float bend_damping;      /* seconds */
  float air_drag;          /* 1/s */
  float carried_air;    /* fraction of the head's velocity that the air in the hair has, [0, 1] */
  float friction;       /* Coulomb coefficient, against colliders */
  float skin;           /* distance that guides keep from colliders, metres; R */
  float gravity[3];     /* m/s^2; R: the rest shape is in equilibrium with it */
  float substep;        /* seconds */
  uint32_t link_solver; /* HAIR_LINKS_... */
  uint32_t iterations;  /* of the link solver, a substep, 1 to 32 */

  uint32_t self_collision;   /* measures the rest density when it is first on */
  uint32_t repulsion_kind;   /* HAIR_REPEL_... */
  float repulsion_cell_size; /* metres */
  uint32_t repulsion_cells;  /* along each axis */
  uint32_t repulsion_stride; /* splat every Nth drawn strand, weighted by N */
  float repulsion_threshold; /* metres of hair per m^3; below it nothing is pushed */
  float repulsion_tolerance; /* push starts at this multiple of the rest density, >= 1 */
  float repulsion_strength;  /* m/s^2 where density is twice the allowed density */
  float repulsion_limit;     /* m/s^2, upper bound of the push */
  float repulsion_interval;  /* seconds between updates of the push */

  float wind[3];      /* m/s */
  float gust;         /* relative amplitude of the speed, [0, 1] */
  float gust_length;  /* wavelength of gusts, metres */
  float wind_shelter; /* metres: occlusion by hair, width × drag coefficient / 2; 0: none */

  uint32_t shadow;      /* computes transmittance */
  uint32_t body_shadow; /* head and capsules cast shadows on the hair */
  uint32_t map_cells;   /* along each axis, 2 to 1024 */
  float map_cell_size;  /* metres */
  uint32_t map_deposit; /* HAIR_DEPOSIT_... */
  uint32_t map_filter;  /* HAIR_FILTER_... */
  float map_footprint;  /* metres; of HAIR_FILTER_FOOTPRINT */

  uint32_t shade;       /* computes colours and radiance, see encode and radiance */
  float eye[3];         /* camera position, metres */
  float root_colour[3]; /* linear */
  float tip_colour[3];  /* linear */
  float variation, ambient, diffuse, specular, exponent;
  float second_specular, second_exponent, first_shift, second_shift;
  uint32_t encode;   /* writes colours while shade is on; default 1 */
  uint32_t radiance; /* stores linear radiance while shade is on; default 0 */
} hair_settings;

enum { HAIR_STYLE_SMOOTH = 0, HAIR_STYLE_CURLY = 1, HAIR_STYLE_LONG = 2 };

/* A built-in hairstyle on the built-in head. */
typedef struct hair_style {
  uint32_t size;
  uint32_t kind;             /* HAIR_STYLE_... */
  uint32_t strands;          /* drawn, >= wisps */
  uint32_t points;           /* per drawn strand, >= 2 */
  uint32_t wisps;            /* of three guides each */
  uint32_t points_per_guide; /* 3 to 64 */
  uint32_t seed;
  float hairs; /* number of hairs that the drawn strands represent together */
} hair_style;

/* How guides are chosen among the caller's strands: farthest from each other. */
typedef struct hair_binding {
  uint32_t size;
  uint32_t guides;           /* at most the number of strands */
  uint32_t points_per_guide; /* 2 to 64 */
  float shape_weight;        /* weight of a difference of shape relative to one of roots, >= 0 */
} hair_binding;

/* Pose of head and body at the end of a step. If the numbers of capsules and planes are those of
   the step before, colliders move from their old poses; otherwise all are new ones at rest. */
typedef struct hair_body {
  uint32_t size;
  uint32_t capsule_count; /* at most 64 */
  uint32_t plane_count;   /* at most 8 */
  hair_transform world_from_head;
  const hair_capsule* capsules;
  const hair_plane* planes;
} hair_body;

/* Output arrays of a hair. Lifetime of pointers: see the top. */
typedef struct hair_view {
  uint32_t size;
  uint32_t light_count; /* 0 while shadows are off */
  uint32_t strand_count;
  uint32_t point_count;
  const float* points;        /* [3 * point_count], metres, world space */
  const uint32_t* first;      /* [strand_count + 1], as in hair_strands */
  const float* transmittance; /* [light_count * point_count], [0, 1], of each light at each point;
                                 null while shadows are off */
  const uint8_t* colours;     /* [4 * point_count] sRGB and opacity: R, G, B, A; A is 255 except for
                                 strands that fade out; null while shading or encoding is off */
  double time;                /* simulated seconds */
  uint32_t drawn_count;       /* strands with points; all, unless hair_set_detail reduced them */
  float wider;                /* draw strands wider by this factor */
  const float* radiance;      /* [3 * point_count] linear RGB before encoding to colours; >= 0, may
                                 be above 1; null unless hair_settings.radiance and shading are on */
} hair_view;

/* Settings of a density map, for shadows on the caller's strands. */
typedef struct hair_map {
  uint32_t size;
  uint32_t cells;  /* along each axis, 2 to 1024 */
  float cell_size; /* metres */
  uint32_t deposit;
  uint32_t filter;
  float footprint; /* metres; of HAIR_FILTER_FOOTPRINT */
  float pivot[3];  /* target of a point light: the hair's centre, metres */
} hair_map;

/* Defaults, for a struct of `size` bytes: hair_settings_init(&settings, sizeof settings). */
HAIR_C_EXPORT hair_status hair_settings_init(hair_settings* settings, size_t size);
HAIR_C_EXPORT hair_status hair_style_init(hair_style* style, size_t size, uint32_t kind);
HAIR_C_EXPORT hair_status hair_binding_init(hair_binding* binding, size_t size);
HAIR_C_EXPORT hair_status hair_body_init(hair_body* body, size_t size);
HAIR_C_EXPORT hair_status hair_map_init(hair_map* map, size_t size);

/* ---- One head of hair ---- */

typedef struct hair_instance hair_instance;

/* Hairs are created at rest on `body`. Null for `settings`, `body`, `fibre`, `binding`: the
   defaults; for `head`: no collision with a head. */

HAIR_C_EXPORT hair_status hair_create_from_style(const hair_style* style,
                                                 const hair_settings* settings,
                                                 const hair_body* body, hair_instance** out);
/* From the caller's strands at rest, in head space, of at least two points: some become guides; all
   follow them and are drawn. Without a fibre they represent 100,000 hairs together. */
HAIR_C_EXPORT hair_status hair_create_from_strands(const hair_strands* strands,
                                                   const hair_fibre* fibre,
                                                   const hair_binding* binding,
                                                   const hair_head* head,
                                                   const hair_settings* settings,
                                                   const hair_body* body, hair_instance** out);
/* From the caller's guides at rest, in head space: `points` is [3 * guide_count *
   points_per_guide], root first. The guides themselves are drawn and shadowed. */
HAIR_C_EXPORT hair_status hair_create_from_guides(const float* points, uint32_t guide_count,
                                                  uint32_t points_per_guide,
                                                  const hair_fibre* fibre, const hair_head* head,
                                                  const hair_settings* settings,
                                                  const hair_body* body, hair_instance** out);
/* Does nothing for null. */
HAIR_C_EXPORT void hair_destroy(hair_instance* hair);

/* Takes effect with the next step or hair_relight. */
HAIR_C_EXPORT hair_status hair_set_settings(hair_instance* hair, const hair_settings* settings);
/* Default: one parallel white light from straight above. None: ambient light only. */
HAIR_C_EXPORT hair_status hair_set_lights(hair_instance* hair, const hair_light* lights,
                                          uint32_t count);

/* Advances the hair by `seconds`, 1e-6 to 1, to the new pose of the body (null: unchanged), shadows
   and shades it. */
HAIR_C_EXPORT hair_status hair_step(hair_instance* hair, const hair_body* body, float seconds);
/* Shadows and shades the hair without moving it, at the level of detail last set. */
HAIR_C_EXPORT hair_status hair_relight(hair_instance* hair);
/* Resets the hair to rest on the body (null: unchanged), then settles it for `settle` seconds (0 to
   3600) while colliders grow to full size. */
HAIR_C_EXPORT hair_status hair_restart(hair_instance* hair, const hair_body* body, float settle);
/* Teleports hair and head: the hair keeps its shape and gets no impulse. */
HAIR_C_EXPORT hair_status hair_teleport(hair_instance* hair, const hair_transform* world_from_head);

/* Height of a head in the picture, from chin to crown, in pixels, at `distance` metres from the
   camera: `picture_height` in pixels, vertical `field_of_view` in radians. */
HAIR_C_EXPORT hair_status hair_head_pixels(float distance, float field_of_view,
                                           float picture_height, float* pixels);
/* Level of detail for a head that is `pixels` high; 0: all strands (the default). Takes effect with
   the next step, restart or hair_relight. `importance`, (0, 1], scales the height. May change every
   frame without effect on the simulation. Strands keep their indices; those not drawn have no
   points. Draw the others hair_view.wider times as wide. */
HAIR_C_EXPORT hair_status hair_set_detail(hair_instance* hair, float pixels, float importance);

/* Set view->size = sizeof *view before. */
HAIR_C_EXPORT hair_status hair_read(const hair_instance* hair, hair_view* view);
/* Hash of the exact bits of guides and drawn points: equal on every machine and number of threads.
 */
HAIR_C_EXPORT hair_status hair_state_hash(const hair_instance* hair, uint64_t* hash);

/* Saves the state that the next step starts from, without settings, lights and hairstyle. Writes
   its size to *size, and the state to `bytes`, of `capacity` bytes, unless that is null. */
HAIR_C_EXPORT hair_status hair_save(const hair_instance* hair, void* bytes, size_t capacity,
                                    size_t* size);
/* Restores a state of the same hairstyle and rest shape; later steps are bit-identical to the saved
   run. Shadows and shades it. Needs the level of detail of the saved hair (hair_set_detail). */
HAIR_C_EXPORT hair_status hair_restore(hair_instance* hair, const void* bytes, size_t size);

/* ---- Shadows on the caller's strands, without simulation ---- */

typedef struct hair_shadow hair_shadow;

HAIR_C_EXPORT hair_status hair_shadow_create(hair_shadow** out);
/* Does nothing for null. */
HAIR_C_EXPORT void hair_shadow_destroy(hair_shadow* shadow);
/* Deposits the strands in the map. `transmittance`: [point_count], [0, 1], at the strands' points,
   without self-shadowing of a strand; or null. Reuse the shadow in every frame: it keeps its
   memory. Null for `map`: the defaults. */
HAIR_C_EXPORT hair_status hair_shadow_compute(hair_shadow* shadow, const hair_strands* strands,
                                              const hair_fibre* fibre, const hair_light* light,
                                              const hair_map* map, float* transmittance);
/* The strands' shadow on any points, such as a head or the ground: `points` is [3 * count],
   `transmittance` [count]. */
HAIR_C_EXPORT hair_status hair_shadow_sample(const hair_shadow* shadow, const float* points,
                                             size_t count, float* transmittance);

/* ---- Threads ---- */

/* Number of threads, the calling one included, for later calls from this thread; 0: those of the
   machine (the default). Results are bit-identical for any number. */
HAIR_C_EXPORT hair_status hair_use_threads(uint32_t count);

typedef struct hair_tasks hair_tasks;

/* A thread pool of the caller. */
typedef struct hair_pool {
  uint32_t size;
  uint32_t thread_count; /* concurrent tasks, 1 to 1024 */
  /* Calls hair_do_task(tasks, i) once for each i below task_count, in any order, from any thread,
     and returns when all are done. Must not throw. */
  void (*run)(void* user, size_t task_count, const hair_tasks* tasks);
  void* user;
} hair_pool;

/* Runs later calls from this thread on that pool, without starting threads. Null: the library's own
   threads. */
HAIR_C_EXPORT hair_status hair_use_pool(const hair_pool* pool);
HAIR_C_EXPORT void hair_do_task(const hair_tasks* tasks, size_t index);

#ifdef __cplusplus
}
#endif

#endif
