#include "sim/simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/range_check.h"

namespace regista {
namespace {

constexpr double kStep_s = to_seconds(kSimStep);

// Streams of the seed.
constexpr std::uint64_t kLinkStream = 0;
constexpr std::uint64_t kCameraStream = 1;  // and those after it, one per camera

const SimSetup& checked(const SimSetup& setup) {
  check_ranges(setup.params);
  return setup;
}

std::vector<RobotBody> bodies_of(const std::vector<RobotPlacement>& placements) {
  std::vector<RobotBody> bodies;
  bodies.reserve(placements.size());
  for (const RobotPlacement& placement : placements) bodies.push_back({placement.id, placement.pose, {}});
  std::sort(bodies.begin(), bodies.end(), [](const RobotBody& a, const RobotBody& b) { return a.id < b.id; });
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    if (bodies[i - 1].id != bodies[i].id) continue;
    throw std::invalid_argument("robot " + to_string(bodies[i].id) + " is placed twice");
  }
  return bodies;
}

std::vector<RobotId> ids_of(const std::vector<RobotBody>& bodies) {
  std::vector<RobotId> ids;
  ids.reserve(bodies.size());
  for (const RobotBody& body : bodies) ids.push_back(body.id);
  return ids;
}

BodyVelocity scaled(const BodyVelocity& velocity, double factor) {
  return {factor * velocity.forward_mps, factor * velocity.left_mps, factor * velocity.angular_radps};
}

/// They take turns: real ones are not synchronised, and evenly is the mean of all ways.
std::vector<Camera> cameras_of(const SimSetup& setup) {
  const VisionParams& params = setup.params.vision;
  std::vector<Camera> cameras;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(params.cameras); ++i) {
    const Duration turn = from_seconds(i / (params.rate_hz * static_cast<double>(params.cameras)));
    cameras.emplace_back(i, params, mixed(setup.seed, kCameraStream + i), setup.start + turn,
                         camera_view(setup.field, i, params));
  }
  return cameras;
}

}  // namespace

SimSetup sim_setup(const Scenario& scenario, Time start) {
  SimSetup setup;
  setup.robots = initial_placements(scenario);
  setup.field = field_of(scenario);
  setup.params = sim_preset(scenario.sim_preset);
  setup.seed = static_cast<std::uint64_t>(scenario.seed);
  setup.start = start;
  return setup;
}

Simulator::Simulator(const SimSetup& setup)
    : field_(setup.field),
      params_(checked(setup).params),
      walls_(walls_of(setup.field)),
      start_(setup.start),
      now_(setup.start),
      robots_collide_(setup.robots_collide),
      robots_(bodies_of(setup.robots)),
      kicker_ready_(robots_.size(), setup.start),
      link_(ids_of(robots_), params_.radio, mixed(setup.seed, kLinkStream)),
      contacts_(params_.limits.radius_m),
      cameras_(cameras_of(setup)) {
  for (RobotBody& robot : robots_) {
    check_place(robot.pose.position_m, params_.limits.radius_m, to_string(robot.id));
    if (!std::isfinite(robot.pose.heading_rad)) {
      throw std::invalid_argument("heading of " + to_string(robot.id) + " is not finite");
    }
    robot.pose.heading_rad = wrap_angle(robot.pose.heading_rad);
  }
  check_place(setup.ball_m, params_.ball.radius_m, "the ball");
  ball_.position_m = setup.ball_m;
  look_if_due();
}

void Simulator::command(const TeamCommands& commands, Time arrived) { link_.receive(commands, arrived); }

void Simulator::advance_to(Time now) {
  if (now < now_) {
    throw std::invalid_argument("simulator told to go back from " + std::to_string(to_us(now_)) + " to " +
                                std::to_string(to_us(now)) + " us");
  }
  while (now_ + kSimStep <= now) step_once();
}

void Simulator::step_once() {
  link_.update(now_);
  move_robots();
  if (robots_collide_) part_robots();
  for (RobotBody& robot : robots_) {
    keep_off(walls_, params_.limits.radius_m, 0.0, robot.pose.position_m, robot.twist.velocity_mps);
  }
  move_ball();
  now_ += kSimStep;
  look_if_due();
}

void Simulator::move_robots() {
  before_m_.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    before_m_.push_back(robots_[i].pose.position_m);
    const HeardCommand* heard = link_.heard(i, now_);
    if (heard != nullptr) {
      step(robots_[i], scaled(heard->velocity, params_.velocity_gain), params_.limits, params_.velocity_lag_s, kStep_s);
    } else {
      brake(robots_[i], params_.limits, kStep_s);
    }
  }
}

