#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "arrays.h"

namespace hair::python {

/// Arrays over a vector that belongs to something larger, which may let go of the vector's memory
/// while arrays still look at it. What is let go then is kept for them: they go on showing what
/// they showed last.
template <class T>
class SharedVector {
 public:
  /// A read-only array over `values`, which `owner` holds.
  template <class Scalar>
  py::array view(std::shared_ptr<void> owner, const std::vector<T>& values, const Shape& shape) {
    if (!keeper_) keeper_ = std::make_shared<Keeper>(Keeper{std::move(owner), {}});
    return arrayOver(reinterpret_cast<const Scalar*>(values.data()), shape, capsuleOf(keeper_));
  }

  /// Before `values` gets other memory. It keeps its items where somebody needs both.
  void letGo(std::vector<T>& values) {
    if (keeper_ && keeper_.use_count() > 1) {
      std::vector<T> copy = values;
      keeper_->retired = std::exchange(values, std::move(copy));
      keeper_->owner.reset();
    }
    keeper_.reset();
  }
  /// Before `values` gets that size.
  void resizing(std::vector<T>& values, std::size_t size) {
    if (values.size() != size) letGo(values);
  }

 private:
  struct Keeper {
    std::shared_ptr<void> owner;  // of the vector
    std::vector<T> retired;       // or the memory itself
  };
  std::shared_ptr<Keeper> keeper_;  // of all arrays over the present memory
};

}  // namespace hair::python
