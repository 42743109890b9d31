#include "allocation_guard.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> largest{0};

}  // namespace

namespace hair {

std::size_t largestAllocation() {
  return largest;
}
void resetLargestAllocation() {
  largest = 0;
}

}  // namespace hair

// The sizes of arrays and of the nothrow forms arrive here too: the library's forward to this.
void* operator new(std::size_t size) {
  std::size_t seen = largest;
  while (seen < size && !largest.compare_exchange_weak(seen, size)) {
  }
  if (void* block = std::malloc(size == 0 ? 1 : size)) return block;
  throw std::bad_alloc();
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
