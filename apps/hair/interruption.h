#pragma once

#include <atomic>
#include <csignal>
#include <iostream>

namespace hair {

/// Ctrl-C (SIGINT) and SIGTERM as a question that a long loop asks between two frames, so that
/// files are closed or removed before the program ends. The second signal ends it at once. What
/// the program was started to ignore (nohup, a shell's background) stays ignored. One at a time.
///
///   Interruption interruption;
///   for (...) { if (interruption.asked()) break; ... }
///   if (interruption.asked()) interruption.end();
class Interruption {
 public:
  Interruption() {
    signal_ = 0;
    for (const int signal : {SIGINT, SIGTERM})
      if (std::signal(signal, note) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  ~Interruption() {
    for (const int signal : {SIGINT, SIGTERM})
      if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool asked() const { return signal_ != 0; }
  /// Ends the program by the signal that asked: shells see 130 or 143, and a script stops too.
  void end() const {
    std::cout.flush();
    std::signal(signal_, SIG_DFL);
    std::raise(signal_);
  }

 private:
  static void note(int signal) {
    std::signal(signal, SIG_DFL);
    signal_ = signal;
  }

  static inline std::atomic<int> signal_ = 0;
  static_assert(std::atomic<int>::is_always_lock_free);  // else no place for a handler to write
};

}  // namespace hair
