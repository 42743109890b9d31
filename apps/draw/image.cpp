#include <apps/draw/image.h>

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include <OpenImageIO/imageio.h>

#include <libhair/core/error.h>

namespace hair::draw {
namespace {

namespace fs = std::filesystem;

float linearFromSrgb(float c) {
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

float srgbFromLinear(float c) {
  return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

const std::array<float, 256>& linearTable() {
  static const auto table = [] {
    std::array<float, 256> t{};
    for (int i = 0; i < 256; ++i) t[std::size_t(i)] = linearFromSrgb(float(i) / 255.0f);
    return t;
  }();
  return table;
}

/// Removes the unfinished file unless the writing got to its end.
struct Unfinished {
  fs::path file;
  ~Unfinished() {
    std::error_code ignored;
    if (!file.empty()) fs::remove(file, ignored);
  }
};

std::string extensionOf(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return char(std::tolower(c)); });
  return extension;
}

// The byte of 0 to 1 of a display; NaN is 0.
std::uint8_t byteOf(float shown) {
  return std::uint8_t(255 * (shown > 0 ? std::min(shown, 1.0f) : 0) + 0.5f);
}

std::uint8_t encodedByte(float linear) {
  return byteOf(srgbFromLinear(std::clamp(linear, 0.0f, 1.0f)));
}

/// Three channels from memory as the file is to have them.
void write(int width, int height, OIIO::TypeDesc inFile, OIIO::TypeDesc inMemory,
           const void* values, const fs::path& file) {
  require(width > 0 && height > 0, file.string(), ": a picture without pixels cannot be written");
  // OpenImageIO picks the format by extension, so the temporary name keeps it.
  Unfinished unfinished{file.parent_path() / (file.stem().string() + ".part" +
                                              std::to_string(::getpid()) + extensionOf(file))};
  const std::string name = unfinished.file.string();
  auto output = OIIO::ImageOutput::create(name);
  require(output != nullptr, file.string(), ": no writer for this format: ", OIIO::geterror());
  OIIO::ImageSpec spec(width, height, 3, inFile);
  spec.attribute("oiio:ColorSpace", inFile == OIIO::TypeDesc::UINT8 ? "sRGB" : "Linear");
  if (!output->open(name, spec)) throw Error(text(file.string(), ": ", output->geterror()));
  if (!output->write_image(inMemory, values) || !output->close())
    throw Error(text(file.string(), ": ", output->geterror()));
  std::error_code failed;
  fs::rename(unfinished.file, file, failed);
  require(!failed, file.string(), ": ", failed.message());
  unfinished.file.clear();
}

/// A picture of at least so many channels.
std::unique_ptr<OIIO::ImageInput> openImage(const fs::path& file, int channels) {
  auto input = OIIO::ImageInput::open(file.string());
  if (!input) throw Error(text(file.string(), ": ", OIIO::geterror()));
  const OIIO::ImageSpec& spec = input->spec();
  require(spec.nchannels >= channels && spec.width > 0 && spec.height > 0 && spec.width <= 65536 &&
              spec.height <= 65536,
          file.string(), ": a picture of ", spec.width, " x ", spec.height, " pixels with ",
          spec.nchannels, " channels; ",
          channels == 3 ? "red, green and blue are wanted" : "one or more are wanted");
  return input;
}

}  // namespace

bool isLinear(const fs::path& file) {
  return extensionOf(file) == ".exr";
}

void writeImage(const Picture& picture, const fs::path& file) {
  require(extensionOf(file) == ".png", file.string(), ": pictures of bytes are written as .png");
  write(picture.width, picture.height, OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT8,
        picture.rgb.data(), file);
}

void writeImage(const LinearPicture& picture, const fs::path& file) {
  if (!isLinear(file)) return writeImage(encoded(picture), file);
  static constexpr float kLargestHalf = 65504;
  std::vector<float> values(picture.rgb.size());
  std::ranges::transform(picture.rgb, values.begin(),
                         [](float v) { return std::clamp(v, -kLargestHalf, kLargestHalf); });
  write(picture.width, picture.height, OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, values.data(),
        file);
}

Picture encoded(const LinearPicture& picture) {
  Picture bytes(picture.width, picture.height);
  std::ranges::transform(picture.rgb, bytes.rgb.begin(), encodedByte);
  return bytes;
}

LinearPicture readLinearImage(const fs::path& file) {
  const auto input = openImage(file, 3);
  const OIIO::ImageSpec& spec = input->spec();
  require(spec.format.is_floating_point(), file.string(), ": not a picture of floats");
  LinearPicture picture(spec.width, spec.height);
  if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, picture.rgb.data()))
    throw Error(text(file.string(), ": ", input->geterror()));
  return picture;
}

