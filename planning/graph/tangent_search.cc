#include "planning/graph/tangent_search.h"

#include <algorithm>
#include <limits>

#include "planning/graph/taut_path.h"

namespace regista::graph {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t kStartState = kNone - 1;
constexpr std::uint32_t kGoalState = kNone - 2;
constexpr std::uint32_t kStart = 0;  // the first leg

constexpr int kLegsPerTimeCheck = 64;

/// A place counts as not beyond another (in order).
constexpr double kSamePlace = 1e-9;

double side_of(std::uint32_t state) { return (state & 1U) != 0 ? 1.0 : -1.0; }

}  // namespace

TangentSearch::End TangentSearch::find(SharedGraph& graph, const Query& query, std::vector<Vec2>& path) {
  clear(graph, query);
  int legs_until_check = kLegsPerTimeCheck;
  LegIndex nearest = kStart;
  double nearest_m = (query.goal - query.start).norm();
  End end = End::no_way;
  while (!queue_.empty()) {
    const Queued next = queue_.front();
    std::pop_heap(queue_.begin(), queue_.end(), later);
    queue_.pop_back();
    if (--legs_until_check == 0) {
      if (query.budget.is_spent()) {
        end = End::no_time;
        break;
      }
      legs_until_check = kLegsPerTimeCheck;
    }
    const Leg& leg = legs_[next.leg];
    if (!is_open(graph, leg)) {
      activate_pending(graph);
      continue;
    }
    if (leg.state == kGoalState) {
      length_m_ = leg.cost;
      trace(graph, next.leg, path);
      return End::goal;
    }
    const double to_goal_m = next.estimate - leg.cost;
    if (expand(graph, next.leg) && to_goal_m < nearest_m) {
      nearest = next.leg;
      nearest_m = to_goal_m;
    }
    activate_pending(graph);
  }
  trace(graph, nearest, path);
  return end;
}

void TangentSearch::clear(SharedGraph& graph, const Query& query) {
  query_ = query;
  goal_ = body_of(query.goal);
  slots_.clear();
  active_.clear();
  is_active_.assign(graph.field().size(), 0);
  expanded_here_.clear();
  legs_.clear();
  expanded_.clear();
  queue_.clear();
  pending_.clear();
  Leg start;
  start.to.point = query.start;
  start.state = kStartState;
  start.reach = std::numeric_limits<double>::infinity();
  legs_.push_back(start);
  expanded_.push_back(kStart);
  depart(kStart, goal_, 1.0, kGoalState);
}

bool TangentSearch::later(const Queued& a, const Queued& b) {
  return a.estimate != b.estimate ? a.estimate > b.estimate : a.leg > b.leg;
}

/// Queues all departures from where the leg arrives; false when an earlier arrival has made them all.
bool TangentSearch::expand(SharedGraph& graph, LegIndex index) {
  {
    const Leg& leg = legs_[index];
    const Body& body = slots_[leg.state / 2].body;
    const double side = side_of(leg.state);
    for (LegIndex other = expanded_here_[leg.state]; other != kNone; other = legs_[other].next_here) {
      const Leg& earlier = legs_[other];
      if (ahead(body, earlier.to.order, leg.to.order, side) > earlier.reach + kSamePlace) continue;
      if (earlier.cost + travel_m(body, earlier.to, leg.to, side) <= leg.cost + 1e-12) return false;
    }
  }
  ObstacleIndex stopped_by = kBounds;
  const double reach = reach_of(graph, legs_[index], stopped_by);
  legs_[index].reach = reach;
  legs_[index].next_here = expanded_here_[legs_[index].state];
  expanded_here_[legs_[index].state] = index;
  expanded_.push_back(index);
  if (stopped_by != kBounds && is_active_[stopped_by] == 0) pending_.push_back(stopped_by);
  const auto slots = static_cast<State>(slots_.size());
  for (State slot = 0; slot < slots; ++slot) depart_to_slot(index, slot);
  depart(index, goal_, 1.0, kGoalState);
  return true;
}

