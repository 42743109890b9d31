#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <libhair/core/parallel.h>

#include "threads.h"

// NumPy arrays in and out of the library without copies.
namespace hair::python {

namespace py = pybind11;

/// Of an axis: any length.
inline constexpr py::ssize_t kAny = -1;
using Shape = std::vector<py::ssize_t>;

/// The object itself, if it is an array of that type and shape, C-contiguous and aligned. Throws
/// TypeError or ValueError that says what it is, what is wanted, and how to get there.
py::array requireArray(py::handle object, std::string_view name, const py::dtype& dtype,
                       const Shape& shape, bool writeable = false);

/// The same of T's scalars, as a span over the array's own memory.
template <class T, class Scalar>
std::span<T> spanOf(const py::array& array) {
  static_assert(sizeof(T) % sizeof(Scalar) == 0);
  // The span is writeable only where requireArray was asked for that.
  auto* data = const_cast<void*>(array.data());
  return {static_cast<T*>(data),
          static_cast<std::size_t>(array.size()) * sizeof(Scalar) / sizeof(T)};
}

/// [N, 3] float32 in place.
std::span<const glm::vec3> pointsOf(const py::array& array);
/// Throws as requireArray.
py::array requirePoints(py::handle object, std::string_view name);

/// An array over memory that `owner` keeps, read-only unless said otherwise.
template <class Scalar>
py::array arrayOver(const Scalar* data, const Shape& shape, py::object owner,
                    bool writeable = false) {
  py::array_t<Scalar> array(shape, data, std::move(owner));
  if (!writeable) array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Keeps anything until the last array over it is gone.
template <class Owner>
py::capsule capsuleOf(Owner owner) {
  auto* kept = new Owner(std::move(owner));
  return py::capsule(kept, [](void* p) { delete static_cast<Owner*>(p); });
}

/// An array that takes a vector over, writeable.
template <class Scalar, class T>
py::array arrayOf(std::vector<T> values, const Shape& shape) {
  static_assert(sizeof(T) % sizeof(Scalar) == 0);
  auto kept = std::make_shared<std::vector<T>>(std::move(values));
  const auto* data = reinterpret_cast<const Scalar*>(kept->data());
  return arrayOver(data, shape, capsuleOf(std::move(kept)), true);
}
inline py::array arrayOfPoints(std::vector<glm::vec3> points) {
  const auto count = static_cast<py::ssize_t>(points.size());
  return arrayOf<float>(std::move(points), {count, 3});
}

/// `out` if given (checked), else a new array of that shape.
template <class Scalar>
py::array outputOf(const py::object& out, const Shape& shape, std::string_view name = "out") {
  if (out.is_none()) return py::array_t<Scalar>(shape);
  return requireArray(out, name, py::dtype::of<Scalar>(), shape, true);
}

/// Rows of floats from anything that NumPy makes an array of ([[..7 numbers], ...]); None: no rows.
template <class Row>
std::vector<Row> rowsOf(const py::object& object, std::string_view name) {
  static_assert(sizeof(Row) % sizeof(float) == 0);
  constexpr auto columns = static_cast<py::ssize_t>(sizeof(Row) / sizeof(float));
  if (object.is_none()) return {};
  py::array array = py::array_t < float,
            py::array::c_style | py::array::forcecast > ::ensure(object);
  if (!array) throw py::error_already_set();
  if (array.size() == 0) return {};
  if (array.ndim() == 1) array = array.reshape({py::ssize_t{1}, array.size()});
  array = requireArray(array, name, py::dtype::of<float>(), {kAny, columns});
  const auto rows = spanOf<const Row, float>(array);
  return {rows.begin(), rows.end()};
}

/// Runs without Python's lock, so that other Python threads go on meanwhile, on as many threads as
/// thread_limit says. All that may use several goes through this.
template <class Work>
auto withoutLock(Work&& work) {
  std::optional<ThreadLimit> limit;
  if (const auto threads = threadsAllowed()) limit.emplace(*threads);
  const py::gil_scoped_release release;
  return work();
}

/// Ctrl-C since the last look becomes KeyboardInterrupt. Call with the lock.
inline void passInterrupts() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Throws where another thread's call is at work on an object. A look that keeps Python's lock
/// needs no more.
inline void requireIdle(bool busy, const char* what) {
  if (busy) throw std::runtime_error(std::string(what) + ": in use by another thread");
}

/// One call at a time may work on an object: the lock of Python, which is released meanwhile, does
/// not keep a second thread out.
class Busy {
 public:
  explicit Busy(bool& flag, const char* what) : flag_(flag) {
    requireIdle(flag_, what);
    flag_ = true;
  }
  ~Busy() { flag_ = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  bool& flag_;  // read and written with Python's lock
};

}  // namespace hair::python

namespace pybind11::detail {

/// Numbers of a short sequence (tuple, list, array, what other programs have for vectors).
template <std::size_t Count>
bool loadNumbers(handle source, float (&numbers)[Count]) {
  if (!source || isinstance<str>(source) || !PySequence_Check(source.ptr())) return false;
  if (PySequence_Size(source.ptr()) != static_cast<ssize_t>(Count)) {
    PyErr_Clear();
    return false;
  }
  for (std::size_t i = 0; i < Count; ++i) {
    const auto item =
        reinterpret_steal<object>(PySequence_GetItem(source.ptr(), static_cast<ssize_t>(i)));
    const double number = item ? PyFloat_AsDouble(item.ptr()) : -1;
    if (PyErr_Occurred()) {
      PyErr_Clear();
      return false;
    }
    numbers[i] = static_cast<float>(number);
  }
  return true;
}

template <>
struct type_caster<glm::vec3> {
  PYBIND11_TYPE_CASTER(glm::vec3, const_name("Vec3"));
  bool load(handle source, bool) {
    float n[3];
    if (!loadNumbers(source, n)) return false;
    value = {n[0], n[1], n[2]};
    return true;
  }
  static handle cast(glm::vec3 v, return_value_policy, handle) {
    return make_tuple(v.x, v.y, v.z).release();
  }
};

template <>
struct type_caster<glm::ivec3> {
  PYBIND11_TYPE_CASTER(glm::ivec3, const_name("IVec3"));
  bool load(handle source, bool) {
    float n[3];
    if (!loadNumbers(source, n)) return false;
    value = glm::ivec3(n[0], n[1], n[2]);
    return true;
  }
  static handle cast(glm::ivec3 v, return_value_policy, handle) {
    return make_tuple(v.x, v.y, v.z).release();
  }
};

/// w first.
template <>
struct type_caster<glm::quat> {
  PYBIND11_TYPE_CASTER(glm::quat, const_name("Quaternion"));
  bool load(handle source, bool) {
    float n[4];
    if (!loadNumbers(source, n)) return false;
    value = glm::quat(n[0], n[1], n[2], n[3]);
    return true;
  }
  static handle cast(glm::quat q, return_value_policy, handle) {
    return make_tuple(q.w, q.x, q.y, q.z).release();
  }
};

}  // namespace pybind11::detail