Picture readImage(const fs::path& file) {
  const auto input = openImage(file, 3);
  const OIIO::ImageSpec& spec = input->spec();
  Picture picture(spec.width, spec.height);
  bool ok = false;
  if (spec.format == OIIO::TypeDesc::UINT8) {
    ok = input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data());
  } else {
    std::vector<float> values(picture.rgb.size());
    ok = input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data());
    const bool integers = !spec.format.is_floating_point();  // then already sRGB
    std::ranges::transform(values, picture.rgb.begin(),
                           [&](float v) { return integers ? byteOf(v) : encodedByte(v); });
  }
  if (!ok) throw Error(text(file.string(), ": ", input->geterror()));
  return picture;
}

Mask readMask(const fs::path& file) {
  const auto input = openImage(file, 1);
  const OIIO::ImageSpec& spec = input->spec();
  const int channels = spec.nchannels < 3 ? 1 : 3;
  Mask mask{spec.width, spec.height, {}};
  std::vector<float> values(std::size_t(spec.width) * std::size_t(spec.height) *
                            std::size_t(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
    throw Error(text(file.string(), ": ", input->geterror()));
  for (auto value = values.begin(); value != values.end(); value += channels)
    mask.values.push_back(
        std::clamp(std::accumulate(value, value + channels, 0.0f) / float(channels), 0.0f, 1.0f));
  return mask;
}

Picture downscaled(const Picture& picture, int width, int height) {
  require(width >= 1 && height >= 1 && width <= picture.width && height <= picture.height,
          "a picture of ", picture.width, " x ", picture.height, " cannot be made ", width, " x ",
          height, " by averaging");
  Picture smaller(width, height);
  // Each new pixel is the mean of the old ones under it, those at its edges in part.
  const auto spread = [](int from, int to, int i, auto visit) {
    const double scale = double(from) / to, begin = i * scale, end = begin + scale;
    for (int k = int(begin); k < from && k < end; ++k) {
      visit(k, float(std::min(end, k + 1.0) - std::max(begin, double(k))));
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<float, 3> sum{};
      float weight = 0;
      spread(picture.height, height, y, [&](int v, float wy) {
        spread(picture.width, width, x, [&](int u, float wx) {
          const std::uint8_t* from = picture.pixel(u, v);
          for (std::size_t c = 0; c < 3; ++c) sum[c] += wx * wy * linearTable()[from[c]];
          weight += wx * wy;
        });
      });
      for (std::size_t c = 0; c < 3; ++c) {
        smaller.pixel(x, y)[c] = std::uint8_t(255 * srgbFromLinear(sum[c] / weight) + 0.5f);
      }
    }
  }
  return smaller;
}

Picture contactSheet(std::span<const Picture> pictures, int columns, int gap) {
  require(!pictures.empty() && columns >= 1 && gap >= 0,
          "a contact sheet needs a picture and a column");
  const int w = pictures[0].width, h = pictures[0].height, count = int(pictures.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  Picture sheet(columns * (w + gap) + gap, rows * (h + gap) + gap);
  std::ranges::fill(sheet.rgb, std::uint8_t(40));
  for (int i = 0; i < count; ++i) {
    const Picture& p = pictures[std::size_t(i)];
    require(p.width == w && p.height == h, "picture ", i, " of a contact sheet is ", p.width, " x ",
            p.height, " pixels, the first one ", w, " x ", h);
    const int x0 = gap + (i % columns) * (w + gap), y0 = gap + (i / columns) * (h + gap);
    for (int y = 0; y < h; ++y) std::copy_n(p.pixel(0, y), 3 * w, sheet.pixel(x0, y0 + y));
  }
  return sheet;
}

}  // namespace hair::draw
