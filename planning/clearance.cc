#include "planning/clearance.h"

namespace regista {
namespace {

/// Signed distance to a box: outside the distance to it, inside minus the distance to its nearest side. `beyond` is how
/// far the point lies beyond the box along each axis, negative within.
double box_distance(const Vec2& point, const Vec2& low, const Vec2& high) {
  const Vec2 beyond = (low - point).cwiseMax(point - high);
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

/// Least box_distance along a segment. It is a convex function of the place t on the segment, made of pieces: where one
/// side is the nearest it is linear, where a corner is, a distance to a point. Its minimum is therefore at an end,
/// where two pieces meet, or at a corner's projection; all of them are tried.
class BoxApproach {
 public:
  BoxApproach(const Vec2& from, const Vec2& to, const Vec2& low, const Vec2& high)
      : from_(from), along_(to - from), low_(low), high_(high) {}

  double least() {
    least_ = std::min(at(0.0), at(1.0));
    const Vec2 middle = 0.5 * (low_ + high_);
    for (const int axis : {0, 1}) {
      for (const double border : {low_[axis], high_[axis], middle[axis]}) {
        try_at(border - from_[axis], along_[axis]);
      }
    }
    for (const double x : {low_.x(), high_.x()}) {
      for (const double y : {low_.y(), high_.y()}) try_corner(Vec2(x, y));
    }
    return least_;
  }

 private:
  double at(double t) const { return box_distance(from_ + t * along_, low_, high_); }

  void try_at(double numerator, double denominator) {
    const double t = numerator / denominator;  // not finite where the segment never gets there
    if (t > 0.0 && t < 1.0) least_ = std::min(least_, at(t));
  }

  void try_corner(const Vec2& corner) {
    const Vec2 to_corner = corner - from_;
    try_at(to_corner.dot(along_), along_.squaredNorm());
    // The diagonals through the corner, on one of which two sides are equally near.
    try_at(to_corner.x() - to_corner.y(), along_.x() - along_.y());
    try_at(to_corner.x() + to_corner.y(), along_.x() + along_.y());
  }

  Vec2 from_, along_, low_, high_;
  double least_ = 0.0;
};

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  const auto differ = [](double one, double other) {
    return (static_cast<unsigned>(one > 0.0) & static_cast<unsigned>(other < 0.0)) |
           (static_cast<unsigned>(one < 0.0) & static_cast<unsigned>(other > 0.0));
  };
  return (differ(c_side, d_side) & differ(a_side, b_side)) != 0;
}

/// Closed box, closed segment: not separated along x, along y or across the segment.
bool box_meets_segment(const Vec2& low, const Vec2& high, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const Vec2 doubled_offset = from + to - low - high;
  const Vec2 size = high - low;
  const unsigned in_x = std::abs(doubled_offset.x()) <= size.x() + std::abs(along.x());
  const unsigned in_y = std::abs(doubled_offset.y()) <= size.y() + std::abs(along.y());
  const unsigned in_line =
      std::abs(cross(along, doubled_offset)) <= std::abs(along.x()) * size.y() + std::abs(along.y()) * size.x();
  return (in_x & in_y & in_line) != 0;
}

double point_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  return (nearest_on_segment(point, a, b) - point).norm();
}

/// Two segments that do not cross are nearest at an end of one of them.
double segment_segment(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (segments_cross(a, b, c, d)) return 0.0;
  return std::min(std::min(point_segment(c, a, b), point_segment(d, a, b)),
                  std::min(point_segment(a, c, d), point_segment(b, c, d)));
}

/// Of a segment that does not meet the box: nearest at an end of the one or a corner of the other.
double box_segment_apart(const Vec2& low, const Vec2& high, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double length2 = along.squaredNorm();
  const double per_length2 = length2 > 0.0 ? 1.0 / length2 : 0.0;
  double least2 = std::min((low - from).cwiseMax(from - high).cwiseMax(0.0).squaredNorm(),
                           (low - to).cwiseMax(to - high).cwiseMax(0.0).squaredNorm());
  for (const Vec2& corner : {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}) {
    const Vec2 to_corner = corner - from;
    const double t = std::clamp(to_corner.dot(along) * per_length2, 0.0, 1.0);
    least2 = std::min(least2, (to_corner - t * along).squaredNorm());
  }
  return std::sqrt(least2);
}

/// A straight line, the segment's own or an axis, has the core on one side and far enough away: what most motions are
/// free by.
bool is_surely_apart(const Vec2& from, const Vec2& to, const Obstacle& obstacle, double least_m) {
  const Vec2 along = to - from;
  const Vec2 half = 0.5 * (obstacle.b - obstacle.a);
  const Vec2 offset = obstacle.a + half - from;
  // Of a segment the ends, of a rectangle all corners.
  const double width = obstacle.core == Core::segment ? std::abs(cross(along, half))
                                                      : std::abs(along.x()) * half.y() + std::abs(along.y()) * half.x();
  const double across = std::abs(cross(along, offset)) - width;
  const Vec2 beyond = (offset - 0.5 * along).cwiseAbs() - half.cwiseAbs() - 0.5 * along.cwiseAbs();
  const unsigned is_beside = static_cast<unsigned>(across > 0.0) &
                             static_cast<unsigned>(across * across >= least_m * least_m * along.squaredNorm());
  return (is_beside | static_cast<unsigned>(beyond.maxCoeff() >= least_m)) != 0;
}

}  // namespace

