#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <libhair/core/profile.h>

namespace hair {

/// The last so many of something, oldest first.
template <class T>
class Recent {
 public:
  explicit Recent(std::size_t capacity) : capacity_(capacity) { items_.reserve(capacity); }

  void add(const T& item) {
    if (items_.size() < capacity_) {
      items_.push_back(item);
    } else {
      items_[oldest_] = item;
      oldest_ = (oldest_ + 1) % capacity_;
    }
  }
  void clear() { items_.clear(), oldest_ = 0; }
  std::size_t size() const { return items_.size(); }
  std::size_t capacity() const { return capacity_; }
  const T& operator[](std::size_t i) const { return items_[(oldest_ + i) % items_.size()]; }
  const T& last() const { return (*this)[items_.size() - 1]; }

 private:
  std::size_t capacity_, oldest_ = 0;
  std::vector<T> items_;
};

/// The drawing comes after all other stages.
inline constexpr auto kDrawStage = static_cast<std::size_t>(Stage::Draw);

/// What the last frames that were drawn and the last pictures cost.
struct History {
  Recent<FrameProfile> frames{200};
  Recent<float> pictures{200};  ///< milliseconds of drawing
};

inline float milliseconds(const StageTime& time) {
  return static_cast<float>(time.nanoseconds) * 1e-6f;
}

/// All stages of a frame but its drawing together, milliseconds.
inline float withoutDrawing(const FrameProfile& frame) {
  float sum = 0;
  for (std::size_t s = 0; s < kDrawStage; ++s) sum += milliseconds(frame[s]);
  return sum;
}

/// The median of what `measure` says of each item; 0 of none.
template <class T, class Measure>
float medianOf(const Recent<T>& items, Measure measure) {
  if (items.size() == 0) return 0;
  std::vector<float> values;
  values.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) values.push_back(measure(items[i]));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace hair
