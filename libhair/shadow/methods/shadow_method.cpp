#include <libhair/shadow/methods/shadow_method.h>

#include <libhair/core/error.h>
#include <libhair/shadow/methods/deep_opacity_map.h>
#include <libhair/shadow/methods/deep_shadow_map.h>
#include <libhair/shadow/methods/density_clustering.h>
#include <libhair/shadow/methods/density_map_method.h>
#include <libhair/shadow/methods/opacity_map.h>
#include <libhair/shadow/methods/shadow_map.h>

namespace hair {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

/// "3 mm"; common() adds what differs from the defaults of all methods.
std::string millimetres(float metres) {
  return text(metres * 1e3f, " mm");
}
std::string common(Extinction extinction, LateralFilter filter) {
  return text(extinction == Extinction::Published ? " published extinction" : "",
              filter == LateralFilter::Nearest ? " nearest" : "");
}

std::string count(int n, const char* what) {
  return text(' ', n, ' ', what, n == 1 ? "" : "s");
}

const char* name(Deposit deposit) {
  switch (deposit) {
    case Deposit::Points:
      return " points";
    case Deposit::Columns:
      return "";
    case Deposit::Segments:
      return " segments";
  }
  return "";
}

const char* name(Filter filter) {
  switch (filter) {
    case Filter::None:
      return " unfiltered";
    case Filter::Paper:
      return " paper filter";
    case Filter::Centred:
      return "";
    case Filter::Footprint:
      return " footprint";
  }
  return "";
}

const char* name(DeepOpacityMapSettings::Growth growth) {
  using enum DeepOpacityMapSettings::Growth;
  switch (growth) {
    case Constant:
      return " constant";
    case Linear:
      return " linear";
    case Doubling:
      return " doubling";
    case Fibonacci:
      return " fibonacci";
  }
  return "";
}

/// Total depth of the layers, and treatment of hair beyond.
std::string reach(const DeepOpacityMapSettings& s) {
  using enum DeepOpacityMapSettings::Beyond;
  switch (s.beyond) {
    case Ignored:
      return text(" over ", millimetres(s.depth), " beyond ignored");
    case InLastLayer:
      return text(" over ", millimetres(s.depth));
    case LargerLayers:
      return " over all";
  }
  return "";
}

}  // namespace

std::unique_ptr<ShadowMethod> makeShadowMethod(const ShadowSettings& settings) {
  return std::visit(
      Overloaded{[](const DensityMapSettings& s) { return makeDensityMapMethod(s); },
                 [](const ShadowMapSettings& s) { return makeShadowMap(s); },
                 [](const OpacityMapSettings& s) { return makeOpacityMap(s); },
                 [](const DeepOpacityMapSettings& s) { return makeDeepOpacityMap(s); },
                 [](const DensityClusteringSettings& s) { return makeDensityClustering(s); },
                 [](const DeepShadowMapSettings& s) { return makeDeepShadowMap(s); }},
      settings);
}

std::string methodName(const ShadowSettings& settings) {
  return std::visit(
      Overloaded{[](const DensityMapSettings&) { return "density map"; },
                 [](const ShadowMapSettings&) { return "shadow map"; },
                 [](const OpacityMapSettings&) { return "opacity map"; },
                 [](const DeepOpacityMapSettings&) { return "deep opacity map"; },
                 [](const DensityClusteringSettings&) { return "density clustering"; },
                 [](const DeepShadowMapSettings&) { return "deep shadow map"; }},
      settings);
}

std::string settingsText(const ShadowSettings& settings) {
  return std::visit(
      Overloaded{[](const DensityMapSettings& s) {
                   return text(millimetres(s.cellSize), count(s.cells, "cell"), name(s.deposit),
                               name(s.filter));
                 },
                 [](const ShadowMapSettings& s) {
                   return text(millimetres(s.pixelSize), " radius ", millimetres(s.filterRadius),
                               " bias ", millimetres(s.bias));
                 },
                 [](const OpacityMapSettings& s) {
                   return text(millimetres(s.pixelSize), count(s.slices, "slice"),
                               common(s.extinction, s.filter));
                 },
                 [](const DeepOpacityMapSettings& s) {
                   return text(millimetres(s.pixelSize), count(s.layers, "layer"), name(s.growth),
                               reach(s), s.depthBits == 32 ? "" : text(' ', s.depthBits, " bits"),
                               common(s.extinction, s.filter));
                 },
                 [](const DensityClusteringSettings& s) {
                   return text(millimetres(s.pixelSize), count(s.clusters, "cluster"),
                               count(s.iterations, "iteration"),
                               s.start == DensityClusteringSettings::Start::TowardsLight
                                   ? " towards the light"
                                   : "",
                               common(s.extinction, s.filter));
                 },
                 [](const DeepShadowMapSettings& s) {
                   return text(millimetres(s.pixelSize), " tolerance ", s.tolerance,
                               common(s.extinction, s.filter));
                 }},
      settings);
}

}  // namespace hair