double clearance(const Vec2& point, const Obstacle& obstacle) {
  switch (obstacle.core) {
    case Core::point:
      return (point - obstacle.a).norm() - obstacle.radius_m;
    case Core::segment:
      return point_segment(point, obstacle.a, obstacle.b) - obstacle.radius_m;
    case Core::rectangle:
      break;
  }
  return box_distance(point, obstacle.a, obstacle.b) - obstacle.radius_m;
}

double clearance(const Vec2& from, const Vec2& to, const Obstacle& obstacle) {
  switch (obstacle.core) {
    case Core::point:
      return point_segment(obstacle.a, from, to) - obstacle.radius_m;
    case Core::segment:
      return segment_segment(from, to, obstacle.a, obstacle.b) - obstacle.radius_m;
    case Core::rectangle:
      break;
  }
  if (!box_meets_segment(obstacle.a, obstacle.b, from, to)) {
    return box_segment_apart(obstacle.a, obstacle.b, from, to) - obstacle.radius_m;
  }
  return BoxApproach(from, to, obstacle.a, obstacle.b).least() - obstacle.radius_m;
}

bool is_free_of_extended(const Vec2& from, const Vec2& to, const Obstacle& obstacle) {
  const Vec2& a = obstacle.a;
  const Vec2& b = obstacle.b;
  const double radius_m = obstacle.radius_m;
  const double least_m = std::max(radius_m - kTouch_m, 0.0);
  if (is_surely_apart(from, to, obstacle, least_m)) return true;
  const auto is_free_of = [&](const Vec2& corner) { return is_free_of_disc(from, to, corner, radius_m); };
  if (obstacle.core == Core::segment) {
    return (radius_m <= kTouch_m || !segments_cross(from, to, a, b)) && is_free_of(a) && is_free_of(b) &&
           is_free_of_disc(a, b, from, radius_m) && is_free_of_disc(a, b, to, radius_m);
  }
  if (box_meets_segment(a, b, from, to)) {
    return radius_m <= kTouch_m && clearance(from, to, obstacle) >= -kTouch_m;
  }
  const auto is_apart = [&](const Vec2& end) {
    return (a - end).cwiseMax(end - b).cwiseMax(0.0).squaredNorm() >= least_m * least_m;
  };
  return is_apart(from) && is_apart(to) && is_free_of(a) && is_free_of({b.x(), a.y()}) && is_free_of(b) &&
         is_free_of({a.x(), b.y()});
}

}  // namespace regista
