#pragma once

#include <filesystem>
#include <iosfwd>
#include <string_view>

#include <libhair/files/strand_file.h>

namespace hair {

/// One format of strands: what reads and writes it, in the file's own units.
struct StrandFormat {
  std::string_view name;  ///< the extension without its dot
  /// `scale` and `up` of what it returns are what the file states, or else the format's default.
  /// Of `options` a format takes what concerns its contents.
  StrandFile (*read)(const std::filesystem::path& file, const ReadOptions& options);
  /// Strands that have been checked and are in units of `scale` and `up`; null: it is only read.
  void (*write)(std::ostream& out, const StrandFile& strands);
  bool holdsArrays;         ///< thickness, transparency and colours
  std::size_t leastPoints;  ///< of a strand
};

/// By the extension, of any case; null where it is none of theirs.
const StrandFormat* findFormat(const std::filesystem::path& file);
/// Throws Error that names the formats there are.
const StrandFormat& formatOf(const std::filesystem::path& file);

/// What follows a format's `read`: from the file's units into metres, +Y up, where options override
/// what the file states; `arrays` named; checked.
void finishReading(const ReadOptions& options, std::string_view name, StrandFile& strands);
/// Checked, and in the units of a file to be written; the strands themselves where these are
/// metres, +Y up, else a copy in `scratch`. `name` names the file in messages.
const StrandFile& prepared(const StrandFormat& format, const WriteOptions& options,
                           std::string_view name, const StrandFile& strands, StrandFile& scratch);

}  // namespace hair
