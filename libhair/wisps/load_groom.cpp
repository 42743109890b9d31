#include <libhair/wisps/load_groom.h>

#include <utility>

#include <libhair/core/error.h>
#include <libhair/model/head.h>

namespace hair {

std::vector<glm::vec3> rootsOf(StrandView strands) {
  std::vector<glm::vec3> roots;
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    if (!strands.strand(s).empty()) roots.push_back(strands.strand(s).front());
  return roots;
}

LoadedGroom loadGroom(const std::filesystem::path& file, const LoadOptions& options,
                      HeadFiles heads, const BindSettings& bind, float hairs) {
  LoadedStrands loaded = loadStrands(file, options);
  LoadedGroom result;
  result.notes = std::move(loaded.notes);
  StrandSet& strands = loaded.file.strands;
  const std::vector<glm::vec3> roots = rootsOf(strands);
  if (heads.meshes.empty()) {
    HeadFit fit = fitHeadToRoots(roots);
    result.head.head = std::move(fit.head);
    result.head.headFromHair = fit.headFromHair;
    result.head.notes.push_back(
        text("no --head: the built-in head was scaled under the roots, which lie on it to ",
             fit.residual * 1000, " mm (mean)"));
  } else {
    result.head = loadedHead(std::move(heads.meshes), {roots, {loaded.file.scale, loaded.file.up}},
                             heads.read);
  }
  for (glm::vec3& p : strands.points) p = result.head.headFromHair.point(p);
  result.groom = bindGroom(strands, bind, hairs);
  result.notes.push_back(text(strands.strandCount(), " strands stand for ", hairs,
                              " hairs: ", result.groom.fibre.hairsPerStrand, " each"));
  result.notes.insert(result.notes.end(), result.head.notes.begin(), result.head.notes.end());
  return result;
}

}  // namespace hair
