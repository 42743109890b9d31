#include <libhair/model/load_strands.h>

#include <utility>

#include <libhair/core/error.h>
#include <libhair/model/resample.h>

namespace hair {

LoadedStrands loadStrands(const std::filesystem::path& file, const LoadOptions& options) {
  LoadedStrands loaded;
  loaded.file = readStrands(file, options.read);
  const StrandSet& strands = loaded.file.strands;
  const std::size_t read = strands.strandCount();
  loaded.notes.push_back(text(file.filename().string(), ": ", read, " strands, ",
                              strands.pointCount(), " points; ", loaded.file.scale,
                              " m a unit, up axis ", wordOf(loaded.file.up)));
  const std::vector<std::string>& said = loaded.file.notes;
  loaded.notes.insert(loaded.notes.end(), said.begin(), said.end());
  const std::vector<std::uint32_t> sound = soundStrands(strands);
  require(!sound.empty(), file.string(), ": no strand is longer than 1 mm; check --scale");
  if (sound.size() < read)
    loaded.notes.push_back(
        text("dropped ", read - sound.size(), " strands of a single point or shorter than 1 mm"));
  const std::size_t wanted = options.strands > 0 ? options.strands : sound.size();
  if (wanted > sound.size())
    loaded.notes.push_back(text("--strands ", wanted, ": the file has only ", sound.size()));
  if (sound.size() == read && wanted >= read && options.points == 0) return loaded;

  for (const std::uint32_t s : chooseStrands(sound.size(), wanted))
    loaded.strandOf.push_back(sound[s]);
  const ResamplePlan plan = planResampling(strands, loaded.strandOf, options.points);
  for (std::size_t s = 0; s < loaded.strandOf.size(); ++s)
    loaded.firstOf.push_back(options.points > 0 ? plan.first[s]
                                                : strands.first[loaded.strandOf[s]]);
  resample(plan, loaded.file);
  return loaded;
}

}  // namespace hair
