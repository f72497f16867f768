#include "tests/support/tangent_oracle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

namespace regista::testing {
namespace {

/// Part of a boundary that can be walked along: the circle around one corner of an obstacle's core. A point (start,
/// goal, or the corner of an obstacle without radius) is a rim without radius.
struct Rim {
  Vec2 centre;
  double radius_m;
};

/// {p : normal·p = offset_m}, |normal| = 1.
struct Line {
  Vec2 normal;
  double offset_m;
};

Vec2 quarter_turn(const Vec2& v) { return {-v.y(), v.x()}; }

/// A shortest path consists of common tangents of rims and of arcs on them (Chew, "Planning the shortest path for a
/// disc in O(n² log n) time", 1985), so the graph of all free ones contains it. Edges have no direction: a path that
/// turns the wrong way at a node is longer, but a path.
class TangentGraph {
 public:
  TangentGraph(const ObstacleField& field, const Vec2& start, const Vec2& goal, std::span<const std::size_t> ignored)
      : bounds_(field.bounds()), rims_{{start, 0.0}, {goal, 0.0}} {
    for (std::size_t i = 0; i < field.size(); ++i) {
      if (std::find(ignored.begin(), ignored.end(), i) == ignored.end()) add_obstacle(field.obstacles()[i]);
    }
    for (const Vec2& normal : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
      lines_.push_back({normal, normal.cwiseAbs().dot(bounds_.half_extent_m)});
    }
    on_rim_.resize(rims_.size());
    for (const std::size_t end : {0U, 1U}) add_node(end, {1, 0});
    for (std::size_t i = 0; i < rims_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) add_tangents(k, i);
    }
    for (std::size_t i = 0; i < rims_.size(); ++i) add_arcs(i);
  }

  /// From node 0 to node 1, by Dijkstra.
  std::optional<double> shortest_length() const {
    std::vector<double> cost(edges_.size(), std::numeric_limits<double>::infinity());
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    queue.emplace(cost[0] = 0.0, 0);
    while (!queue.empty()) {
      const auto [reached_at, node] = queue.top();
      queue.pop();
      if (node == 1) return reached_at;
      if (reached_at > cost[node]) continue;
      for (const auto& [next, length_m] : edges_[node]) {
        if (reached_at + length_m < cost[next]) queue.emplace(cost[next] = reached_at + length_m, next);
      }
    }
    return std::nullopt;
  }

 private:
  using Node = std::size_t;

  void add_obstacle(const Obstacle& obstacle) {
    obstacles_.push_back(obstacle);
    const auto& [core, a, b, radius_m] = obstacle;
    rims_.push_back({a, radius_m});
    if (core == Core::point) return;
    rims_.push_back({b, radius_m});
    if (core == Core::rectangle) {
      rims_.push_back({{a.x(), b.y()}, radius_m});
      rims_.push_back({{b.x(), a.y()}, radius_m});
      for (const Vec2& normal : {Vec2(1, 0), Vec2(0, 1)}) {
        lines_.push_back({normal, normal.dot(b) + radius_m});
        lines_.push_back({-normal, -normal.dot(a) + radius_m});
      }
    } else if (a != b) {
      const Vec2 normal = quarter_turn(b - a).normalized();
      lines_.push_back({normal, normal.dot(a) + radius_m});
      lines_.push_back({-normal, -normal.dot(a) + radius_m});
    }
  }

  bool is_free(const Vec2& from, const Vec2& to) const {
    return is_inside(from, bounds_) && is_inside(to, bounds_) &&
           std::all_of(obstacles_.begin(), obstacles_.end(),
                       [&](const Obstacle& obstacle) { return regista::is_free(from, to, obstacle); });
  }

  Node add_node(std::size_t rim, const Vec2& normal) { return add_node(rim, std::atan2(normal.y(), normal.x())); }

  Node add_node(std::size_t rim, double angle_rad) {
    on_rim_[rim].emplace_back(angle_rad, edges_.size());
    edges_.emplace_back();
    return edges_.size() - 1;
  }

  void connect(Node one, Node other, double length_m) {
    edges_[one].emplace_back(other, length_m);
    edges_[other].emplace_back(one, length_m);
  }

