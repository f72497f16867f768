#include "world_model/world_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "world_model/prediction.h"
#include "world_model/types/plausible.h"

namespace regista {
namespace {

constexpr double kHeading_rad = 100.0;  // a source may count turns, but not for ever

/// Commands kept per robot: 100 Hz over the longest latency_s and robot_lost_after_s, 61 s.
constexpr std::size_t kCommandsMax = 6400;

void require(double value, double limit, const std::string& what) {
  if (is_plausible(value, limit)) return;
  throw std::invalid_argument(what + " is " + std::to_string(value) + ", outside ±" + std::to_string(limit));
}

void require(Time time, const std::string& what) {
  if (to_us(time) <= kLatestStamp_us && to_us(time) >= -kLatestStamp_us) return;
  throw std::invalid_argument(what + " is " + std::to_string(to_us(time)) + " us, no possible time");
}

void require(const Vec2& position_m, double confidence, const std::string& whose) {
  require(position_m.x(), kFarthest_m, whose + ": x in m");
  require(position_m.y(), kFarthest_m, whose + ": y in m");
  require(confidence, 1e6, whose + ": confidence");
}

void require(const VisionFrame& frame) {
  require(frame.captured, "capture time");
  for (const RobotDetection& robot : frame.robots) {
    require(robot.pose.position_m, robot.confidence, "robot " + to_string(robot.id));
    require(robot.pose.heading_rad, kHeading_rad, "robot " + to_string(robot.id) + ": heading in rad");
  }
  for (const BallDetection& ball : frame.balls) require(ball.position_m, ball.confidence, "ball");
}

/// Some order of detections that does not depend on the order they were listed in.
auto rank(const Vec2& position_m, double confidence) { return std::tuple(-confidence, position_m.x(), position_m.y()); }

}  // namespace

FrameResult WorldModel::add_frame(const VisionFrame& frame) {
  require(frame);
  const FrameResult result = gate_.judge(frame, params_.frames);
  if (result == FrameResult::restarted) {
    robots_.clear();
    ball_.reset();
    alignment_ = {};  // another field, or another simulator
  } else if (result != FrameResult::taken) {
    return result;
  }
  take_robots(frame);
  take_ball(frame);
  remove_lost();
  return result;
}

void WorldModel::take_robots(const VisionFrame& frame) {
  std::vector<RobotDetection> robots = frame.robots;
  std::sort(robots.begin(), robots.end(), [](const RobotDetection& a, const RobotDetection& b) {
    return std::tuple(a.id, rank(a.pose.position_m, a.confidence), a.pose.heading_rad) <
           std::tuple(b.id, rank(b.pose.position_m, b.confidence), b.pose.heading_rad);
  });
  const RobotDetection* end = robots.data() + robots.size();
  for (const RobotDetection* first = robots.data(); first != end;) {
    const RobotDetection* last =
        std::find_if(first, end, [&](const RobotDetection& other) { return other.id != first->id; });
    take_robot(first, last, frame.camera, frame.captured);
    first = last;
  }
}

/// All detections of one id in one frame, the most confident first: the one nearest to the prediction is the robot.
void WorldModel::take_robot(const RobotDetection* first, const RobotDetection* last, std::uint32_t camera,
                            Time captured) {
  const auto found = robots_.find(first->id);
  if (found == robots_.end()) {
    const Sight sight{camera, captured, first->pose.position_m};
    const RobotFilter filter(unshifted(first->pose, camera), captured, params_.robot);
    robots_.emplace(first->id, RobotTrack{filter, captured, sight, alignment_.shift_m(camera)});
    return;
  }
  RobotTrack& track = found->second;
  follow_shift(track, track.sight.camera);
  track.filter.advance(captured, commands_of(track, captured), params_.robot);
  const auto distance_m = [&](const RobotDetection& seen) {
    return track.filter.distance_m(unshifted(seen.pose, camera), captured);
  };
  const Pose& seen = std::min_element(first, last, [&](const RobotDetection& a, const RobotDetection& b) {
                       return distance_m(a) < distance_m(b);
                     })->pose;
  const Sight sight{camera, captured, seen.position_m};
  if (!correct(track, seen, sight)) return;
  track.sight = sight;
  track.shift_m = alignment_.shift_m(camera);
  track.seen = std::max(track.seen, captured);
  ++track.sightings;
}

/// Takes the detection in, or begins anew where it and those before show that the robot is elsewhere. False: ignored.
bool WorldModel::correct(RobotTrack& track, const Pose& seen, const Sight& sight) {
  const Pose pose = unshifted(seen, sight.camera);
  if (track.filter.accepts(pose, sight.captured, params_.robot)) {
    track.guard.accepted();
    compare_cameras(track, sight);
    follow_shift(track, track.sight.camera);
    track.filter.correct(unshifted(seen, sight.camera), sight.captured, params_.robot);
    return true;
  }
  if (sight.captured < track.filter.time() ||
      !track.guard.refused(pose.position_m, sight.captured, params_.robot.gate_m, 2.0 * params_.robot.speed_sigma_mps,
                           params_.teleport_detections)) {
    return false;
  }
  track.filter = RobotFilter(pose, sight.captured, params_.robot);
  return true;
}

Pose WorldModel::unshifted(const Pose& seen, std::uint32_t camera) const {
  return {seen.position_m - alignment_.shift_m(camera), seen.heading_rad};
}

/// A robot seen by one camera and shortly after by another tells how both lie beside each other, once its velocity is
/// known so well that the way in between is no matter.
void WorldModel::compare_cameras(const RobotTrack& track, const Sight& sight) {
  const Sight& before = track.sight;
  const double apart_s = to_seconds(sight.captured - before.captured);
  if (!params_.cameras.learn || before.camera == sight.camera || std::abs(apart_s) > params_.cameras.pair_within_s) {
    return;
  }
  const double way_sigma_m = std::sqrt(track.filter.x().rate_variance) * std::abs(apart_s);
  constexpr double kNoMatter = 0.25;  // of the sights' own noise: a sixteenth of the variance
  if (way_sigma_m > kNoMatter * params_.cameras.pair_sigma_m) return;
  const Vec2 velocity_mps(track.filter.x().rate, track.filter.y().rate);
  alignment_.compare(before.camera, before.place_m + apart_s * velocity_mps, sight.camera, sight.place_m,
                     params_.cameras);
}

/// What is newly known of a camera moves what it saw, and that is no motion.
template <class Track>
void WorldModel::follow_shift(Track& track, std::uint32_t camera) const {
  const Vec2 shift_m = alignment_.shift_m(camera);
  track.filter.shift(track.shift_m - shift_m);
  track.shift_m = shift_m;
}

void WorldModel::take_ball(const VisionFrame& frame) {
  if (frame.balls.empty()) return;
  const Time captured = frame.captured;
  const Vec2 shift_m = alignment_.shift_m(frame.camera);
  if (!ball_) {
    const auto best =
        std::min_element(frame.balls.begin(), frame.balls.end(), [](const BallDetection& a, const BallDetection& b) {
          return rank(a.position_m, a.confidence) < rank(b.position_m, b.confidence);
        });
    ball_.emplace(
        BallTrack{BallFilter(best->position_m - shift_m, captured, params_.ball), captured, frame.camera, shift_m});
    return;
  }
  follow_shift(*ball_, ball_->camera);
  BallFilter& filter = ball_->filter;
  filter.advance(captured, params_.ball);
  const auto distance = [&](const BallDetection& ball) {
    return std::tuple(filter.distance_m(ball.position_m - shift_m, captured), rank(ball.position_m, ball.confidence));
  };
  const Vec2 position_m =
      std::min_element(frame.balls.begin(), frame.balls.end(),
                       [&](const BallDetection& a, const BallDetection& b) { return distance(a) < distance(b); })
          ->position_m -
      shift_m;
  if (filter.accepts(position_m, captured, params_.ball)) {
    ball_->guard.accepted();
    filter.correct(position_m, captured, params_.ball);
  } else if (captured >= filter.time() &&
             ball_->guard.refused(position_m, captured, params_.ball.gate_m, params_.ball.speed_max_mps,
                                  params_.teleport_detections)) {
    filter = BallFilter(position_m, captured, params_.ball);
  } else {
    return;
  }
  ball_->camera = frame.camera;
  ball_->shift_m = shift_m;
  ball_->seen = std::max(ball_->seen, captured);
  ++ball_->sightings;
}

void WorldModel::remove_lost() {
  const auto lost = [&](const auto& track, double lost_after_s) {
    const bool believed = track.sightings >= params_.believed_after;
    const double after_s = believed ? lost_after_s : std::min(lost_after_s, params_.unconfirmed_lost_after_s);
    return *gate_.newest() - track.seen > from_seconds(after_s);
  };
  std::erase_if(robots_, [&](const auto& entry) { return lost(entry.second, params_.robot_lost_after_s); });
  if (ball_ && lost(*ball_, params_.ball_lost_after_s)) ball_.reset();
}

bool WorldModel::add_command(RobotId id, const SentVelocity& command) {
  const std::string whose = "command of robot " + to_string(id);
  require(command.captured, whose + ": capture time");
  require(command.velocity.forward_mps, kFastest_mps, whose + ": forward in m/s");
  require(command.velocity.left_mps, kFastest_mps, whose + ": left in m/s");
  require(command.velocity.angular_radps, kFastestTurn_radps, whose + ": angular in rad/s");
  const auto found = robots_.find(id);
  if (found == robots_.end()) return false;
  const double ahead_s = to_seconds(command.captured - *gate_.newest());
  if (ahead_s < -params_.frames.clock_back_s || ahead_s > params_.frames.clock_back_s) return false;

  RobotTrack& track = found->second;
  std::vector<SentVelocity>& sent = track.sent;
  const auto at = std::lower_bound(sent.begin(), sent.end(), command.captured,
                                   [](const SentVelocity& known, Time captured) { return known.captured < captured; });
  if (at != sent.end() && at->captured == command.captured) {
    *at = command;
  } else {
    sent.insert(at, command);
  }
  // Only what moves the robot after its estimate's time will be asked for: the first may go once the second acts then.
  const Time asked = track.filter.time() - from_seconds(params_.latency_s);
  const auto acting =
      std::find_if(sent.begin() + 1, sent.end(), [&](const auto& next) { return next.captured > asked; });
  sent.erase(sent.begin(), acting - 1);
  if (sent.size() > kCommandsMax) sent.erase(sent.begin());
  return true;
}

/// The commands that tell how the robot moves until `at`; none where they have stopped coming.
CommandModel WorldModel::commands_of(const RobotTrack& track, Time at) const {
  if (!params_.use_commands || track.sent.empty()) return {};
  const Duration latency = from_seconds(params_.latency_s);
  if (at - (track.sent.back().captured + latency) > from_seconds(params_.command_timeout_s)) return {};
  return {track.sent, latency, params_.velocity_lag_s};
}

WorldState WorldModel::state() {
  WorldState world;
  world.sequence = ++sequence_;
  if (!gate_.newest()) return world;
  world.captured = *gate_.newest();
  world.valid_at = world.captured + from_seconds(params_.latency_s);
  world.robots.reserve(robots_.size());
  for (auto& [id, track] : robots_) {
    follow_shift(track, track.sight.camera);
    if (track.sightings < params_.believed_after) continue;
    RobotFilter filter = track.filter;
    filter.advance(world.captured, commands_of(track, world.captured), params_.robot);
    const CommandModel ahead = commands_of(track, world.valid_at);
    RobotState robot = predicted(filter.state(id, world.captured - track.seen), world.captured, world.valid_at,
                                 ahead.sent, ahead.latency, ahead.velocity_lag_s);
    filter.advance(world.valid_at, {}, params_.robot);  // for the variances
    const RobotState coasted = filter.state(id, {});
    robot.position_variance_m2 = coasted.position_variance_m2;
    robot.velocity_variance_m2ps2 = coasted.velocity_variance_m2ps2;
    robot.heading_variance_rad2 = coasted.heading_variance_rad2;
    world.robots.push_back(robot);
  }
  if (ball_ && ball_->sightings >= params_.believed_after) {
    follow_shift(*ball_, ball_->camera);
    BallFilter filter = ball_->filter;
    filter.advance(world.valid_at, params_.ball);
    world.ball = filter.state(world.captured - ball_->seen);
  }
  return world;
}

}  // namespace regista
