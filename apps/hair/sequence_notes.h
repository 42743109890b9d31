#pragma once

#include <iostream>

#include <libhair/files/strand_sequence.h>

namespace hair {

/// What somebody who wrote a sequence should know, on the error stream: arrays that move and are
/// kept as in the first frame; files of an earlier run that a reader takes for frames of this one.
inline void printNotes(const std::filesystem::path& file, const StrandSequenceWriter& writer) {
  if (const std::string kept = writer.keptAsFirst(); !kept.empty())
    std::cerr
        << file.string() << ": " << kept
        << " of later frames differ; kept as in the first frame (numbered .hair files hold all)\n";
  const std::vector<std::filesystem::path> others = writer.otherFrames();
  if (others.empty()) return;
  std::cerr << file.string() << ": " << others.size() << " more "
            << (others.size() == 1 ? "file" : "files") << " of that name ("
            << others.front().string();
  if (others.size() > 1) std::cerr << " to " << others.back().string();
  std::cerr << ") are not of this run, and are read as frames of it: remove them, or write under "
               "another name\n";
}

}  // namespace hair
