#include <libhair/files/data_file.h>

#include <libhair/files/byte_reader.h>

namespace hair {

StrandSet parseData(std::string_view bytes, std::string_view name) {
  ByteReader in(bytes, name);
  const auto strandCount = in.read<std::int32_t>("count of strands");
  in.expect(strandCount > 0, "count of strands is ", strandCount);
  const auto count = static_cast<std::size_t>(strandCount);
  in.expectLeft(count, sizeof(std::int32_t), "strands");
  StrandSet strands;
  strands.first.reserve(count + 1);
  for (std::size_t s = 0; s < count; ++s) {
    const auto pointCount = in.read<std::int32_t>("count of points");
    in.expect(pointCount >= 0, "strand ", s, " has ", pointCount, " points");
    in.appendFinite(strands.points, static_cast<std::size_t>(pointCount), text("strand ", s));
    in.expect(strands.pointCount() < (std::size_t{1} << 32), "more than 2^32 - 1 points");
    strands.first.push_back(static_cast<std::uint32_t>(strands.pointCount()));
  }
  in.expect(in.left() == 0, in.left(), " bytes are left over after ", count,
            " strands: this is no .data file, or its count is damaged");
  return strands;
}

StrandSet readData(const std::filesystem::path& file) {
  return parseData(readWholeFile(file), file.string());
}

}  // namespace hair
