#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <apps/hair/commands.h>
#include <libhair/core/strands.h>
#include <libhair/model/groom.h>

namespace hair {

/// The hair that `hair measure` measures: metres, +Y up.
struct MeasuredHair {
  std::string name;  ///< "straight.hair", "smooth style"
  StrandSet strands;
  Fibre fibre;  ///< of the truth and all methods: a strand is one tube of `width`
  std::vector<std::string> notes;  ///< what was assumed or dropped

  /// Strand and point (counted over all strands) of the file, or of the style, that a point of
  /// `strands` was: what was dropped before it is counted too. Where points were asked for anew
  /// (--points), those of `strands`.
  struct Origin {
    std::uint32_t strand, point;
  };
  Origin origin(std::uint32_t strand, std::uint32_t point) const;

  std::vector<std::uint32_t> fileStrand, fileFirst;  ///< [strandCount]; empty: as in `strands`
};

/// Reads or grows the hair of --hair or --style. Strands of a file stay where and as they are,
/// but for degenerate ones, and for --strands and --points. Throws Error.
MeasuredHair measuredHair(const MeasureOptions& options);

}  // namespace hair
