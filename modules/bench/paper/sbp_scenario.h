// The world of Pinheiro, Maximo & Yoneyama (LARS 2020): start in a region on the left, robots in the middle, goal on
// the right.
#pragma once

#include "modules/bench/paper/sampling_data.h"

namespace regista::bench {

inline constexpr const char* kSbpFile = "sbp_figures.toml";

struct SbpScenario {
  Bounds bounds;
  std::size_t robots = 0;
  double robot_radius_m = 0.0;
  double agent_radius_m = 0.0;
  Vec2 start_x_m = Vec2::Zero();  ///< the regions' left and right ends; all of the field's width
  Vec2 robots_x_m = Vec2::Zero();
  Vec2 goal_x_m = Vec2::Zero();
};

/// From [scenario].
SbpScenario sbp_scenario(const DataTable& data);

/// Robots of that region that do not overlap, a free start, a free goal.
Scene sbp_scene(const SbpScenario& scenario, std::mt19937_64& random);

/// What a planner may take by the paper's equation 2, one part in five of the camera's period, in microseconds.
double sbp_budget_us(const DataTable& data);

/// As many runs as asked for, else the number in the figure's data.
std::size_t runs_or(std::size_t asked, const DataTable& figure);

}  // namespace regista::bench
