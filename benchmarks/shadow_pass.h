#pragma once

#include <vector>

#include <benchmarks/floor.h>
#include <benchmarks/scenes.h>
#include <libhair/shadow/density_map.h>
#include <libhair/shadow/literal.h>

namespace hair::bench {

/// Points as the paper deposits them, each worth what darkens as the scene's segments would: the
/// work of the literal transcription.
DensityMapSettings paperSettings(const Scene& scene, Filter filter);

/// A whole shadow of strands that stand still: clear, deposit, transmittance, filter.
class ShadowPass {
 public:
  ShadowPass(StrandView strands, const Fibre& fibre, const LightSpace& light,
             const DensityMapSettings& settings);
  /// Of the scene's strands, its light and its map but for the settings.
  ShadowPass(const Scene& scene, const DensityMapSettings& settings);

  void run();
  /// The bytes that it cannot do without; after a run.
  double leastBytes() const;

  DensityMapSettings settings;
  DensityMap map;
  std::vector<float> transmittance;  ///< [pointCount]

 private:
  StrandView strands_;
  Fibre fibre_;
  LightSpace light_;
};

/// The paper's section 3 as it is written down in shadow/literal.h: one thread, and as slow as
/// that. Cells and extinction of `settings`, which count points (paperSettings).
class LiteralPass {
 public:
  LiteralPass(const Scene& scene, const DensityMapSettings& settings);
  void run();

  literal::LiteralMap map;
  std::vector<float> transmittance;  ///< [pointCount]

 private:
  StrandView strands_;
  LightSpace light_;
};

}  // namespace hair::bench
