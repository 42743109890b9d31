#include <libhair/files/strand_file.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include <libhair/core/error.h>
#include <libhair/files/atomic_write.h>
#include <libhair/files/strand_formats.h>

namespace hair {

namespace {

// Moves what belongs to the kept strands to the front; nothing ever moves towards the end.
template <class T>
void keepStrands(std::vector<T>& items, const std::vector<std::uint32_t>& first,
                 const std::vector<std::uint32_t>& kept) {
  auto to = items.begin();
  for (std::uint32_t s : kept)
    to = std::copy(items.begin() + first[s], items.begin() + first[s + 1], to);
  items.erase(to, items.end());
}

void keepOffsets(std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& kept) {
  std::vector<std::uint32_t> result = {0};
  for (std::uint32_t s : kept) result.push_back(result.back() + first[s + 1] - first[s]);
  first = std::move(result);
}

}  // namespace

StrandFile readStrands(const std::filesystem::path& file, const ReadOptions& options) {
  StrandFile result = formatOf(file).read(file, options);
  finishReading(options, file.string(), result);
  return result;
}

void writeStrands(const std::filesystem::path& file, StrandView strands,
                  const WriteOptions& options) {
  StrandFile whole;
  whole.strands.points.assign(strands.points.begin(), strands.points.end());
  whole.strands.first.assign(strands.first.begin(), strands.first.end());
  writeStrands(file, whole, options);
}

void writeStrands(const std::filesystem::path& file, const StrandFile& strands,
                  const WriteOptions& options) {
  const StrandFormat& format = formatOf(file);
  StrandFile scratch;
  const StrandFile& converted = prepared(format, options, file.string(), strands, scratch);
  writeAtomically(file, [&](std::ostream& out) { format.write(out, converted); });
}

std::vector<std::uint32_t> soundStrands(StrandView strands, float minLength,
                                        std::size_t minPoints) {
  std::vector<std::uint32_t> sound;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto points = strands.strand(s);
    if (points.size() >= minPoints && arcLength(points) >= minLength)
      sound.push_back(static_cast<std::uint32_t>(s));
  }
  return sound;
}

std::size_t dropDegenerate(StrandSet& strands, float minLength, std::size_t minPoints) {
  const auto kept = soundStrands(strands, minLength, minPoints);
  const std::size_t dropped = strands.strandCount() - kept.size();
  keepStrands(strands.points, strands.first, kept);
  keepOffsets(strands.first, kept);
  return dropped;
}

std::size_t dropDegenerate(StrandFile& file, float minLength, std::size_t minPoints) {
  const auto kept = soundStrands(file.strands, minLength, minPoints);
  const std::size_t dropped = file.strands.strandCount() - kept.size();
  for (auto* array : {&file.thickness, &file.transparency})
    if (!array->empty()) keepStrands(*array, file.strands.first, kept);
  if (!file.colours.empty()) keepStrands(file.colours, file.strands.first, kept);
  keepStrands(file.strands.points, file.strands.first, kept);
  keepOffsets(file.strands.first, kept);
  return dropped;
}

}  // namespace hair
