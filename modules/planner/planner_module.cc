#include "modules/planner/planner_module.h"

#include "planning/registry.h"

namespace regista {
namespace {

constexpr Duration kGraphEvery = std::chrono::milliseconds(100);  // people look at it, nothing is steered by it

std::string planner_names() {
  std::string names;
  for (const PlannerEntry& entry : planners()) names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

}  // namespace

PlannerModule::PlannerModule(Bus& bus, Team team, const PlannerModuleParams& params, Stopwatch stopwatch)
    : Module(channels::of("planner", team), bus),
      team_(team),
      params_(params),
      planner_(team, params.planning),
      stopwatch_(std::move(stopwatch)),
      world_(bus, channels::world_state()),
      geometry_(bus, channels::geometry()),
      targets_(bus, channels::targets(team)),
      referee_(bus, channels::referee()) {
  planner_.use(params.use);
  expose<PlannerModuleParams>(params_, [this](const PlannerModuleParams& changed) {
    if (changed.use != params_.use) planner_.use(changed.use);  // the only step that may throw
    planner_.set_params(changed.planning);
    params_ = changed;
  });
  answer("planner.list", [](const Request&) { return planner_names(); });
  answer("planner.use", [this](const Request& request) {
    planner_.use(request.key);
    params_.use = request.key;
    return name() + " plans with " + request.key;
  });
}

const char* PlannerModule::waits_for() const {
  if (world_.newest() == nullptr) return "WORLD_STATE";
  if (geometry_.newest() == nullptr) return "GEOMETRY";
  const bool ours = targets_.newest() != nullptr && targets_.newest()->team == team_;
  if (!ours || !targets_.is_younger_than(from_seconds(params_.targets_deadline_s))) return "TARGETS";
  return nullptr;
}

std::string PlannerModule::note() const {
  const char* missing = waits_for();
  return missing != nullptr ? std::string("waiting for ") + missing : std::string(planner_.planner());
}

void PlannerModule::on_tick(Time) {
  if (!world_.fresh()) return;
  const WorldState& world = *world_.take();
  const Situation situation = situation_.update(referee_.newest(), world);
  if (waits_for() != nullptr) return;  // no plan: the controller brakes at its deadline
  const std::int64_t begin_ns = stopwatch_();
  const TeamPlans plans = planner_.plan(geometry_.newest()->field, world, *targets_.newest(), &stopwatch_, situation);
  Timing timing{world.captured, name(), stopwatch_() - begin_ns, {}};
  for (std::size_t i = 0; i < plans.plans.size(); ++i) {
    bus().publish(channels::plan(plans.plans[i].robot), plans.plans[i]);
    timing.robots.push_back({plans.plans[i].robot.number, plans.durations_ns[i]});
  }
  publish_graph(world);
  bus().publish(channels::timing(name()), timing);
}

void PlannerModule::publish_graph(const WorldState& world) {
  if (graph_published_ && world.captured >= *graph_published_ && world.captured - *graph_published_ < kGraphEvery)
    return;
  graph_published_ = world.captured;
  bus().publish(channels::graph(team_), planner_.picture());
}

}  // namespace regista
