#include "planning/planners/apf_wall.h"

namespace regista {
namespace {

constexpr int kHeadings = 24;
constexpr double kTurn_rad = 2.0 * std::numbers::pi / kHeadings;
constexpr int kQuarter = kHeadings / 4;

/// Back at the beginning is within one step of it, after having been this many steps away.
constexpr double kAwaySteps = 3.0;

/// Who does not get that far in so many steps is in a pocket.
constexpr std::size_t kStepsInPocket = 100;

}  // namespace

WallFollower::WallFollower(const ObstacleField& field, std::span<const std::size_t> ignored, const Vec2& begin,
                           const Vec2& goal, double side, double step_m)
    : field_(field),
      ignored_(ignored),
      begin_(begin),
      goal_(goal),
      forward_((goal - begin).stableNormalized()),
      at_(begin),
      side_(side),
      step_m_(step_m) {}

void WallFollower::step() {
  if (end_ != End::walking) return;
  // The way to the goal is blocked where it begins; later the hand feels for the wall a quarter turn towards it.
  const int first = path_.empty() ? 1 : heading_ - kQuarter;
  for (int k = 0; k < kHeadings; ++k) {
    const int heading = (first + k) % kHeadings;
    const Vec2 to = at_ + step_m_ * rotated(forward_, side_ * kTurn_rad * heading);
    if (!field_.is_free(at_, to, ignored_)) continue;
    heading_ = heading;
    at_ = to;
    path_.push_back(to);
    const double from_begin_m = (at_ - begin_).norm();
    was_away_ = was_away_ || from_begin_m > kAwaySteps * step_m_;
    if (may_leave()) {
      end_ = End::left;
    } else if (was_away_ ? from_begin_m <= step_m_ : path_.size() >= kStepsInPocket) {
      end_ = End::around;
    }
    return;
  }
  end_ = End::around;
}

bool WallFollower::may_leave() const {
  const Vec2 to_goal = goal_ - at_;
  const double goal_m = to_goal.norm();
  if (goal_m > (goal_ - begin_).norm() - step_m_) return false;
  return field_.is_free(at_, at_ + std::min(goal_m, step_m_) * to_goal.stableNormalized(), ignored_);
}

double WallFollower::estimate_m() const { return step_m_ * static_cast<double>(path_.size()) + (goal_ - at_).norm(); }

}  // namespace regista
