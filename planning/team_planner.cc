#include "planning/team_planner.h"

#include <set>
#include <stdexcept>
#include <string>

#include "planning/uniform.h"

namespace regista {
namespace {

constexpr std::int64_t kNanosecondsPerMicrosecond = 1000;

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
                            const Stopwatch* stopwatch) {
  check(targets, team_);
  const std::int64_t frame_began = read(stopwatch);
  TeamObstacles obstacles = obstacles_for(team_, field, world, params_);
  graph_.reset(std::move(obstacles.field));
  captured_ = world.captured;
  world_sequence_ = world.sequence;
  TeamPlans out;
  for (const Target& target : targets.targets) {
    const RobotState* robot = find_robot(world, {team_, target.robot});
    if (robot == nullptr) continue;
    const std::int64_t began = read(stopwatch);
    Plan plan = plan_robot(obstacles, *robot, target, stopwatch);
    if (stopwatch != nullptr) out.durations_ns.push_back(read(stopwatch) - began);
    out.plans.push_back({robot->id, world.captured, world.sequence, targets.sequence, 0, std::string(entry_->name),
                         generation_, target, std::move(plan)});
  }
  previous_paths_.clear();
  for (RobotPlan& plan : out.plans) {
    plan.set_size = static_cast<std::uint32_t>(out.plans.size());
    if (plan.plan.status == PlanStatus::ok) previous_paths_[plan.robot.number] = plan.plan.path;
  }
  out.frame_ns = read(stopwatch) - frame_began;
  return out;
}

Plan TeamPlanner::plan_robot(const TeamObstacles& obstacles, const RobotState& robot, const Target& target,
                             const Stopwatch* stopwatch) {
  PlanRequest request;
  request.start = robot.pose.position_m;
  request.goal = target.pose.position_m;
  request.ignored = ignored_by(obstacles, robot.id, target.may_enter_own_area);
  request.seed = mixed(mixed(static_cast<std::uint64_t>(params_.seed), world_sequence_), robot.id.number);
  request.budget.iterations = params_.iterations;
  std::function<bool()> out_of_time;
  if (stopwatch != nullptr && params_.budget_us > 0) {
    const std::int64_t deadline = read(stopwatch) + params_.budget_us * kNanosecondsPerMicrosecond;
    out_of_time = [stopwatch, deadline] { return read(stopwatch) >= deadline; };
    request.budget.out_of_time = &out_of_time;
  }
  if (const auto previous = previous_paths_.find(robot.id.number); previous != previous_paths_.end()) {
    request.previous_path = previous->second;
  }
  return plan_or_invalid(*planner_, graph_, request);
}

GraphPicture TeamPlanner::picture() const {
  GraphPicture picture = graph_.picture();
  picture.captured = captured_;
  picture.team = team_;
  picture.world_sequence = world_sequence_;
  return picture;
}

}  // namespace regista
