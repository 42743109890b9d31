#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include <apps/draw/picture.h>

namespace hair::draw {

/// Writes a PNG (sRGB). The file appears whole or not at all: it is written beside its place and
/// renamed. Throws Error (file, cause), also for another extension: bytes are no linear picture.
void writeImage(const Picture& picture, const std::filesystem::path& file);

/// Writes an EXR of linear half floats, in the same way; what is beyond their range (65504) is
/// written as its end. Or a PNG, of `encoded`.
void writeImage(const LinearPicture& picture, const std::filesystem::path& file);

/// Whether files of that name hold linear light: .exr.
bool isLinear(const std::filesystem::path& file);

/// As displays show it: sRGB bytes, of what is above 1 255.
Picture encoded(const LinearPicture& picture);

/// Reads a picture of floats (EXR) as it is. Throws Error (file, cause), also for bytes.
LinearPicture readLinearImage(const std::filesystem::path& file);

/// Reads any picture that OpenImageIO reads, as 8-bit RGB. Throws Error (file, cause).
Picture readImage(const std::filesystem::path& file);

/// What a picture says about places: 0 black to 1 white, rows from top to bottom without padding.
struct Mask {
  int width = 0, height = 0;
  std::vector<float> values;  ///< [height·width]
};

/// Reads any picture that OpenImageIO reads, grey or the mean of red, green and blue, as the file
/// has them: half-way between black and white is 0.5. Throws Error (file, cause).
Mask readMask(const std::filesystem::path& file);

/// Smaller by averaging in linear light. Throws Error when either side would grow or vanish.
Picture downscaled(const Picture& picture, int width, int height);

/// Pictures of one size in rows from left to right, `gap` pixels of dark grey around each.
/// Throws Error when sizes differ, or none is given.
Picture contactSheet(std::span<const Picture> pictures, int columns, int gap = 4);

}  // namespace hair::draw
