#include "planning/graph/tangent_front.h"

#include "planning/graph/taut_path.h"

namespace regista::graph {
namespace {

constexpr int kStepsPerTimeCheck = 64;

/// A search that takes so long may be hopeless: then it is proved that there is no way, instead of trying them all. It
/// goes on a little for a path that leads near the goal.
constexpr int kLegsBeforeProof = 64;
constexpr int kLegsWithoutHope = 192;

/// In a large field a leg costs the more the larger it is, and laying out a corridor as much as one leg or two. Most
/// detours stay within.
constexpr std::size_t kLargeField = 64;
constexpr double kCorridor_m = 0.5;

/// A leg between two that are apart by more than kTangentTouch_m is longer.
constexpr double kTouching_m = 1e-3;

/// Bodies within this of the origin are touched far more exactly than clearance asks for: 1e-16 of it.
constexpr double kExact_m = 1e4;

bool is_within(const Obstacle& obstacle, double distance_m) {
  return obstacle.a.cwiseAbs().sum() + obstacle.b.cwiseAbs().sum() + obstacle.radius_m < distance_m;
}

}  // namespace

TangentFront::Progress TangentFront::advance(SharedGraph& graph, int legs) {
  for (const int end = legs_tested_ + legs; legs_tested_ < end;) {
    if (queue_.is_empty()) return Progress::no_way;
    if (++steps_ % kStepsPerTimeCheck == 0 && query_.budget.is_spent()) return Progress::no_time;
    const SearchQueue::Entry next = queue_.pop();
    horizon_m_ = next.estimate_m;
    if (next.estimate_m > query_.length_max_m) return Progress::too_long;
    if (next.is_arrival) {
      if (next.estimate_m == arrivals_[next.index].next_m) make_departures(next.index);
      continue;
    }
    if (is_put_off(next)) continue;
    ++legs_tested_;
    if (legs_tested_ == kLegsBeforeProof) {
      is_separated_ = separation_.separates(graph.field(), graph.overlaps(), query_.start, query_.goal, query_.ignored);
    }
    if (is_separated_ && legs_tested_ >= kLegsWithoutHope) return Progress::no_way;
    const Leg& leg = legs_[next.index];
    if (!is_open(graph, leg)) {
      activate_pending(graph);
      continue;
    }
    if (leg.state == kGoalState) {
      length_m_ = leg.cost;
      last_ = next.index;
      return Progress::goal;
    }
    const double to_goal_m = (query_.goal - leg.to.point).norm();
    if (expand(graph, next.index) && to_goal_m < nearest_m_) {
      last_ = next.index;
      nearest_m_ = to_goal_m;
    }
    activate_pending(graph);
  }
  return Progress::going_on;
}

void TangentFront::begin(SharedGraph& graph, const Query& query) {
  query_ = query;
  field_ = &graph.field();
  start_ = body_of(query.start);
  goal_ = body_of(query.goal);
  active_.clear(graph.field().size());
  corridor_.clear();
  detours_.clear();
  first_here_.clear();
  legs_.clear();
  arrivals_.clear();
  queue_.clear();
  pending_.clear();
  legs_tested_ = 0;
  steps_ = 0;
  horizon_m_ = 0.0;
  is_separated_ = false;
  last_ = kStart;
  nearest_m_ = (query.goal - query.start).norm();
  Leg start;
  start.to.point = query.start;
  start.state = kStartState;
  legs_.push_back(start);
  Arrival at_start;
  at_start.departure.point = query.start;
  at_start.reach = kInfinite_m;
  at_start.made_m = kInfinite_m;
  at_start.next_m = kInfinite_m;
  at_start.state = kStartState;
  arrivals_.push_back(at_start);
  if (query.straight_blockers.empty()) {
    depart(kStart, goal_, 1.0, kGoalState);
  } else {
    if (field_->size() > kLargeField) corridor_.lay_out(*field_, query_.start, query_.goal, kCorridor_m);
    pend_deepest(graph.field(), query.start, query.goal, query.straight_blockers);
    activate_pending(graph);
  }
}

/// Nothing blocks the leg; else what does is active or will be.
bool TangentFront::is_open(SharedGraph& graph, const Leg& leg) {
  const ObstacleField& field = graph.field();
  if (!is_inside(leg.to.point, field.bounds())) return false;
  Arrival& begin = arrivals_[leg.parent];
  const State from = begin.state / 2;
  const State to = leg.state / 2;
  const ObstacleBoxes::Motion motion{leg.from.point, leg.to.point, leg.along};
  const bool is_news = leg.free_of < active_.size();
  if (is_news && !active_.blockers().are_clear_of(field, motion, from, to, begin.occluders)) return false;
  // Most legs that fail have failed by now; the others show what else has to be gone round.
  blockers_.clear();
  corridor_.visit_candidates(field, motion, [&](ObstacleIndex i) {
    if (active_.contains(i) || is_ignored(i, query_.ignored)) return false;
    if (!is_free(leg.from.point, leg.to.point, field.obstacles()[i])) blockers_.push_back(i);
    return false;
  });
  pend_deepest(field, leg.from.point, leg.to.point, blockers_);
  graph.note_leg(leg.from.point, leg.to.point, !blockers_.empty());
  return blockers_.empty();
}

/// One of them is enough to drop a leg; the one that is crossed deepest is the one most worth going round.
void TangentFront::pend_deepest(const ObstacleField& field, const Vec2& from, const Vec2& to,
                                std::span<const ObstacleIndex> blockers) {
  if (blockers.empty()) return;
  ObstacleIndex deepest = blockers.front();
  double least_m = 0.0;
  for (const ObstacleIndex i : blockers) {
    if (blockers.size() == 1) break;
    const double clearance_m = clearance(from, to, field.obstacles()[i]);
    if (clearance_m >= least_m) continue;
    least_m = clearance_m;
    deepest = i;
  }
  pending_.push_back(deepest);
}

void TangentFront::activate(SharedGraph& graph, ObstacleIndex obstacle) {
  active_.add(graph.field(), obstacle, graph.body(obstacle), query_.goal);
  first_here_.resize(2 * active_.size(), kNone);
  const auto slot = static_cast<State>(active_.size() - 1);
  for (ArrivalIndex i = 0; i < arrivals_.size(); ++i) {
    Arrival& arrival = arrivals_[i];
    const double least_m = active_.least_way_m(arrival.departure, slot);
    if (least_m <= arrival.made_m) {
      if (least_m < kInfinite_m) depart_to_slot(i, slot);
    } else if (least_m < arrival.next_m) {
      arrival.next_m = least_m;
      queue_.push({least_m, i, true});
    }
  }
}

void TangentFront::activate_pending(SharedGraph& graph) {
  for (const ObstacleIndex obstacle : pending_) {
    if (!active_.contains(obstacle)) activate(graph, obstacle);
  }
  pending_.clear();
}

/// All legs were tested on the way against all but the bodies they touch, and touch those to within rounding: that is
/// enough unless the leg is so short or a body so far out or large that rounding is near what counts as touching. A
/// polyline can only meet what its arc nearly touches.
void TangentFront::trace(SharedGraph& graph, std::vector<Vec2>& path) {
  chain_.clear();
  for (LegIndex leg = last_; leg != kStart; leg = arrivals_[legs_[leg].parent].leg) chain_.push_back(leg);
  path.clear();
  path.push_back(query_.start);
  is_path_known_free_ = true;
  for (std::size_t i = chain_.size(); i-- > 0;) {
    const Leg& leg = legs_[chain_[i]];
    is_path_known_free_ =
        is_path_known_free_ && (leg.to.point - leg.from.point).squaredNorm() > kTouching_m * kTouching_m;
    if (leg.state == kGoalState) {
      path.push_back(query_.goal);
      return;
    }
    if (i == 0) {
      path.push_back(leg.to.point);
      return;
    }
    const ActiveObstacles::Slot& slot = active_[leg.state / 2];
    is_path_known_free_ = is_path_known_free_ && is_within(graph.field().obstacles()[slot.obstacle], kExact_m);
    const Place& leave = legs_[chain_[i - 1]].from;
    const std::size_t first = path.size();
    const Contacts::Of near = append_arc(graph, slot.obstacle, slot.body, {leg.to, leave, side_of(leg.state)}, path);
    if (near.cuts.empty() && near.brushes.empty()) continue;
    polyline_.assign(1, leg.to.point);
    polyline_.insert(polyline_.end(), path.begin() + static_cast<std::ptrdiff_t>(first), path.end());
    polyline_.push_back(leave.point);
    is_path_known_free_ = is_path_known_free_ && is_clear_of(*field_, near, polyline_, query_.ignored);
  }
}

}  // namespace regista::graph
