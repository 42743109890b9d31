#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include <libhair/core/fields.h>

#include "arrays.h"
#include "choices.h"

namespace hair::python {

/// The comment of a struct (member "") or of its member in C++, written by member_docs.py.
inline const char* memberDoc(std::string_view type, std::string_view member) {
  struct Row {
    std::string_view type, member;
    const char* doc;
  };
  static constexpr Row kRows[] = {
#include "member_docs.inl"
  };
  for (const Row& row : kRows)
    if (row.type == type && row.member == member) return row.doc;
  throw std::logic_error(text(type, "::", member,
                              " has no comment, or is not in a header that "
                              "python/CMakeLists.txt gives to member_docs.py"));
}

/// A class of settings with a table of fields (core/fields.h): fields by keyword, defaults those of
/// the C++ class, `==`, repr, copies (also with some fields changed), pickling.
template <class T>
class Fields {
 public:
  Fields(py::module_& m, const char* name) : class_(m, name, memberDoc(name, "")), name_(name) {
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
    forFields<T>([&](const auto& field) { add(field.name, field.member); });
  }

  /// Reads and writes a field in a way of its own.
  template <class Get, class Set>
  Fields& property(const char* name, Get get, Set set) {
    class_.def_property(name, get, set, memberDoc(name_, name));
    return *this;
  }

  py::class_<T>& type() { return class_; }

 private:
  template <class M, class C>
  void add(std::string_view own, M C::* member) {
    const std::string name = snakeCase(own);
    std::string doc = docOf<C>(own);
    if constexpr (HasWords<M>) doc += " One of: " + allWords<M>() + ".";
    class_.def_readwrite(name.c_str(), member, doc.c_str());
    const py::tuple before = class_.attr("_fields");
    class_.attr("_fields") = before + py::make_tuple(name);
  }

  // A field of what T is derived from has its comment there.
  template <class C>
  const char* docOf(std::string_view member) const {
    if constexpr (std::is_same_v<C, T>)
      return memberDoc(name_, member);
    else
      return memberDoc(py::cast<std::string>(py::type::of<C>().attr("__name__")), member);
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