void Simulator::part_robots() {
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    farthest_m = std::max(farthest_m, (robots_[i].pose.position_m - before_m_[i]).norm());
  }
  // Two that touched on the way are at most both their ways beyond touching at its end.
  const auto& near = near_.find(robots_, contacts_.end_distance_m() + 2.0 * farthest_m);
  contacts_.observe(robots_, before_m_, near, now_ + kSimStep);
  keep_apart(robots_, near, params_.limits);
}

void Simulator::move_ball() {
  const double robot_radius = params_.limits.radius_m;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotBody& robot = robots_[i];
    if (!can_kick(ball_, robot, robot_radius, params_.ball)) continue;
    const HeardCommand* heard = link_.heard(i, now_);
    if (heard == nullptr || heard->kick_speed_mps <= 0.0 || now_ < kicker_ready_[i]) continue;
    kick(ball_, rotated({heard->kick_speed_mps, 0.0}, robot.pose.heading_rad), params_.ball);
    kicker_ready_[i] = now_ + kKickerRecharge;
  }
  step(ball_, params_.ball, kStep_s);
  for (const RobotBody& robot : robots_) push(ball_, robot, robot_radius, params_.ball);
  keep_off(walls_, params_.ball.radius_m, params_.ball.wall_restitution, ball_.position_m, ball_.velocity_mps);
}

void Simulator::look_if_due() {
  for (Camera& camera : cameras_) {
    if (camera.next_capture() <= now_) frames_.push_back(camera.capture(robots_, ball_, now_));
  }
}

std::vector<VisionFrame> Simulator::take_frames() {
  std::vector<VisionFrame> taken;
  for (; !frames_.empty() && frames_.front().sent <= now_; frames_.pop_front()) {
    taken.push_back(std::move(frames_.front()));
  }
  return taken;
}

Time Simulator::next_frame_due() const {
  if (!frames_.empty()) return on_grid(frames_.front().sent);
  Time due = Time::max();
  for (const Camera& camera : cameras_) due = std::min(due, on_grid(camera.next_capture()) + camera.latency());
  return on_grid(due);
}

Time Simulator::on_grid(Time time) const {
  const auto steps = (time - start_ + kSimStep - Duration{1}) / kSimStep;
  return start_ + steps * kSimStep;
}

void Simulator::check_place(const Vec2& position_m, double radius_m, const std::string& who) const {
  const Vec2 limit = half_extent(field_, radius_m);
  const bool inside = std::abs(position_m.x()) <= limit.x() && std::abs(position_m.y()) <= limit.y();
  if (inside) return;  // false for NaN
  throw std::invalid_argument("place (" + std::to_string(position_m.x()) + ", " + std::to_string(position_m.y()) +
                              ") m of " + who + " is not inside the boards, |x| <= " + std::to_string(limit.x()) +
                              ", |y| <= " + std::to_string(limit.y()));
}

void Simulator::teleport(RobotId id, const Pose& pose) {
  const auto robot =
      std::find_if(robots_.begin(), robots_.end(), [id](const RobotBody& body) { return body.id == id; });
  if (robot == robots_.end()) throw std::invalid_argument("there is no robot " + to_string(id));
  check_place(pose.position_m, params_.limits.radius_m, to_string(id));
  if (!std::isfinite(pose.heading_rad)) {
    throw std::invalid_argument("heading of " + to_string(id) + " is not finite");
  }
  robot->pose = {pose.position_m, wrap_angle(pose.heading_rad)};
  robot->twist = {};
}

void Simulator::teleport_ball(const Vec2& position_m, const Vec2& velocity_mps) {
  check_place(position_m, params_.ball.radius_m, "the ball");
  if (!is_finite(velocity_mps)) throw std::invalid_argument("the ball's velocity is not finite");
  ball_.position_m = position_m;
  kick(ball_, velocity_mps, params_.ball);
}

WorldState Simulator::truth() const {
  WorldState world;
  world.captured = now_;
  world.valid_at = now_;
  world.sequence = static_cast<std::uint64_t>((now_ - start_) / kSimStep);
  for (const RobotBody& robot : robots_)
    world.robots.push_back({.id = robot.id, .pose = robot.pose, .twist = robot.twist});
  world.ball = BallState{.position_m = ball_.position_m, .velocity_mps = ball_.velocity_mps};
  return world;
}

}  // namespace regista
