// One line of `regista plan`'s output: the query planned, timed and written as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "modules/regista/plan_query.h"
#include "planning/planner.h"

namespace regista {

struct QueryAnswer {
  std::vector<Plan> plans;            ///< one per request
  std::vector<std::int64_t> plan_ns;  ///< per request, least over the repeats
  std::int64_t total_ns = 0;          ///< field, graph and all plans, least over the repeats
};

/// Plans `repeat` >= 1 times, each time with the obstacles laid out and the shared graph begun anew; the plans are the
/// last repeat's. The stopwatch returns nanoseconds since some fixed moment.
QueryAnswer answer_query(Planner& planner, const PlanQuery& query, int repeat,
                         const std::function<std::int64_t()>& stopwatch);

/// A whole line in, a whole line out (without its end). Never throws on account of the line: what is wrong with it is
/// said in an answer of status "invalid".
std::string answer_line(const std::string& line, Planner& planner, const std::string& planner_name, int repeat,
                        const std::function<std::int64_t()>& stopwatch);

}  // namespace regista
