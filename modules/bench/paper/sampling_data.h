// What the tables of the sampling papers (sbp_*, irrt_*, vis_*) read from their data files: published rows, scenes,
// planners with their settings. A key that is missing or of another type is an error that names file and key.
#pragma once

#include <toml++/toml.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modules/bench/contender.h"

namespace regista::bench {

/// A table of a TOML file. All functions throw std::runtime_error, but for `has` and `number_or`.
class DataTable {
 public:
  /// A file of modules/bench/data/paper/.
  explicit DataTable(const std::string& file);

  bool has(const std::string& key) const { return table_->contains(key); }
  double number(const std::string& key) const;
  double number_or(const std::string& key, double otherwise) const { return has(key) ? number(key) : otherwise; }
  std::size_t count(const std::string& key) const;
  std::string text(const std::string& key) const;
  bool flag(const std::string& key) const;
  std::vector<double> numbers(const std::string& key) const;
  Vec2 point(const std::string& key) const;
  std::vector<Vec2> points(const std::string& key) const;
  DataTable table(const std::string& key) const;
  std::vector<DataTable> tables(const std::string& key) const;  ///< [[key]] [[key]] …

  /// Parameters of planning by dotted key ("ompl.range_m" = 0.15), put onto `params`.
  PlanningParams planning_params(const std::string& key, PlanningParams params = {}) const;

 private:
  DataTable(std::shared_ptr<const toml::table> root, const toml::table* table, std::string place)
      : root_(std::move(root)), table_(table), place_(std::move(place)) {}
  const toml::node& node(const std::string& key) const;
  [[noreturn]] void refuse(const std::string& key, const char* wanted) const;

  std::shared_ptr<const toml::table> root_;
  const toml::table* table_;
  std::string place_;  ///< file and table, for messages
};

/// A row of [[planner]]: `name` as shown, `planner` of the registry where that is another one, `params`.
Contender contender_of(const DataTable& row, const PlanningParams& params = {});
Contenders contenders_of(const std::vector<DataTable>& rows);

}  // namespace regista::bench
