// The obstacles along the straight line of a query: in a large field a search asks these few for each of its legs, so
// that a leg costs by what stands around it, not by the field.
#pragma once

#include "planning/obstacle_field.h"

namespace regista::graph {

/// All obstacles near a segment. Only scratch memory is kept between two queries.
class Corridor {
 public:
  /// Holds no leg until it is laid out.
  void clear() { radius_m_ = -1.0; }
  bool is_laid_out() const { return radius_m_ >= 0.0; }

  /// With all that comes nearer than radius_m (>= 0) to the segment.
  void lay_out(const ObstacleField& field, const Vec2& from, const Vec2& to, double radius_m);

  /// Calls visit(index) for all obstacles of the field that block the motion, and for some that do not, until it
  /// returns true: in the field's order. Asks the whole field where the motion leaves the corridor.
  template <class Visit>
  void visit_candidates(const ObstacleField& field, const ObstacleBoxes::Motion& motion, Visit&& visit) const {
    if (holds(motion.from) && holds(motion.to)) {
      boxes_.visit_near(motion, visit);
    } else {
      field.visit_candidates(motion, visit);
    }
  }

 private:
  /// What holds both ends holds the motion: a capsule is convex.
  bool holds(const Vec2& point) const {
    return is_laid_out() && (nearest_on_segment(point, from_, to_) - point).squaredNorm() <= radius_m_ * radius_m_;
  }

  Vec2 from_ = Vec2::Zero();
  Vec2 to_ = Vec2::Zero();
  double radius_m_ = -1.0;
  ObstacleBoxes boxes_;
};

}  // namespace regista::graph
