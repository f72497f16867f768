#include "planning/goal_leaning.h"

#include <algorithm>

#include "planning/clearance.h"

namespace regista {
namespace {

/// How much nearer to the robot a covered goal counts. Of a robot that stands right on a goal all places around it are
/// equally near, and noise would have the waiting one run around it; this is far above noise.
constexpr double kLean_m = 0.02;

}  // namespace

void lean(PlanRequest& request, std::span<const Obstacle> obstacles) {
  bool is_covered = false;
  for (std::size_t i = 0; i < obstacles.size() && !is_covered; ++i) {
    is_covered = obstacles[i].core == Core::point && clearance(request.goal, obstacles[i]) < 0.0 &&
                 !std::binary_search(request.ignored.begin(), request.ignored.end(), i);
  }
  const Vec2 back = request.start - request.goal;
  if (is_covered && back.norm() > kLean_m) request.goal += kLean_m * back.normalized();
}

}  // namespace regista
