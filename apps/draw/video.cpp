#include <apps/draw/video.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <libhair/core/error.h>

namespace hair::draw {
namespace {

namespace fs = std::filesystem;

fs::path findFfmpeg() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / "ffmpeg";
    if (!folder.empty() && ::access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return {};
}

}  // namespace

struct VideoWriter::State {
  fs::path file, part, log;
  int width = 0, height = 0;
  pid_t child = -1;
  int pipe = -1;

  ~State() {
    // Not finished: what is there is no film.
    if (child > 0) stop();
    std::error_code ignored;
    fs::remove(part, ignored);
    fs::remove(log, ignored);
  }

  void start(const fs::path& program, double framesPerSecond, int quality);
  bool stop();
  std::string complaint() const;
};

void VideoWriter::State::start(const fs::path& program, double framesPerSecond, int quality) {
  const std::vector<std::string> words = {
      program.string(), "-y", "-loglevel", "error",
      // In: what `add` sends.
      "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", text(width, "x", height),
      "-framerate", text(framesPerSecond), "-i", "pipe:0", "-an",
      // Out: colours as televisions and browsers expect them, and said so in the file.
      "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-colorspace", "bt709",
      "-color_primaries", "bt709", "-color_trc", "bt709", "-c:v", "libx264", "-preset", "fast",
      "-crf", text(quality), "-pix_fmt", "yuv420p", "-movflags", "+faststart", part.string()};
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  // A socket and not a pipe: writing to a dead reader is then an error and no signal.
  int ends[2];
  require(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0,
          "cannot connect to ffmpeg: ", std::strerror(errno));
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0644);
  // In a process group of its own: an interrupt at the keyboard is ours to handle.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int failed =
      ::posix_spawn(&child, program.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  ::close(ends[0]);
  pipe = ends[1];
  if (failed) child = -1;
  require(!failed, program.string(), ": cannot be started: ", std::strerror(failed));
}

/// Ends the stream and waits. True if ffmpeg was content.
bool VideoWriter::State::stop() {
  ::close(pipe);
  pipe = -1;
  int status = 0;
  pid_t done = 0;
  do {
    done = ::waitpid(child, &status, 0);
  } while (done < 0 && errno == EINTR);
  child = -1;
  return done > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string VideoWriter::State::complaint() const {
  std::ifstream stream(log);
  std::string all, line;
  while (std::getline(stream, line) && all.size() < 1000) all += (all.empty() ? "" : "; ") + line;
  return all.empty() ? "it said nothing" : all;
}

VideoWriter::VideoWriter(const fs::path& file, int width, int height, double framesPerSecond,
                         int quality)
    : state(std::make_unique<State>()) {
  require(width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0 && framesPerSecond > 0,
          file.string(), ": a video of ", width, " x ", height, " pixels at ", framesPerSecond,
          " frames a second; sides must be even, the rate above 0");
  const fs::path program = findFfmpeg();
  require(!program.empty(), file.string(),
          ": the program ffmpeg is needed to write videos: apt-get install ffmpeg");
  const std::string mark = ".part" + std::to_string(::getpid());
  state->file = file;
  state->width = width, state->height = height;
  state->part = file.parent_path() / (file.stem().string() + mark + file.extension().string());
  state->log = file.parent_path() / (file.stem().string() + mark + ".log");
  {
    std::ofstream probe(state->log);
    require(probe.good(), file.string(), ": its folder cannot be written");
  }
  state->start(program, framesPerSecond, quality);
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::add(const Picture& frame) {
  State& s = *state;
  require(frame.width == s.width && frame.height == s.height, s.file.string(), ": a frame of ",
          frame.width, " x ", frame.height, " pixels in a video of ", s.width, " x ", s.height);
  require(s.child > 0, s.file.string(), ": the video is finished, or ffmpeg has given up");
  for (std::size_t sent = 0; sent < frame.rgb.size();) {
    const ssize_t n =
        ::send(s.pipe, frame.rgb.data() + sent, frame.rgb.size() - sent, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      s.stop();
      throw Error(text(s.file.string(), ": ffmpeg has given up: ", s.complaint()));
    }
    sent += std::size_t(n);
  }
}

void VideoWriter::finish() {
  State& s = *state;
  require(s.child > 0, s.file.string(), ": the video is finished, or ffmpeg has given up");
  const bool content = s.stop();
  require(content, s.file.string(), ": ffmpeg failed: ", s.complaint());
  std::error_code failed;
  fs::rename(s.part, s.file, failed);
  require(!failed, s.file.string(), ": ", failed.message());
}

bool videoAvailable() {
  return !findFfmpeg().empty();
}

}  // namespace hair::draw
