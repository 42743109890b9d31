#pragma once

#include <string>
#include <type_traits>

#include "arrays.h"
#include "choices.h"

namespace hair::python {

/// A class of settings: fields by keyword, defaults those of the C++ class, `==`, repr, copies
/// (also with some fields changed), pickling.
template <class T>
class Fields {
 public:
  Fields(py::module_& m, const char* name, const char* doc) : class_(m, name, doc), name_(name) {
    class_.def(py::init([name = name_](const py::kwargs& fields) {
                 auto value = std::make_unique<T>();
                 set(py::cast(value.get(), py::return_value_policy::reference), fields, name);
                 return value;
               }),
               "Fields by keyword; the others keep their defaults.");
    class_.def(
        "replace",
        [name = name_](const T& self, const py::kwargs& fields) {
          py::object copy = py::cast(T(self));
          set(copy, fields, name);
          return copy;
        },
        "A copy with these fields changed.");
    class_.def(
        "__reduce__",
        [](const py::object& self) {
          py::dict fields;
          for (const py::handle field : self.attr("_fields")) fields[field] = self.attr(field);
          const auto make = py::module_::import("functools").attr("partial");
          return py::make_tuple(make(py::type::of(self), **fields), py::tuple());
        },
        "For the modules copy and pickle; nothing is shared.");
    class_.def(
        "__eq__",
        [](const py::object& a, const py::object& b) {
          if (!b.get_type().is(a.get_type())) return false;
          for (const py::handle field : a.attr("_fields"))
            if (!a.attr(field).equal(b.attr(field))) return false;
          return true;
        },
        py::arg("other"), "All fields are equal.");
    class_.attr("__hash__") = py::none();
    class_.def("__repr__", [name = name_](const py::object& self) {
      std::string all;
      for (const py::handle field : self.attr("_fields"))
        all += (all.empty() ? "" : ", ") + std::string(py::str(field)) + "=" +
               valueText(self.attr(field));
      return name + "(" + all + ")";
    });
    class_.attr("_fields") = py::tuple();
  }

  /// `member`: of T, or of what T is derived from.
  template <class M, class C>
    requires std::is_base_of_v<C, T>
  Fields& field(const char* name, M C::* member, const char* doc) {
    class_.def_readwrite(name, member, doc);
    return add(name);
  }
  template <class Get, class Set>
  Fields& field(const char* name, Get get, Set set, const char* doc) {
    class_.def_property(name, get, set, doc);
    return add(name);
  }

  py::class_<T>& type() { return class_; }

 private:
  Fields& add(const char* name) {
    const py::tuple before = class_.attr("_fields");
    class_.attr("_fields") = before + py::make_tuple(name);
    return *this;
  }

  static void set(const py::object& value, const py::kwargs& fields, const std::string& name) {
    for (const auto& [field, given] : fields) {
      if (!value.attr("_fields").contains(field))
        throw py::type_error(
            name + ": no field '" + std::string(py::str(field)) + "'; there are " +
            std::string(py::str(py::str(", ").attr("join")(value.attr("_fields")))));
      py::setattr(value, field, given);
    }
  }

  // Seven digits: what a float has.
  static std::string valueText(const py::object& value) {
    if (py::isinstance<py::float_>(value)) return py::str("{:.7g}").format(value);
    if (py::isinstance<py::tuple>(value)) {
      std::string all;
      for (const py::handle item : value)
        all += (all.empty() ? "" : ", ") + valueText(py::reinterpret_borrow<py::object>(item));
      return "(" + all + ")";
    }
    return py::repr(value);
  }

  py::class_<T> class_;
  std::string name_;
};

}  // namespace hair::python
