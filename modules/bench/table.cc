#include "modules/bench/table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>
#include <stdexcept>

namespace regista::bench {
namespace {

/// Fixed point where that is readable, never more than `digits` significant digits behind the point.
std::string readable(double value, int digits) {
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e7)) return fmt::format("{:.{}g}", value, digits);
  const int before = size < 1.0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  return fmt::format("{:.{}f}", value, std::max(0, digits - before));
}

std::string on_terminal(const Cell& cell, int digits) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return std::to_string(*count);
  if (const auto* value = std::get_if<double>(&cell)) return readable(*value, digits);
  return "-";
}

std::string in_csv(const Cell& cell) {
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return std::to_string(*count);
  if (const auto* value = std::get_if<double>(&cell)) return fmt::format("{}", *value);
  const auto* text = std::get_if<std::string>(&cell);
  if (text == nullptr) return "";
  if (text->find_first_of(",\"\n") == std::string::npos) return *text;
  std::string quoted = "\"";
  for (const char c : *text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Letters, not bytes: µ and σ take two.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string head(const Column& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

void print_row(const std::vector<std::string>& row, const std::vector<std::size_t>& widths, std::ostream& out) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string filling(widths[i] - width_of(row[i]), ' ');
    // The first column names the row.
    line += i == 0 ? row[i] + filling : "  " + filling + row[i];
  }
  out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
}

}  // namespace

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns.size()) {
    throw std::invalid_argument("table '" + title + "' has " + std::to_string(columns.size()) + " columns, the row " +
                                std::to_string(row.size()));
  }
  rows.push_back(std::move(row));
}

void print(const Table& table, std::ostream& out) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : table.columns) lines[0].push_back(head(column));
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<std::string>& line = lines.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) line.push_back(on_terminal(row[i], table.columns[i].digits));
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width_of(line[i]));
  }
  out << table.title << '\n';
  for (const auto& line : lines) print_row(line, widths, out);
  for (const std::string& note : table.notes) out << "  " << note << '\n';
  out << std::endl;
}

void write_csv(const Table& table, const Record& record, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "# table: " << table.title << '\n';
  for (const auto& [key, value] : record) out << "# " << key << ": " << value << '\n';
  for (const std::string& note : table.notes) out << "# note: " << note << '\n';
  for (std::size_t i = 0; i < table.columns.size(); ++i) out << (i > 0 ? "," : "") << in_csv(head(table.columns[i]));
  out << '\n';
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i > 0 ? "," : "") << in_csv(row[i]);
    out << '\n';
  }
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + file.string() + ": no such folder, or the disk is full");
}

}  // namespace regista::bench
