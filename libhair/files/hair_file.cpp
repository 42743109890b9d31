#include <libhair/files/hair_file.h>

#include <algorithm>
#include <ostream>

#include <libhair/files/atomic_write.h>
#include <libhair/files/byte_reader.h>

namespace hair {

namespace {

// The file header, 128 bytes.
struct Header {
  char magic[4] = {'H', 'A', 'I', 'R'};
  std::uint32_t strands = 0;
  std::uint32_t points = 0;
  std::uint32_t flags = 0;
  std::uint32_t segments = 0;  // of each strand, where there is no array of them
  float thickness = 0;
  float transparency = 0;
  float colour[3] = {};
  char info[88] = {};
};
static_assert(sizeof(Header) == 128);

constexpr std::uint32_t kSegments = 1, kPoints = 2, kThickness = 4, kTransparency = 8,
                        kColours = 16;
constexpr std::size_t kMostSegments = 65535;  // they are counted in 16 bits

template <class T>
void put(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

void checkOptional(std::size_t count, std::size_t points, std::string_view what) {
  require(count == 0 || count == points, "writing .hair: ", what, ": ", count, " items for ",
          points, " points; give one a point, or none");
}

}  // namespace

HairFile parseHair(std::string_view bytes, std::string_view name) {
  ByteReader in(bytes, name);
  in.expect(bytes.starts_with("HAIR"), "'HAIR' expected: this is no .hair file");
  const auto header = in.read<Header>("header");
  in.seek(4, "header");
  in.expect((header.flags & kPoints) != 0, "flags ", header.flags, ": the file holds no points");
  in.expect(header.strands > 0, "the file holds no strands");
  in.expect(header.strands <= header.points, header.strands, " strands cannot have ", header.points,
            " points: each has one at least");
  in.seek(sizeof(Header), "points");
  in.expectLeft(header.points, sizeof(glm::vec3), "points");
  for (float value : {header.thickness, header.transparency, header.colour[0], header.colour[1],
                      header.colour[2]})
    in.expect(std::isfinite(value), "a default in the header is ", value, ", not finite");

  HairFile hair;
  hair.defaultThickness = header.thickness;
  hair.defaultTransparency = header.transparency;
  hair.defaultColour = {header.colour[0], header.colour[1], header.colour[2]};
  hair.info.assign(header.info, std::find(std::begin(header.info), std::end(header.info), '\0'));

  std::vector<std::uint16_t> segments;
  if (header.flags & kSegments) in.append(segments, header.strands, "segments of strands");
  hair.strands.first.reserve(header.strands + std::size_t{1});
  std::uint64_t pointCount = 0;
  for (std::size_t s = 0; s < header.strands; ++s) {
    pointCount += 1 + std::uint64_t{segments.empty() ? header.segments : segments[s]};
    in.expect(pointCount <= header.points, "strands 0 to ", s, " need ", pointCount,
              " points but the header announces ", header.points);
    hair.strands.first.push_back(static_cast<std::uint32_t>(pointCount));
  }
  in.expect(pointCount == header.points, "all strands need ", pointCount,
            " points but the header announces ", header.points);

  in.appendFinite(hair.strands.points, header.points, "points");
  if (header.flags & kThickness) in.appendFinite(hair.thickness, header.points, "thickness");
  if (header.flags & kTransparency)
    in.appendFinite(hair.transparency, header.points, "transparency");
  if (header.flags & kColours) in.appendFinite(hair.colours, header.points, "colours");
  in.expect(in.left() == 0, in.left(), " bytes are left over: counts or flags in the header (",
            header.flags, ") do not fit this file");
  return hair;
}

HairFile readHair(const std::filesystem::path& file) {
  return parseHair(readWholeFile(file), file.string());
}

std::string hairBytes(const HairFile& hair) {
  const StrandSet& strands = hair.strands;
  validate(strands, "writing .hair", 1);
  require(strands.strandCount() > 0, "writing .hair: there are no strands");
  checkOptional(hair.thickness.size(), strands.pointCount(), "thickness");
  checkOptional(hair.transparency.size(), strands.pointCount(), "transparency");
  checkOptional(hair.colours.size(), strands.pointCount(), "colours");
  require(hair.info.size() <= sizeof(Header::info), "writing .hair: the info text has ",
          hair.info.size(), " bytes, at most ", sizeof(Header::info));

  std::vector<std::uint16_t> segments;
  bool equal = true;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const std::size_t count = strands.strand(s).size() - 1;
    require(count <= kMostSegments, "writing .hair: strand ", s, " has ", count + 1,
            " points, at most ", kMostSegments + 1, "; resample it");
    segments.push_back(static_cast<std::uint16_t>(count));
    equal = equal && count == segments.front();
  }

  Header header;
  header.strands = static_cast<std::uint32_t>(strands.strandCount());
  header.points = static_cast<std::uint32_t>(strands.pointCount());
  header.flags = kPoints | (equal ? 0 : kSegments) | (hair.thickness.empty() ? 0 : kThickness) |
                 (hair.transparency.empty() ? 0 : kTransparency) |
                 (hair.colours.empty() ? 0 : kColours);
  header.segments = equal ? segments.front() : 0;
  header.thickness = hair.defaultThickness;
  header.transparency = hair.defaultTransparency;
  for (int c = 0; c < 3; ++c) header.colour[c] = hair.defaultColour[c];
  std::copy(hair.info.begin(), hair.info.end(), header.info);

  std::string bytes(reinterpret_cast<const char*>(&header), sizeof(Header));
  if (!equal) put(bytes, segments);
  put(bytes, strands.points);
  put(bytes, hair.thickness);
  put(bytes, hair.transparency);
  put(bytes, hair.colours);
  return bytes;
}

void writeHair(const std::filesystem::path& file, const HairFile& hair) {
  const std::string bytes = hairBytes(hair);
  writeAtomically(file, [&](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace hair
