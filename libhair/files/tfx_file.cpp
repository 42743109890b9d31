#include <libhair/files/tfx_file.h>

#include <ostream>

#include <libhair/files/byte_reader.h>

namespace hair {

namespace {

// The file header, 160 bytes. An offset of 0: no such array.
struct Header {
  float version = 0;
  std::uint32_t strands = 0;
  std::uint32_t pointsPerStrand = 0;
  std::uint32_t positions = 0, strandUv = 0, vertexUv = 0, strandThickness = 0, vertexColour = 0;
  std::uint32_t reserved[32] = {};
};
static_assert(sizeof(Header) == 160);

constexpr std::uint32_t kFewestPoints = 4, kMostPoints = 64;  // of a strand

}  // namespace

TfxFile parseTfx(std::string_view bytes, std::string_view name) {
  ByteReader in(bytes, name);
  const auto header = in.read<Header>("header");
  in.seek(0, "header");
  in.expect(header.version == 4.0f, "version 4.0 expected, found ", header.version,
            ": this is no .tfx file, or of another version");
  in.seek(4, "header");
  in.expect(header.strands > 0, "the file holds no strands");
  in.seek(8, "header");
  in.expect(header.pointsPerStrand >= kFewestPoints && header.pointsPerStrand <= kMostPoints,
            "strands of ", header.pointsPerStrand, " points; the format has ", kFewestPoints,
            " to ", kMostPoints);
  in.seek(12, "header");
  in.expect(header.positions >= sizeof(Header), "positions at byte ", header.positions,
            ": there are none, or they lie inside the header");
  // Arrays that are not read must at least be possible: else the header is damaged.
  const auto checkOffset = [&](std::uint32_t offset, std::string_view what) {
    in.expect(offset == 0 || (offset >= sizeof(Header) && offset < in.size()), what, " at byte ",
              offset, ", outside of the file (", in.size(), " bytes)");
  };
  checkOffset(header.strandUv, "strand UV");
  checkOffset(header.vertexUv, "vertex UV");
  checkOffset(header.strandThickness, "strand thickness");
  checkOffset(header.vertexColour, "vertex colours");

  // At most 2^32 strands of 64 points: no overflow in 64 bits, but the offsets have only 32.
  const std::uint64_t pointCount = std::uint64_t{header.strands} * header.pointsPerStrand;
  in.seek(header.positions, "positions");
  in.expectLeft(pointCount, sizeof(glm::vec4), "positions");
  in.expect(pointCount < (std::uint64_t{1} << 32), pointCount, " points; at most 2^32 - 1");
  std::vector<glm::vec4> positions;
  in.appendFinite(positions, pointCount, "positions");

  TfxFile tfx;
  tfx.strands.points.reserve(pointCount);
  tfx.pinned.reserve(pointCount);
  for (glm::vec4 p : positions) {
    tfx.strands.points.emplace_back(p);
    tfx.pinned.push_back(p.w == 0.0f);
  }
  tfx.strands.first.reserve(header.strands + std::size_t{1});
  for (std::uint32_t s = 1; s <= header.strands; ++s)
    tfx.strands.first.push_back(s * header.pointsPerStrand);
  if (header.strandUv != 0) {
    in.seek(header.strandUv, "strand UV");
    in.appendFinite(tfx.strandUv, header.strands, "strand UV");
  }
  return tfx;
}

TfxFile readTfx(const std::filesystem::path& file) {
  return parseTfx(readWholeFile(file), file.string());
}

void writeTfx(std::ostream& out, StrandView strands) {
  const std::size_t count = strands.strandCount() > 0 ? strands.strand(0).size() : 0;
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    require(strands.strand(s).size() == count, "writing .tfx: strand ", s, " has ",
            strands.strand(s).size(), " points and the first has ", count,
            "; the format has one number for all: resample (`hair convert --points 16`)");
  require(count >= kFewestPoints && count <= kMostPoints, "writing .tfx: strands of ", count,
          " points; the format has ", kFewestPoints, " to ", kMostPoints,
          ": resample (`hair convert --points 16`)");
  const Header header = {.version = 4,
                         .strands = static_cast<std::uint32_t>(strands.strandCount()),
                         .pointsPerStrand = static_cast<std::uint32_t>(count),
                         .positions = sizeof(Header)};
  out.write(reinterpret_cast<const char*>(&header), sizeof header);
  std::vector<glm::vec4> positions(count);
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    for (std::size_t i = 0; i < count; ++i)
      positions[i] = glm::vec4(strands.strand(s)[i], i == 0 ? 0.0f : 1.0f);
    out.write(reinterpret_cast<const char*>(positions.data()),
              static_cast<std::streamsize>(count * sizeof(glm::vec4)));
  }
}

}  // namespace hair
