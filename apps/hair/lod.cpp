#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <utility>

#include <apps/common/scene_view.h>
#include <apps/draw/gl_context.h>
#include <apps/draw/image.h>
#include <apps/hair/commands.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>
#include <libhair/shadow/density_map.h>

namespace hair {

namespace {

using draw::Picture;

constexpr float kStep = 0.99f;      // from a size to the next, where jumps are measured
constexpr float kAbrupt = 1e-3f;    // a fade so short that strands vanish
constexpr int kLargest = 2400;      // pixels that are drawn of a picture, an axis
constexpr int kMostSamples = 8;     // drawn for each of the picture's, an axis
constexpr int kThumbnail = 480;     // pixels of a picture on the sheet
constexpr double kDifference = 10;  // how much differences on the sheet are enlarged

struct Difference {
  double bias = 0, rms = 0;
};

// What the hair of one level costs, and what is wrong with it.
struct LodRow {
  float pixels = 0;
  LevelOfDetail level;
  std::size_t strands = 0, points = 0;
  float wider = 1, cellSize = 0;
  double mapMb = 0, pointsMb = 0, ms = 0, fullMs = 0;
  Difference light;    // of transmittance
  Difference picture;  // bias: of luminance, as a share of the mean; rms: as displayed, of white
  double jump = 0, abruptJump = 0;
};

// Linear luminance.
std::vector<float> luminance(const Picture& picture) {
  std::array<float, 256> linear;
  for (std::size_t i = 0; i < 256; ++i) {
    const float c = static_cast<float>(i) / 255;
    linear[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  }
  std::vector<float> y(picture.rgb.size() / 3);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = 0.2126f * linear[picture.rgb[3 * i]] + 0.7152f * linear[picture.rgb[3 * i + 1]] +
           0.0722f * linear[picture.rgb[3 * i + 2]];
  return y;
}

// Where the hair is seen: pixels that are not those of a bald head.
std::vector<bool> hairOf(const Picture& picture, const Picture& bald) {
  std::vector<bool> hair(picture.rgb.size() / 3);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    if (std::abs(int{picture.rgb[i]} - int{bald.rgb[i]}) > 3) hair[i / 3] = true;
  return hair;
}

// As bright as a pixel is shown, 0 to 1: the eye's steps are about even there.
double shown(const std::uint8_t* rgb) {
  return (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255;
}

// Of b from a where the mask is. Bias: of linear luminance, as a share of a's; is the hair lighter,
// or is there less of it? RMS: of what is shown, of white.
Difference compare(const Picture& a, const Picture& b, const std::vector<bool>& mask) {
  const std::vector<float> x = luminance(a), y = luminance(b);
  double sum = 0, difference = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!mask[i]) continue;
    const double d = shown(&b.rgb[3 * i]) - shown(&a.rgb[3 * i]);
    sum += static_cast<double>(x[i]), difference += static_cast<double>(y[i] - x[i]);
    squares += d * d, ++count;
  }
  if (count == 0 || sum == 0) return {};
  return {difference / sum, std::sqrt(squares / count)};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Picture enlarged(const Picture& picture) {
  Picture large(kThumbnail, kThumbnail);
  for (int y = 0; y < kThumbnail; ++y)
    for (int x = 0; x < kThumbnail; ++x)
      std::copy_n(picture.pixel(x * picture.width / kThumbnail, y * picture.height / kThumbnail), 3,
                  large.pixel(x, y));
  return large;
}

// Grey where two pictures agree.
Picture difference(const Picture& a, const Picture& b) {
  Picture d(a.width, a.height);
  for (std::size_t i = 0; i < d.rgb.size(); ++i)
    d.rgb[i] = static_cast<std::uint8_t>(
        std::clamp(128 + kDifference * (int{b.rgb[i]} - int{a.rgb[i]}), 0.0, 255.0));
  return d;
}

// Pictures of one moment of a motion at any level and size.
class Studio {
 public:
  Studio(Player& player, const LodOptions& options) : player_(player), view_(player) {
    view_.frameHead(glm::radians(options.yaw), glm::radians(options.pitch), options.distance);
    // Lines are never wider than a pixel, and would lose what is.
    view_.scene.hair[0].primitive = draw::HairPrimitive::Ribbons;
  }
  // A square picture in which the head is so many pixels high. Each pixel is the mean of many.
  Picture shoot(const LevelOfDetail& level, float pixels, bool bald = false) {
    const draw::Camera& camera = view_.scene.camera;
    const float share = headPixels(camera.distance, camera.fieldOfView, 1);
    const int side = std::max(static_cast<int>(std::lround(pixels / share)), 1);
    const int samples = std::clamp(kLargest / side, 1, kMostSamples);
    player_.hair.level = level;
    redraw(player_.hair);
    player_.relight();
    view_.update(renderer_);
    if (bald) view_.scene.hair[0].strands = {}, view_.scene.hair[0].colours = {};
    renderer_.draw(view_.scene, samples * side, samples * side);
    return draw::downscaled(renderer_.read(), side, side);
  }

 private:
  Player& player_;
  draw::OffscreenContext context_;
  // Every strand casts its shadow: a choice of some would be another one at each level.
  draw::Renderer renderer_{{4, 1024, 1 << 30}};
  SceneView view_;
};

// Of the hair as it stands from what the whole hair's map says at the same points.
Difference lightDifference(const DensityMap& whole, const Hair& hair) {
  const StrandView strands = hair.strands();
  std::vector<float> expected(strands.pointCount());
  sampleStrandTransmittance(whole, strands, expected);
  const std::vector<float>& weights = hair.wisps.drawn.weights;
  double sum = 0, squares = 0, weight = 0;
  for (std::size_t s = 0; s < strands.strandCount(); ++s) {
    const double w = weights.empty() ? 1.0 : static_cast<double>(weights[s]);
    for (std::uint32_t p = strands.first[s]; p < strands.first[s + 1]; ++p) {
      const double d =
          static_cast<double>(hair.transmittance[p]) - static_cast<double>(expected[p]);
      sum += w * d, squares += w * d * d, weight += w;
    }
  }
  return weight > 0 ? Difference{sum / weight, std::sqrt(squares / weight)} : Difference{};
}

LodRow look(const GroomDetail& detail, const LodOptions& options, float pixels, Studio& studio,
            Hair& hair, std::vector<Picture>& sheet) {
  LodRow row;
  row.pixels = pixels;
  row.level = levelFor(detail, pixels, options.importance, options.detail);
  const Picture whole = studio.shoot({}, pixels);
  const std::vector<bool> mask = hairOf(whole, studio.shoot({}, pixels, true));
  const std::vector<DensityMap> maps = std::exchange(hair.maps, {});

  const Picture less = studio.shoot(row.level, pixels);
  row.picture = compare(whole, less, mask);
  const StrandView strands = hair.strands();
  row.points = strands.pointCount();
  for (std::size_t s = 0; s < strands.strandCount(); ++s)
    row.strands += strands.first[s + 1] > strands.first[s];
  row.wider = hair.wisps.drawn.wider;
  row.pointsMb = static_cast<double>(row.points * (sizeof(glm::vec3) + sizeof(std::uint32_t) +
                                                   hair.maps.size() * sizeof(float))) *
                 1e-6;
  if (!hair.maps.empty()) {
    row.light = lightDifference(maps.front(), hair);
    row.cellSize = hair.maps.front().settings.cellSize;
    for (const DensityMap& m : hair.maps) row.mapMb += static_cast<double>(m.bytes()) * 1e-6;
  }
  DetailSettings abrupt = options.detail;
  abrupt.fade = kAbrupt;
  const auto at = [&](float size, const DetailSettings& settings) {
    return studio.shoot(levelFor(detail, size, options.importance, settings), pixels);
  };
  row.jump = compare(less, at(kStep * pixels, options.detail), mask).rms;
  row.abruptJump = compare(at(pixels, abrupt), at(kStep * pixels, abrupt), mask).rms;
  if (!options.sheet.empty())
    for (const Picture& p : {whole, less, difference(whole, less)}) sheet.push_back(enlarged(p));
  return row;
}

// Frames of the motion, all of the hair and the level by turns.
void time(const LodOptions& options, Player& player, LodRow& row) {
  constexpr int kTurns = 3;  // a machine that is busy for a while is so for both
  std::vector<double> whole, less;
  for (int turn = 0; turn < kTurns; ++turn)
    for (const bool all : {true, false}) {
      player.hair.level = all ? LevelOfDetail{} : row.level;
      player.step();  // makes room
      for (int f = 0; f < (options.frames + kTurns - 1) / kTurns; ++f) {
        player.step();
        double ms = 0;
        for (const StageTime& stage : player.profile)
          ms += static_cast<double>(stage.nanoseconds) * 1e-6;
        (all ? whole : less).push_back(ms);
      }
    }
  row.fullMs = median(whole), row.ms = median(less);
}

void print(const std::vector<LodRow>& rows, const Character& character) {
  const Groom& groom = character.groom;
  std::cout << groom.strandCount() << " strands, " << groom.pointCount() << " points\n\n"
            << "head  strands   wider  points  cell   map     points  frame  of all  shadow        "
               " picture, %     1 % on, %\n"
            << "  px                  a strand    mm    MB        MB     ms          bias     rms  "
               "  bias    rms  jump  abrupt\n"
            << std::fixed;
  for (const LodRow& r : rows) {
    const auto number = [](double value, int width, int digits) {
      std::cout << std::setw(width) << std::setprecision(digits) << value;
    };
    number(static_cast<double>(r.pixels), 4, 0);
    std::cout << std::setw(9) << r.strands;
    number(static_cast<double>(r.wider), 8, 2);
    number(static_cast<double>(r.points) / static_cast<double>(std::max<std::size_t>(r.strands, 1)),
           8, 1);
    number(static_cast<double>(r.cellSize) * 1e3, 6, 1);
    number(r.mapMb, 6, 1);
    number(r.pointsMb, 10, 2);
    number(r.ms, 7, 2);
    number(r.ms / r.fullMs, 8, 2);
    number(r.light.bias, 8, 4);
    number(r.light.rms, 8, 4);
    number(100 * r.picture.bias, 8, 2);
    number(100 * r.picture.rms, 7, 2);
    number(100 * r.jump, 6, 2);
    number(100 * r.abruptJump, 8, 2);
    std::cout << '\n';
  }
}

void writeCsv(const std::filesystem::path& file, const std::vector<LodRow>& rows) {
  writeAtomically(file, [&](std::ostream& out) {
    out << "pixels,strands,wider,points,cell_m,map_mb,points_mb,ms,full_ms,light_bias,light_rms,"
           "picture_bias,picture_rms,jump,abrupt_jump\n";
    for (const LodRow& r : rows)
      out << r.pixels << ',' << r.strands << ',' << r.wider << ',' << r.points << ',' << r.cellSize
          << ',' << r.mapMb << ',' << r.pointsMb << ',' << r.ms << ',' << r.fullMs << ','
          << r.light.bias << ',' << r.light.rms << ',' << r.picture.bias << ',' << r.picture.rms
          << ',' << r.jump << ',' << r.abruptJump << '\n';
  });
}

}  // namespace

void runLod(const LodOptions& options) {
  const ThreadLimit limit(options.threads);
  const Character character(options.character);
  for (const std::string& note : character.notes) std::cerr << note << '\n';
  Player player(character, options.player);
  const GroomDetail detail(character.groom);
  player.simulation.setDetail(borrowed(detail));
  std::vector<LodRow> rows;
  std::vector<Picture> sheet;
  {
    Studio studio(player, options);
    for (const float pixels : options.sizes)
      rows.push_back(look(detail, options, pixels, studio, player.hair, sheet));
  }
  player.settings.shade = true;
  for (LodRow& row : rows) time(options, player, row);
  print(rows, character);
  if (!options.csv.empty()) writeCsv(options.csv, rows);
  if (!sheet.empty()) draw::writeImage(draw::contactSheet(sheet, 3), options.sheet);
}

}  // namespace hair
