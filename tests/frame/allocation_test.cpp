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
  settings.bodyShadow = true;
  settings.wind.velocity = {1, 0, 0.5f};
  test::Scene scene(test::small(Style::Smooth), Motion::dance(), settings);
  const auto play = [&] {
    scene.time = 0;
    for (const float seconds : {1.0f / 60, 1.0f / 24, 1.0f / 144})
      for (int f = 0; f < 10; ++f) scene.step(seconds);
  };
  // Memory is kept for the most that there was: of substeps in a frame, and of cells with hair.
  play();
  restart(scene.bodyAt(0), settings, 0, scene.hair);
  const std::size_t before = allocations;
  play();
  EXPECT_EQ(allocations - before, 0u);
}

}  // namespace
}  // namespace hair
