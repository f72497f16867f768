#include "modules/bench/paper/comparison.h"

#include <algorithm>

namespace regista::bench {
namespace {

/// Where, what, and who of a row or sample.
struct Key {
  std::string where, what, who;
  bool operator==(const Key&) const = default;
};

template <class Row>
Key key_of(const Row& row) {
  return {row.where, row.what, row.who};
}

template <class Row>
const Row* find(const std::vector<Row>& rows, const Key& key) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return key_of(row) == key; });
  return found == rows.end() ? nullptr : &*found;
}

/// Quantities of a scenario stand together, published planners first.
std::vector<Key> ordered(const Published& published, const std::vector<Sampled>& sampled) {
  std::vector<Key> all;
  const auto add = [&](const Key& key) {
    if (std::find(all.begin(), all.end(), key) != all.end()) return;
    const auto last = std::find_if(
        all.rbegin(), all.rend(), [&](const Key& other) { return other.where == key.where && other.what == key.what; });
    all.insert(last == all.rend() ? all.end() : last.base(), key);
  };
  for (const PublishedRow& row : published.rows) add(key_of(row));
  for (const Sampled& sample : sampled) add(key_of(sample));
  return all;
}

Cell cell(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

std::string unit_of(const Published& published, const std::string& what) {
  const auto found = published.units.find(what);
  return found == published.units.end() ? "" : found->second;
}

Summary as_box(const PublishedRow& row) {
  Summary box;
  box.count = 1;
  box.mean = box.p25 = box.p50 = box.p75 = row.mean;
  box.min = row.min.value_or(row.mean);
  box.max = row.max.value_or(row.mean);
  return box;
}

/// So that whiskers do not end on the border.
void leave_room(Plot& plot) {
  constexpr double kShare = 0.05;
  if (plot.boxes.empty()) return;
  double low = plot.boxes[0].summary.min;
  double high = plot.boxes[0].summary.max;
  for (const Box& box : plot.boxes) {
    low = std::min(low, box.summary.min);
    high = std::max(high, box.summary.max);
  }
  if (low == high) return;
  plot.y.low = low - kShare * (high - low);
  plot.y.high = high + kShare * (high - low);
}

}  // namespace

Table comparison(const std::string& title, const Published& published, const std::vector<Sampled>& sampled) {
  Table table{title,
              {{"quantity"},
               {"scenario"},
               {"planner"},
               {"row"},
               {"mean"},
               {"p50"},
               {"σ"},
               {"min"},
               {"max"},
               {"samples"},
               {"failures"}}};
  for (const Key& key : ordered(published, sampled)) {
    const std::string unit = unit_of(published, key.what);
    const std::string quantity = unit.empty() ? key.what : key.what + " [" + unit + "]";
    if (const PublishedRow* row = find(published.rows, key)) {
      table.add({quantity, key.where, key.who, "published", row->mean, Cell(), cell(row->sigma), cell(row->min),
                 cell(row->max), count_cell(published.samples), Cell()});
    }
    if (const Sampled* sample = find(sampled, key)) {
      Summary s = summarise(sample->values, sample->failures);
      if (s.min == s.max) s.sigma = 0.0;  // the mean of equal values is not always rounded to their value
      const auto value = [&s](double number) { return s.count > 0 ? Cell(number) : Cell(); };
      table.add({quantity, key.where, key.who, "measured", value(s.mean), value(s.p50), value(s.sigma), value(s.min),
                 value(s.max), count_cell(s.count), count_cell(s.failures)});
    }
  }
  const auto has_place = [](const auto& row) { return !std::get<std::string>(row[1]).empty(); };
  if (std::none_of(table.rows.begin(), table.rows.end(), has_place)) {
    table.columns.erase(table.columns.begin() + 1);
    for (auto& row : table.rows) row.erase(row.begin() + 1);
  }
  return table;
}

Plot boxes(const std::string& title, const std::string& where, const std::string& what, const Published& published,
           const std::vector<Sampled>& sampled) {
  Plot plot{title, {""}, {what, unit_of(published, what)}};
  bool has_published = false;
  for (const Key& key : ordered(published, sampled)) {
    if (key.where != where || key.what != what) continue;
    if (const PublishedRow* row = find(published.rows, key)) {
      plot.boxes.push_back({key.who + " (published)", as_box(*row)});
      has_published = true;
    }
    const Sampled* sample = find(sampled, key);
    if (sample != nullptr && !sample->values.empty()) plot.boxes.push_back({key.who, summarise(sample->values)});
  }
  if (has_published) plot.title += " (published: mean, minimum, maximum)";
  leave_room(plot);
  return plot;
}

}  // namespace regista::bench
