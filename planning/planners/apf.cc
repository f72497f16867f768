#include "planning/planners/apf.h"

#include "planning/planners/apf_force.h"
#include "planning/planners/apf_wall.h"
#include "planning/polyline.h"

namespace regista {
namespace {

/// So many steps downhill that do not come nearer to the goal are a local minimum.
constexpr std::size_t kPatience = 10;

/// So is a step shorter than this share of a whole one.
constexpr double kStanding = 0.02;

/// How many steps are taken between two questions whether time is up.
constexpr std::int64_t kStepsPerTimeCheck = 32;

/// Points this near to a straight leg are left out of the path. Metres.
constexpr double kStraight_m = 0.01;

class Drive {
 public:
  enum class End { driving, goal, walled_in, steps_spent, no_time };

  Drive(const ObstacleField& field, const Query& query, const ApfParams& params)
      : field_(field), query_(query), params_(params), path_{query.start} {}

  End run() {
    while (end_ == End::driving) {
      if (descend() || advance()) continue;
      follow_wall();
    }
    return end_;
  }

  /// The points driven through.
  const std::vector<Vec2>& path() const { return path_; }

 private:
  bool is_free(const Vec2& from, const Vec2& to) const { return field_.is_free(from, to, query_.ignored); }
  Vec2 at() const { return path_.back(); }
  double to_goal_m(const Vec2& point) const { return (query_.goal - point).norm(); }
  Vec2 direction(const Vec2& point) const {
    return potential_force(field_, query_.ignored, query_.goal, point, params_).stableNormalized();
  }

  /// The mean of a step here and one at its end (Heun): across a valley of the potential, where single steps would go
  /// to and fro, they cancel, and at its bottom nothing remains.
  Vec2 downhill() const {
    const Vec2 here = direction(at());
    return 0.5 * params_.step_m * (here + direction(at() + params_.step_m * here));
  }

  /// Counts a step; true when there must be no other.
  bool is_over() {
    if (steps_ % kStepsPerTimeCheck == 0 && query_.budget.is_spent()) end_ = End::no_time;
    if (++steps_ > params_.steps_max) end_ = End::steps_spent;
    return end_ != End::driving;
  }

  bool arrive() {
    if (to_goal_m(at()) > params_.step_m || !is_free(at(), query_.goal)) return false;
    if (at() != query_.goal) path_.push_back(query_.goal);
    end_ = End::goal;
    return true;
  }

  bool descend();
  bool advance();
  void follow_wall();

  const ObstacleField& field_;
  const Query& query_;
  const ApfParams& params_;
  std::vector<Vec2> path_;
  std::int64_t steps_ = 0;
  End end_ = End::driving;
};

/// Downhill as far as that leads nearer to the goal. True when that ended the drive.
bool Drive::descend() {
  std::size_t best = path_.size() - 1;
  while (path_.size() - 1 - best < kPatience) {
    if (is_over() || arrive()) return true;
    const Vec2 move = downhill();
    if (move.norm() < kStanding * params_.step_m || !is_free(at(), at() + move)) break;
    const Vec2 next = at() + move;
    path_.push_back(next);
    if (to_goal_m(next) < to_goal_m(path_[best])) best = path_.size() - 1;
  }
  path_.resize(best + 1);
  return false;
}

/// Straight towards the goal. True when that ended the drive or led to where the field leads on, false at an obstacle.
bool Drive::advance() {
  const Vec2 begin = at();
  for (double step_m = params_.step_m; step_m > 0.1 * params_.step_m;) {
    if (is_over() || arrive()) return true;
    const Vec2 ahead = (query_.goal - at()).stableNormalized();
    const Vec2 next = at() + std::min(step_m, to_goal_m(at())) * ahead;
    if (!is_free(at(), next)) {
      step_m *= 0.5;
      continue;
    }
    path_.push_back(next);
    if ((next - begin).norm() > params_.influence_m && direction(at()).dot(ahead) > 0.5) return true;
  }
  return false;
}

/// Both ways along the wall, a step each in turn; the way that leaves it and is the shorter one is appended.
void Drive::follow_wall() {
  // In mirrored worlds the sides change places; where both are equally long, which is first must change with them.
  const Vec2 ahead = query_.goal - query_.start;
  const double first = (ahead.x() < 0.0) != (ahead.y() < 0.0) ? -1.0 : 1.0;
  WallFollower one(field_, query_.ignored, at(), query_.goal, first, params_.step_m);
  WallFollower other(field_, query_.ignored, at(), query_.goal, -first, params_.step_m);
  using Way = WallFollower::End;
  const auto is_worth_it = [](const WallFollower& walker, const WallFollower& rival) {
    return walker.end() == Way::walking && (rival.end() != Way::left || walker.estimate_m() < rival.estimate_m());
  };
  while (is_worth_it(one, other) || is_worth_it(other, one)) {
    if (is_over()) return;
    if (is_worth_it(one, other)) one.step();
    if (is_worth_it(other, one)) other.step();
  }
  const bool other_is_better =
      other.end() == Way::left && (one.end() != Way::left || other.estimate_m() < one.estimate_m());
  const WallFollower& taken = other_is_better ? other : one;
  if (taken.end() != Way::left) {
    end_ = End::walled_in;
    return;
  }
  path_.insert(path_.end(), taken.path().begin(), taken.path().end());
}

}  // namespace

void Apf::search(graph::SharedGraph& graph, const Query& query, SearchResult& result) {
  Drive drive(graph.field(), query, params_);
  const Drive::End end = drive.run();
  result.path = thinned(graph.field(), drive.path(), query.ignored, kStraight_m);
  switch (end) {
    case Drive::End::goal:
      result.status = PlanStatus::ok;
      return;
    case Drive::End::driving:
    case Drive::End::walled_in:
      result.reason = "a wall leads round to where it was met";
      return;
    case Drive::End::steps_spent:
      result.reason = "the steps were spent";
      return;
    case Drive::End::no_time:
      result.reason = "the time was spent";
      return;
  }
}

}  // namespace regista
