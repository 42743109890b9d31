#include <apps/hair/measure/measured_hair.h>

#include <algorithm>
#include <utility>

#include <apps/common/player.h>
#include <libhair/core/error.h>
#include <libhair/model/load_strands.h>

namespace hair {

namespace {

constexpr float kHairWidth = 80e-6f;
// Many files state a thickness in no unit at all; nothing thicker than this is hair or yarn.
constexpr float kThickest = 2e-3f;
// Of a built-in style: ten times what is drawn, so that fibres, each of a few hairs, are thinner
// than the footprints that shadows are measured over.
constexpr std::uint32_t kStyleStrands = 33'500;

float medianOf(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

float fileWidth(const StrandFile& file, std::vector<std::string>& notes) {
  const float stated = file.thickness.empty() ? file.defaultThickness : medianOf(file.thickness);
  if (stated <= 0) return kHairWidth;
  if (stated <= kThickest) {
    notes.push_back(text("width ", stated, " m, the file's thickness"));
    return stated;
  }
  notes.push_back(text("the file's thickness of ", stated, " m is no hair's; width ", kHairWidth,
                       " m instead (--width)"));
  return kHairWidth;
}

MeasuredHair fromFile(const MeasureOptions& options) {
  const CharacterOptions& character = options.character;
  LoadedStrands loaded =
      loadStrands(character.hair, {character.read, character.strands, character.points});
  MeasuredHair hair;
  hair.name = character.hair.filename().string();
  hair.notes = std::move(loaded.notes);
  hair.fibre.width = fileWidth(loaded.file, hair.notes);
  hair.fibre.hairsPerStrand = 1;
  hair.strands = std::move(loaded.file.strands);
  hair.fileStrand = std::move(loaded.strandOf);
  hair.fileFirst = std::move(loaded.firstOf);
  return hair;
}

MeasuredHair fromMesh(const MeasureOptions& options) {
  MeasuredHair hair;
  hair.name = options.character.hair.filename().string();
  hair.strands = growMeshHair(options.character, hair.notes).grown.strands;
  hair.fibre.width = kHairWidth;
  hair.fibre.hairsPerStrand = 1;
  return hair;
}

MeasuredHair fromStyle(const MeasureOptions& options) {
  CharacterOptions still = options.character;
  still.still = true;
  if (still.strands == 0) still.strands = kStyleStrands;
  const Character character(still);
  PlayerOptions rest;
  rest.settle = 0;
  rest.shadow = rest.selfCollision = false;
  const Player player(character, rest);
  MeasuredHair hair;
  const char* const names[] = {"smooth", "curly", "long"};
  hair.name = text(names[static_cast<int>(options.character.style)], " style");
  const StrandView strands = player.hair.strands();
  hair.strands.points.assign(strands.points.begin(), strands.points.end());
  hair.strands.first.assign(strands.first.begin(), strands.first.end());
  // The truth's fibre is a tube of all the hairs that a strand stands for.
  hair.fibre = character.groom.fibre;
  hair.fibre.width *= hair.fibre.hairsPerStrand;
  hair.fibre.hairsPerStrand = 1;
  return hair;
}

}  // namespace

MeasuredHair::Origin MeasuredHair::origin(std::uint32_t strand, std::uint32_t point) const {
  if (fileStrand.empty()) return {strand, point};
  return {fileStrand[strand], fileFirst[strand] + (point - strands.first[strand])};
}

MeasuredHair measuredHair(const MeasureOptions& options) {
  const auto& file = options.character.hair;
  MeasuredHair hair = file.empty()       ? fromStyle(options)
                      : isHairMesh(file) ? fromMesh(options)
                                         : fromFile(options);
  validate(hair.strands, hair.name, 2);
  if (options.width > 0) {
    hair.fibre.width = options.width;
    hair.fibre.hairsPerStrand = 1;
  }
  if (options.alpha > 0) hair.fibre.opacity = options.alpha;
  return hair;
}

}  // namespace hair
