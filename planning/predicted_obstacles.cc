#include "planning/predicted_obstacles.h"

#include <array>

#include "planning/clearance.h"

namespace regista {
namespace {

/// Smaller by what the point is covered; a core that holds it cannot be helped.
double uncovering_radius(const Obstacle& obstacle, const Vec2& point) {
  return std::max(0.0, obstacle.radius_m + std::min(0.0, clearance(point, obstacle)));
}

/// An opponent slower than this stands, or creeps as the noise of vision makes it, and is no guess.
constexpr double kStands_mps = 0.1;

/// How much of an opponent's radius is left, and until when that is to be known.
class Fading {
 public:
  Fading(double speed_mps, const Prediction& prediction)
      : speed_mps_(speed_mps),
        prediction_(prediction),
        fades_(prediction.fade_over_m > 0.0 && speed_mps > kStands_mps) {}

  double gone_s() const { return fades_ ? (prediction_.fade_from_m + prediction_.fade_over_m) / speed_mps_ : 0.0; }
  double share_at(double time_s) const {
    if (!fades_) return 1.0;
    const double beyond_m = speed_mps_ * time_s - prediction_.fade_from_m;
    return 1.0 - std::clamp(beyond_m / prediction_.fade_over_m, 0.0, 1.0);
  }

 private:
  double speed_mps_;
  const Prediction& prediction_;
  bool fades_;
};

}  // namespace

double nearest_approach_s(const Course& a, const Course& b, double horizon_s) {
  std::array turns_s{0.0, std::min(a.lasts_s, horizon_s), std::min(b.lasts_s, horizon_s), horizon_s};
  if (turns_s[1] > turns_s[2]) std::swap(turns_s[1], turns_s[2]);
  double approach_s = 0.0;
  Vec2 apart = b.from_m - a.from_m;
  double least = apart.squaredNorm();
  for (std::size_t i = 0; i + 1 < turns_s.size(); ++i) {
    const double length_s = turns_s[i + 1] - turns_s[i];
    const Vec2 then = b.at(turns_s[i + 1]) - a.at(turns_s[i + 1]);
    const Vec2 change = then - apart;
    const double change2 = change.squaredNorm();
    if (change2 > 0.0) {
      const double share = std::clamp(-apart.dot(change) / change2, 0.0, 1.0);
      const double distance2 = (apart + share * change).squaredNorm();
      if (distance2 < least) {
        least = distance2;
        approach_s = turns_s[i] + share * length_s;
      }
    }
    apart = then;
  }
  return approach_s;
}

Course own_course(const RobotState& self, const Vec2& goal, const Prediction& prediction) {
  Course course{self.pose.position_m, Vec2::Zero(), 0.0};
  const Vec2 way = goal - self.pose.position_m;
  if (!(prediction.speed_mps > 0.0) || way.isZero(0.0)) return course;
  if (prediction.turn_mps2 > 0.0) {
    const Vec2 off_mps = self.twist.velocity_mps - prediction.speed_mps * way.normalized();
    course.from_m += off_mps * off_mps.norm() / (2.0 * prediction.turn_mps2);
  }
  const Vec2 rest = goal - course.from_m;
  course.velocity_mps = prediction.speed_mps * rest.stableNormalized();
  course.lasts_s = rest.norm() / prediction.speed_mps;
  return course;
}

double arrival_s(const RobotState& robot, const Vec2& goal, double least_mps) {
  return (goal - robot.pose.position_m).norm() / std::max(least_mps, robot.twist.velocity_mps.norm());
}

void predict(std::span<const Obstacle> obstacles, const WorldState& world, std::span<const double> arrivals_s,
             const RobotState& self, const Vec2& goal, const Prediction& prediction, std::vector<Obstacle>& out) {
  out.assign(obstacles.begin(), obstacles.end());
  const Course ours = own_course(self, goal, prediction);
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    const RobotState& other = world.robots[i];
    if (other.id == self.id) continue;
    const bool goal_was_covered = clearance(goal, out[i]) < 0.0;
    const bool is_mate = other.id.team == self.id.team;
    const double ahead_s = is_mate ? prediction.team_horizon_s : prediction.horizon_s;
    const Course theirs{other.pose.position_m, other.twist.velocity_mps, arrivals_s[i]};
    const Fading fading(is_mate ? 0.0 : theirs.velocity_mps.norm(), prediction);
    const double known_s = std::max(ahead_s, std::min(fading.gone_s(), ours.lasts_s));
    const double met_s = nearest_approach_s(ours, theirs, known_s);
    const Vec2 ahead = theirs.at(std::min(met_s, ahead_s)) - theirs.from_m;
    out[i].a += ahead;
    out[i].b += ahead;
    out[i].radius_m *= fading.share_at(met_s);
    out[i].radius_m = uncovering_radius(out[i], self.pose.position_m);
    if (!goal_was_covered) out[i].radius_m = uncovering_radius(out[i], goal);
  }
}

}  // namespace regista
