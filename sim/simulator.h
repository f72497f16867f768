// The field's stand-in: commands in, vision frames out. Kinematic, in fixed steps of one millisecond; the same setup
// and the same calls give the same bytes.
#pragma once

#include <deque>
#include <vector>

#include "sim/camera_model.h"
#include "sim/command_link.h"
#include "sim/contacts.h"
#include "sim/formation.h"
#include "sim/scenario.h"
#include "sim/walls.h"
#include "world_model/types/world_state.h"

namespace regista {

/// The inner step. Long enough to be cheap, short enough that a robot at 3 m/s moves 3 mm in it.
inline constexpr Duration kSimStep{1000};

/// A kicker fires again after this time. Kickers charge capacitors; a guess on the fast side.
inline constexpr Duration kKickerRecharge{200'000};

struct SimSetup {
  FieldGeometry field;
  SimParams params;
  std::vector<RobotPlacement> robots;  ///< any order, each id once
  Vec2 ball_m = Vec2::Zero();
  std::uint64_t seed = 1;
  Time start{};
  bool robots_collide = true;  ///< false: they pass through each other and no contact is counted, for comparisons
  bool operator==(const SimSetup&) const = default;
};

/// A scenario's field, preset, formation and seed, the ball in the centre. Throws as validate(scenario).
SimSetup sim_setup(const Scenario& scenario, Time start);

class Simulator {
 public:
  /// Everything stands. The first camera's first frame is captured at setup.start. Throws std::invalid_argument when a
  /// parameter is out of its range, an id occurs twice, or something is placed outside the boards.
  explicit Simulator(const SimSetup& setup);

  /// Commands that arrive at the simulator at that time; they act from the step that begins radio.latency_s later, the
  /// newest wins. Throws std::invalid_argument, taking none, when a number is not finite.
  void command(const TeamCommands& commands, Time arrived);

  /// Simulates whole steps up to `now`. Throws std::invalid_argument when that lies before now().
  void advance_to(Time now);

  /// Frames sent by now() and not taken yet, oldest first.
  std::vector<VisionFrame> take_frames();
  /// The earliest moment to advance to for which take_frames() has something.
  Time next_frame_due() const;

  /// Moves a robot or the ball; a robot stands afterwards. Throws std::invalid_argument for an unknown robot, a number
  /// that is not finite, or a place outside the boards.
  void teleport(RobotId id, const Pose& pose);
  void teleport_ball(const Vec2& position_m, const Vec2& velocity_mps);

  Time now() const { return now_; }
  /// How everything is, without noise. sequence counts steps.
  WorldState truth() const;
  /// The newest, as ContactLog keeps them.
  const std::deque<Contact>& contacts() const { return contacts_.contacts(); }
  const ContactCounts& contact_counts() const { return contacts_.counts(); }
  const FieldGeometry& field() const { return field_; }
  const SimParams& params() const { return params_; }

 private:
  void step_once();
  void move_robots();
  void part_robots();
  void move_ball();
  void look_if_due();
  Time on_grid(Time time) const;
  void check_place(const Vec2& position_m, double radius_m, const std::string& who) const;

  FieldGeometry field_;
  SimParams params_;
  Walls walls_;
  Time start_;
  Time now_;
  bool robots_collide_;
  std::vector<RobotBody> robots_;   // sorted by id
  std::vector<Vec2> before_m_;      // where each was when the step began
  std::vector<Time> kicker_ready_;  // per robot
  BallBody ball_;
  CommandLink link_;
  NearPairs near_;
  ContactLog contacts_;
  std::vector<Camera> cameras_;
  std::deque<VisionFrame> frames_;  // captured, not taken yet
};

}  // namespace regista
