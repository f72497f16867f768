#include "world_model/params.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace regista {
namespace {

/// Levenshtein's edit distance: how many letters to insert, delete or replace.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
  return nearest == known.end() ? "" : *nearest;
}

namespace params_detail {
namespace {

template <class T>
void parse_number(const std::string& key, std::string_view text, Range range, T& out) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw ParamError(key + ": '" + std::string(text) + "' is not a number");
  }
  const auto number = static_cast<double>(value);
  if (!(number >= range.low && number <= range.high)) {
    throw ParamError(key + ": " + std::string(text) + " is outside [" + print(range.low) + ", " + print(range.high) +
                     "]");
  }
  out = value;
}

}  // namespace

std::string print(double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc{} ? std::string(text, end) : std::string("?");
}
std::string print(std::int64_t value) { return std::to_string(value); }
std::string print(bool value) { return value ? "true" : "false"; }
std::string print(const std::string& value) { return value; }

void parse(const std::string& key, std::string_view text, Range range, double& out) {
  parse_number(key, text, range, out);
}
void parse(const std::string& key, std::string_view text, Range range, std::int64_t& out) {
  parse_number(key, text, range, out);
}
void parse(const std::string& key, std::string_view text, Range, bool& out) {
  if (text != "true" && text != "false") throw ParamError(key + ": '" + std::string(text) + "' is not true or false");
  out = text == "true";
}
void parse(const std::string&, std::string_view text, Range, std::string& out) { out = std::string(text); }

void unknown_key(std::string_view key, const std::vector<ParamInfo>& known) {
  std::vector<std::string> keys;
  keys.reserve(known.size());
  for (const ParamInfo& info : known) keys.push_back(info.key);
  const std::string nearest = nearest_name(key, keys);
  throw ParamError("unknown parameter '" + std::string(key) + "'" +
                   (nearest.empty() ? nearest : ", did you mean '" + nearest + "'?"));
}

}  // namespace params_detail
}  // namespace regista
