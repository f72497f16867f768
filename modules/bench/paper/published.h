// The rows that a paper prints: data, in a file of modules/bench/data/paper/.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace regista::bench {

/// As much of a row as is printed.
struct PublishedRow {
  std::string where;  ///< scenario; "" where the table has one only
  std::string what;   ///< quantity
  std::string who;    ///< planner or variant
  double mean = 0.0;
  std::optional<double> sigma, min, max;
  bool operator==(const PublishedRow&) const = default;
};

struct Published {
  std::size_t samples = 0;                   ///< of the paper's tests
  std::map<std::string, std::string> units;  ///< by quantity, of all tables of the file
  std::vector<PublishedRow> rows;
};

/// One table of a file of modules/bench/data/paper/. Throws std::runtime_error naming the file where it makes no sense
/// or has no such table.
Published load_published(const std::string& file, const std::string& table);

}  // namespace regista::bench
