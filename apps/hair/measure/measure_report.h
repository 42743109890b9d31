#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <apps/hair/commands.h>
#include <apps/hair/measure/measured_hair.h>
#include <libhair/light/light.h>
#include <libhair/measure/shadow/choose.h>
#include <libhair/measure/shadow/flicker.h>
#include <libhair/measure/shadow/shadow_trial.h>
#include <libhair/measure/shadow/truth.h>
#include <libhair/measure/shadow/visibility_ray.h>

namespace hair {

/// A light of the command line.
struct MeasuredLight {
  bool atPoint = false;
  glm::vec3 given{0};  ///< --light: the way it travels; --point: where it is
  LightSpace space;

  std::string name() const;  ///< "light 0.5,-0.8,0.35", "point 0,1,0"
};

/// What was measured for one light and one footprint.
struct MeasuredCase {
  MeasuredLight light;
  float footprint = 0;  ///< metres
  Truth truth;          ///< at MeasureReport::points
  std::vector<ShadowTrial> trials;
  std::vector<std::size_t> front;  ///< trialFront
  std::vector<std::size_t> best;   ///< bestOfEachMethod
  VisibilityRay ray;               ///< empty unless there is an HTML report to draw it in
  std::vector<Flicker> flicker;    ///< [best.size()], or empty: not measured
  Flicker truthFlicker;
  std::optional<ShadowChoice> choice;  ///< --max-error, --budget-ms; its trial is `chosen`
};

/// All of a run.
struct MeasureReport {
  MeasureOptions options;
  MeasuredHair hair;
  std::vector<SamplePoint> points;
  std::vector<MeasuredCase> cases;
  std::string version, cpu;
  int threads = 1;
};

}  // namespace hair
