#include "arrays.h"

namespace hair::python {

namespace {

// "(N, 3)", where -1 is any length.
std::string shapeText(const Shape& shape) {
  constexpr const char* kLetters[] = {"N", "M", "K", "L"};
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (i > 0) text += ", ";
    text += shape[i] == kAny ? std::string(kLetters[i % 4]) : std::to_string(shape[i]);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

bool fits(const py::array& array, const Shape& shape) {
  if (array.ndim() != static_cast<py::ssize_t>(shape.size())) return false;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (shape[i] != kAny && array.shape(static_cast<py::ssize_t>(i)) != shape[i]) return false;
  return true;
}

}  // namespace

py::array requireArray(py::handle object, std::string_view name, const py::dtype& dtype,
                       const Shape& shape, bool writeable) {
  const std::string what(name);
  const std::string type = py::str(dtype.attr("name"));
  if (!py::isinstance<py::array>(object))
    throw py::type_error(
        what + ": a " + std::string(py::str(py::type::of(object).attr("__name__"))) +
        ", but a NumPy array is wanted: numpy.asarray(" + what + ", numpy." + type + ")");
  auto array = py::reinterpret_borrow<py::array>(object);
  if (!array.dtype().equal(dtype))
    throw py::type_error(what + ": " + std::string(py::str(array.dtype())) + ", but " + type +
                         " is wanted: " + what + ".astype(numpy." + type + ")");
  if (!fits(array, shape)) {
    const Shape has(array.shape(), array.shape() + array.ndim());
    throw py::value_error(what + ": shape " + shapeText(has) + ", but " + shapeText(shape) +
                          " is wanted");
  }
  constexpr int kAligned = py::detail::npy_api::NPY_ARRAY_ALIGNED_;
  if ((array.flags() & py::array::c_style) == 0)
    throw py::value_error(what + ": not C-contiguous: numpy.ascontiguousarray(" + what + ")");
  if ((array.flags() & kAligned) == 0)
    throw py::value_error(what + ": not aligned: numpy.require(" + what + ", requirements=\"CA\")");
  if (writeable && !array.writeable()) throw py::value_error(what + ": read-only");
  return array;
}

std::span<const glm::vec3> pointsOf(const py::array& array) {
  return spanOf<const glm::vec3, float>(array);
}

py::array requirePoints(py::handle object, std::string_view name) {
  return requireArray(object, name, py::dtype::of<float>(), {kAny, 3});
}

}  // namespace hair::python
