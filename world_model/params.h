// Parameters: a struct lists its fields once, in `visit`, and gets parsing, listing, range checks and nearest-name
// advice from here. A field is `v("key", field, Range{lo, hi}, "unit", "help")`; a nested struct `v.group("key",
// field)`.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace regista {

/// A key that does not exist or a value that does not parse or fit; what() is one line that says what to do.
struct ParamError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Range {
  double low = 0.0;
  double high = 0.0;  ///< both inclusive
};

struct ParamInfo {
  std::string key;    ///< dotted, relative to the struct
  std::string value;  ///< as set_param takes it
  std::string unit;   ///< "" for none
  std::string help;
  bool operator==(const ParamInfo&) const = default;
};

/// The name that fewest letters inserted, deleted or replaced turn into `name` (Levenshtein); the first of equals, ""
/// when none is known.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

namespace params_detail {

std::string print(double value);
std::string print(std::int64_t value);
std::string print(bool value);
std::string print(const std::string& value);
void parse(const std::string& key, std::string_view text, Range range, double& out);
void parse(const std::string& key, std::string_view text, Range range, std::int64_t& out);
void parse(const std::string& key, std::string_view text, Range range, bool& out);
void parse(const std::string& key, std::string_view text, Range range, std::string& out);
[[noreturn]] void unknown_key(std::string_view key, const std::vector<ParamInfo>& known);

struct Lister {
  std::vector<ParamInfo>& out;
  std::string prefix;
  template <class T>
  void operator()(const char* key, const T& field, Range, const char* unit, const char* help) {
    out.push_back({prefix + key, print(field), unit, help});
  }
  template <class P>
  void group(const char* key, const P& params) {
    Lister inner{out, prefix + key + "."};
    P::visit(params, inner);
  }
};

struct Setter {
  std::string_view wanted;
  std::string_view text;
  std::string prefix;
  bool found = false;
  template <class T>
  void operator()(const char* key, T& field, Range range, const char*, const char*) {
    if (prefix + key != wanted) return;
    parse(prefix + key, text, range, field);
    found = true;
  }
  template <class P>
  void group(const char* key, P& params) {
    Setter inner{wanted, text, prefix + key + ".", false};
    P::visit(params, inner);
    found = found || inner.found;
  }
};

}  // namespace params_detail

/// All parameters with their present values, in the order of the list of fields.
template <class P>
std::vector<ParamInfo> list_params(const P& params) {
  std::vector<ParamInfo> out;
  params_detail::Lister lister{out, ""};
  P::visit(params, lister);
  return out;
}

/// Sets one parameter from text. Throws ParamError, leaving params as they were, on an unknown key (naming the nearest
/// known one), text that is no value of the field's type, or a value out of range.
template <class P>
void set_param(P& params, std::string_view key, std::string_view text) {
  P copy = params;
  params_detail::Setter setter{key, text, "", false};
  P::visit(copy, setter);
  if (!setter.found) params_detail::unknown_key(key, list_params(params));
  params = copy;
}

}  // namespace regista
