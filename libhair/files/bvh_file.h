#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include <libhair/core/api.h>

namespace HAIR_API hair {

/// Contents of a BVH motion capture file: a tree of joints and one row of numbers a frame.
///
/// Units are the file's own: offsets and positions mostly centimetres, rotations degrees. Convert
/// them when making transforms (motion/: 0.01 to metres).
struct Bvh {
  /// Meaning of one number of a row.
  enum class Channel : std::uint8_t {
    Xposition,  ///< along X, the file's unit
    Yposition,  ///< along Y, the file's unit
    Zposition,  ///< along Z, the file's unit
    Xrotation,  ///< about X, degrees
    Yrotation,  ///< about Y, degrees
    Zrotation,  ///< about Z, degrees
  };

  /// A joint, and which numbers of a row move it.
  struct Joint {
    std::string name;                ///< for an end site: "<parent's name> end"
    int parent = -1;                 ///< index of a joint before this one; -1: a root
    glm::vec3 offset{0};             ///< from the parent, at rest
    std::vector<Channel> channels;   ///< in the file's order, any count, none for an end site
    std::uint32_t firstChannel = 0;  ///< where this joint's channels start in a row of values
    bool endSite = false;            ///< tip of a bone without channels
  };

  std::vector<Joint> joints;     ///< [jointCount], parents before children, in the file's order
  std::size_t channelCount = 0;  ///< of all joints together
  double frameTime = 0;          ///< seconds
  std::vector<float> values;     ///< [frameCount · channelCount], frame by frame
  /// What the file does otherwise than the format wants and was made good, for the user; no name of
  /// the file in it.
  std::vector<std::string> notes;

  /// How many rows of values there are.
  std::size_t frameCount() const { return channelCount == 0 ? 0 : values.size() / channelCount; }
  /// The row of frame f: [channelCount].
  std::span<const float> frame(std::size_t f) const {
    return std::span(values).subspan(f * channelCount, channelCount);
  }
  /// Index of the joint of that name, -1 where there is none; `ignoreCase`: "head" finds "Head".
  int find(std::string_view name, bool ignoreCase = false) const;
};

/// Reads a BVH file: any tree, any channels in any order, and the dialects of the programs that
/// write them. Keywords in any case; words and braces separated by blanks or lines as they come;
/// comments (#, //, ;); end sites with names or channels. Rows may wrap over lines; more rows than
/// announced are read, one less is forgiven, and so is text after the last; a frame time that can
/// only be a rate or milliseconds is taken as such (frameTimeMeant). `notes` tells which of these
/// changed anything. Throws Error (file, line, cause) for what cannot be understood.
Bvh readBvh(const std::filesystem::path& file);

/// The same from bytes in memory; `name` names the file in messages.
Bvh parseBvh(std::string_view bytes, std::string_view name);

/// Seconds that a `Frame Time` stands for. Below 1: those seconds. Above: frames a second where
/// that is a usual rate (30, 59.94, 120 ...), else milliseconds. Zero: 1/60. To seven decimals, as
/// frame times are written. `stated` must not be negative.
double frameTimeMeant(double stated);

}  // namespace hair
