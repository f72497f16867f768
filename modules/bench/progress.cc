#include "modules/bench/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace regista::bench {
namespace {

constexpr double kTerminalEvery_s = 0.1;
constexpr double kLineEvery_s = 10.0;
constexpr std::size_t kBarWidth = 30;

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  constexpr const char* kEraseLine = "\r\x1b[K";
  if (terminal_ && shown_at_s_ > 0.0) std::fputs(kEraseLine, stderr);
}

void Progress::advance(std::size_t steps) {
  done_ += steps;
  const double now_s = since_.s();
  if (now_s - shown_at_s_ < (terminal_ ? kTerminalEvery_s : kLineEvery_s)) return;
  shown_at_s_ = now_s;
  show();
}

void Progress::show() const {
  const double share = total_ == 0 ? 1.0 : std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_));
  const double left_s = share > 0.0 ? shown_at_s_ * (1.0 - share) / share : 0.0;
  if (terminal_) {
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(kBarWidth));
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    std::fprintf(stderr, "\r%s [%s] %3.0f %%, %.0f s left ", what_.c_str(), bar.c_str(), 100.0 * share, left_s);
    std::fflush(stderr);
  } else {
    std::fprintf(stderr, "%s: %zu of %zu, %.0f s left\n", what_.c_str(), done_, total_, left_s);
  }
}

}  // namespace regista::bench
