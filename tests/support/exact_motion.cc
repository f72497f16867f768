#include "tests/support/exact_motion.h"

#include <algorithm>
#include <vector>

#include "planning/clearance.h"

namespace regista::testing {
namespace {

constexpr double kExact_m = 1e-10;

/// Least `distance(from, to)` of the curve's chords. Between two moments h apart the curve lies within |a|·h²/8 of its
/// chord, so halving bounds it from below.
template <class Distance>
double least(const Phase& phase, double begin_s, double end_s, double cap_m, const Distance& distance) {
  const double h = end_s - begin_s;
  const double bulge_m = phase.acceleration_mps2.norm() * h * h / 8.0;
  const Vec2 from = position_after(phase, begin_s);
  const double chord_m = distance(from, position_after(phase, end_s));
  if (chord_m - bulge_m >= cap_m) return cap_m;
  if (bulge_m <= kExact_m) return std::min(cap_m, chord_m);
  const double middle_s = begin_s + h / 2.0;
  const double first_m = least(phase, begin_s, middle_s, std::min(cap_m, distance(from, from)), distance);
  return least(phase, middle_s, end_s, first_m, distance);
}

double length_of_phase(const Motion& motion, std::size_t i) {
  return i + 1 < motion.phases().size() ? motion.phases()[i + 1].begin_s - motion.phases()[i].begin_s : 0.0;
}

/// The phase that t lies in, from t on.
Phase phase_at(const Motion& motion, double t) {
  const std::span<const Phase> phases = motion.phases();
  std::size_t i = phases.size() - 1;
  while (i > 0 && phases[i].begin_s > t) --i;
  const double since_s = t - phases[i].begin_s;
  return {t, position_after(phases[i], since_s), velocity_after(phases[i], since_s), phases[i].acceleration_mps2};
}

}  // namespace

double least_distance(const Phase& relative, double length_s, double cap_m) {
  return least(relative, 0.0, length_s, cap_m,
               [](const Vec2& from, const Vec2& to) { return nearest_on_segment(Vec2::Zero(), from, to).norm(); });
}

double least_distance(const Motion& a, const Motion& b, double cap_m) {
  std::vector<double> moments{0.0};
  for (const Motion* motion : {&a, &b}) {
    for (const Phase& phase : motion->phases()) moments.push_back(phase.begin_s);
  }
  std::sort(moments.begin(), moments.end());
  moments.push_back(moments.back());  // at rest from then on
  double least_m = cap_m;
  for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
    const Phase pa = phase_at(a, moments[i]);
    const Phase pb = phase_at(b, moments[i]);
    const Phase relative{0.0, pa.position_m - pb.position_m, pa.velocity_mps - pb.velocity_mps,
                         pa.acceleration_mps2 - pb.acceleration_mps2};
    least_m = least_distance(relative, moments[i + 1] - moments[i], least_m);
  }
  return least_m;
}

double least_clearance(const Motion& motion, const Obstacle& shape, double cap_m) {
  double least_m = cap_m;
  for (std::size_t i = 0; i < motion.phases().size(); ++i) {
    least_m = least(motion.phases()[i], 0.0, length_of_phase(motion, i), least_m,
                    [&](const Vec2& from, const Vec2& to) { return clearance(from, to, shape); });
  }
  return least_m;
}

Vec2 furthest(const Phase& phase, double length_s) {
  Vec2 furthest_m = phase.position_m.cwiseAbs().cwiseMax(position_after(phase, length_s).cwiseAbs());
  for (int axis = 0; axis < 2; ++axis) {
    const double turns_s = -phase.velocity_mps[axis] / phase.acceleration_mps2[axis];
    if (!(turns_s > 0.0 && turns_s < length_s)) continue;
    furthest_m[axis] = std::max(furthest_m[axis], std::abs(position_after(phase, turns_s)[axis]));
  }
  return furthest_m;
}

Vec2 furthest(const Motion& motion) {
  Vec2 furthest_m = Vec2::Zero();
  for (std::size_t i = 0; i < motion.phases().size(); ++i) {
    furthest_m = furthest_m.cwiseMax(furthest(motion.phases()[i], length_of_phase(motion, i)));
  }
  return furthest_m;
}

}  // namespace regista::testing
