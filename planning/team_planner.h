// A team's planning for one frame: world and targets become obstacles, one shared graph and one plan per robot. The
// planner can be exchanged between two frames; the graph belongs to the frame, so nothing is lost.
#pragma once

#include <map>
#include <memory>

#include "planning/graph/graph_picture.h"
#include "planning/obstacle_rules.h"
#include "planning/plan.h"
#include "planning/registry.h"
#include "planning/side_keeping.h"

namespace regista {

struct TeamPlans {
  std::vector<RobotPlan> plans;            ///< sorted by robot; one for each that has a target and is in the world
  std::vector<std::int64_t> durations_ns;  ///< one per plan; empty without stopwatch
  std::int64_t frame_ns = 0;               ///< all of it, obstacles and graph included; 0 without stopwatch
};

class TeamPlanner {
 public:
  /// Returns nanoseconds since some fixed moment.
  using Stopwatch = std::function<std::int64_t()>;

  /// Begins with kDefaultPlanner.
  TeamPlanner(Team team, const PlanningParams& params);

  /// Plans with that planner from the next frame on. Throws UnknownPlanner and keeps the present one.
  void use(std::string_view planner);
  std::string_view planner() const { return entry_->name; }
  /// Counts the changes of planner, from 0.
  std::uint64_t generation() const { return generation_; }

  void set_params(const PlanningParams& params);
  const PlanningParams& params() const { return params_; }
  Team team() const { return team_; }

  /// Targets of robots that are not in the world are left out; a target that makes no sense is answered by a plan of
  /// status invalid. A robot stays on its side of obstacles (side_change_gain), and one to whom a team-mate leaves no
  /// way leaves that one's (give_way_within_m). Without stopwatch the answer is a function of the arguments and of the
  /// paths answered in the frame before, and no time limit is honoured. Throws std::invalid_argument where
  /// obstacles_for does, and for targets of the other team or two for one robot. The rules of the situation lower the
  /// speed limits in the plans' targets; at halt every robot gets a plan without path, so that it brakes.
  TeamPlans plan(const FieldGeometry& field, const WorldState& world, const Targets& targets,
                 const Stopwatch* stopwatch = nullptr, const Situation& situation = {});

  /// The last frame's graph as far as it was needed; of graphs that are each robot's own, as many as a picture holds.
  GraphPicture picture() const;

 private:
  Plan plan_robot(const TeamObstacles& obstacles, const WorldState& world, const RobotState& robot,
                  const Target& target, const Stopwatch* stopwatch, std::int64_t budget_ns);
  Plan plan_among(const TeamObstacles& obstacles, const WorldState& world, const RobotState& robot,
                  double speed_max_mps, PlanRequest request);
  void give_way(const TeamObstacles& obstacles, const WorldState& world, std::vector<RobotPlan>& plans);
  graph::SharedGraph& own_graph();
  Plan plan_in_field(graph::SharedGraph& graph, std::size_t robots, const PlanRequest& request);
  std::int64_t budget_ns(std::size_t robots) const;

  Team team_;
  PlanningParams params_;
  const PlannerEntry* entry_;
  std::unique_ptr<Planner> planner_;
  std::uint64_t generation_ = 0;
  graph::SharedGraph graph_;
  /// One per robot where each expects the others at their own nearest approach; the first own_graphs_used_ are of the
  /// last frame.
  std::vector<std::unique_ptr<graph::SharedGraph>> own_graphs_;
  std::size_t own_graphs_used_ = 0;
  std::vector<Obstacle> predicted_;
  std::vector<double> arrivals_s_;  ///< by robot of the world
  graph::SharedGraph grown_graph_;  ///< of one robot, whose goal decides how obstacles grow
  std::vector<Obstacle> grown_;
  SideKeeper side_keeper_;
  Time captured_{};
  std::uint64_t world_sequence_ = 0;
  std::map<std::uint16_t, std::vector<Vec2>> previous_paths_;
};

}  // namespace regista
