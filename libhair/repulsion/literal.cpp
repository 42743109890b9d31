#include <libhair/repulsion/literal.h>

#include <algorithm>

namespace hair::literal {

glm::vec3 push(const DensityGrid& grid, const RepulsionSettings& settings, float allowed,
               glm::vec3 p) {
  glm::vec3 direction(0);
  float density = 0;
  if (settings.kind == RepulsionKind::CellCentre) {
    const glm::ivec3 cell = grid.cellOf(p);
    const glm::vec3 out = p - grid.cellCentre(cell);
    const float length = glm::length(out);
    if (length > 0) direction = out / length;
    density = grid.density(cell);
  } else {
    const DensitySample sample = sampleDensity(grid, p);
    const float across = settings.cellSize * glm::length(sample.gradient);
    const float steepness = across / (across + 0.1f * sample.density + 1e-20f);
    if (across > 0) direction = sample.gradient * (-settings.cellSize / across * steepness);
    density = sample.density;
  }
  const float excess = std::max(0.0f, density / allowed - 1);
  return std::min(settings.strength * excess, settings.limit) * direction;
}

}  // namespace hair::literal
