#include "modules/regista/display.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace regista {
namespace {

constexpr std::size_t kEventsShown = 6;
constexpr Duration kRedrawEvery = std::chrono::milliseconds(500);  // modules report once a second
constexpr Duration kPrintEvery = std::chrono::seconds(5);
constexpr std::size_t kPlainWidth = 200;

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 120;
}

}  // namespace

Display::Display() : is_terminal_(isatty(STDOUT_FILENO) == 1) {}

void Display::event(const std::string& line) {
  if (!is_terminal_) {
    fmt::print("{}\n", fit(line, kPlainWidth));
    std::fflush(stdout);
    return;
  }
  events_.push_back(line);
  if (events_.size() > kEventsShown) events_.pop_front();
  next_ = Time{};  // show it at once
}

void Display::update(Time now, const std::vector<ModuleRow>& rows) {
  if (now < next_) return;
  if (is_terminal_) {
    redraw(rows);
    next_ = now + kRedrawEvery;
    return;
  }
  const bool first = next_ == Time{};
  next_ = now + kPrintEvery;
  if (first) return;  // nothing to tell yet
  for (const std::string& line : table_lines(rows, kPlainWidth)) fmt::print("{}\n", line);
  std::fflush(stdout);
}

void Display::redraw(const std::vector<ModuleRow>& rows) {
  const std::size_t width = terminal_width();
  std::vector<std::string> lines = table_lines(rows, width);
  for (const std::string& line : events_) lines.push_back(fit(line, width));
  // ANSI: up to where the last table began, then clear to the end of the screen.
  if (drawn_lines_ > 0) fmt::print("\033[{}A", drawn_lines_);
  fmt::print("\r\033[J");
  for (const std::string& line : lines) fmt::print("{}\n", line);
  std::fflush(stdout);
  drawn_lines_ = lines.size();
}

}  // namespace regista
