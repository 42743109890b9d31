// A frame works in memory that is there: the global allocation functions of this program count.

#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include <libhair/core/parallel.h>

#include "scene.h"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!p) throw std::bad_alloc();
  return p;
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}

namespace hair {
namespace {

TEST(Frame, AllocatesNothing) {
  // One thread: the scheduler of a threading library keeps books of its own.
  const ThreadLimit limit(1);
  FrameSettings settings;
  settings.lights.push_back(Light::point({1, 2, 1}));
  test::Scene scene(test::small(Style::Smooth), Motion::dance(), settings);
  for (int f = 0; f < 3; ++f) scene.step();
  const std::size_t before = allocations;
  for (int f = 0; f < 30; ++f) scene.step();
  EXPECT_EQ(allocations - before, 0u);
}

}  // namespace
}  // namespace hair
