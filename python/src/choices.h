#pragma once

#include <string>
#include <string_view>

#include <pybind11/pybind11.h>

#include <libhair/core/fields.h>
#include <libhair/files/strand_file.h>
#include <libhair/guides/settings.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/shadow_trial.h>
#include <libhair/model/styles.h>
#include <libhair/repulsion/repulsion.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/methods/shadow_method.h>

// Enumerations are words in Python, those of their tables (core/fields.h): filter="footprint".
namespace hair::python {

namespace py = pybind11;

/// The name of an enumeration in signatures and stubs.
template <class E>
struct ChoiceName {};

#define HAIR_CHOICE(Type, Name)                                       \
  template <>                                                         \
  struct ChoiceName<Type> {                                           \
    static constexpr auto kName = pybind11::detail::const_name(Name); \
  }

HAIR_CHOICE(UpAxis, "UpAxis");
HAIR_CHOICE(Style, "Style");
HAIR_CHOICE(LinkSolver, "LinkSolver");
HAIR_CHOICE(RepulsionKind, "RepulsionKind");
HAIR_CHOICE(Deposit, "Deposit");
HAIR_CHOICE(Filter, "Filter");
HAIR_CHOICE(Light::Kind, "LightKind");
HAIR_CHOICE(Extinction, "Extinction");
HAIR_CHOICE(LateralFilter, "LateralFilter");
HAIR_CHOICE(DeepOpacityMapSettings::Growth, "Growth");
HAIR_CHOICE(DeepOpacityMapSettings::Beyond, "Beyond");
HAIR_CHOICE(DensityClusteringSettings::Start, "ClusterStart");
HAIR_CHOICE(CandidateSet, "CandidateSet");

#undef HAIR_CHOICE

template <class E>
concept HasChoices = HasWords<E> && requires { ChoiceName<E>::kName; };

/// Throws ValueError with all words.
template <HasChoices E>
E choiceOf(std::string_view word) {
  for (const auto& choice : wordsOf(E{}))
    if (choice.word == word) return choice.value;
  throw py::value_error("'" + std::string(word) + "' is none of: " + allWords<E>());
}

/// All words of a type, as the stubs list them.
template <HasChoices E>
void addChoices(py::dict& all) {
  py::list words;
  for (const auto& choice : wordsOf(E{})) words.append(py::str(std::string(choice.word)));
  all[py::str(ChoiceName<E>::kName.text)] = py::tuple(words);
}

}  // namespace hair::python

namespace pybind11::detail {

template <hair::python::HasChoices E>
struct type_caster<E> {
  PYBIND11_TYPE_CASTER(E, hair::python::ChoiceName<E>::kName);

  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    value = hair::python::choiceOf<E>(source.cast<std::string>());
    return true;
  }
  static handle cast(E value, return_value_policy, handle) {
    return str(std::string(hair::wordOf(value))).release();
  }
};

}  // namespace pybind11::detail