/// How far a path can go on along the boundary from the leg's end, in order; and what stops it there (kBounds: nothing
/// that could be gone round).
double TangentSearch::reach_of(SharedGraph& graph, const Leg& leg, ObstacleIndex& stopped_by) {
  const Slot& slot = slots_[leg.state / 2];
  const double side = side_of(leg.state);
  double reach = slot.body.period;
  for (const Cut& cut : graph.contacts(slot.obstacle, slot.body).cuts) {
    if (cut.other != kBounds && is_ignored(cut.other, query_.ignored)) continue;
    const double distance = cut.is_whole ? 0.0 : ahead(slot.body, leg.to.order, side > 0.0 ? cut.from : cut.to, side);
    if (distance >= reach) continue;
    reach = distance;
    stopped_by = cut.other;
  }
  return reach;
}

void TangentSearch::depart_to_slot(LegIndex index, State slot) {
  const Leg& leg = legs_[index];
  if (leg.state != kStartState && leg.state / 2 == slot) return;
  for (const State side : {0U, 1U}) depart(index, slots_[slot].body, side_of(side), 2 * slot + side);
}

void TangentSearch::depart(LegIndex index, const Body& to, double to_side, State state) {
  const Leg& leg = legs_[index];
  const bool is_start = leg.state == kStartState;
  const Body start = is_start ? body_of(leg.to.point) : Body{};
  const Body& from = is_start ? start : slots_[leg.state / 2].body;
  const double side = is_start ? 1.0 : side_of(leg.state);
  const Place arrival = leg.to;
  const double reach = leg.reach;
  const double cost = leg.cost;
  for_tangents(from, side, to, to_side, [&](const Tangent& tangent) {
    double along_m = 0.0;
    if (!is_start) {
      if (ahead(from, arrival.order, tangent.from.order, side) > reach + kSamePlace) return;
      along_m = travel_m(from, arrival, tangent.from, side);
    }
    Leg next;
    next.from = tangent.from;
    next.to = tangent.to;
    next.cost = cost + along_m + tangent.length_m;
    next.parent = index;
    next.state = state;
    next.next_here = kNone;
    legs_.push_back(next);
    queue_.push_back({next.cost + (goal_.corners[0] - next.to.point).norm(), static_cast<LegIndex>(legs_.size() - 1)});
    std::push_heap(queue_.begin(), queue_.end(), later);
  });
}

/// Nothing blocks the leg; else what does is active or will be.
bool TangentSearch::is_open(SharedGraph& graph, const Leg& leg) {
  if (!is_inside(leg.to.point, graph.field().bounds())) return false;
  blockers_.clear();
  graph.field().blockers(leg.from.point, leg.to.point, blockers_);
  bool is_free = true;
  for (const ObstacleIndex blocker : blockers_) {
    if (is_ignored(blocker, query_.ignored)) continue;
    is_free = false;
    if (is_active_[blocker] == 0) pending_.push_back(blocker);
  }
  return is_free;
}

void TangentSearch::activate(SharedGraph& graph, ObstacleIndex obstacle) {
  is_active_[obstacle] = 1;
  active_.push_back(obstacle);
  slots_.push_back({body_of(graph.field().obstacles()[obstacle]), obstacle});
  expanded_here_.resize(2 * slots_.size(), kNone);
  const auto slot = static_cast<State>(slots_.size() - 1);
  for (const LegIndex leg : expanded_) depart_to_slot(leg, slot);
}

void TangentSearch::activate_pending(SharedGraph& graph) {
  for (const ObstacleIndex obstacle : pending_) {
    if (is_active_[obstacle] == 0) activate(graph, obstacle);
  }
  pending_.clear();
}

void TangentSearch::trace(SharedGraph& graph, LegIndex last, std::vector<Vec2>& path) {
  chain_.clear();
  for (LegIndex leg = last; leg != kStart; leg = legs_[leg].parent) chain_.push_back(leg);
  path.clear();
  path.push_back(query_.start);
  for (std::size_t i = chain_.size(); i-- > 0;) {
    const Leg& leg = legs_[chain_[i]];
    if (leg.state == kGoalState) {
      path.push_back(query_.goal);
      return;
    }
    if (i == 0) {
      path.push_back(leg.to.point);
      return;
    }
    const Slot& slot = slots_[leg.state / 2];
    append_arc(graph, slot.obstacle, slot.body, {leg.to, legs_[chain_[i - 1]].from, side_of(leg.state)}, path);
  }
}

}  // namespace regista::graph
