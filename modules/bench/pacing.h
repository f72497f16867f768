// A bench that ends in time: planners too slow for all queries get every k-th.
#pragma once

#include <cstddef>
#include <vector>

namespace regista::bench {

/// For each planner the k of "every k-th query", so that all together need no more than `available_s`: the time is
/// shared evenly, and what a fast planner leaves of its share goes to the slower ones.
std::vector<std::size_t> strides(const std::vector<double>& query_s, std::size_t queries, double available_s);

}  // namespace regista::bench
