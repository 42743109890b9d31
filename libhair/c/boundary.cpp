#include <libhair/c/boundary.h>

#include <cstdio>

namespace hair::c {

namespace {

// Fixed size, because an allocation could fail when memory is exhausted.
thread_local char lastError[1024] = "";

// Settings of hair_use_threads and hair_use_pool.
thread_local int threadLimit = 0;  // 0: those of the machine
thread_local hair_pool pool = {};  // run is null: none

}  // namespace

hair_status failed(hair_status status, const char* why) noexcept {
  std::snprintf(lastError, sizeof lastError, "%s", why);
  return status;
}

ThreadsInUse::ThreadsInUse() {
  if (pool.run)
    pool_.emplace(callers_.emplace(pool));
  else if (threadLimit > 0)
    limit_.emplace(threadLimit);
}

}  // namespace hair::c

using namespace hair::c;

uint32_t hair_version() {
  return HAIR_C_VERSION_MAJOR << 16 | HAIR_C_VERSION_MINOR;
}

const char* hair_library_version() {
  return HAIR_LIBRARY_VERSION;
}

const char* hair_last_error() {
  return lastError;
}

hair_status hair_use_threads(uint32_t count) {
  return guarded([&] {
    hair::require(count <= 1024, "hair_use_threads: ", count, " is not in 0 to 1024");
    threadLimit = static_cast<int>(count);
    pool = {};
  });
}

hair_status hair_use_pool(const hair_pool* own) {
  return guarded([&] {
    if (!own) return void(pool = {});
    const hair_pool taken = hair::c::taken(own, hair_pool{}, "hair_pool");
    hair::require(taken.run != nullptr, "hair_pool: run is null");
    hair::require(taken.thread_count >= 1 && taken.thread_count <= 1024, "hair_pool: thread_count ",
                  taken.thread_count, " is not in 1 to 1024");
    pool = taken;
  });
}

void hair_do_task(const hair_tasks* tasks, size_t index) {
  if (tasks) (*reinterpret_cast<const hair::ThreadPool::Tasks*>(tasks))(index);
}
