#include "modules/regista/status_table.h"

#include <fmt/core.h>

#include <algorithm>

namespace regista {
namespace {

std::string uptime_text(Duration uptime) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(uptime).count();
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string milliseconds(std::int64_t duration_ns) {
  return fmt::format("{:.3f}", static_cast<double>(duration_ns) / 1e6);
}

std::string line_of(const ModuleRow& row) {
  std::string rate = "-", p50 = "-", p99 = "-", refused = "-";
  if (row.status) {
    rate = fmt::format("{:.1f}", row.status->rate_hz);
    p50 = milliseconds(row.status->tick_p50_ns);
    p99 = milliseconds(row.status->tick_p99_ns);
    refused = std::to_string(row.status->refused);
  }
  return fmt::format("{:<14} {:>8} {:<10} {:>9} {:>8} {:>9} {:>9} {:>8}  {}", row.name,
                     row.pid ? std::to_string(*row.pid) : "-", row.state,
                     row.uptime > Duration::zero() ? uptime_text(row.uptime) : "-", rate, p50, p99, refused, row.note);
}

}  // namespace

std::string fit(const std::string& text, std::size_t width) {
  std::string out;
  std::size_t characters = 0;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // the rest of a UTF-8 character
    if (!continues && characters++ == width) break;
    out += (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) ? ' ' : c;
  }
  return out;
}

std::vector<std::string> table_lines(const std::vector<ModuleRow>& rows, std::size_t width) {
  std::vector<std::string> lines{fmt::format("{:<14} {:>8} {:<10} {:>9} {:>8} {:>9} {:>9} {:>8}  {}", "module", "pid",
                                             "state", "uptime", "rate Hz", "p50 ms", "p99 ms", "refused", "note")};
  for (const ModuleRow& row : rows) lines.push_back(line_of(row));
  for (std::string& line : lines) line = fit(line, width);
  return lines;
}

}  // namespace regista
