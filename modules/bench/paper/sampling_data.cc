#include "modules/bench/paper/sampling_data.h"

#include <stdexcept>

#include "modules/bench/grid.h"

namespace regista::bench {
namespace {

std::shared_ptr<const toml::table> parsed(const std::string& file) {
  try {
    return std::make_shared<const toml::table>(toml::parse_file(data_file("paper/" + file).string()));
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file + ": " + std::string(error.description()));
  }
}

std::optional<double> number_of(const toml::node& node) {
  if (const auto* value = node.as_floating_point()) return value->get();
  if (const auto* value = node.as_integer()) return static_cast<double>(value->get());
  return {};
}

std::optional<Vec2> point_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() != 2) return {};
  const std::optional<double> x = number_of((*list)[0]);
  const std::optional<double> y = number_of((*list)[1]);
  if (!x || !y) return {};
  return Vec2(*x, *y);
}

}  // namespace

DataTable::DataTable(const std::string& file) : root_(parsed(file)), table_(root_.get()), place_(file) {}

void DataTable::refuse(const std::string& key, const char* wanted) const {
  throw std::runtime_error(place_ + ": " + key + " must be " + wanted);
}

const toml::node& DataTable::node(const std::string& key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) refuse(key, "there");
  return *node;
}

double DataTable::number(const std::string& key) const {
  const std::optional<double> value = number_of(node(key));
  if (!value) refuse(key, "a number");
  return *value;
}

std::size_t DataTable::count(const std::string& key) const {
  const auto* value = node(key).as_integer();
  if (value == nullptr || value->get() < 0) refuse(key, "a count");
  return static_cast<std::size_t>(value->get());
}

std::string DataTable::text(const std::string& key) const {
  const auto* value = node(key).as_string();
  if (value == nullptr) refuse(key, "text");
  return value->get();
}

bool DataTable::flag(const std::string& key) const {
  const auto* value = node(key).as_boolean();
  if (value == nullptr) refuse(key, "true or false");
  return value->get();
}

std::vector<double> DataTable::numbers(const std::string& key) const {
  const toml::array* list = node(key).as_array();
  if (list == nullptr || list->empty()) refuse(key, "a list of numbers");
  std::vector<double> out;
  for (const toml::node& item : *list) {
    const std::optional<double> value = number_of(item);
    if (!value) refuse(key, "a list of numbers");
    out.push_back(*value);
  }
  return out;
}

Vec2 DataTable::point(const std::string& key) const {
  const std::optional<Vec2> value = point_of(node(key));
  if (!value) refuse(key, "a point [x, y]");
  return *value;
}

std::vector<Vec2> DataTable::points(const std::string& key) const {
  const toml::array* list = node(key).as_array();
  if (list == nullptr) refuse(key, "a list of points [x, y]");
  std::vector<Vec2> out;
  for (const toml::node& item : *list) {
    const std::optional<Vec2> value = point_of(item);
    if (!value) refuse(key, "a list of points [x, y]");
    out.push_back(*value);
  }
  return out;
}

DataTable DataTable::table(const std::string& key) const {
  const toml::table* table = node(key).as_table();
  if (table == nullptr) refuse(key, "a table");
  return DataTable(root_, table, place_ + " [" + key + "]");
}

std::vector<DataTable> DataTable::tables(const std::string& key) const {
  const toml::array* list = node(key).as_array();
  if (list == nullptr) refuse(key, "a list of tables");
  std::vector<DataTable> out;
  for (const toml::node& item : *list) {
    if (!item.is_table()) refuse(key, "a list of tables");
    out.push_back(DataTable(root_, item.as_table(), place_ + " [[" + key + "]] " + std::to_string(out.size() + 1)));
  }
  return out;
}

PlanningParams DataTable::planning_params(const std::string& key, PlanningParams params) const {
  if (!has(key)) return params;
  const toml::table* list = node(key).as_table();
  if (list == nullptr) refuse(key, "a table");
  for (const auto& [name, value] : *list) {
    const std::optional<double> number = number_of(value);
    const auto* flag = value.as_boolean();
    if (!number && flag == nullptr) refuse(key, "numbers or true/false");
    set_param(params, std::string(name.str()),
              number ? params_detail::print(*number) : params_detail::print(flag->get()));
  }
  return params;
}

Contender contender_of(const DataTable& row, const PlanningParams& params) {
  const std::string name = row.text("name");
  const std::string planner = row.has("planner") ? row.text("planner") : name;
  return {name, make_planner(planner, row.planning_params("params", params))};
}

Contenders contenders_of(const std::vector<DataTable>& rows) {
  Contenders out;
  for (const DataTable& row : rows) out.push_back(contender_of(row));
  return out;
}

}  // namespace regista::bench
