#include <libhair/files/strand_formats.h>

#include <cctype>

#include <libhair/core/error.h>
#include <libhair/files/byte_reader.h>
#include <libhair/files/data_file.h>
#include <libhair/files/file_units.h>
#include <libhair/files/hair_file.h>
#include <libhair/files/numpy/npz_strands.h>
#include <libhair/files/obj_strands.h>
#include <libhair/files/pbrt_file.h>
#include <libhair/files/ply_file.h>
#include <libhair/files/tfx_file.h>
#include <libhair/files/usda/usda_file.h>
#include <libhair/files/usda/usda_write.h>

namespace hair {

namespace {

namespace fs = std::filesystem;

constexpr float kYukselScale = 0.00465f;  // of straight.hair: a head of 9.5 cm radius

StrandFile readHairStrands(const fs::path& file, const ReadOptions&) {
  HairFile hair = readHair(file);
  StrandFile result;
  result.format = "hair";
  if (!unitsFromText(hair.info, result.scale, result.up)) {
    result.scale = kYukselScale;
    result.up = UpAxis::Z;
  }
  result.strands = std::move(hair.strands);
  result.thickness = std::move(hair.thickness);
  result.transparency = std::move(hair.transparency);
  result.colours = std::move(hair.colours);
  result.defaultThickness = hair.defaultThickness;
  result.defaultTransparency = hair.defaultTransparency;
  result.defaultColour = hair.defaultColour;
  return result;
}

void writeHairStrands(std::ostream& out, const StrandFile& strands) {
  const std::string bytes = hairBytes({.strands = strands.strands,
                                       .thickness = strands.thickness,
                                       .transparency = strands.transparency,
                                       .colours = strands.colours,
                                       .defaultThickness = strands.defaultThickness,
                                       .defaultTransparency = strands.defaultTransparency,
                                       .defaultColour = strands.defaultColour,
                                       .info = unitsText(strands.scale, strands.up)});
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

StrandFile readTfxStrands(const fs::path& file, const ReadOptions&) {
  TfxFile tfx = readTfx(file);
  StrandFile result;
  result.format = "tfx";
  result.arrays = "points, pinned";
  if (!tfx.strandUv.empty()) result.arrays += ", strand UV";
  result.strands = std::move(tfx.strands);
  return result;
}

StrandFile readDataStrands(const fs::path& file, const ReadOptions&) {
  StrandFile result;
  result.format = "data";
  result.strands = readData(file);
  return result;
}

StrandFile readNumpy(const fs::path& file, const ReadOptions& options) {
  return parseNumpy(readWholeFile(file), file.string(), options.pointsPerStrand);
}

constexpr StrandFormat kFormats[] = {
    {"hair", readHairStrands, writeHairStrands, true, 1},
    {"tfx", readTfxStrands,
     [](std::ostream& out, const StrandFile& file) { writeTfx(out, file.strands); }, false, 4},
    {"data", readDataStrands,
     [](std::ostream& out, const StrandFile& file) { writeData(out, file.strands); }, false, 0},
    {"ply",
     [](const fs::path& file, const ReadOptions& options) {
       return parsePly(readWholeFile(file), file.string(), options.pointsPerStrand);
     },
     writePly, true, 1},
    {"obj",
     [](const fs::path& file, const ReadOptions&) {
       return parseObjStrands(readWholeFile(file), file.string());
     },
     writeObjStrands, false, 1},
    {"usda", readUsda, writeUsda, true, 2},
    {"npy", readNumpy, nullptr, false, 0},
    {"npz", readNumpy, nullptr, false, 0},
    {"pbrt",
     [](const fs::path& file, const ReadOptions&) {
       return parsePbrt(readWholeFile(file), file.string());
     },
     nullptr, false, 2}};

void checkOptional(std::size_t count, std::size_t points, std::string_view name,
                   std::string_view what) {
  require(count == 0 || count == points, name, ": ", what, ": ", count, " items for ", points,
          " points; give one a point, or none");
}

}  // namespace

const StrandFormat* findFormat(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const StrandFormat& format : kFormats)
    if (extension.size() > 1 && extension.substr(1) == format.name) return &format;
  return nullptr;
}

const StrandFormat& formatOf(const fs::path& file) {
  const StrandFormat* format = findFormat(file);
  require(format != nullptr, file.string(), ": unknown format '", file.extension().string(),
          "'; strands are kept in ", strandFormats());
  return *format;
}

bool isStrandFile(const fs::path& file) {
  return findFormat(file) != nullptr;
}

bool holdsStrands(const fs::path& file) {
  const StrandFormat* format = findFormat(file);
  return format != nullptr &&
         (format->name != "obj" || objContents(readWholeFile(file), file.string()).lines > 0);
}

bool holdsMesh(const fs::path& file) {
  const StrandFormat* format = findFormat(file);
  return format != nullptr && format->name == "obj" &&
         objContents(readWholeFile(file), file.string()).faces > 0;
}

bool isWrittenStrandFile(const fs::path& file) {
  const StrandFormat* format = findFormat(file);
  return format != nullptr && format->write != nullptr;
}

std::string strandFormats() {
  std::string names;
  for (std::size_t i = 0; i < std::size(kFormats); ++i) {
    if (i > 0) names += i + 1 < std::size(kFormats) ? ", " : " and ";
    names += '.';
    names += kFormats[i].name;
  }
  return names;
}

std::string lossOf(const fs::path& file, const StrandFile& strands) {
  if (formatOf(file).holdsArrays) return {};
  std::string lost;
  const auto add = [&](bool there, std::string_view what) {
    if (there) lost += (lost.empty() ? "" : ", ") + std::string(what);
  };
  add(!strands.thickness.empty() || strands.defaultThickness > 0, "thickness");
  add(!strands.transparency.empty() || strands.defaultTransparency > 0, "transparency");
  add(!strands.colours.empty() || strands.defaultColour != glm::vec3(0), "colours");
  return lost;
}

void finishReading(const ReadOptions& options, std::string_view name, StrandFile& strands) {
  require(std::isfinite(options.scale) && options.scale >= 0, "scale of ", options.scale,
          " metres a unit: must be above zero (or 0 for the format's default)");
  if (!strands.thickness.empty()) strands.arrays += ", thickness";
  if (!strands.transparency.empty()) strands.arrays += ", transparency";
  if (!strands.colours.empty()) strands.arrays += ", colours";
  if (options.scale > 0) strands.scale = options.scale;
  if (options.up != UpAxis::AsFile) strands.up = options.up;
  if (strands.scale != 1 || strands.up != UpAxis::Y)
    convertUnits(strands.strands.points, strands.scale, strands.up);
  for (float& t : strands.thickness) t *= strands.scale;
  strands.defaultThickness *= strands.scale;
  validate(strands.strands, name, 0);
}

const StrandFile& prepared(const StrandFormat& format, const WriteOptions& options,
                           std::string_view name, const StrandFile& strands, StrandFile& scratch) {
  require(format.write != nullptr, name, ": .", format.name,
          " files are read, not written; write .ply, or .usda");
  require(std::isfinite(options.scale) && options.scale > 0, name, ": scale of ", options.scale,
          " metres a unit: must be above zero");
  const std::size_t points = strands.strands.pointCount();
  validate(strands.strands, name, 0);
  require(strands.strands.strandCount() > 0, name, ": there are no strands to write");
  for (std::size_t s = 0; s < strands.strands.strandCount(); ++s)
    require(strands.strands.strand(s).size() >= format.leastPoints, name, ": strand ", s, " has ",
            strands.strands.strand(s).size(), " points, a .", format.name, " file needs ",
            format.leastPoints, ": drop short strands (dropDegenerate) or resample them");
  checkOptional(strands.thickness.size(), points, name, "thickness");
  checkOptional(strands.transparency.size(), points, name, "transparency");
  checkOptional(strands.colours.size(), points, name, "colours");
  const UpAxis up = options.up == UpAxis::AsFile ? UpAxis::Y : options.up;
  const bool asIs = options.scale == 1 && up == UpAxis::Y;
  // The caller's own, as its declaration says.
  // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter)
  if (asIs && strands.scale == 1 && strands.up == UpAxis::Y) return strands;
  scratch = strands;
  scratch.scale = options.scale;
  scratch.up = up;
  if (asIs) return scratch;
  convertUnitsBack(scratch.strands.points, scratch.scale, scratch.up);
  for (glm::vec3 p : scratch.strands.points)
    require(std::isfinite(p.x + p.y + p.z), name, ": coordinates are too large in units of ",
            scratch.scale, " m; write larger units");
  for (float& t : scratch.thickness) t /= scratch.scale;
  scratch.defaultThickness /= scratch.scale;
  return scratch;
}

}  // namespace hair
