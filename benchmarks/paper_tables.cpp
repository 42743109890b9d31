// Tables 1 and 2 of Bertails et al. 2005, measured here: seconds a frame, by stage, of the smooth
// and the curly style while they dance; beside them, in the same run and on the same strands, the
// literal transcription of the paper's section 3 on one thread. Then the simulation of Yuksel et
// al. 2009, section 4.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <vector>

#include <apps/common/player.h>
#ifdef HAIR_WITH_HAIR_MESH
#include <benchmarks/hair_mesh_table.h>
#endif
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/shadow/literal.h>

namespace hair {
namespace {

constexpr std::string_view kHelp = R"(paper_tables [FRAMES]

Tables 1 and 2 of Bertails et al. 2005, measured here: seconds a frame, by stage, of the smooth and the
curly style while they dance, medians of FRAMES frames (120; at least 8); beside them the literal
transcription of the paper on one thread, and what the paper printed.

  -h, --help     this
)";

struct Row {
  double density = 0, transmittance = 0, filter = 0;  // table 1, seconds a frame
  double animation = 0, selfCollision = 0;            // table 2
  double rendering() const { return density + transmittance + filter; }
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Measured {
  std::size_t segments = 0;
  Row fast, literal;
};

Measured measure(Style style, int frames) {
  CharacterOptions who;
  who.style = style;
  const Character character(who);
  Player player(character, {});
  std::vector<double> density, transmittance, filter;
  literal::LiteralMap map;
  map.cells = player.settings.map.cells;
  map.cellSize = player.settings.map.cellSize;
  std::vector<float> shadows(character.groom.pointCount());
  for (int f = 0; f < frames; ++f) {
    player.step();
    if (f % 8 != 0) continue;
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point a, Clock::time_point b) {
      return std::chrono::duration<double>(b - a).count();
    };
    const StrandView strands = player.hair.strands();
    const auto start = Clock::now();
    literal::fillDensity(strands.points, makeLightSpace(player.settings.lights.front().direction),
                         map);
    const auto filled = Clock::now();
    literal::computeTransmittance(map);
    const auto walked = Clock::now();
    literal::filterTransmittance(map, strands.points, shadows);
    const auto done = Clock::now();
    density.push_back(seconds(start, filled));
    transmittance.push_back(seconds(filled, walked));
    filter.push_back(seconds(walked, done));
  }
  const auto stage = [&](Stage from, Stage to) {
    return player.log.milliseconds(from, to, 0.5) / 1000;
  };
  Measured result;
  for (std::size_t s = 0; s < character.groom.strandCount(); ++s)
    result.segments += character.groom.first[s + 1] - character.groom.first[s] - 1;
  result.fast = {stage(Stage::Deposit, Stage::Deposit),
                 stage(Stage::Transmittance, Stage::Transmittance),
                 stage(Stage::Filter, Stage::Shade), stage(Stage::Motion, Stage::Wisps),
                 stage(Stage::SelfCollision, Stage::SelfCollision)};
  result.literal = {median(density), median(transmittance), median(filter), 0, 0};
  return result;
}

void print(const char* name, const std::vector<double>& cells) {
  std::cout << std::left << std::setw(28) << name << std::right << std::fixed
            << std::setprecision(5);
  for (double cell : cells) std::cout << std::setw(16) << cell;
  std::cout << '\n';
}

void header(std::initializer_list<const char*> columns) {
  std::cout << std::left << std::setw(28) << "seconds a frame" << std::right;
  for (const char* column : columns) std::cout << std::setw(16) << column;
  std::cout << '\n';
}

int program(int frames) {
  const Measured smooth = measure(Style::Smooth, frames), curly = measure(Style::Curly, frames);
  std::cout << "smooth: " << smooth.segments << " segments; curly: " << curly.segments << "; "
            << frames << " frames, medians, " << threadCount()
            << " threads; the literal passes on one\n\n"
            << "Table 1: rendering (here shading in place of drawing)\n";
  header({"reset+density", "transmittance", "filter+shade", "total"});
  const auto table1 = [](const char* name, const Row& r) {
    print(name, {r.density, r.transmittance, r.filter, r.rendering()});
  };
  table1("smooth", smooth.fast);
  table1("curly", curly.fast);
  table1("smooth, literal, no shading", smooth.literal);
  table1("curly, literal, no shading", curly.literal);
  print("smooth, paper, with drawing", {0.038, 0.015, 0.037, 0.09});
  print("curly, paper, with drawing", {0.062, 0.015, 0.053, 0.13});
  std::cout << "\nTable 2: simulation (animation with hair-body collisions)\n";
  header({"animation", "self-collision", "rendering", "total"});
  const auto table2 = [](const char* name, const Row& r, double rendering) {
    print(name,
          {r.animation, r.selfCollision, rendering, r.animation + r.selfCollision + rendering});
  };
  table2("smooth", smooth.fast, smooth.fast.rendering());
  table2("curly", curly.fast, curly.fast.rendering());
  table2("smooth, literal shadows", smooth.fast, smooth.literal.rendering());
  table2("curly, literal shadows", curly.fast, curly.literal.rendering());
  print("smooth, paper, no body", {0.067, 0.003, 0.09, 0.16});
  print("curly, paper, no body", {0.254, 0.003, 0.13, 0.557});
  const double step = smooth.fast.animation + smooth.fast.selfCollision + smooth.fast.rendering();
  std::cout << std::setprecision(1) << "\nsmooth: " << 1 / step
            << " frames a second, self-collision " << 100 * smooth.fast.selfCollision / step
            << " % of the step\n";
#ifdef HAIR_WITH_HAIR_MESH
  printHairMeshTable(frames);
#endif
  return 0;
}

}  // namespace
}  // namespace hair

int main(int argc, char** argv) {
  try {
    const std::string_view word = argc > 1 ? argv[1] : "";
    if (word == "--help" || word == "-h") {
      std::cout << hair::kHelp;
      return 0;
    }
    const int frames = argc > 1 ? std::atoi(argv[1]) : 120;
    hair::require(frames >= 8, "paper_tables: needs at least 8 frames, got ", argv[1]);
    return hair::program(frames);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
