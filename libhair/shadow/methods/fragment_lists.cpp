#include <libhair/shadow/methods/fragment_lists.h>

#include <algorithm>
#include <atomic>

#include <libhair/core/error.h>
#include <libhair/core/parallel.h>

namespace hair {

namespace {

constexpr std::size_t kStrands = 64;  // a task, at least
constexpr std::size_t kPixels = 512;

template <class Visit>
void forAllFragments(StrandView strands, const Fibre& fibre, Extinction extinction,
                     const LightImage& image, Visit&& visit) {
  parallelFor(strands.strandCount(), kStrands, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
      forFragments(strands.strand(s), fibre, extinction, image, [&](const Fragment& fragment) {
        if (fragment.opticalDepth > 0) visit(fragment);
      });
  });
}

std::uint32_t increment(std::uint32_t& count) {
  return std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
}

bool comesBefore(const PixelFragment& a, const PixelFragment& b) {
  return a.depth < b.depth || (a.depth == b.depth && a.opticalDepth < b.opticalDepth);
}

}  // namespace

std::size_t FragmentLists::bytes() const {
  return fragments.capacity() * sizeof(PixelFragment) +
         (first.capacity() + next.capacity()) * sizeof(std::uint32_t);
}

void buildFragmentLists(StrandView strands, const Fibre& fibre, Extinction extinction,
                        const LightImage& image, FragmentLists& lists) {
  const std::size_t pixels = image.pixelCount();
  lists.first.resize(pixels + 1);
  lists.next.assign(pixels, 0);

  // Count.
  forAllFragments(strands, fibre, extinction, image,
                  [&](const Fragment& fragment) { increment(lists.next[fragment.pixel]); });

  // Prefix sum: offsets of pixels.
  std::uint64_t sum = 0;
  for (std::size_t p = 0; p < pixels; ++p) {
    lists.first[p] = static_cast<std::uint32_t>(sum);
    sum += lists.next[p];
    lists.next[p] = lists.first[p];
  }
  require(sum <= UINT32_MAX, "fragment lists: ", sum, " fragments of ", image.pixelSize,
          " m are more than 2^32; take larger pixels");
  lists.first[pixels] = static_cast<std::uint32_t>(sum);
  lists.fragments.resize(sum);

  // Visit the same fragments again and store them. Adding 0 turns -0 into 0: the sort treats the
  // two as equal, so their order would depend on the threads.
  forAllFragments(strands, fibre, extinction, image, [&](const Fragment& fragment) {
    lists.fragments[increment(lists.next[fragment.pixel])] = {fragment.depth + 0.0f,
                                                              fragment.opticalDepth};
  });
  parallelFor(pixels, kPixels, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      std::sort(lists.fragments.begin() + lists.first[p],
                lists.fragments.begin() + lists.first[p + 1], comesBefore);
  });
}

}  // namespace hair