  /// A line with the unit normal n that touches the one circle at c₁ + r₁·n and the other at c₂ ± r₂·n: + with both on
  /// the same side (outer), - between them (inner). Hence n·(c₂ - c₁) = r₁ ∓ r₂, which n and its mirror image fulfil.
  void add_tangents(std::size_t one, std::size_t other) {
    const Rim& a = rims_[one];
    const Rim& b = rims_[other];
    const Vec2 between = b.centre - a.centre;
    const double distance_m = between.norm();
    if (distance_m == 0.0) return;
    const Vec2 along = between / distance_m;
    for (const double side : {1.0, -1.0}) {
      const double reach_m = a.radius_m - side * b.radius_m;
      if (std::abs(reach_m) > distance_m + kTouch_m) continue;
      const double cosine = std::clamp(reach_m / distance_m, -1.0, 1.0);
      const Vec2 across = quarter_turn(along) * std::sqrt(1.0 - cosine * cosine);
      for (const Vec2& normal : {Vec2(cosine * along + across), Vec2(cosine * along - across)}) {
        const Vec2 from = a.centre + a.radius_m * normal;
        const Vec2 to = b.centre + side * b.radius_m * normal;
        if (!is_free(from, to)) continue;
        connect(add_node(one, normal), add_node(other, Vec2(side * normal)), (to - from).norm());
      }
    }
  }

  /// Every place where the rim can go from free to covered becomes a node; between two neighbouring nodes an arc is
  /// then free all along or nowhere, and its middle tells which.
  void add_arcs(std::size_t index) {
    const Rim& rim = rims_[index];
    for (const Rim& other : rims_) cut(index, other);
    for (const Line& line : lines_) cut(index, line.normal, line.offset_m - line.normal.dot(rim.centre));
    std::vector<std::pair<double, Node>>& nodes = on_rim_[index];
    std::sort(nodes.begin(), nodes.end());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const bool is_last = i + 1 == nodes.size();
      const auto& [next_rad, next] = nodes[is_last ? 0 : i + 1];
      const double span_rad = next_rad - nodes[i].first + (is_last ? 2.0 * std::numbers::pi : 0.0);
      const Vec2 middle = rim.centre + rotated({rim.radius_m, 0.0}, nodes[i].first + 0.5 * span_rad);
      if (is_free(middle, middle)) connect(nodes[i].second, next, rim.radius_m * span_rad);
    }
  }

  void cut(std::size_t index, const Rim& other) {
    const Rim& rim = rims_[index];
    const Vec2 between = other.centre - rim.centre;
    const double distance_m = between.norm();
    if (distance_m == 0.0) return;
    // To the chord that both circles have in common.
    const double r2 = rim.radius_m * rim.radius_m - other.radius_m * other.radius_m;
    cut(index, between / distance_m, 0.5 * (distance_m + r2 / distance_m));
  }

  /// Where the rim meets the line of that normal, `distance_m` from its centre. A line that misses it by rounding
  /// touches it: the sides of its own obstacle do.
  void cut(std::size_t index, const Vec2& normal, double distance_m) {
    const double radius_m = rims_[index].radius_m;
    if (radius_m == 0.0 || std::abs(distance_m) > radius_m + kTouch_m) return;
    const double middle_rad = std::atan2(normal.y(), normal.x());
    const double half_rad = std::acos(std::clamp(distance_m / radius_m, -1.0, 1.0));
    for (const double angle_rad : {middle_rad + half_rad, middle_rad - half_rad}) {
      add_node(index, wrap_angle(angle_rad));
    }
  }

  Bounds bounds_;
  std::vector<Obstacle> obstacles_;
  std::vector<Rim> rims_;    ///< start, goal, then those of the obstacles
  std::vector<Line> lines_;  ///< along the straight sides of obstacles and bounds, infinitely long
  std::vector<std::vector<std::pair<Node, double>>> edges_;   ///< by node: to which, how long in metres
  std::vector<std::vector<std::pair<double, Node>>> on_rim_;  ///< by rim: at which angle, in (-π, π]
};

}  // namespace

std::optional<double> exact_shortest_length(const ObstacleField& field, const Vec2& start, const Vec2& goal,
                                            std::span<const std::size_t> ignored) {
  if (start == goal) return 0.0;
  return TangentGraph(field, start, goal, ignored).shortest_length();
}

}  // namespace regista::testing
