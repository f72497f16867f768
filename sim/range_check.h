// Checks a whole parameter struct against the ranges in its list of fields, for structs that were filled by hand.
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>

#include "world_model/params.h"

namespace regista {

namespace range_check_detail {

struct Checker {
  std::string prefix;
  template <class T>
  void operator()(const char* key, const T& field, Range range, const char* unit, const char*) const {
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const auto value = static_cast<double>(field);
      if (value >= range.low && value <= range.high) return;
      throw std::invalid_argument(prefix + key + " is " + params_detail::print(field) + " " + unit + ", must be in [" +
                                  params_detail::print(range.low) + ", " + params_detail::print(range.high) + "]");
    }
  }
  template <class P>
  void group(const char* key, const P& params) const {
    Checker inner{prefix + key + "."};
    P::visit(params, inner);
  }
};

}  // namespace range_check_detail

/// Throws std::invalid_argument naming key, value and range of the first number outside its range (NaN always is).
template <class P>
void check_ranges(const P& params) {
  range_check_detail::Checker checker{""};
  P::visit(params, checker);
}

}  // namespace regista
