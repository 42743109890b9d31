/* The hair library for C, and for all that can call C: one head of hair over its frames, and
   shadows on strands of one's own. docs/c_interface.md has the whole contract. In short:

   - SI units: metres, kilograms, seconds, radians. Right-handed, +Y up. Points are three floats.
   - Functions return HAIR_OK or why not; hair_last_error() says it in words. A call that fails
     changes nothing and writes no result (what it was to create is null); nothing is ever thrown.
   - A struct that begins with `size` grows at its end in later versions. Its function hair_..._init
     sets the size and the defaults; a program compiled with an older header goes on working. All
     other structs stay as they are.
   - Pointers that hair_read returns are the library's and stay until the next call that changes the
     same hair. What a caller hands over is copied, or used only during the call.
   - One hair, one thread at a time; different hairs in different threads at once. */
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

/* Of this header. The library's own: hair_version(). */
#define HAIR_C_VERSION_MAJOR 1
#define HAIR_C_VERSION_MINOR 1

#ifdef __cplusplus
extern "C" {
#endif

/* ---- What went wrong ---- */

typedef int32_t hair_status;
enum {
  HAIR_OK = 0,
  HAIR_BAD_ARGUMENT = 1, /* a null pointer, a number out of range, bytes that are no state ... */
  HAIR_OUT_OF_MEMORY = 2,
  HAIR_INTERNAL_ERROR = 3 /* a fault of the library */
};

/* Major * 65536 + minor of the interface that the library has. The same major, and no smaller a
   minor than the header's: all of the header is there. */
HAIR_C_EXPORT uint32_t hair_version(void);
/* Of the library behind the interface: "0.1.0". */
HAIR_C_EXPORT const char* hair_library_version(void);
/* Why the last call of this thread that failed did; "" where none has. Stays until the next one
   that fails. */
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

/* All behind it is solid. */
typedef struct hair_plane {
  float point[3];  /* anywhere on it, metres, world space; goes where the surface goes */
  float normal[3]; /* unit; to the free side */
} hair_plane;

enum { HAIR_LIGHT_PARALLEL = 0, HAIR_LIGHT_POINT = 1 };
typedef struct hair_light {
  uint32_t kind;
  float direction[3]; /* parallel: the way light travels, any length but zero */
  float position[3];  /* at a point: metres, world space */
  float colour[3];    /* linear, >= 0; of a light at a point: what arrives at the head's joint */
} hair_light;

/* What a drawn strand stands for. */
typedef struct hair_fibre {
  float width;            /* of one hair, metres; human hair: 50e-6 to 100e-6 */
  float opacity;          /* of one hair to the light, (0, 1] */
  float hairs_per_strand; /* >= 1 */
} hair_fibre;

/* Strands of the caller, root first: strand s owns points first[s] .. first[s + 1] - 1. */
typedef struct hair_strands {
  const float* points;   /* [3 * point_count], metres */
  const uint32_t* first; /* [strand_count + 1], first[0] = 0, never decreasing */
  uint32_t point_count;
  uint32_t strand_count;
} hair_strands;

/* A closed mesh in head space (metres, +Y up, +Z where the face looks, origin at the joint on which
   the head turns) that hair collides with. */
typedef struct hair_head {
  const float* positions;    /* [3 * position_count], metres */
  const uint32_t* triangles; /* [3 * triangle_count], counter-clockwise from outside */
  uint32_t position_count;
  uint32_t triangle_count;
  float cell; /* of its distance field, metres; 0: 0.004 */
} hair_head;

/* ---- Structs that grow ---- */

enum { HAIR_LINKS_DIRECT = 0, HAIR_LINKS_RELAXATION = 1 };
enum { HAIR_REPEL_FROM_CELL_CENTRE = 0, HAIR_REPEL_DOWN_GRADIENT = 1 };
enum { HAIR_DEPOSIT_POINTS = 0, HAIR_DEPOSIT_COLUMNS, HAIR_DEPOSIT_SEGMENTS };
enum { HAIR_FILTER_NONE = 0, HAIR_FILTER_PAPER, HAIR_FILTER_CENTRED, HAIR_FILTER_FOOTPRINT };

/* How hair moves, is shadowed and looks. Switches are 0 or 1. The same fields, ranges and defaults
   as FrameSettings (libhair/simulation/frame.h), where each is explained; those marked R shape the
   rest state, and what they are when a hair is made is what it keeps. */
typedef struct hair_settings {
  uint32_t size;
  float linear_density;    /* kg/m; R */
  float bending_stiffness; /* N m^2 at the root; R */
  float tip_stiffness;     /* fraction of it left at the tip, (0, 1]; R */
  float bend_damping;      /* seconds */
  float air_drag;          /* 1/s */
  float carried_air;       /* how much of the head's motion the air in its hair has, [0, 1] */
  float friction;          /* Coulomb's, against colliders */
  float skin;              /* metres that guides keep from colliders; R */
  float gravity[3];        /* m/s^2; R: what the rest shape holds against */
  float substep;           /* seconds */
  uint32_t link_solver;    /* HAIR_LINKS_... */
  uint32_t iterations;     /* of it a substep, 1 to 32 */

  uint32_t self_collision;   /* learns the density at rest when it is first on */
  uint32_t repulsion_kind;   /* HAIR_REPEL_... */
  float repulsion_cell_size; /* metres */
  uint32_t repulsion_cells;  /* along each axis */
  uint32_t repulsion_stride; /* every so many drawn strands are counted, for all */
  float repulsion_threshold; /* metres of hair per m^3 that never push */
  float repulsion_tolerance; /* nor does less than the groom's own density times this */
  float repulsion_strength;  /* m/s^2 where density is twice what it may be */
  float repulsion_limit;     /* m/s^2, the most */
  float repulsion_interval;  /* seconds */

  float wind[3];      /* m/s */
  float gust;         /* swing of the speed, [0, 1] */
  float gust_length;  /* metres from gust to gust */
  float wind_shelter; /* metres: half a hair's width times its drag; 0: none */

  uint32_t shadow;      /* transmittance is made */
  uint32_t body_shadow; /* head and capsules throw shadows on the hair */
  uint32_t map_cells;   /* along each axis, 2 to 1024 */
  float map_cell_size;  /* metres */
  uint32_t map_deposit; /* HAIR_DEPOSIT_... */
  uint32_t map_filter;  /* HAIR_FILTER_... */
  float map_footprint;  /* metres; of HAIR_FILTER_FOOTPRINT */

  uint32_t shade;       /* colours are made, and radiance where it is asked for below */
  float eye[3];         /* where the picture is taken from, metres */
  float root_colour[3]; /* linear */
  float tip_colour[3];  /* linear */
  float variation, ambient, diffuse, specular, exponent;
  float second_specular, second_exponent, first_shift, second_shift;
  uint32_t encode;   /* colours are made while shade is on; default 1 */
  uint32_t radiance; /* linear radiance is kept while shade is on; default 0 */
} hair_settings;

enum { HAIR_STYLE_SMOOTH = 0, HAIR_STYLE_CURLY = 1, HAIR_STYLE_LONG = 2 };

/* A built-in hairstyle on the built-in head. */
typedef struct hair_style {
  uint32_t size;
  uint32_t kind;             /* HAIR_STYLE_... */
  uint32_t strands;          /* drawn, >= wisps */
  uint32_t points;           /* a drawn strand, >= 2 */
  uint32_t wisps;            /* of three guides each */
  uint32_t points_per_guide; /* 3 to 64 */
  uint32_t seed;
  float hairs; /* that the drawn strands stand for together */
} hair_style;

/* How strands of the caller get guides: some of them, chosen far from each other. */
typedef struct hair_binding {
  uint32_t size;
  uint32_t guides;           /* at most as many as there are strands */
  uint32_t points_per_guide; /* 2 to 64 */
  float shape_weight;        /* how much a difference of shape counts beside one of roots, >= 0 */
} hair_binding;

/* Where head and body are at the end of a step. As many capsules and planes as in the step before
   have moved from there; other counts are new ones that stand where they are. */
typedef struct hair_body {
  uint32_t size;
  uint32_t capsule_count; /* at most 64 */
  uint32_t plane_count;   /* at most 8 */
  hair_transform world_from_head;
  const hair_capsule* capsules;
  const hair_plane* planes;
} hair_body;

/* What can be read of a hair. Pointers: see the top. */
typedef struct hair_view {
  uint32_t size;
  uint32_t light_count; /* 0 while shadows are off */
  uint32_t strand_count;
  uint32_t point_count;
  const float* points;        /* [3 * point_count], metres, world space */
  const uint32_t* first;      /* [strand_count + 1], as in hair_strands */
  const float* transmittance; /* [light_count * point_count], what of each light gets to each point;
                                 null while shadows are off */
  const uint8_t* colours;     /* [4 * point_count] sRGB and opacity: R, G, B, A; A is 255 but for
                                 strands on their way out; null while shading or encoding is
                                 off */
  double time;                /* simulated seconds */
  uint32_t drawn_count;       /* strands that have points: all, but for hair_set_detail */
  float wider;                /* so much wider are strands to be drawn than all of them would be */
  const float* radiance;      /* [3 * point_count] linear RGB, of which colours are the bytes; >= 0,
                                 may be above 1; null unless hair_settings.radiance and shading
                                 are on */
} hair_view;

/* A density map, for shadows on strands of one's own. */
typedef struct hair_map {
  uint32_t size;
  uint32_t cells;  /* along each axis, 2 to 1024 */
  float cell_size; /* metres */
  uint32_t deposit;
  uint32_t filter;
  float footprint; /* metres; of HAIR_FILTER_FOOTPRINT */
  float pivot[3];  /* what a light at a point looks at: the hair's middle, metres */
} hair_map;

/* Defaults, for a struct of `size` bytes: hair_settings_init(&settings, sizeof settings). */
HAIR_C_EXPORT hair_status hair_settings_init(hair_settings* settings, size_t size);
HAIR_C_EXPORT hair_status hair_style_init(hair_style* style, size_t size, uint32_t kind);
HAIR_C_EXPORT hair_status hair_binding_init(hair_binding* binding, size_t size);
HAIR_C_EXPORT hair_status hair_body_init(hair_body* body, size_t size);
HAIR_C_EXPORT hair_status hair_map_init(hair_map* map, size_t size);

/* ---- One head of hair ---- */

typedef struct hair_instance hair_instance;

/* All hairs are made at rest on `body`. Null for `settings`, `body`, `fibre`, `binding`: the
   defaults; for `head`: hair that collides with no head. */

HAIR_C_EXPORT hair_status hair_create_from_style(const hair_style* style,
                                                 const hair_settings* settings,
                                                 const hair_body* body, hair_instance** out);
/* Strands of the caller at rest, in head space, of two points or more: some become guides, all
   follow them and are drawn. Without a fibre they stand for 100,000 hairs together. */
HAIR_C_EXPORT hair_status hair_create_from_strands(const hair_strands* strands,
                                                   const hair_fibre* fibre,
                                                   const hair_binding* binding,
                                                   const hair_head* head,
                                                   const hair_settings* settings,
                                                   const hair_body* body, hair_instance** out);
/* Guides of the caller at rest, in head space: `points` is [3 * guide_count * points_per_guide],
   root first. What is drawn and shadowed are the guides themselves. */
HAIR_C_EXPORT hair_status hair_create_from_guides(const float* points, uint32_t guide_count,
                                                  uint32_t points_per_guide,
                                                  const hair_fibre* fibre, const hair_head* head,
                                                  const hair_settings* settings,
                                                  const hair_body* body, hair_instance** out);
/* Null is no hair. */
HAIR_C_EXPORT void hair_destroy(hair_instance* hair);

/* From the next step or hair_relight on. */
HAIR_C_EXPORT hair_status hair_set_settings(hair_instance* hair, const hair_settings* settings);
/* At first there is one, parallel and white from straight above. None: ambient light only. */
HAIR_C_EXPORT hair_status hair_set_lights(hair_instance* hair, const hair_light* lights,
                                          uint32_t count);

/* Moves the hair by `seconds`, 1e-6 to 1, to where the body is then (null: where it was), shadows
   and shades it. */
HAIR_C_EXPORT hair_status hair_step(hair_instance* hair, const hair_body* body, float seconds);
/* Shadows and shades the hair as it stands, with the detail that it was set. */
HAIR_C_EXPORT hair_status hair_relight(hair_instance* hair);
/* Back to rest on the body (null: where it was), then `settle` seconds (0 to 3600) to find its way
   out of it. */
HAIR_C_EXPORT hair_status hair_restart(hair_instance* hair, const hair_body* body, float settle);
/* To another place with its head: the hair does not see the jump. */
HAIR_C_EXPORT hair_status hair_teleport(hair_instance* hair, const hair_transform* world_from_head);

/* How high a head is in a picture, from chin to crown, in pixels: the picture is `picture_height`
   pixels high and sees the angle `field_of_view` (radians, bottom to top) from `distance` metres.
 */
HAIR_C_EXPORT hair_status hair_head_pixels(float distance, float field_of_view,
                                           float picture_height, float* pixels);
/* From the next step, restart or hair_relight on, as much of the hair is drawn as a head needs that
   is `pixels` high; 0: all of it, as at first. A head of `importance` 0.5, of (0, 1], is drawn as
   one half as large. Any frame may have another: guides do not feel it. Strands keep their numbers,
   and one that is not drawn has no points; draw the others hair_view.wider times as wide. */
HAIR_C_EXPORT hair_status hair_set_detail(hair_instance* hair, float pixels, float importance);

/* Set view->size = sizeof *view before. */
HAIR_C_EXPORT hair_status hair_read(const hair_instance* hair, hair_view* view);
/* Over the exact bits of guides and drawn points: equal on every machine and number of threads. */
HAIR_C_EXPORT hair_status hair_state_hash(const hair_instance* hair, uint64_t* hash);

/* What the next step starts from; settings, lights and the hairstyle are not part of it. Writes its
   size to *size, and, where `bytes` is not null, the state to `bytes`, which has room for
   `capacity`. */
HAIR_C_EXPORT hair_status hair_save(const hair_instance* hair, void* bytes, size_t capacity,
                                    size_t* size);
/* Goes on from a state of the same hairstyle and rest shape, with the bits of the run that was
   saved; shadows and shades it. As much of the hair must be drawn as was (hair_set_detail). */
HAIR_C_EXPORT hair_status hair_restore(hair_instance* hair, const void* bytes, size_t size);

/* ---- Shadows on strands of one's own, without simulation ---- */

typedef struct hair_shadow hair_shadow;

HAIR_C_EXPORT hair_status hair_shadow_create(hair_shadow** out);
/* Null is no shadow. */
HAIR_C_EXPORT void hair_shadow_destroy(hair_shadow* shadow);
/* Fills the map with the strands. `transmittance`: [point_count], the part of the light that gets
   to each point, without what a strand takes from itself; or null. Keep the shadow from frame to
   frame: it keeps its memory. Null for `map`: the defaults. */
HAIR_C_EXPORT hair_status hair_shadow_compute(hair_shadow* shadow, const hair_strands* strands,
                                              const hair_fibre* fibre, const hair_light* light,
                                              const hair_map* map, float* transmittance);
/* The shadow of the strands on any points, of a head or the ground: `points` is [3 * count],
   `transmittance` [count]. */
HAIR_C_EXPORT hair_status hair_shadow_sample(const hair_shadow* shadow, const float* points,
                                             size_t count, float* transmittance);

/* ---- Threads ---- */

/* How many threads the calls that this thread makes from now on use, itself included; 0: as many as
   the machine has, which is what they do at first. Results have the same bits whatever it is. */
HAIR_C_EXPORT hair_status hair_use_threads(uint32_t count);

typedef struct hair_tasks hair_tasks;

/* Threads of the caller's own. */
typedef struct hair_pool {
  uint32_t size;
  uint32_t thread_count; /* tasks that run at once, 1 to 1024 */
  /* Calls hair_do_task(tasks, i) once for each i below task_count, in any order, from any thread,
     and returns when the last is done. Must not throw. */
  void (*run)(void* user, size_t task_count, const hair_tasks* tasks);
  void* user;
} hair_pool;

/* The calls that this thread makes from now on run on that pool and start no threads of their own.
   Null: the library's threads again. */
HAIR_C_EXPORT hair_status hair_use_pool(const hair_pool* pool);
HAIR_C_EXPORT void hair_do_task(const hair_tasks* tasks, size_t index);

#ifdef __cplusplus
}
#endif

#endif
