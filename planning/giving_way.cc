#include "planning/giving_way.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace regista {
namespace {

/// Who is so near to the goal has arrived: nobody waits for him to pass.
constexpr double kArrived_m = 0.05;

/// Where both ways out are about equal, the one of the higher index goes.
constexpr double kAboutEqual_m = 0.1;

constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

class GivingWay {
 public:
  GivingWay(const ObstacleField& field, std::span<const std::size_t> mates, double within_m,
            std::span<const Traveller> travellers)
      : space_(field), mates_(mates), within_m_(within_m), travellers_(travellers), ways_(travellers.size()) {
    for (std::size_t i = 0; i < travellers.size(); ++i) met_.push_back(closed_by(i));
  }

  /// Nothing for who does not give way.
  std::optional<Plan> plan_of(std::size_t traveller) {
    const std::size_t other = met_[traveller];
    if (other == kNobody) return std::nullopt;
    const std::span<const Vec2> of_other = way_of(other).path;
    const Traveller& self = travellers_[traveller];
    std::optional<Plan> plan =
        space_.is_clear(self, of_other) ? space_.held_back(self, of_other) : space_.way_out(self, of_other, within_m_);
    if (!plan || (met_[other] == traveller && !goes_aside(traveller, other, plan->length_m))) return std::nullopt;
    plan->status = PlanStatus::unreachable;
    plan->reason = "obstacles close every way; gives way to a team-mate";
    return plan;
  }

 private:
  /// As if no team-mate stood anywhere, but perhaps one.
  Plan plan_without_mates(std::size_t traveller, std::size_t but) {
    std::vector<std::size_t> ignored;
    std::ranges::set_union(travellers_[traveller].ignored, mates_, std::back_inserter(ignored));
    std::erase(ignored, but);
    return space_.plan(travellers_[traveller], travellers_[traveller].goal, std::move(ignored),
                       std::numeric_limits<double>::infinity());
  }

  /// What it drives, or will once team-mates let it.
  const Plan& way_of(std::size_t traveller) {
    std::optional<Plan>& way = ways_[traveller];
    const Plan& own = *travellers_[traveller].plan;
    if (!way) way = own.status == PlanStatus::ok ? own : plan_without_mates(traveller, kNobody);
    return *way;
  }

  /// The team-mate under way that stands first in a robot's only way and closes it alone: in a crowd there is a way
  /// again soon.
  std::size_t closed_by(std::size_t traveller) {
    if (travellers_[traveller].plan->status != PlanStatus::unreachable) return kNobody;
    const std::size_t other = first_met(traveller);
    if (other == kNobody) return kNobody;
    const Plan& way = way_of(other);
    if (way.status != PlanStatus::ok || way.length_m < kArrived_m) return kNobody;
    const Plan alone = plan_without_mates(traveller, travellers_[other].obstacle);
    return alone.status == PlanStatus::unreachable ? other : kNobody;
  }

  std::size_t first_met(std::size_t traveller) {
    const Plan& way = way_of(traveller);
    if (way.status != PlanStatus::ok) return kNobody;
    const std::span<const Obstacle> obstacles = space_.field().obstacles();
    std::size_t first = kNobody;
    for (std::size_t leg = 1; leg < way.path.size() && first == kNobody; ++leg) {
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const std::size_t mate : mates_) {
        if (mate == travellers_[traveller].obstacle) continue;
        if (is_free(way.path[leg - 1], way.path[leg], obstacles[mate])) continue;
        const double from_m = (obstacles[mate].a - way.path[leg - 1]).norm();
        if (from_m < nearest_m) first = mate;
        nearest_m = std::min(nearest_m, from_m);
      }
    }
    const auto met = std::ranges::find(travellers_, first, &Traveller::obstacle);
    return met == travellers_.end() ? kNobody : static_cast<std::size_t>(met - travellers_.begin());
  }

  /// Of two that stand in each other's way: the one, by a way of that length, that gets out of it sooner.
  bool goes_aside(std::size_t traveller, std::size_t other, double length_m) {
    const std::optional<Plan> out = space_.way_out(travellers_[other], way_of(traveller).path, within_m_);
    const bool is_higher = travellers_[traveller].obstacle > travellers_[other].obstacle;
    return !out || length_m < out->length_m + (is_higher ? kAboutEqual_m : -kAboutEqual_m);
  }

  OutOfTheWay space_;
  std::span<const std::size_t> mates_;
  double within_m_;
  std::span<const Traveller> travellers_;
  std::vector<std::optional<Plan>> ways_;  ///< by traveller
  std::vector<std::size_t> met_;           ///< by traveller: who closes its way, or kNobody
};

}  // namespace

void give_way(const ObstacleField& field, std::span<const std::size_t> mates, double within_m,
              std::span<const Traveller> travellers) {
  if (within_m <= 0.0) return;
  GivingWay decision(field, mates, within_m, travellers);
  std::vector<std::pair<Plan*, Plan>> changes;  // decided by what was planned
  for (std::size_t i = 0; i < travellers.size(); ++i) {
    if (std::optional<Plan> plan = decision.plan_of(i)) changes.emplace_back(travellers[i].plan, std::move(*plan));
  }
  for (auto& [plan, change] : changes) *plan = std::move(change);
}

}  // namespace regista
