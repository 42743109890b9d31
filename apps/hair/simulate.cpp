#include <fstream>
#include <iostream>
#include <optional>

#include <apps/common/progress.h>
#include <apps/hair/commands.h>
#include <apps/hair/interruption.h>
#include <apps/hair/sequence_notes.h>
#include <libhair/core/error.h>
#include <libhair/core/parallel.h>
#include <libhair/files/atomic_write.h>
#include <libhair/files/strand_sequence.h>

namespace hair {

namespace {

// strands.hair -> strands.####.hair: a file a frame where one cannot hold them all.
std::filesystem::path sequenceName(const std::filesystem::path& file) {
  if (file.empty() || holdsSequence(file)) return file;
  std::filesystem::path out = file;
  return out.replace_extension("####" + file.extension().string());
}

void load(const std::filesystem::path& file, Player& player) {
  std::ifstream in(file, std::ios::binary);
  require(in.is_open(), file.string(), ": cannot read");
  try {
    player.resume(in);
  } catch (const Error& error) {
    throw Error(text(file.string(), ": ", error.what()));
  }
}

}  // namespace

void runSimulate(const SimulateOptions& options) {
  const ThreadLimit limit(options.threads);
  const Character character(options.character);
  for (const std::string& note : character.notes) std::cerr << note << '\n';
  PlayerOptions performing = options.player;
  // Shadows are work only for those who look at their times.
  performing.shadow = performing.shadow && !options.results.profile.empty();
  Player player(character, performing);
  player.settings.shade = performing.shadow;
  if (!options.loadState.empty()) load(options.loadState, player);
  const Interruption interruption;
  const std::filesystem::path cacheName = sequenceName(options.cache);
  std::optional<StrandSequenceWriter> cache;
  if (!options.cache.empty()) cache.emplace(cacheName, SequenceOptions{.fps = options.player.fps});
  StatsLog stats;
  Progress progress("simulate", options.frames);
  int frame = 0;
  for (; frame < options.frames && !interruption.asked(); ++frame) {
    player.step();
    if (!options.results.stats.empty()) stats.add(player);
    if (cache) cache->add(player.hair.strands());
    progress.step();
  }
  progress.finish();
  // What is done is worth as much as a shorter run: it is written, and the program ends then.
  if (interruption.asked()) {
    std::cerr << "interrupted after " << frame << " of " << options.frames
              << " frames: what is written ends there\n";
    if (frame == 0) {
      cache.reset();
      interruption.end();
    }
  }
  if (cache) {
    cache->close();
    printNotes(cacheName, *cache);
  }
  if (!options.saveState.empty())
    writeAtomically(options.saveState, [&](std::ostream& out) { player.simulation.save(out); });
  writeResults(options.results, player, player.log, stats);
  if (interruption.asked()) interruption.end();
}

}  // namespace hair
