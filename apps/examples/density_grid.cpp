// How much hair is where: a density grid read as a picture, for volume renderers, for statistics,
// or to see whether a groom has bald spots.
//
//   example_density_grid
//
// Look at: a level cut through the built-in long style at the height of the ears. Hair (. to @)
// lies around a head that is empty, and the face (below) is free. The sum over all cells is the
// length of all hair.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <libhair/density/density_grid.h>
#include <libhair/model/styles.h>
#include <libhair/wisps/wisps.h>

int main() {
  // Any strands do. These are the built-in style's at rest: guides, and what follows them.
  const hair::MeshSdf head(hair::builtinHead().mesh);
  const hair::Groom groom = hair::makeGroom(hair::styleSettings(hair::Style::Long), head);
  const hair::GuideStrands guides(groom, {});
  const hair::Wisps wisps(groom, guides);
  const hair::StrandView strands = wisps.strands();

  hair::DensityGridSettings settings;
  settings.deposit = hair::Deposit::Segments;
  settings.cellSize = 0.01f;
  hair::DensityGrid grid;
  hair::clear(grid, settings);  // axes of the world
  hair::deposit(strands, hair::metresOfHair(groom.fibre.hairsPerStrand), grid);

  std::puts("level cut 9 cm above the joint of the head, seen from above, a cell a centimetre:");
  for (int z = -13; z <= 12; ++z) {
    for (int x = -13; x <= 13; ++x) {
      const auto cell =
          grid.cellOf({0.01f * static_cast<float>(x), 0.09f, 0.01f * static_cast<float>(z)});
      const float metres = grid.density(cell);  // of hair in a cubic metre
      const int tone = metres > 0 ? static_cast<int>(2.5f * (std::log10(metres) - 4.0f)) : 0;
      std::printf("%c ", " .:+*#%@"[std::clamp(tone, 0, 7)]);
    }
    std::puts("");
  }

  double inCells = 0, inStrands = 0;
  for (int i = grid.lower.x; i <= grid.upper.x; ++i)
    for (int j = grid.lower.y; j <= grid.upper.y; ++j)
      for (int k = grid.lower.z; k <= grid.upper.z; ++k)
        inCells += static_cast<double>(grid.density({i, j, k})) * 1e-6;
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    inStrands +=
        static_cast<double>(hair::arcLength(strands.strand(s)) * groom.fibre.hairsPerStrand);
  std::printf("hair in all cells %.2f km, in all strands %.2f km, %.1f MB\n", 1e-3 * inCells,
              1e-3 * inStrands, 1e-6 * static_cast<double>(grid.bytes()));
  const bool same = std::abs(inCells / inStrands - 1) < 0.01;
  std::puts(same ? "nothing was lost" : "NOT the same");
  return same ? 0 : 1;
}
