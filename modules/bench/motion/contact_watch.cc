#include "modules/bench/motion/contact_watch.h"

#include <algorithm>

namespace regista::bench {

ContactTally& ContactTally::operator+=(const ContactTally& other) {
  own += other.own;
  own_pushed += other.own_pushed;
  own_touching_s += other.own_touching_s;
  opponent += other.opponent;
  opponent_touching_s += other.opponent_touching_s;
  at_fault += other.at_fault;
  at_fault_pushed += other.at_fault_pushed;
  return *this;
}

void ContactWatch::observe(const Simulator& simulator, const WorldState& truth, double dt_s) {
  const ContactCounts& counts = simulator.contact_counts();
  const std::int64_t all = counts.own_yellow + counts.own_blue + counts.opponent;
  const auto& contacts = simulator.contacts();
  const auto fresh = std::min(all - seen_, static_cast<std::int64_t>(contacts.size()));
  std::for_each(contacts.end() - fresh, contacts.end(), [this](const Contact& contact) { begin(contact); });
  seen_ = all;
  tally_.at_fault = team_ == Team::yellow ? counts.at_fault_yellow : counts.at_fault_blue;
  const double end_m = 2.0 * robot_radius_m_ + kContactHysteresis_m;
  std::erase_if(touching_, [&](const Touch& touch) {
    const RobotState* first = find_robot(truth, touch.first);
    const RobotState* second = find_robot(truth, touch.second);
    return (first->pose.position_m - second->pose.position_m).norm() > end_m;
  });
  for (const Touch& touch : touching_) {
    const bool own = touch.first.team == touch.second.team;
    (own ? tally_.own_touching_s : tally_.opponent_touching_s) += dt_s;
    if (!own) pushed_at_[touch.first.team == team_ ? touch.first : touch.second] = truth.captured;
  }
}

void ContactWatch::begin(const Contact& contact) {
  const bool ours_first = contact.first.team == team_;
  const bool ours_second = contact.second.team == team_;
  if (!ours_first && !ours_second) return;
  touching_.push_back({contact.first, contact.second});
  if (ours_first != ours_second) {
    ++tally_.opponent;
    const RobotId ours = ours_first ? contact.first : contact.second;
    const bool is_guilty = contact.fault == Fault::both || contact.fault == (ours_first ? Fault::first : Fault::second);
    if (is_guilty && was_pushed(ours, contact.at)) ++tally_.at_fault_pushed;
    pushed_at_[ours] = contact.at;
    return;
  }
  ++tally_.own;
  if (!was_pushed(contact.first, contact.at) && !was_pushed(contact.second, contact.at)) return;
  ++tally_.own_pushed;
  // It passes the push on: neither goes where it wanted.
  pushed_at_[contact.first] = contact.at;
  pushed_at_[contact.second] = contact.at;
}

bool ContactWatch::was_pushed(RobotId robot, Time now) const {
  const auto pushed = pushed_at_.find(robot);
  return pushed != pushed_at_.end() && now - pushed->second <= kPushMemory;
}

}  // namespace regista::bench
