// The static scenarios of Costa & Tonidandel as data files, and what a planner is asked in them. Pure values: nothing
// here measures.
#pragma once

#include <optional>

#include "modules/bench/worlds.h"
#include "planning/planners/dvg_published.h"

namespace regista::bench {

struct DvgScenario {
  std::string title;
  std::string rebuilt;  ///< what of a lost figure was rebuilt, for the report
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  std::vector<Vec2> robots;
  std::optional<dvg::Object> ball;
  std::int64_t rrt_samples = 2500;  ///< N
  double group_distance_m = 0.5;    ///< d_group
};

/// modules/bench/data/paper/<name>.toml. Throws std::runtime_error naming the file.
DvgScenario load_dvg_scenario(const std::string& name);

/// What every planner is asked.
struct ObjectsQuery {
  std::vector<dvg::Object> objects;  ///< robots of r = 240 mm, then the ball
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  std::int64_t rrt_samples = 2500;
};

ObjectsQuery query_of(const DvgScenario& scenario);

/// The same for planners of exact geometry: each object the disc of its r, within the lines of 12 × 9 m.
World world_of(const ObjectsQuery& query);

/// Sum over the objects of the distance between their centre and the path ("path safety", section 5).
double safety_m(std::span<const dvg::Object> objects, std::span<const Vec2> path);

/// Whether a robot on that path would touch one of the robots: centres nearer than two radii of 90 mm.
bool touches_robot(std::span<const dvg::Object> objects, std::span<const Vec2> path);

/// Distance from a point to the path; infinite for an empty path.
double distance_m(const Vec2& point, std::span<const Vec2> path);

}  // namespace regista::bench
