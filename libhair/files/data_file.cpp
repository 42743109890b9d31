#include <libhair/files/data_file.h>

#include <ostream>

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

void writeData(std::ostream& out, StrandView strands) {
  constexpr std::size_t kMost = 0x7fffffff;  // counts have a sign
  require(strands.strandCount() <= kMost, "writing .data: ", strands.strandCount(),
          " strands, at most ", kMost);
  const auto put = [&](const void* items, std::size_t bytes) {
    out.write(static_cast<const char*>(items), static_cast<std::streamsize>(bytes));
  };
  const auto putCount = [&](std::size_t count) {
    const auto number = static_cast<std::int32_t>(count);
    put(&number, sizeof number);
  };
  putCount(strands.strandCount());
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const auto points = strands.strand(s);
    require(points.size() <= kMost, "writing .data: strand ", s, " has ", points.size(),
            " points, at most ", kMost);
    putCount(points.size());
    put(points.data(), points.size_bytes());
  }
}

}  // namespace hair
