// hair simulate: runs that are cut in two.
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include <apps/common/player.h>
#include <libhair/core/state_hash.h>
#include <libhair/files/strand_sequence.h>
#include <tests/apps/outcome.h>
#include <tests/files/samples.h>

namespace hair {
namespace {

std::string lastLine(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

TEST(Simulate, ARunThatIsSavedAndLoadedHasTheHashOfOneInOneGo) {
  const TemporaryFolder folder;
  const std::string state = (folder / "at.state").string();
  const std::string scene = "simulate --strands 200 --settle 0.05 --wind 1,0,0 --no-shadow ";
  const Outcome whole = run(scene + "--frames 11 --hash");
  ASSERT_EQ(whole.code, 0) << whole.out;
  ASSERT_TRUE(lastLine(whole.out).starts_with("hash ")) << whole.out;
  const Outcome first = run(scene + "--frames 6 --save-state " + state);
  ASSERT_EQ(first.code, 0) << first.out;
  const Outcome second = run(scene + "--frames 5 --hash --load-state " + state);
  ASSERT_EQ(second.code, 0) << second.out;
  EXPECT_EQ(lastLine(second.out), lastLine(whole.out));

  const Outcome other = run("simulate --style long --frames 1 --load-state " + state);
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.out.find(state + ": saved state: of another groom"), std::string::npos)
      << other.out;
  std::ofstream(state, std::ios::binary) << "HAIR";
  const Outcome cut = run(scene + "--frames 1 --load-state " + state);
  EXPECT_EQ(cut.code, 1);
  EXPECT_NE(cut.out.find("truncated"), std::string::npos) << cut.out;
}

std::uint64_t hashOf(std::span<const glm::vec3> points) {
  StateHash hash;
  hash.add(points);
  return hash.value();
}

TEST(Simulate, ACacheHoldsEveryFrameBitForBit) {
  const TemporaryFolder folder;
  const std::string scene = "simulate --strands 200 --settle 0.05 --no-shadow --frames 5 --fps 24 ";
  for (const char* name : {"one.usda", "many.##.ply", "plain.hair"}) {
    const Outcome outcome = run(scene + "--cache " + (folder / name).string());
    ASSERT_EQ(outcome.code, 0) << outcome.out;
  }

  CharacterOptions hair;
  hair.strands = 200;
  const Character character(hair);
  PlayerOptions options;
  options.settle = 0.05f;
  options.fps = 24;
  options.shadow = false;
  Player player(character, options);
  player.settings.shade = false;
  for (std::size_t f = 0; f < 5; ++f) {
    player.step();
    const std::uint64_t hash = hashOf(player.hair.strands().points);
    for (const char* name : {"one.usda", "many.##.ply", "plain.####.hair"}) {
      StrandSequenceReader reader(folder / name);
      ASSERT_EQ(reader.frameCount(), 5u) << name;
      StrandFile read;
      reader.read(f, read);
      EXPECT_EQ(hashOf(read.strands.points), hash) << name << ' ' << f;
    }
  }
}

std::size_t fileCount(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                std::filesystem::directory_iterator()));
}

TEST(Simulate, AShorterRunSaysWhichFilesOfALongerOneAreLeft) {
  const TemporaryFolder folder;
  const std::string cache = (folder / "s.##.hair").string();
  const std::string scene =
      "simulate --strands 200 --settle 0.05 --no-shadow --cache " + cache + " --frames ";
  EXPECT_EQ(run(scene + "4").out.find("not of this run"), std::string::npos);
  const Outcome shorter = run(scene + "2");
  EXPECT_EQ(shorter.code, 0);
  EXPECT_NE(shorter.out.find("2 more files of that name (" + (folder / "s.02.hair").string() +
                             " to " + (folder / "s.03.hair").string() + ") are not of this run"),
            std::string::npos)
      << shorter.out;
}

