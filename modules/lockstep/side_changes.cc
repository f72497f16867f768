#include "modules/lockstep/side_changes.h"

#include "planning/path_sides.h"

namespace regista {
namespace {

constexpr Duration kQuick = std::chrono::milliseconds(200);

}  // namespace

SideChanges::SideChanges(Bus& bus, Team team, const PlanningParams& params)
    : team_(team),
      params_(params),
      geometry_(bus, channels::geometry()),
      world_(bus, channels::world_state()),
      plans_(bus, channels::plans(team), [this](const RobotPlan& plan) { judge(plan); }) {}

SideChangeRate SideChanges::rate() const {
  const double minutes = to_seconds(observed_) / 60.0;
  if (!(minutes > 0.0)) return {};
  return {static_cast<double>(changes_) / minutes, static_cast<double>(quick_changes_) / minutes};
}

void SideChanges::judge(const RobotPlan& plan) {
  const WorldState* world = world_.newest();
  if (world == nullptr || geometry_.newest() == nullptr || plan.world_sequence != world->sequence) return;
  Followed& followed = followed_[plan.robot];
  if (followed.plan.target != plan.target) followed.changed.reset();
  if (followed.plan.world_sequence + 1 == plan.world_sequence && followed.plan.target == plan.target) {
    compare(followed, plan);
  }
  followed.plan = plan;
}

void SideChanges::compare(Followed& followed, const RobotPlan& plan) {
  observed_ += plan.captured - followed.plan.captured;
  if (obstacles_sequence_ != plan.world_sequence) {
    obstacles_ = obstacles_for(team_, geometry_.newest()->field, *world_.newest(), params_);
    obstacles_sequence_ = plan.world_sequence;
  }
  const auto ignored = ignored_by(obstacles_, plan.robot, plan.target.may_enter_own_area);
  if (!changes_side(obstacles_.field, ignored, followed.plan, plan)) return;
  ++changes_;
  if (followed.changed && plan.captured - *followed.changed <= kQuick) ++quick_changes_;
  followed.changed = plan.captured;
}

}  // namespace regista
