#include "allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> count{0}, largest{0};

void* countedOrNull(std::size_t size, std::size_t alignment) {
  ++count;
  std::size_t seen = largest;
  while (seen < size && !largest.compare_exchange_weak(seen, size)) {
  }
  const std::size_t room = (size + alignment - 1) / alignment * alignment;
  return std::aligned_alloc(alignment, room > 0 ? room : alignment);
}

void* counted(std::size_t size, std::size_t alignment) {
  if (void* block = countedOrNull(size, alignment)) return block;
  throw std::bad_alloc();
}

}  // namespace

namespace hair::test {

std::size_t allocationCount() {
  return count;
}
std::size_t largestAllocation() {
  return largest;
}
void resetLargestAllocation() {
  largest = 0;
}

}  // namespace hair::test

// The sizes of arrays arrive here too: the library's forward to these. So do those of the nothrow
// form, but not a sanitizer's, which must not meet our delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return countedOrNull(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  std::free(block);
}
