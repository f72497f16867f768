// One line of `regista plan`'s input as a value: where robots are, where they want to go, what stands in the way.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "planning/obstacle_field.h"
#include "planning/request.h"

namespace regista {

/// A line that is no query; what() names the field and the value.
struct QueryError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct PlanQuery {
  Bounds bounds;                      ///< for the robot's centre
  std::vector<Obstacle> obstacles;    ///< grown by the robot's radius
  std::vector<PlanRequest> requests;  ///< one, or one per robot of a team; their budgets have no clock yet
  bool is_team = false;
  std::optional<double> budget_us;  ///< per robot; nullopt: no limit, 0: spent at once
};

/// The line's JSON object. Throws QueryError when it is none, or nested too deep for any query.
nlohmann::json parse_line(const std::string& line);

/// What the answer carries to be told from others: a string, a number, or null where there is none. Throws QueryError.
nlohmann::json id_of(const nlohmann::json& query);

/// Required: field {length, width}, radius, obstacles, and start and goal, or robots [{start, goal}]. Optional:
/// field.margin (0), seed (1), budget_us, ignore (per robot: indices of obstacles that are none for it). Metres. Keys
/// of other meaning are left alone, but not in obstacles. Throws QueryError.
PlanQuery parse_query(const nlohmann::json& query);

}  // namespace regista
