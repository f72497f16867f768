#include "control/safety/separation.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

/// A gap so much below the present distance is kept by whoever comes no nearer, in spite of rounding. Metres.
constexpr double kStill_m = 1e-9;

/// Each step at least halves what is left of a near miss; a contact is approached so closely that rounding decides.
constexpr int kSteps = 40;

/// The first root u > 0 of gap + rate·u + half·u², gap > 0; infinite without one.
double first_root(double gap, double rate, double half) {
  if (rate >= 0.0 && half >= 0.0) return kNever;
  const double discriminant = rate * rate - 4.0 * gap * half;
  if (discriminant < 0.0) return kNever;
  return 2.0 * gap / (std::sqrt(discriminant) - rate);
}

/// Of two points whose difference is that of `relative`, during length_s; gap as of its begin.
double time_to_contact_while(const Phase& relative, double length_s, const Gap& gap) {
  double t = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 apart = position_after(relative, t);
    const double distance_m = apart.norm();
    const double left_m = distance_m - (gap.distance_m + gap.growth_mps * t);
    if (!(left_m > 0.0)) return t;
    const Vec2 n = apart / distance_m;
    const double rate = n.dot(velocity_after(relative, t)) - gap.growth_mps;
    t += first_root(left_m, rate, n.dot(relative.acceleration_mps2) / 2.0);
    if (t >= length_s) return kNever;
  }
  return t;
}

double end_of(std::span<const Phase> phases, std::size_t i) {
  if (i + 1 < phases.size()) return phases[i + 1].begin_s;
  return kNever;
}

/// The box leaves out the last phase.
bool stays_in_box(const Motion& motion, double until_s) {
  return until_s <= motion.settled_s() || motion.phases().back().velocity_mps.isZero(0.0);
}

bool boxes_are_apart(const Motion& a, const Motion& b, double distance_m) {
  return a.low_m().x() - b.high_m().x() > distance_m || b.low_m().x() - a.high_m().x() > distance_m ||
         a.low_m().y() - b.high_m().y() > distance_m || b.low_m().y() - a.high_m().y() > distance_m;
}

bool keeps_off_while(const Phase& phase, double length_s, const Obstacle& shape, double distance_m) {
  double t = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 position = position_after(phase, t);
    const Vec2 nearest = shape.core == Core::rectangle ? Vec2(position.cwiseMax(shape.a).cwiseMin(shape.b))
                                                       : nearest_on_segment(position, shape.a, shape.b);
    const Vec2 apart = position - nearest;
    const double off_m = apart.norm();
    const double left_m = off_m - distance_m;
    if (!(left_m > 0.0)) return false;
    const Vec2 n = apart / off_m;  // the core lies behind the line across n through its nearest point
    t += first_root(left_m, n.dot(velocity_after(phase, t)), n.dot(phase.acceleration_mps2) / 2.0);
    if (t >= length_s) return true;
  }
  return false;
}

/// Largest |position| along one axis during a phase.
double furthest(double position, double velocity, double acceleration, double length_s) {
  const double end = position + length_s * (velocity + length_s / 2.0 * acceleration);
  double furthest_m = std::max(std::abs(position), std::abs(end));
  const double turns_s = acceleration != 0.0 ? -velocity / acceleration : -1.0;
  if (turns_s > 0.0 && turns_s < length_s) {
    furthest_m = std::max(furthest_m, std::abs(position + turns_s * velocity / 2.0));
  }
  return furthest_m;
}

}  // namespace

double time_to_disc(const Vec2& apart_m, const Vec2& velocity_mps, double gap_m) {
  const double approach = -apart_m.dot(velocity_mps);
  if (approach <= 0.0) return kNever;
  const double excess = apart_m.squaredNorm() - gap_m * gap_m;
  if (excess <= 0.0) return 0.0;
  const double speed2 = velocity_mps.squaredNorm();
  const double discriminant = approach * approach - speed2 * excess;
  if (discriminant < 0.0) return kNever;
  return (approach - std::sqrt(discriminant)) / speed2;
}

double attainable_gap(double wanted_m, const Motion& a, const Motion& b) {
  return std::min(wanted_m, (a.phases().front().position_m - b.phases().front().position_m).norm() - kStill_m);
}

bool keep_apart(const Motion& a, const Motion& b, const Gap& gap, double until_s) {
  return time_to_contact(a, b, gap, until_s) == kNever;
}

double time_to_contact(const Motion& a, const Motion& b, const Gap& gap, double until_s) {
  const double largest_m = gap.growth_mps > 0.0 ? gap.distance_m + gap.growth_mps * until_s : gap.distance_m;
  if (stays_in_box(a, until_s) && stays_in_box(b, until_s) && boxes_are_apart(a, b, largest_m)) {
    return kNever;
  }
  const std::span<const Phase> pa = a.phases();
  const std::span<const Phase> pb = b.phases();
  std::size_t i = 0;
  std::size_t j = 0;
  double begin_s = 0.0;
  while (true) {
    const double end_s = std::min({end_of(pa, i), end_of(pb, j), until_s});
    const double since_a = begin_s - pa[i].begin_s;
    const double since_b = begin_s - pb[j].begin_s;
    const Phase relative{0.0, position_after(pa[i], since_a) - position_after(pb[j], since_b),
                         velocity_after(pa[i], since_a) - velocity_after(pb[j], since_b),
                         pa[i].acceleration_mps2 - pb[j].acceleration_mps2};
    const Gap now{gap.distance_m + gap.growth_mps * begin_s, gap.growth_mps};
    const double contact_s = time_to_contact_while(relative, end_s - begin_s, now);
    if (contact_s < kNever) return begin_s + contact_s;
    if (end_s >= until_s) return kNever;
    if (end_of(pa, i) <= end_s) ++i;
    if (end_of(pb, j) <= end_s) ++j;
    begin_s = end_s;
  }
}

bool keeps_off(const Motion& motion, const Obstacle& shape, double distance_m) {
  if (shape.a.cwiseMin(shape.b).x() - motion.high_m().x() > distance_m ||
      motion.low_m().x() - shape.a.cwiseMax(shape.b).x() > distance_m ||
      shape.a.cwiseMin(shape.b).y() - motion.high_m().y() > distance_m ||
      motion.low_m().y() - shape.a.cwiseMax(shape.b).y() > distance_m) {
    return true;
  }
  const std::span<const Phase> phases = motion.phases();
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (!keeps_off_while(phases[i], end_of(phases, i) - phases[i].begin_s, shape, distance_m)) return false;
  }
  return true;
}

bool keeps_inside(const Motion& motion, const Vec2& half_extent_m) {
  if ((motion.low_m().cwiseAbs().cwiseMax(motion.high_m().cwiseAbs()).array() <= half_extent_m.array()).all()) {
    return true;
  }
  const std::span<const Phase> phases = motion.phases();
  for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
    const Phase& phase = phases[i];
    const double length_s = phases[i + 1].begin_s - phase.begin_s;
    for (int axis = 0; axis < 2; ++axis) {
      if (furthest(phase.position_m[axis], phase.velocity_mps[axis], phase.acceleration_mps2[axis], length_s) >
          half_extent_m[axis]) {
        return false;
      }
    }
  }
  return (phases.back().position_m.cwiseAbs().array() <= half_extent_m.array()).all();
}

}  // namespace regista
