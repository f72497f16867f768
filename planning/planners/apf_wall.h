// Following a wall with a hand on it: how the potential field planner leaves a local minimum.
#pragma once

#include <span>
#include <vector>

#include "planning/obstacle_field.h"

namespace regista {

/// Walks one step at a time along the edge of free space, obstacles and bounds alike, beginning where the straight way
/// to the goal is blocked. Headings are 15° apart.
class WallFollower {
 public:
  enum class End {
    walking,
    left,    ///< nearer to the goal than at the beginning, and the next step towards it is free
    around,  ///< back at the beginning, or no step is free: this wall does not lead to the goal
  };

  /// side 1: turns left, the wall is on its right; -1: the other way round.
  WallFollower(const ObstacleField& field, std::span<const std::size_t> ignored, const Vec2& begin, const Vec2& goal,
               double side, double step_m);

  /// One step, if it is still walking.
  void step();

  End end() const { return end_; }
  /// Without the beginning.
  const std::vector<Vec2>& path() const { return path_; }
  /// Walked so far and straight on to the goal from there. Metres.
  double estimate_m() const;

 private:
  bool may_leave() const;

  const ObstacleField& field_;
  std::span<const std::size_t> ignored_;
  Vec2 begin_;
  Vec2 goal_;
  Vec2 forward_;  ///< unit, heading 0
  Vec2 at_;
  double side_;
  double step_m_;
  int heading_ = 0;  ///< times 15°, away from the wall
  bool was_away_ = false;
  End end_ = End::walking;
  std::vector<Vec2> path_;
};

}  // namespace regista
