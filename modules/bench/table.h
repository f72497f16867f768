// Measured numbers in rows: aligned for a terminal, and as CSV under the record of the run.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

#include "modules/bench/record.h"

namespace regista::bench {

struct Column {
  std::string name;
  std::string unit = {};  ///< "" for none
  int digits = 4;         ///< significant digits of numbers on the terminal; the CSV has all of them
};

/// Nothing, text, a count, or a number.
using Cell = std::variant<std::monostate, std::string, std::int64_t, double>;

struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::string> notes = {};  ///< printed below, and in the CSV's head
  std::vector<std::vector<Cell>> rows = {};

  /// Throws std::invalid_argument where the row has not one cell per column.
  void add(std::vector<Cell> row);
};

inline Cell count_cell(std::size_t count) { return static_cast<std::int64_t>(count); }

void print(const Table& table, std::ostream& out);

/// Head: "# key: value" lines; then "name [unit]", then the rows, by RFC 4180. Throws std::runtime_error when it cannot
/// be written.
void write_csv(const Table& table, const Record& record, const std::filesystem::path& file);

}  // namespace regista::bench
