// Simulates hair and writes it, frame after frame, as a moving cache that other programs open.
//
//   example_write_usd OUT.usda             then look: usdview OUT.usda, or Blender's import of USD
//   example_write_usd 'OUT.####.hair'      a file a frame; or .ply, .obj, .tfx, .data
//
// Look at: a writer that takes frames as they come, in the memory of one; the file says its units,
// axes and frame rate, so that nobody has to guess; and it is read back here, to be sure.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <libhair/hair.h>

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fputs("usage: example_write_usd OUT.usda\n", stderr);
    return 2;
  }
  // Few strands: a thumbnail of the smooth style, in gusts of wind.
  hair::StyleSettings style = hair::styleSettings(hair::Style::Smooth);
  style.wisps = 100;
  style.strands = 500;
  const auto head = std::make_shared<hair::MeshSdf>(hair::builtinHead().mesh);
  hair::FrameSettings settings;
  settings.shadow = settings.shade = false;
  settings.wind = {.velocity = {4, 0, 1}, .gust = 0.8f};
  hair::Simulation simulation(hair::makeGroom(style, *head), settings, {}, head);

  constexpr int kFrames = 24;
  constexpr double kRate = 24;
  hair::StrandSequenceWriter out(argv[1], {.fps = kRate, .firstFrame = 1});
  for (int frame = 0; frame < kFrames; ++frame) {
    if (frame > 0) simulation.step({}, static_cast<float>(1 / kRate));
    out.add(simulation.strands());
  }
  out.close();

  // What another program finds.
  hair::StrandSequenceReader in(argv[1]);
  hair::StrandFile first, last;
  in.read(0, first);
  in.read(in.frameCount() - 1, last);
  float moved = 0, differs = 0;
  for (std::size_t p = 0; p < last.strands.points.size(); ++p) {
    moved = std::max(moved, glm::distance(last.strands.points[p], first.strands.points[p]));
    differs =
        std::max(differs, glm::distance(last.strands.points[p], simulation.strands().points[p]));
  }
  std::printf(
      "%zu frames of %zu strands, %zu points; the last differs by %g m from what was made\n",
      in.frameCount(), last.strands.strandCount(), last.strands.pointCount(), differs);
  std::printf("in %.2f s points moved by up to %.0f cm\n", (kFrames - 1) / kRate, 100 * moved);
  return in.frameCount() == kFrames && differs < 1e-5f && moved > 0.02f ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
