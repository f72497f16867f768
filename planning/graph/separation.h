// Whether overlapping obstacles close every way between two points: a proof that costs one look at each pair of
// overlapping obstacles, where an exhausted search would cost all tangents of the field.
#pragma once

#include <span>
#include <vector>

#include "planning/obstacle_field.h"

namespace regista::graph {

/// Two obstacles of a field that overlap, and the way from the middle of one to the middle of the other that lies
/// within both: along one's core to `from`, across to `to`, along the other's core.
struct Overlap {
  ObstacleIndex one = 0;
  ObstacleIndex other = 0;
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
};

/// Appends all overlaps of the field, by `one`, which is the smaller index. Touching (kTouch_m) is none.
void append_overlaps(const ObstacleField& field, std::vector<Overlap>& out);

/// Two free points are separated if and only if some closed curve within the obstacles (and out of bounds) crosses the
/// segment between them, in sum of signs, not zero times. Union-find over overlapping obstacles, where each one knows
/// how often the way to it from its root crosses the segment: an overlap within a set closes a curve.
/// Only scratch memory is kept between two questions.
class Separation {
 public:
  /// Start and goal must be free; the overlaps are all of the field's.
  bool separates(const ObstacleField& field, std::span<const Overlap> overlaps, const Vec2& start, const Vec2& goal,
                 std::span<const std::size_t> ignored);

 private:
  struct Member {
    ObstacleIndex parent = 0;
    int crossings = 0;  ///< of the way from the parent to it
  };

  Member root_of(ObstacleIndex member);
  bool closes(ObstacleIndex one, ObstacleIndex other, int crossings);
  bool meets_bounds(const ObstacleField& field, ObstacleIndex index);

  int crossings(const Vec2& from, const Vec2& to) const;

  Vec2 start_ = Vec2::Zero();  ///< of the question that is being answered
  Vec2 along_ = Vec2::Zero();
  std::vector<Member> members_;  ///< by obstacle; the last is the outside of the bounds
};

}  // namespace regista::graph
