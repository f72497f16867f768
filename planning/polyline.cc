#include "planning/polyline.h"

namespace regista {

std::vector<Vec2> pruned(const ObstacleField& field, std::span<const Vec2> path, std::span<const std::size_t> ignored) {
  std::vector<Vec2> out;
  for (std::size_t at = 0; at < path.size();) {
    out.push_back(path[at]);
    std::size_t next = path.size() - 1;
    while (next > at + 1 && !field.is_free(path[at], path[next], ignored)) --next;
    at = std::max(next, at + 1);
  }
  return out;
}

std::vector<Vec2> thinned(const ObstacleField& field, std::span<const Vec2> path, std::span<const std::size_t> ignored,
                          double tolerance_m) {
  std::vector<Vec2> out{path.front()};
  for (std::size_t at = 0; at + 1 < path.size();) {
    std::size_t next = at + 1;
    const auto is_straight = [&](std::size_t to) {
      for (std::size_t i = at + 1; i < to; ++i) {
        if ((nearest_on_segment(path[i], path[at], path[to]) - path[i]).norm() > tolerance_m) return false;
      }
      return field.is_free(path[at], path[to], ignored);
    };
    while (next + 1 < path.size() && is_straight(next + 1)) ++next;
    out.push_back(path[next]);
    at = next;
  }
  return out;
}

std::optional<std::vector<Vec2>> kept_path(const ObstacleField& field, const Query& query, double goal_drift_max_m) {
  const std::span<const Vec2> previous = query.previous_path;
  if (previous.size() < 2 || (previous.back() - query.goal).norm() >= goal_drift_max_m) return std::nullopt;
  const auto is_free = [&](const Vec2& from, const Vec2& to) { return field.is_free(from, to, query.ignored); };
  // The first vertex was where the robot stood, the last is the goal's old place; those between may be kept.
  std::size_t first = previous.size() - 2;
  while (first > 0 && !is_free(query.start, previous[first])) --first;
  if (first == 0) return std::nullopt;
  if (previous[first] == query.start) ++first;
  std::vector<Vec2> path{query.start};
  path.insert(path.end(), previous.begin() + static_cast<std::ptrdiff_t>(first), previous.end() - 1);
  path.push_back(query.goal);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!is_free(path[i - 1], path[i])) return std::nullopt;
  }
  return path;
}

}  // namespace regista
