#pragma once

namespace hair {

/// Prints the simulation on a hair mesh as Yuksel et al. 2009, section 4 has it (150 vertices in 5
/// layers), measured here on one thread, beside the paper's figure.
void printHairMeshTable(int frames);

}  // namespace hair
