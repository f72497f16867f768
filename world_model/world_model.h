// The estimate of everything on the field: takes vision frames of any number of cameras and the commands sent to
// robots, answers the world as it will be when a command sent now acts. The one entry of this folder for modules.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "world_model/ball_filter.h"
#include "world_model/camera_alignment.h"
#include "world_model/frame_gate.h"
#include "world_model/params.h"
#include "world_model/robot_filter.h"
#include "world_model/teleport_guard.h"
#include "world_model/types/vision_frame.h"
#include "world_model/types/world_state.h"

namespace regista {

struct WorldModelParams {
  RobotFilterParams robot;
  BallFilterParams ball;
  FrameGateParams frames;
  CameraAlignmentParams cameras;
  double robot_lost_after_s = 0.5;
  double ball_lost_after_s = 1.0;
  double unconfirmed_lost_after_s = 0.05;  // a few frames: a false detection that returns twice a second stays one
  /// Two: a single false detection must not stand as an obstacle for robot_lost_after_s, and one detection shows no
  /// velocity anyway; it costs one frame when a robot appears.
  std::int64_t believed_after = 2;
  /// Three: more than false detections last, less than a person who moved a robot notices.
  std::int64_t teleport_detections = 3;
  double latency_s = 0.0;
  double velocity_lag_s = 0.0;
  bool use_commands = true;
  double command_timeout_s = 0.2;  // robots brake by themselves 0.1 s after the last command
  bool operator==(const WorldModelParams&) const = default;

  template <class Self, class V>
  static void visit(Self& self, V&& v) {
    v.group("robot", self.robot);
    v.group("ball", self.ball);
    v.group("frames", self.frames);
    v.group("cameras", self.cameras);
    v("robot_lost_after_s", self.robot_lost_after_s, Range{0.0, 60.0}, "s", "a robot unseen for longer is gone");
    v("ball_lost_after_s", self.ball_lost_after_s, Range{0.0, 60.0}, "s", "a ball unseen for longer is gone");
    v("unconfirmed_lost_after_s", self.unconfirmed_lost_after_s, Range{0.0, 60.0}, "s",
      "a robot or ball not yet believed and unseen for longer is forgotten");
    v("believed_after", self.believed_after, Range{1.0, 1000.0}, "", "detections before a robot or ball is reported");
    v("teleport_detections", self.teleport_detections, Range{1.0, 1000.0}, "",
      "agreeing detections in a row elsewhere before a robot or ball is taken to be there");
    v("latency_s", self.latency_s, Range{0.0, 1.0}, "s", "capture of a frame to a command made from it acting");
    v("velocity_lag_s", self.velocity_lag_s, Range{0.0, 1.0}, "s", "first-order lag of robots behind their command");
    v("use_commands", self.use_commands, Range{0.0, 1.0}, "", "let commands sent to robots enter the estimate");
    v("command_timeout_s", self.command_timeout_s, Range{0.0, 10.0}, "s", "commands older than this count no more");
  }
};

/// Same calls in the same order, same answers. A frame slightly older than the newest (of a slower camera, within
/// frames.late_s) corrects the estimate as of its time; estimates are never moved back.
class WorldModel {
 public:
  explicit WorldModel(const WorldModelParams& params = {}) : params_(params) {}

  /// From the next call on; what is estimated stays.
  void set_params(const WorldModelParams& params) { params_ = params; }
  const WorldModelParams& params() const { return params_; }

  /// Throws std::invalid_argument, and changes nothing, where a value is not finite or not of this world.
  FrameResult add_frame(const VisionFrame& frame);

  /// How many frames add_frame gave which result, since the beginning.
  const FrameCounts& frame_counts() const { return gate_.counts(); }

  /// A command sent to a robot, in any order; of those with the same capture time the last counts. False, and not
  /// used, when the robot is not seen, or the command's capture time is a clock jump away from the newest frame. Throws
  /// std::invalid_argument where a value is not finite or not of this world.
  bool add_command(RobotId id, const SentVelocity& command);

  /// The world, predicted to the capture of the newest frame plus latency_s; ages are as of that capture. Each call
  /// counts `sequence` up, from 1. Before the first frame it is empty, at time 0.
  WorldState state();

 private:
  /// What one camera saw of a robot, before its shift was taken off.
  struct Sight {
    std::uint32_t camera = 0;
    Time captured{};
    Vec2 place_m = Vec2::Zero();
  };
  struct RobotTrack {
    RobotFilter filter;
    Time seen{};
    Sight sight{};                // the last one taken in
    Vec2 shift_m = Vec2::Zero();  // taken for its camera's in the estimate
    std::int64_t sightings = 1;
    TeleportGuard guard{};
    std::vector<SentVelocity> sent{};  // to this robot, sorted by capture time
  };
  struct BallTrack {
    BallFilter filter;
    Time seen{};
    std::uint32_t camera = 0;     // that saw it last
    Vec2 shift_m = Vec2::Zero();  // taken for its camera's in the estimate
    std::int64_t sightings = 1;
    TeleportGuard guard{};
  };

  void take_robots(const VisionFrame& frame);
  void take_robot(const RobotDetection* first, const RobotDetection* last, std::uint32_t camera, Time captured);
  bool correct(RobotTrack& track, const Pose& seen, const Sight& sight);
  Pose unshifted(const Pose& seen, std::uint32_t camera) const;
  void compare_cameras(const RobotTrack& track, const Sight& sight);
  template <class Track>
  void follow_shift(Track& track, std::uint32_t camera) const;
  void take_ball(const VisionFrame& frame);
  void remove_lost();
  CommandModel commands_of(const RobotTrack& track, Time at) const;

  WorldModelParams params_;
  FrameGate gate_;
  CameraAlignment alignment_;
  std::map<RobotId, RobotTrack> robots_;
  std::optional<BallTrack> ball_;
  std::uint64_t sequence_ = 0;
};

}  // namespace regista
