/* Hairs in threads of their own, and threads of somebody else's. */
#include <pthread.h>
#include <string.h>

#include "check.h"

static uint64_t danced(void) {
  hair_instance* hair = small_hair();
  hair_transform nod = body_at(0)->world_from_head;
  hair_body body;
  OK(hair_body_init(&body, sizeof body));
  for (int f = 0; f < 10; ++f) {
    nod.translation[2] = 0.002f * (float)f;
    body.world_from_head = nod;
    OK(hair_step(hair, &body, 1.0f / 60));
  }
  const uint64_t hash = hash_of(hair);
  hair_destroy(hair);
  return hash;
}

struct Job {
  hair_instance* hair;
  uint32_t threads;
  uint64_t hash;
  int error_is_own;
};

static void* dance(void* user) {
  struct Job* job = user;
  hair_body body;
  char word[32];
  OK(hair_use_threads(job->threads));
  OK(hair_body_init(&body, sizeof body));
  for (int f = 0; f < 10; ++f) {
    body.world_from_head.translation[2] = 0.002f * (float)f;
    OK(hair_step(job->hair, &body, 1.0f / 60));
  }
  job->hash = hash_of(job->hair);
  snprintf(word, sizeof word, "%u", 2000 + job->threads);
  job->error_is_own =
      hair_use_threads(2000 + job->threads) == HAIR_BAD_ARGUMENT && strstr(hair_last_error(), word);
  return NULL;
}

static void a_hair_a_thread_is_as_one_after_the_other(void) {
  enum { kJobs = 4 };
  struct Job jobs[kJobs];
  pthread_t running[kJobs];
  const uint64_t expected = danced();
  for (uint32_t j = 0; j < kJobs; ++j) {
    jobs[j].hair = small_hair();
    jobs[j].threads = j;
    CHECK(pthread_create(&running[j], NULL, dance, &jobs[j]) == 0);
  }
  for (uint32_t j = 0; j < kJobs; ++j) {
    pthread_join(running[j], NULL);
    CHECK(jobs[j].hash == expected);
    CHECK(jobs[j].error_is_own);
    hair_destroy(jobs[j].hair);
  }
}

struct Pool {
  size_t runs, tasks;
  size_t forgets;
};

/* One thread, last task first. */
static void run_backwards(void* user, size_t task_count, const hair_tasks* tasks) {
  struct Pool* pool = user;
  pool->runs += 1;
  pool->tasks += task_count;
  for (size_t i = task_count; i > pool->forgets; --i) hair_do_task(tasks, i - 1);
}

static void an_own_pool_gives_the_same_bits(void) {
  struct Pool own = {0, 0, 0};
  hair_pool pool = {sizeof pool, 6, run_backwards, &own};
  const uint64_t expected = danced();
  OK(hair_use_pool(&pool));
  CHECK(danced() == expected);
  CHECK(own.runs > 10 && own.tasks > own.runs);
  const size_t runs = own.runs;
  OK(hair_use_pool(NULL));
  CHECK(danced() == expected);
  CHECK(own.runs == runs);

  pool.thread_count = 0;
  REFUSED(hair_use_pool(&pool), "thread_count");
  pool.thread_count = 6;
  pool.run = NULL;
  REFUSED(hair_use_pool(&pool), "run is null");
  /* A pool that does less than it was asked for is told. */
  pool.run = run_backwards;
  own.forgets = 1;
  hair_instance* hair = small_hair();
  OK(hair_use_pool(&pool));
  REFUSED(hair_relight(hair), "tasks");
  OK(hair_use_pool(NULL));
  OK(hair_relight(hair));
  hair_destroy(hair);
}

/* A host whose thread that waits does another job meanwhile, which has a pool of its own. */
struct Helpful {
  int helped;
};

static void run_and_help(void* user, size_t task_count, const hair_tasks* tasks) {
  struct Helpful* host = user;
  if (!host->helped) {
    host->helped = 1;
    OK(hair_use_pool(NULL));
  }
  for (size_t i = 0; i < task_count; ++i) hair_do_task(tasks, i);
}

static void a_call_keeps_the_pool_that_it_began_with(void) {
  struct Helpful host = {0};
  const hair_pool pool = {sizeof pool, 3, run_and_help, &host};
  hair_instance* hair = small_hair();
  OK(hair_use_pool(&pool));
  OK(hair_step(hair, body_at(0), 1.0f / 60));
  CHECK(host.helped);
  hair_destroy(hair);
}

void threads(void);
void threads(void) {
  a_hair_a_thread_is_as_one_after_the_other();
  an_own_pool_gives_the_same_bits();
  a_call_keeps_the_pool_that_it_began_with();
}
