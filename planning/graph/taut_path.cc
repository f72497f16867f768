#include "planning/graph/taut_path.h"

#include <algorithm>

#include "planning/graph/turn.h"

namespace regista::graph {
namespace {

void append(const Vec2& point, std::vector<Vec2>& path) {
  if (path.empty() || path.back() != point) path.push_back(point);
}

/// By the angle of the unit vector `by`.
Vec2 turned(const Vec2& by, const Vec2& v) {
  return {by.x() * v.x() - by.y() * v.y(), by.y() * v.x() + by.x() * v.y()};
}

/// One corner's circle between two of its normals.
class CornerArc {
 public:
  CornerArc(const Vec2& corner, double radius_m, double side, std::vector<Vec2>& path)
      : corner_(corner), radius_m_(radius_m), side_(side), path_(path) {}

  /// Tangent legs at both ends.
  void append_between(const Vec2& from, const Vec2& to) {
    const double angle_rad = turn(from, to, side_);
    const int steps = 1 + static_cast<int>(angle_rad / kArcStep_rad);
    if (steps == 1) {
      append(corner_ + from_both(from, to), path_);
      return;
    }
    // Series: half a step is below 0.055.
    const double half_rad = 0.5 * angle_rad / steps;
    const double half2 = half_rad * half_rad;
    const double cosine = 1.0 - half2 / 2 * (1.0 - half2 / 12 * (1.0 - half2 / 30));
    const double sine = side_ * half_rad * (1.0 - half2 / 6 * (1.0 - half2 / 20 * (1.0 - half2 / 42)));
    const double reach_m = radius_m_ / cosine;
    const Vec2 half(cosine, sine);
    const Vec2 whole = turned(half, half);
    Vec2 normal = turned(half, from);
    for (int i = 0; i < steps; ++i, normal = turned(whole, normal)) append(corner_ + reach_m * normal, path_);
  }

 private:
  /// Where the tangents at both normals meet.
  Vec2 from_both(const Vec2& from, const Vec2& to) const { return (from + to) * (radius_m_ / (1.0 + from.dot(to))); }

  const Vec2& corner_;
  double radius_m_;
  double side_;
  std::vector<Vec2>& path_;
};

/// Calls visit(normal) for the normals of a corner that point straight at what lies near: there a leg must touch, for
/// the tangent separates both.
template <class Visit>
void for_breaks(const SharedGraph& graph, std::span<const ObstacleIndex> brushes, const Vec2& corner, Visit&& visit) {
  for (const ObstacleIndex brush : brushes) {
    if (brush == kBounds) {
      for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) visit(axis);
      continue;
    }
    const Obstacle& other = graph.field().obstacles()[brush];
    const Vec2 nearest = other.core == Core::rectangle ? Vec2(corner.cwiseMax(other.a).cwiseMin(other.b))
                                                       : nearest_on_segment(corner, other.a, other.b);
    const Vec2 towards = nearest - corner;
    if (towards.squaredNorm() > 0.0) visit(Vec2(towards.normalized()));
  }
}

void append_corner(const SharedGraph& graph, std::span<const ObstacleIndex> brushes, const Body& body,
                   std::uint32_t corner, const Arc& arc, std::vector<Vec2>& path) {
  const Vec2& centre = body.corners[corner];
  if (body.radius_m == 0.0) {
    append(centre, path);
    return;
  }
  CornerArc corner_arc(centre, body.radius_m, arc.side, path);
  Vec2 from = arc.from.normal;
  const double angle_rad = brushes.empty() ? 0.0 : turn(arc.from.normal, arc.to.normal, arc.side);
  // Breaks are few: the next one is looked for among all.
  for (double from_rad = 0.0; !brushes.empty();) {
    double next_rad = angle_rad - kNoTurn_rad;
    Vec2 next = from;
    for_breaks(graph, brushes, centre, [&](const Vec2& normal) {
      const double normal_rad = turn(arc.from.normal, normal, arc.side);
      if (normal_rad <= from_rad + kNoTurn_rad || normal_rad >= next_rad) return;
      next_rad = normal_rad;
      next = normal;
    });
    if (next == from) break;
    corner_arc.append_between(from, next);
    from = next;
    from_rad = next_rad;
  }
  corner_arc.append_between(from, arc.to.normal);
}

}  // namespace

Contacts::Of append_arc(SharedGraph& graph, ObstacleIndex obstacle, const Body& body, const Arc& arc,
                        std::vector<Vec2>& path) {
  const Contacts::Of near = graph.contacts(obstacle);
  const bool is_forwards = arc.side > 0.0;
  const std::uint32_t step = is_forwards ? 1 : body.count - 1;
  // Behind on the same corner: all the way round.
  bool goes_round = body.count > 1 && arc.from.corner == arc.to.corner &&
                    ahead(body, order_of(body, arc.from), order_of(body, arc.to), arc.side) > 0.5 * body.period;
  Arc rest = arc;
  for (std::uint32_t corner = arc.from.corner; corner != arc.to.corner || goes_round;
       corner = (corner + step) % body.count) {
    goes_round = false;
    const Vec2 end = body.begin_normals[is_forwards ? (corner + 1) % body.count : corner];
    append_corner(graph, near.brushes, body, corner, {rest.from, {Vec2::Zero(), end, corner}, arc.side}, path);
    rest.from.normal = end;
  }
  append_corner(graph, near.brushes, body, arc.to.corner, rest, path);
  return near;
}

bool is_clear_of(const ObstacleField& field, const Contacts::Of& near, std::span<const Vec2> polyline,
                 std::span<const std::size_t> ignored) {
  const auto is_clear = [&](ObstacleIndex other) {
    if (other == kBounds) {
      return std::all_of(polyline.begin(), polyline.end(),
                         [&](const Vec2& point) { return is_inside(point, field.bounds()); });
    }
    if (is_ignored(other, ignored)) return true;
    for (std::size_t i = 1; i < polyline.size(); ++i) {
      if (!is_free(polyline[i - 1], polyline[i], field.obstacles()[other])) return false;
    }
    return true;
  };
  return std::all_of(near.cuts.begin(), near.cuts.end(), [&](const Cut& cut) { return is_clear(cut.other); }) &&
         std::all_of(near.brushes.begin(), near.brushes.end(), is_clear);
}

}  // namespace regista::graph
