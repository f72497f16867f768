#include "planning/team_planner.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "planning/arrivals.h"
#include "planning/game_rules.h"
#include "planning/giving_way.h"
#include "planning/goal_leaning.h"
#include "planning/obstacle_growth.h"
#include "planning/predicted_obstacles.h"
#include "planning/uniform.h"

namespace regista {
namespace {

constexpr std::int64_t kNanosecondsPerMicrosecond = 1000;
constexpr double kNanosecondsPerSecond = 1e9;

std::int64_t read(const TeamPlanner::Stopwatch* stopwatch) { return stopwatch != nullptr ? (*stopwatch)() : 0; }

void check(const Targets& targets, Team team) {
  if (targets.team != team) {
    throw std::invalid_argument(std::string("targets of team ") + name(targets.team) + " for the planner of team " +
                                name(team));
  }
  std::set<std::uint16_t> robots;
  for (const Target& target : targets.targets) {
    if (robots.insert(target.robot).second) continue;
    throw std::invalid_argument("two targets for " + to_string(RobotId{team, target.robot}));
  }
}

/// Without a path a robot brakes and turns no more.
Plan halted() {
  Plan plan;
  plan.status = PlanStatus::not_found;
  plan.reason = "halt: every robot stands still";
  return plan;
}

bool predicts(const PlanningParams& params) {
  return params.prediction_horizon_s > 0.0 || params.team_prediction_horizon_s > 0.0;
}

}  // namespace

TeamPlanner::TeamPlanner(Team team, const PlanningParams& params)
    : team_(team), params_(params), entry_(&planner_entry(kDefaultPlanner)), planner_(entry_->make(params)) {}

void TeamPlanner::use(std::string_view planner) {
  const PlannerEntry& entry = planner_entry(planner);
  if (&entry == entry_) return;
  planner_ = entry.make(params_);
  entry_ = &entry;
  ++generation_;
}

void TeamPlanner::set_params(const PlanningParams& params) {
  params_ = params;
  planner_ = entry_->make(params_);
}

TeamPlans TeamPlanner::plan(const FieldGeometry& field, const WorldState& world, const Targets& targets,
                            const Stopwatch* stopwatch, const Situation& situation) {
  check(targets, team_);
  const std::int64_t frame_began = read(stopwatch);
  TeamObstacles obstacles = obstacles_for(team_, field, world, params_, situation);
  const double speed_max_mps = rule_speed_max(situation, params_.rules);
  graph_.reset(std::move(obstacles.field));
  captured_ = world.captured;
  world_sequence_ = world.sequence;
  const std::int64_t robot_budget_ns = stopwatch != nullptr ? budget_ns(targets.targets.size()) : 0;
  own_graphs_used_ = 0;
  if (predicts(params_)) find_arrivals(world, targets, speed_max_mps, arrivals_s_);
  TeamPlans out;
  for (Target target : targets.targets) {
    const RobotState* robot = find_robot(world, {team_, target.robot});
    if (robot == nullptr) continue;
    const std::int64_t began = read(stopwatch);
    target.speed_max_mps = std::min(target.speed_max_mps, speed_max_mps);
    Plan plan = situation.kind == SituationKind::halt
                    ? halted()
                    : plan_robot(obstacles, world, *robot, target, stopwatch, robot_budget_ns);
    if (stopwatch != nullptr) out.durations_ns.push_back(read(stopwatch) - began);
    out.plans.push_back({robot->id, world.captured, world.sequence, targets.sequence, 0, std::string(entry_->name),
                         generation_, target, std::move(plan)});
  }
  give_way(obstacles, world, out.plans);
  previous_paths_.clear();
  for (RobotPlan& plan : out.plans) {
    plan.set_size = static_cast<std::uint32_t>(out.plans.size());
    if (plan.plan.status == PlanStatus::ok) previous_paths_[plan.robot.number] = plan.plan.path;
  }
  out.frame_ns = read(stopwatch) - frame_began;
  return out;
}

/// 0: no limit.
std::int64_t TeamPlanner::budget_ns(std::size_t robots) const {
  if (params_.budget_us > 0) return params_.budget_us * kNanosecondsPerMicrosecond;
  // Planners that are not random end by themselves, long before; a share would only cost plans when the machine halts.
  if (entry_->guarantees.deterministic || robots == 0) return 0;
  // Pinheiro, Maximo & Yoneyama (LARS 2020), equation 2.
  return static_cast<std::int64_t>(params_.frame_period_s * kNanosecondsPerSecond / static_cast<double>(robots));
}

Plan TeamPlanner::plan_robot(const TeamObstacles& obstacles, const WorldState& world, const RobotState& robot,
                             const Target& target, const Stopwatch* stopwatch, std::int64_t budget_ns) {
  PlanRequest request;
  request.start = robot.pose.position_m;
  request.goal = target.pose.position_m;
  request.ignored = ignored_by(obstacles, robot.id, target.may_enter_own_area);
  request.seed = mixed(mixed(static_cast<std::uint64_t>(params_.seed), world_sequence_), robot.id.number);
  const bool ends_by_count = entry_->guarantees.anytime && budget_ns == 0;
  request.budget.iterations = ends_by_count ? params_.anytime_iterations : params_.iterations;
  std::function<bool()> out_of_time;
  if (budget_ns > 0) {
    const std::int64_t deadline = read(stopwatch) + budget_ns;
    out_of_time = [stopwatch, deadline] { return read(stopwatch) >= deadline; };
    request.budget.out_of_time = &out_of_time;
  }
  if (const auto previous = previous_paths_.find(robot.id.number); previous != previous_paths_.end()) {
    request.previous_path = previous->second;
  }
  return plan_among(obstacles, world, robot, target.speed_max_mps, request);
}

Plan TeamPlanner::plan_among(const TeamObstacles& obstacles, const WorldState& world, const RobotState& robot,
                             double speed_max_mps, PlanRequest request) {
  const std::size_t robots = obstacles.robots.size();
  lean(request, graph_.field().obstacles());
  if (!predicts(params_) || !is_finite(request.goal)) return plan_in_field(graph_, robots, request);
  predict(graph_.field().obstacles(), world, arrivals_s_, robot, request.goal,
          {.horizon_s = params_.prediction_horizon_s,
           .team_horizon_s = params_.team_prediction_horizon_s,
           .speed_mps = std::min(params_.prediction_speed_mps, speed_max_mps),
           .turn_mps2 = params_.prediction_turn_mps2,
           .fade_from_m = params_.opponent_fade_from_m,
           .fade_over_m = params_.opponent_fade_over_m},
          predicted_);
  graph::SharedGraph& own = own_graph();
  own.reset(graph_.field().bounds(), predicted_);
  Plan plan = plan_in_field(own, robots, request);
  // What is expected may leave no way where today's places do.
  return plan.status == PlanStatus::ok ? plan : plan_in_field(graph_, robots, request);
}

/// Decided once all have plans, among today's places.
void TeamPlanner::give_way(const TeamObstacles& obstacles, const WorldState& world, std::vector<RobotPlan>& plans) {
  if (std::ranges::none_of(plans, [](const RobotPlan& plan) { return plan.plan.status == PlanStatus::unreachable; }))
    return;
  std::vector<Traveller> travellers;
  for (RobotPlan& plan : plans) {
    const auto obstacle = std::ranges::find(obstacles.robots, plan.robot) - obstacles.robots.begin();
    travellers.push_back({static_cast<std::size_t>(obstacle), find_robot(world, plan.robot)->pose.position_m,
                          plan.target.pose.position_m,
                          ignored_by(obstacles, plan.robot, plan.target.may_enter_own_area), &plan.plan});
  }
  std::vector<std::size_t> mates;
  for (std::size_t i = 0; i < obstacles.robots.size(); ++i) {
    if (obstacles.robots[i].team == team_) mates.push_back(i);
  }
  regista::give_way(graph_.field(), mates, params_.give_way_within_m, travellers);
}

graph::SharedGraph& TeamPlanner::own_graph() {
  if (own_graphs_used_ == own_graphs_.size()) own_graphs_.push_back(std::make_unique<graph::SharedGraph>());
  return *own_graphs_[own_graphs_used_++];
}

Plan TeamPlanner::plan_in_field(graph::SharedGraph& graph, std::size_t robots, const PlanRequest& request) {
  graph::SharedGraph* used = &graph;
  Plan plan;
  if (params_.growth_radius_max_m > 0.0) {
    grow(graph.field().obstacles(), robots, request.start, request.goal, params_, grown_);
    grown_graph_.reset(graph.field().bounds(), grown_);
    used = &grown_graph_;
    plan = plan_or_invalid(*planner_, *used, request);
  }
  // Growth may close the only gap; a narrow way is better than none.
  if (plan.status != PlanStatus::ok) {
    used = &graph;
    plan = plan_or_invalid(*planner_, *used, request);
  }
  if (params_.side_change_gain > 0.0) {
    side_keeper_.keep(*planner_, used->field(), request, params_.side_change_gain, plan);
  }
  return plan;
}

GraphPicture TeamPlanner::picture() const {
  GraphPicture picture = graph_.picture();
  for (std::size_t i = 0; i < own_graphs_used_; ++i) {
    append(own_graphs_[i]->picture(), picture);
  }
  picture.captured = captured_;
  picture.team = team_;
  picture.world_sequence = world_sequence_;
  return picture;
}

}  // namespace regista
