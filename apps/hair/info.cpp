#include <algorithm>
#include <cctype>
#include <numeric>

#include <apps/hair/commands.h>
#include <apps/hair/info_rows.h>
#include <libhair/core/error.h>
#include <libhair/files/bvh_file.h>
#include <libhair/files/obj.h>
#include <libhair/files/strand_sequence.h>
#include <libhair/files/text_reader.h>
#include <libhair/model/head.h>
#include <libhair/motion/motion.h>
#include <libhair/wisps/load_groom.h>

namespace hair {

namespace {

// Distance of each root to the nearest other one. Sorted along x, so that only roots that are
// nearer in x than the best so far need a look.
std::vector<float> rootSpacings(StrandView strands) {
  std::vector<glm::vec3> roots = rootsOf(strands);
  std::sort(roots.begin(), roots.end(), [](glm::vec3 a, glm::vec3 b) { return a.x < b.x; });
  std::vector<float> spacings;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    float best = INFINITY;
    const auto look = [&](std::size_t j) {
      best = std::min(best, glm::distance(roots[i], roots[j]));
    };
    for (std::size_t j = i; j > 0 && roots[i].x - roots[j - 1].x < best; --j) look(j - 1);
    for (std::size_t j = i + 1; j < roots.size() && roots[j].x - roots[i].x < best; ++j) look(j);
    if (best < INFINITY) spacings.push_back(best);
  }
  return spacings;
}

void printStrands(const InfoOptions& options) {
  StrandSequenceReader in(options.file, options.read);
  StrandFile file;
  in.read(0, file);
  const StrandSet& strands = file.strands;
  std::vector<float> lengths, counts;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    lengths.push_back(arcLength(strands.strand(s)));
    counts.push_back(static_cast<float>(strands.strand(s).size()));
  }
  const Quantiles length = quantiles(lengths), points = quantiles(counts);

  row("file") << options.file.string() << '\n';
  row("format") << '.' << file.format << ": " << file.arrays << '\n';
  if (const std::size_t frames = in.frameCount(); frames > 1)
    row("frames") << frames << ", " << in.seconds(frames - 1) - in.seconds(0)
                  << " s from first to last; below: the first\n";
  row("read as") << file.scale << " m per unit, " << upAxisMeaning(file.up) << " (--up "
                 << wordOf(file.up) << "); below: metres, +Y up, +Z face\n";
  try {
    requireHeadSized(rootsOf(strands));
  } catch (const Error& e) {
    row("note") << e.what() << '\n';
  }
  for (const std::string& note : file.notes) row("note") << note << '\n';
  row("strands") << strands.strandCount() << '\n';
  row("points") << strands.pointCount() << "; a strand: " << points.least << " to " << points.most
                << ", median " << points.median << '\n';
  row("segments") << strands.segmentCount() << '\n';
  row("length") << length.least << " to " << length.most << " m, median " << length.median
                << " m\n";
  printBounds(strands.points);
  if (const auto spacings = rootSpacings(strands); !spacings.empty())
    row("root spacing") << quantiles(spacings).median << " m, median to the nearest other root\n";
  row("degenerate") << strands.strandCount() - soundStrands(strands).size()
                    << " strands of fewer than 2 points or shorter than 0.001 m\n";
  if (file.defaultThickness > 0 && file.thickness.empty())
    row("thickness") << file.defaultThickness << " m (the file's default)\n";
  if (!file.thickness.empty()) {
    const Quantiles t = quantiles(file.thickness);
    row("thickness") << t.least << " to " << t.most << " m, median " << t.median << " m\n";
  }
}

void printMesh(const InfoOptions& options) {
  ObjReport report;
  const TriangleMesh mesh = readObj(options.file, options.read, &report);
  row("file") << options.file.string() << '\n';
  row("format") << ".obj: " << report.faces << " faces\n";
  row("read as") << report.scale << " m per unit, " << upAxisMeaning(report.up) << '\n';
  row("vertices") << mesh.positions.size() << '\n';
  row("triangles") << mesh.triangles.size() << '\n';
  printBounds(mesh.positions);
  row("split") << report.split << " faces on complex edges got vertices of their own\n";
  row("dropped") << report.dropped << " faces with fewer than 3 different corners\n";
}

void printMotion(const InfoOptions& options) {
  const Bvh bvh = readBvh(options.file);
  const auto frames = static_cast<double>(bvh.frameCount());
  row("file") << options.file.string() << '\n';
  row("format") << ".bvh\n";
  row("frames") << bvh.frameCount() << ", " << 1 / bvh.frameTime << " a second, "
                << frames * bvh.frameTime << " s\n";
  row("channels") << bvh.channelCount << '\n';
  row("joints") << bvh.joints.size() << '\n';
  std::vector<int> depth;
  for (const Bvh::Joint& joint : bvh.joints) {
    depth.push_back(joint.parent < 0 ? 0 : depth[static_cast<std::size_t>(joint.parent)] + 1);
    if (!joint.endSite)
      std::cout << std::string(static_cast<std::size_t>(2 * depth.back() + 2), ' ') << joint.name
                << '\n';
  }
  try {
    const Motion motion(bvh, options.clip);
    row("person") << motion.person() << '\n';
    const std::vector<std::string> notes = motion.notes();
    for (std::size_t i = 1; i < notes.size(); ++i) row("note") << notes[i] << '\n';
    if (options.verbose)
      for (const std::string& detail : motion.details()) row("detail") << detail << '\n';
  } catch (const Error& error) {  // the file is one all the same
    row("person") << "none: " << error.what() << '\n';
  }
}

}  // namespace

void runInfo(const InfoOptions& options) {
  std::cout << std::setprecision(4);
  std::string extension = options.file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".obj" && !holdsStrands(options.file)) return printMesh(options);
  if (extension == ".bvh") return printMotion(options);
  printStrands(options);
}

}  // namespace hair
