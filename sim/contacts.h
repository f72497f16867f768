// Contacts between robots: counts them, judges who is at fault (SSL rules, "Crashing"), keeps the bodies apart.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "sim/near_pairs.h"
#include "sim/robot_model.h"
#include "world_model/types/crash_rule.h"
#include "world_model/types/time.h"

namespace regista {

/// A contact begins when discs overlap at any moment of a step and ends when they are this far apart, so that shaking
/// is one contact. Metres.
inline constexpr double kContactHysteresis_m = 0.01;

/// How many contacts a log keeps: minutes of a crowded game, however long a run is.
inline constexpr std::size_t kContactsKept = 1000;

struct Contact {
  Time at{};      ///< when it began
  RobotId first;  ///< the smaller id
  RobotId second;
  double closing_speed_mps = 0.0;  ///< when it began, along the line of centres; negative: going apart
  Fault fault = Fault::none;       ///< of a crash between opponents; none inside a team
  bool operator==(const Contact&) const = default;
};

struct ContactCounts {
  std::int64_t own_yellow = 0;
  std::int64_t own_blue = 0;
  std::int64_t opponent = 0;
  std::int64_t at_fault_yellow = 0;  ///< contacts with opponents, alone or shared guilt
  std::int64_t at_fault_blue = 0;
  bool operator==(const ContactCounts&) const = default;
};

/// Relative speed along the line of centres, positive when the robots approach.
double closing_speed_mps(const RobotBody& a, const RobotBody& b);

/// The crash rule for two robots that touch with these velocities, whatever their teams.
Fault crash_fault(const RobotBody& first, const RobotBody& second);

class ContactLog {
 public:
  explicit ContactLog(double robot_radius_m);

  /// Distance of centres up to which observe() must be told all pairs.
  double end_distance_m() const { return 2.0 * robot_radius_m_ + kContactHysteresis_m; }
  /// Looks at one step that ends now, before keep_apart changes the velocities. `before_m` is where each robot was when
  /// the step began; in between all went straight on. `near` as NearPairs finds them, in the distance that a pair may
  /// have come through in the step.
  void observe(const std::vector<RobotBody>& robots, std::span<const Vec2> before_m, const std::vector<IndexPair>& near,
               Time now);

  /// The newest kContactsKept, oldest first; counts() are of all.
  const std::deque<Contact>& contacts() const { return contacts_; }
  const ContactCounts& counts() const { return counts_; }

 private:
  void begin(const RobotBody& a, const RobotBody& b, Time now);

  double robot_radius_m_;
  std::vector<IndexPair> touching_;  // sorted
  std::vector<IndexPair> still_touching_;
  std::deque<Contact> contacts_;
  ContactCounts counts_;
};

/// Moves overlapping robots apart, each by half, and takes away their closing velocity: along the line of centres both
/// go on with the mean (equal masses, no bounce); nobody leaves faster than a robot can drive.
void keep_apart(std::vector<RobotBody>& robots, const std::vector<IndexPair>& near, const RobotLimits& limits);

}  // namespace regista
