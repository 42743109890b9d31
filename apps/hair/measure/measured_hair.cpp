#include <apps/hair/measure/measured_hair.h>

#include <algorithm>
#include <utility>

#include <apps/common/player.h>
#include <libhair/core/error.h>
#include <libhair/model/resample.h>

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
  MeasuredHair hair;
  hair.name = character.hair.filename().string();
  StrandFile file = readStrands(character.hair, character.read);
  const std::vector<std::uint32_t> sound = soundStrands(file.strands);
  const std::size_t read = file.strands.strandCount();
  require(!sound.empty(), character.hair.string(),
          ": no strand is longer than 1 mm; check --scale");
  hair.notes.push_back(text(hair.name, ": ", read, " strands, ", file.strands.pointCount(),
                            " points; ", file.scale, " m a unit, up axis ", wordOf(file.up)));
  if (sound.size() < read)
    hair.notes.push_back(
        text("dropped ", read - sound.size(), " strands of a single point or shorter than 1 mm"));
  hair.fibre.width = fileWidth(file, hair.notes);
  hair.fibre.hairsPerStrand = 1;

  // Which of the file's strands stay.
  std::vector<std::uint32_t> kept;
  const std::size_t wanted = character.strands > 0 ? character.strands : sound.size();
  if (wanted > sound.size())
    hair.notes.push_back(text("--strands ", wanted, ": the file has only ", sound.size()));
  for (const std::uint32_t s : chooseStrands(sound.size(), wanted)) kept.push_back(sound[s]);
  if (kept.size() == read && character.points == 0) {
    hair.strands = std::move(file.strands);
    return hair;
  }
  const ResamplePlan plan = planResampling(file.strands, kept, character.points);
  hair.strands = {resample(plan, file.strands.points), plan.first};
  hair.fileStrand = kept;
  for (std::size_t s = 0; s < kept.size(); ++s)
    hair.fileFirst.push_back(character.points > 0 ? plan.first[s] : file.strands.first[kept[s]]);
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
