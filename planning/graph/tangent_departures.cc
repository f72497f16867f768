// How a tangent search goes on from where a free leg arrives: along the arc, and off it by the legs to what is active.
#include <algorithm>

#include "planning/graph/tangent_front.h"

namespace regista::graph {
namespace {

/// A place counts as not beyond another (in order).
constexpr double kSamePlace = 1e-9;

/// Costs that differ by less are equal. Metres.
constexpr double kRounding_m = 1e-12;

/// Departures that lead on over so much longer ways than what is being looked at wait.
constexpr double kDetour_m = 0.4;  // measured: from 0.05 to 0.4 the time falls by 2 %

/// Short searches end before a better estimate has paid.
constexpr int kLegsBeforeDetours = 3;

/// Half of a disc's boundary, in order. Where nothing cuts the disc, who goes on farther has gone the longer way round.
constexpr double kHalfRound = 2.0;

}  // namespace

/// Makes the departures from where the leg arrives; false when an earlier arrival stands for them.
bool TangentFront::expand(SharedGraph& graph, LegIndex index) {
  const Leg& leg = legs_[index];
  const ActiveObstacles::Slot& slot = active_[leg.state / 2];
  const double side = side_of(leg.state);
  const std::span<const Cut> cuts = graph.contacts(slot.obstacle).cuts;
  ArrivalIndex& first_here = first_here_[leg.state];
  double order = 0.0;
  if (!cuts.empty() || first_here != kNone) order = order_of(slot.body, leg.to);
  for (ArrivalIndex other = first_here; other != kNone; other = arrivals_[other].next_here) {
    const Arrival& earlier = arrivals_[other];
    const Leg& earlier_leg = legs_[earlier.leg];
    if (earlier_leg.cost + travel_m(slot.body, earlier_leg.to, leg.to, side) > leg.cost + kRounding_m) continue;
    const double earlier_order = cuts.empty() ? order_of(slot.body, earlier_leg.to) : earlier.order;
    if (ahead(slot.body, earlier_order, order, side) <= earlier.reach + kSamePlace) return false;
  }
  double reach = slot.body.period;
  ObstacleIndex stopped_by = kBounds;
  for (const Cut& cut : cuts) {
    if (cut.other != kBounds && is_ignored(cut.other, query_.ignored)) continue;
    const double distance = cut.is_whole ? 0.0 : ahead(slot.body, order, side > 0.0 ? cut.from : cut.to, side);
    if (distance >= reach) continue;
    reach = distance;
    stopped_by = cut.other;
  }
  if (reach == slot.body.period && slot.body.count == 1) reach = kHalfRound;
  if (stopped_by != kBounds && !active_.contains(stopped_by)) pending_.push_back(stopped_by);
  const auto arrival = static_cast<ArrivalIndex>(arrivals_.size());
  arrivals_.push_back({{leg.to.point, leg.cost, window_of(slot.body, leg, reach, order)},
                       reach,
                       order,
                       -kInfinite_m,
                       kInfinite_m,
                       index,
                       leg.state,
                       first_here,
                       {}});
  first_here = arrival;
  make_departures(arrival);
  depart(arrival, goal_, 1.0, kGoalState);
  return true;
}

/// No way that goes on from there is shorter, as far as those active obstacles show that are not among the first few.
double TangentFront::least_to_goal_m(const Vec2& from, std::uint32_t few) {
  for (std::size_t slot = detours_.size(); slot < active_.size(); ++slot) {
    detours_.add(field_->obstacles()[active_.list()[slot]], field_->bounds());
  }
  return detours_.least_m(from, query_.goal, few);
}

/// What has become active since the leg was made shows that it leads to longer ways: it goes back into the queue.
bool TangentFront::is_put_off(const SearchQueue::Entry& entry) {
  Leg& leg = legs_[entry.index];
  if (leg.state == kGoalState || leg.bound_by == active_.size() || legs_tested_ < kLegsBeforeDetours) return false;
  const double estimate_m = leg.cost + least_to_goal_m(leg.to.point, leg.bound_by);
  leg.bound_by = static_cast<std::uint32_t>(active_.size());
  if (estimate_m <= entry.estimate_m + kPutOff_m) return false;
  queue_.push({estimate_m, entry.index, false});
  return true;
}

/// From the leg's end as far as its reach.
Departures TangentFront::window_of(const Body& body, const Leg& leg, double reach, double order) {
  constexpr double kSurely = 0.01;
  if (body.count != 1) return {};
  const double side = side_of(leg.state);
  if (reach == kHalfRound) return {true, side, leg.to.normal, -leg.to.normal};
  if (reach > kHalfRound - kSurely) return {};
  return {true, side, leg.to.normal, disc_normal(order + side * reach)};
}

/// Makes those that are due, and puts off the others until nothing better is left.
void TangentFront::make_departures(ArrivalIndex index) {
  Arrival& arrival = arrivals_[index];
  const double made_m = arrival.made_m;
  const double due_m = horizon_m_ + kDetour_m;
  const State own = arrival.state / 2;
  double next_m = kInfinite_m;
  const std::span<const double> least_m = active_.least_ways_m(arrival.departure);
  for (State slot = 0; slot < least_m.size(); ++slot) {
    if (slot == own) continue;
    if (least_m[slot] > due_m) {
      next_m = std::min(next_m, least_m[slot]);
    } else if (least_m[slot] > made_m) {
      depart_to_slot(index, slot);
    }
  }
  arrival.made_m = due_m;
  arrival.next_m = next_m;
  if (next_m < kInfinite_m) queue_.push({next_m, index, true});
}

void TangentFront::depart_to_slot(ArrivalIndex index, State slot) {
  const Body& to = active_[slot].body;
  const Arrival& arrival = arrivals_[index];
  const bool is_start = arrival.state == kStartState;
  const Body& from = is_start ? start_ : active_[arrival.state / 2].body;
  if (from.count == 1 && to.count == 1) {
    const auto visit = [&](const Tangent& tangent, bool is_second) {
      add_leg(index, from, tangent, 2 * slot + (is_second ? 1 : 0));
    };
    if (for_disc_tangents(from, is_start ? 1.0 : side_of(arrival.state), to, arrival.departure.window, visit)) return;
  }
  depart(index, to, side_of(0), 2 * slot);
  depart(index, to, side_of(1), 2 * slot + 1);
}

void TangentFront::depart(ArrivalIndex index, const Body& to, double to_side, State state) {
  const Arrival& arrival = arrivals_[index];
  const bool is_start = arrival.state == kStartState;
  const Body& from = is_start ? start_ : active_[arrival.state / 2].body;
  for_tangents(from, is_start ? 1.0 : side_of(arrival.state), to, to_side, arrival.departure.window,
               [&](const Tangent& tangent) { add_leg(index, from, tangent, state); });
}

void TangentFront::add_leg(ArrivalIndex index, const Body& from, const Tangent& tangent, State state) {
  Arrival& arrival = arrivals_[index];
  const bool is_start = arrival.state == kStartState;
  const double side = is_start ? 1.0 : side_of(arrival.state);
  // Half way round, the departures say it all.
  const bool is_cut = !is_start && arrival.reach < from.period && arrival.reach != kHalfRound;
  if (is_cut && ahead(from, arrival.order, order_of(from, tangent.from), side) > arrival.reach + kSamePlace) return;
  if (!active_.blockers().are_clear_of(*field_, {tangent.from.point, tangent.to.point, tangent.along},
                                       arrival.state / 2, state / 2, arrival.occluders))
    return;
  const double along_m = is_start ? 0.0 : travel_m(from, legs_[arrival.leg].to, tangent.from, side);
  const double cost = arrival.departure.cost_m + along_m + tangent.length_m;
  const auto known = static_cast<std::uint32_t>(active_.size());
  const bool is_early = legs_tested_ < kLegsBeforeDetours;
  double estimate_m = cost;
  if (state != kGoalState) {
    const Vec2& from_there = tangent.to.point;
    estimate_m += is_early ? (query_.goal - from_there).norm() : least_to_goal_m(from_there, 0);
  }
  queue_.push({estimate_m, static_cast<LegIndex>(legs_.size()), false});
  legs_.push_back({tangent.from, tangent.to, tangent.along, cost, index, state, known, is_early ? 0 : known});
}

}  // namespace regista::graph
