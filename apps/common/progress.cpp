#include <apps/common/progress.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace hair {

namespace {

constexpr std::chrono::milliseconds kTerminalPause{100};
constexpr std::chrono::seconds kLogPause{5};
constexpr int kBarCells = 24;

// 0:07, 12:34, 1:02:03
std::string duration(double seconds) {
  const std::int64_t s = std::llround(seconds);
  std::ostringstream out;
  out << std::setfill('0');
  if (s >= 3600) out << s / 3600 << ':' << std::setw(2);
  out << s / 60 % 60 << ':' << std::setw(2) << s % 60;
  return out.str();
}

}  // namespace

Progress::Progress(std::string what, std::int64_t total)
    : Progress(std::move(what), total, std::cerr, isatty(STDERR_FILENO) == 1, Clock::now) {}

Progress::Progress(std::string what, std::int64_t total, std::ostream& out, bool terminal,
                   Clock::time_point (*now)())
    : what_(std::move(what)),
      total_(total),
      out_(out),
      terminal_(terminal),
      now_(now),
      start_(now()),
      due_(start_ + (terminal ? Clock::duration(kTerminalPause) : Clock::duration(kLogPause))) {}

Progress::~Progress() {
  finish();
}

void Progress::step(std::int64_t items) {
  done_ += items;
  const auto time = now_();
  if (finished_ || time < due_) return;
  print(time);
  due_ = time + (terminal_ ? Clock::duration(kTerminalPause) : Clock::duration(kLogPause));
}

void Progress::finish() {
  if (finished_) return;
  finished_ = true;
  if (!terminal_ || width_ == 0) return;
  print(now_());
  out_ << '\n' << std::flush;
}

void Progress::print(Clock::time_point time) {
  const double elapsed = std::chrono::duration<double>(time - start_).count();
  const double part =
      total_ > 0 ? std::clamp(static_cast<double>(done_) / static_cast<double>(total_), 0.0, 1.0)
                 : 0.0;
  std::ostringstream line;
  line << what_ << ' ';
  if (terminal_) {
    const int filled = static_cast<int>(part * kBarCells);
    line << '[' << std::string(static_cast<std::size_t>(filled), '#')
         << std::string(static_cast<std::size_t>(kBarCells - filled), '.') << "] ";
  }
  line << done_ << '/' << total_;
  if (done_ > 0 && elapsed > 0) {
    const double rate = static_cast<double>(done_) / elapsed;
    line << ", " << std::fixed << std::setprecision(rate < 10 ? 2 : 0) << rate << "/s, ";
    if (done_ < total_)
      line << duration(static_cast<double>(total_ - done_) / rate) << " left";
    else
      line << duration(elapsed) << " taken";
  }
  std::string text = line.str();
  const std::size_t width = text.size();
  if (!terminal_) {
    out_ << text << '\n' << std::flush;
    return;
  }
  if (width < width_) text.append(width_ - width, ' ');  // wipes the rest of a longer line
  width_ = width;
  out_ << '\r' << text << std::flush;
}

}  // namespace hair
