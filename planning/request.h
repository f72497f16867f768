// What a planner is asked: from where to where, which obstacles are none for this robot, and how long it may take.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "world_model/types/geometry.h"

namespace regista {

struct Budget {
  /// Samples a random planner may draw, >= 0. Planners that end by themselves do not count.
  std::int64_t iterations = 2500;
  /// Asked now and then; true ends the search with not_found. Cores own no clock, so it is injected; nullptr: never.
  const std::function<bool()>* out_of_time = nullptr;

  bool is_spent() const { return out_of_time != nullptr && (*out_of_time)(); }
};

struct PlanRequest {
  Vec2 start = Vec2::Zero();         ///< metres
  Vec2 goal = Vec2::Zero();          ///< metres
  std::vector<std::size_t> ignored;  ///< sorted indices of the obstacles that are none for this robot
  std::uint64_t seed = 1;            ///< of random planners
  Budget budget;
  /// A longer path is of no use; metres. Searches that know a lower bound may give up with not_found.
  double length_max_m = std::numeric_limits<double>::infinity();
  std::vector<Vec2> previous_path;  ///< what the robot follows now, may be empty: for planners that would jitter
};

/// A request as a planner's search sees it: start and goal are free points, the rest is as asked.
struct Query {
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  std::span<const std::size_t> ignored;
  std::uint64_t seed = 1;
  Budget budget;
  std::span<const Vec2> previous_path;
  /// What blocks the segment from start to goal, ignored obstacles left out; empty and is_straight_free: nothing does,
  /// empty and not: nobody has asked.
  std::span<const std::uint32_t> straight_blockers = {};
  bool is_straight_free = false;
  double length_max_m = std::numeric_limits<double>::infinity();
};

}  // namespace regista
