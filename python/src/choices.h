#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <pybind11/pybind11.h>

#include <libhair/files/strand_file.h>
#include <libhair/guides/settings.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/candidates.h>
#include <libhair/model/styles.h>
#include <libhair/repulsion/repulsion.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/methods/shadow_method.h>

// Enumerations are words in Python: filter="footprint". One table a type says which.
namespace hair::python {

namespace py = pybind11;

template <class E>
struct Choices {};

#define HAIR_CHOICES(Type, Name, ...)                                            \
  template <>                                                                    \
  struct Choices<Type> {                                                         \
    static constexpr auto kName = pybind11::detail::const_name(Name);            \
    static constexpr std::array kAll = std::to_array<Choice<Type>>(__VA_ARGS__); \
  }

template <class E>
struct Choice {
  std::string_view word;
  E value;
};

HAIR_CHOICES(UpAxis, "UpAxis",
             {{"file", UpAxis::AsFile},
              {"y", UpAxis::Y},
              {"z", UpAxis::Z},
              {"z-back", UpAxis::ZBack},
              {"x", UpAxis::X},
              {"y-down", UpAxis::YDown}});
HAIR_CHOICES(Style, "Style",
             {{"smooth", Style::Smooth}, {"curly", Style::Curly}, {"long", Style::Long}});
HAIR_CHOICES(LinkSolver, "LinkSolver",
             {{"direct", LinkSolver::Direct}, {"relaxation", LinkSolver::Relaxation}});
HAIR_CHOICES(RepulsionKind, "RepulsionKind",
             {{"cell centre", RepulsionKind::CellCentre}, {"gradient", RepulsionKind::Gradient}});
HAIR_CHOICES(Deposit, "Deposit",
             {{"points", Deposit::Points},
              {"columns", Deposit::Columns},
              {"segments", Deposit::Segments}});
HAIR_CHOICES(Filter, "Filter",
             {{"none", Filter::None},
              {"paper", Filter::Paper},
              {"centred", Filter::Centred},
              {"footprint", Filter::Footprint}});
HAIR_CHOICES(Light::Kind, "LightKind",
             {{"parallel", Light::Kind::Parallel}, {"point", Light::Kind::Point}});
HAIR_CHOICES(Extinction, "Extinction",
             {{"unbiased", Extinction::Unbiased}, {"published", Extinction::Published}});
HAIR_CHOICES(LateralFilter, "LateralFilter",
             {{"nearest", LateralFilter::Nearest}, {"linear", LateralFilter::Linear}});
HAIR_CHOICES(DeepOpacityMapSettings::Growth, "Growth",
             {{"constant", DeepOpacityMapSettings::Growth::Constant},
              {"linear", DeepOpacityMapSettings::Growth::Linear},
              {"doubling", DeepOpacityMapSettings::Growth::Doubling},
              {"fibonacci", DeepOpacityMapSettings::Growth::Fibonacci}});
HAIR_CHOICES(DeepOpacityMapSettings::Beyond, "Beyond",
             {{"ignored", DeepOpacityMapSettings::Beyond::Ignored},
              {"in last layer", DeepOpacityMapSettings::Beyond::InLastLayer},
              {"larger layers", DeepOpacityMapSettings::Beyond::LargerLayers}});
HAIR_CHOICES(DensityClusteringSettings::Start, "ClusterStart",
             {{"uniform", DensityClusteringSettings::Start::Uniform},
              {"towards light", DensityClusteringSettings::Start::TowardsLight}});
HAIR_CHOICES(CandidateSet, "CandidateSet",
             {{"quick", CandidateSet::Quick}, {"all", CandidateSet::All}});

#undef HAIR_CHOICES

template <class E>
concept HasChoices = requires { Choices<E>::kAll; };

template <HasChoices E>
std::string_view wordOf(E value) {
  for (const auto& choice : Choices<E>::kAll)
    if (choice.value == value) return choice.word;
  return "?";
}

/// Throws ValueError with all words.
template <HasChoices E>
E choiceOf(std::string_view word) {
  std::string words;
  for (const auto& choice : Choices<E>::kAll) {
    if (choice.word == word) return choice.value;
    words += (words.empty() ? "'" : ", '") + std::string(choice.word) + "'";
  }
  throw py::value_error("'" + std::string(word) + "' is none of " + words);
}

/// All words of a type, as the stubs list them.
template <HasChoices E>
void addChoices(py::dict& all) {
  py::list words;
  for (const auto& choice : Choices<E>::kAll) words.append(py::str(std::string(choice.word)));
  all[py::str(Choices<E>::kName.text)] = py::tuple(words);
}

}  // namespace hair::python

namespace pybind11::detail {

template <hair::python::HasChoices E>
struct type_caster<E> {
  PYBIND11_TYPE_CASTER(E, hair::python::Choices<E>::kName);

  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    value = hair::python::choiceOf<E>(source.cast<std::string>());
    return true;
  }
  static handle cast(E value, return_value_policy, handle) {
    return str(std::string(hair::python::wordOf(value))).release();
  }
};

}  // namespace pybind11::detail