// Starts a run, sends it the signal once frames are there, and returns what it said and how it
// ended.
std::string interrupted(const TemporaryFolder& folder, const std::string& cache,
                        const char* signal) {
  const pid_t child = fork();
  const std::string out = (folder / "out").string(), frames = (folder / cache).string();
  if (child == 0) {
    // A test that is run in the background may ignore what is tested here.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    const std::string command = std::string("exec ") + HAIR_PROGRAM +
                                " simulate --strands 200 --settle 0.05 --no-shadow "
                                "--frames 1000000 --cache '" +
                                frames + "' > " + out + " 2>&1";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  // Files of the run, and bytes in them: out, and at least one frame.
  const auto begun = [&] {
    std::error_code gone;
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      if (entry.path().filename() != "out") bytes += entry.file_size(gone);
    return bytes > 1000000;
  };
  int status = 0;
  pid_t ended = 0;
  while (!begun() && (ended = waitpid(child, &status, WNOHANG)) == 0) usleep(10000);
  if (ended == 0) {
    kill(child, std::string(signal) == "INT" ? SIGINT : SIGTERM);
    waitpid(child, &status, 0);
  }
  std::ifstream in(out);
  const std::string said(std::istreambuf_iterator<char>(in), {});
  return text(said, "\nsignal ", WIFSIGNALED(status) ? WTERMSIG(status) : 0, '\n');
}

TEST(Simulate, AnInterruptedCacheHoldsTheFramesThatAreDone) {
  for (const char* name : {"a.usda", "a.####.hair"})
    for (const char* signal : {"INT", "TERM"}) {
      SCOPED_TRACE(text(name, ' ', signal));
      const TemporaryFolder folder;
      const std::string out = interrupted(folder, name, signal);
      EXPECT_TRUE(out.ends_with(text("signal ", signal[0] == 'I' ? SIGINT : SIGTERM, '\n'))) << out;
      const std::size_t said = out.find("interrupted after ");
      ASSERT_NE(said, std::string::npos) << out;
      StrandSequenceReader reader(folder / name);
      EXPECT_GE(reader.frameCount(), 1u);
      EXPECT_NE(out.find(text("interrupted after ", reader.frameCount(), " of 1000000")),
                std::string::npos)
          << out;
      StrandFile read;
      reader.read(reader.frameCount() - 1, read);
      // The words, the frames, and nothing hidden.
      EXPECT_EQ(fileCount(folder.path()), 1 + (isNumbered(name) ? reader.frameCount() : 1));
    }
}

TEST(Convert, KeepsTimeCodesAndNumbers) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder / name).string(); };
  StrandFile strands;
  strands.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.25f, 0}});
  StrandSequenceWriter writer(path("shot.usda"), {.fps = 24});
  for (int time : {1001, 1003, 1009}) writer.addAt(time, strands);
  writer.close();
  const auto timesOf = [&](const char* name) {
    StrandSequenceReader reader(path(name));
    std::vector<double> times;
    for (std::size_t f = 0; f < reader.frameCount(); ++f) times.push_back(reader.timeCode(f));
    return times;
  };
  const auto convert = [&](const char* in, const char* out, const char* options = "") {
    const Outcome outcome = run("convert " + path(in) + ' ' + path(out) + options);
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    return outcome.out;
  };
  const std::vector<double> uneven = {1001, 1003, 1009};
  EXPECT_NE(convert("shot.usda", "same.usda").find("times are uneven, and kept"),
            std::string::npos);
  EXPECT_EQ(timesOf("same.usda"), uneven);
  EXPECT_EQ(StrandSequenceReader(path("same.usda")).codesPerSecond(), 24);
  EXPECT_NE(convert("shot.usda", "apart.####.ply").find("do not state the rate: 24 a second"),
            std::string::npos);
  EXPECT_EQ(timesOf("apart.####.ply"), uneven);
  EXPECT_NE(convert("apart.####.ply", "back.usda").find("taken as 60 a second"), std::string::npos);
  EXPECT_EQ(timesOf("back.usda"), uneven);
  convert("apart.####.ply", "other.##.hair", " --frame 1");
  EXPECT_EQ(timesOf("other.##.hair"), std::vector<double>{1003});
  EXPECT_NE(convert("apart.####.ply", "other.##.hair").find("times are uneven"), std::string::npos);
  std::filesystem::remove(path("other.1003.hair"));
  std::filesystem::rename(path("other.1009.hair"), path("other.1012.hair"));
  const std::string again = convert("apart.####.ply", "other.##.hair");
  EXPECT_NE(again.find("1 more file of that name (" + path("other.1012.hair") + ')'),
            std::string::npos)
      << again;

  StrandSequenceWriter halves(path("halves.usda"), {.fps = 24});
  for (double time : {7.5, 8.0, 8.5}) halves.addAt(time, strands);
  halves.close();
  EXPECT_NE(convert("halves.usda", "halves.#.ply").find("times are not whole"), std::string::npos);
  EXPECT_EQ(timesOf("halves.#.ply"), (std::vector<double>{7, 8, 9}));
}

