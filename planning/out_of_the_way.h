// How one robot keeps out of another's way: by going on only as far as it stays clear of it, or by leaving it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planning/planners/tangent.h"

namespace regista {

/// One of a team that has a plan.
struct Traveller {
  std::size_t obstacle = 0;  ///< its own index in the field
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  std::vector<std::size_t> ignored;  ///< sorted indices of the obstacles that are none for it
  Plan* plan = nullptr;
};

/// Of paths with at least one point. The answers depend on field and arguments alone.
class OutOfTheWay {
 public:
  explicit OutOfTheWay(const ObstacleField& field) : graph_(field) {}

  const ObstacleField& field() const { return graph_.field(); }

  /// The exact planner's way to any goal, whatever the traveller's own planner; lengths in metres. A goal that is not
  /// finite is answered by status invalid.
  Plan plan(const Traveller& traveller, const Vec2& goal, std::vector<std::size_t> ignored, double length_max_m);

  /// Where it is, the traveller does not reach into that path.
  bool is_clear(const Traveller& traveller, std::span<const Vec2> of_other) const;

  /// The traveller's own plan as far as it keeps off that path, of which it is clear.
  Plan held_back(const Traveller& traveller, std::span<const Vec2> of_other) const;

  /// To the nearest place from which it does not reach into that path, if there is one by a way shorter than within_m,
  /// metres.
  std::optional<Plan> way_out(const Traveller& traveller, std::span<const Vec2> of_other, double within_m);

 private:
  double reach_m(const Traveller& traveller) const { return field().obstacles()[traveller.obstacle].radius_m; }
  std::vector<Vec2> places(const Traveller& traveller, std::span<const Vec2> of_other, double within_m) const;

  TangentPlanner planner_;
  graph::SharedGraph graph_;  ///< its own: what is tried here is no robot's plan
};

}  // namespace regista
