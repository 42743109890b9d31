/* Laws in C: CHECK says where one is broken; the program then returns 1. */
#ifndef HAIR_TESTS_C_CHECK_H
#define HAIR_TESTS_C_CHECK_H

#include <libhair/c/hair.h>
#include <stdio.h>

extern int broken;

#define CHECK(condition)                                                             \
  do {                                                                               \
    if (!(condition)) {                                                              \
      printf("%s:%d: not so: %s (last error: %s)\n", __FILE__, __LINE__, #condition, \
             hair_last_error());                                                     \
      ++broken;                                                                      \
    }                                                                                \
  } while (0)
#define OK(call) CHECK((call) == HAIR_OK)
#define REFUSED(call, word)                         \
  do {                                              \
    CHECK((call) == HAIR_BAD_ARGUMENT);             \
    CHECK(strstr(hair_last_error(), word) != NULL); \
  } while (0)

/* The curly style with few strands, and no other settings than the defaults. */
hair_instance* small_hair(void);
/* The head after `seconds` of nodding and turning, with a shoulder. */
const hair_body* body_at(double seconds);
uint64_t hash_of(const hair_instance* hair);

#endif