TEST(Convert, SaysWhatMovesAndIsKeptAsInTheFirstFrame) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder / name).string(); };
  StrandFile strands;
  strands.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.25f, 0}});
  StrandSequenceWriter writer(path("a.#.hair"));
  for (int f = 0; f < 3; ++f) {
    if (f == 2) strands.defaultThickness = 1e-4f, strands.defaultColour = {1, 0, 0};
    writer.add(strands);
  }
  writer.close();
  const Outcome kept = run("convert " + path("a.#.hair") + ' ' + path("a.usda"));
  EXPECT_NE(kept.out.find("thickness, colours of later frames differ; kept as in the first frame"),
            std::string::npos)
      << kept.out;
  const Outcome none = run("convert " + path("a.#.hair") + ' ' + path("b.#.ply"));
  EXPECT_EQ(none.out.find("kept as in"), std::string::npos) << none.out;
  // What a format has no room for may come late.
  const Outcome lost = run("convert " + path("a.#.hair") + ' ' + path("b.#.obj"));
  EXPECT_NE(lost.out.find(".obj has no room for: thickness, colours"), std::string::npos)
      << lost.out;
}

TEST(Convert, TakesSequencesApartAndTogether) {
  const TemporaryFolder folder;
  const std::string shot = (folder / "shot.usda").string();
  StrandFile strands;
  strands.strands.append(std::vector<glm::vec3>{{0, 0, 0}, {0, 0.25f, 0}});
  strands.strands.append(std::vector<glm::vec3>{{1, 0, 0}, {1, 0.25f, 0}, {1, 0.25f, 0.5f}});
  strands.defaultThickness = 1e-4f;
  StrandSequenceWriter writer(shot, {.fps = 25});
  for (int f = 0; f < 3; ++f) {
    strands.strands.points[4].z = static_cast<float>(1 + f);
    writer.add(strands);
  }
  writer.close();
  EXPECT_NE(run("info " + shot).out.find("3, 0.08 s"), std::string::npos);

  const std::string plys = (folder / "shot.#.ply").string(), back = (folder / "b.usda").string();
  const Outcome apart = run("convert " + shot + ' ' + plys + " --out-scale 0.5 --out-up z-back");
  EXPECT_NE(apart.out.find("3 frames"), std::string::npos) << apart.out;
  EXPECT_EQ(run("convert " + plys + ' ' + back).code, 0);
  StrandSequenceReader reader(back);
  ASSERT_EQ(reader.frameCount(), 3u);
  StrandFile read;
  reader.read(2, read);
  EXPECT_EQ(read.strands.points, strands.strands.points);

  const std::string tfx = (folder / "a.tfx").string();
  const Outcome unequal = run("convert " + shot + ' ' + tfx);
  EXPECT_EQ(unequal.code, 1);
  EXPECT_NE(unequal.out.find("resample"), std::string::npos) << unequal.out;
  const Outcome one = run("convert " + shot + ' ' + tfx + " --points 8 --frame 1");
  EXPECT_EQ(one.code, 0) << one.out;
  EXPECT_NE(one.out.find(".tfx has no room for: thickness"), std::string::npos) << one.out;
  EXPECT_EQ(readStrands(tfx).strands.points[15].z, 2.0f);
  EXPECT_NE(run("convert " + shot + ' ' + tfx + " --frame 3").out.find("there are 3"),
            std::string::npos);
}

}  // namespace
}  // namespace hair
