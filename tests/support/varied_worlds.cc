#include "tests/support/varied_worlds.h"

#include <array>
#include <charconv>

#include "planning/uniform.h"
#include "tests/support/planning_worlds.h"

namespace regista::testing {
namespace {

/// Small ones are frequent.
double random_radius(std::mt19937_64& random, double most_m) {
  const double share = uniform(random);
  return most_m * share * share;
}

Obstacle varied_obstacle(std::mt19937_64& random, const Bounds& bounds) {
  const double size_m = bounds.half_extent_m.minCoeff();
  const Vec2 a = random_point(random, bounds);
  const double kind = uniform(random);
  if (kind < 0.4) return disc(a, random_radius(random, 0.5 * size_m));
  const double x = uniform(random, -size_m, size_m);
  const double y = uniform(random, -size_m, size_m);
  const double radius_m = uniform(random) < 0.2 ? 0.0 : random_radius(random, 0.4 * size_m);
  return kind < 0.7 ? capsule(a, a + Vec2(x, y), radius_m) : rounded_rectangle(a, a + Vec2(x, y), radius_m);
}

/// A disc that touches the given disc, up to rounding.
Obstacle touching(std::mt19937_64& random, const Obstacle& other) {
  const double radius_m = uniform(random, 0.05, 0.5);
  const Vec2 direction = rotated({1.0, 0.0}, uniform(random, -std::numbers::pi, std::numbers::pi));
  return disc(other.a + (other.radius_m + radius_m) * direction, radius_m);
}

std::string number(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string list(std::initializer_list<double> values) {
  std::string text = "[";
  for (const double value : values) text += (text.size() > 1 ? "," : "") + number(value);
  return text + "]";
}

std::string shape(const Obstacle& o) {
  switch (o.core) {
    case Core::point:
      return "{\"disc\":" + list({o.a.x(), o.a.y(), o.radius_m}) + "}";
    case Core::segment:
      return "{\"capsule\":" + list({o.a.x(), o.a.y(), o.b.x(), o.b.y(), o.radius_m}) + "}";
    case Core::rectangle:
      break;
  }
  return "{\"rectangle\":" + list({o.a.x(), o.a.y(), o.b.x(), o.b.y(), o.radius_m}) + "}";
}

}  // namespace

ObstacleField varied_field(std::mt19937_64& random, std::size_t obstacles) {
  const double x = uniform(random, 1.0, 6.0);
  const double y = uniform(random, 1.0, 6.0);
  const Bounds bounds{{x, y}};
  std::vector<Obstacle> all;
  while (all.size() < obstacles) {
    const double special = uniform(random);
    if (!all.empty() && special < 0.02) {
      all.push_back(all.back());
    } else if (!all.empty() && special < 0.1 && all.back().core == Core::point) {
      all.push_back(touching(random, all.back()));
    } else {
      all.push_back(varied_obstacle(random, bounds));
    }
  }
  return {bounds, all};
}

std::string pasteable(const ObstacleField& field, const PlanRequest& request) {
  const Vec2 size = 2.0 * field.bounds().half_extent_m;
  std::string obstacles, ignored;
  for (const Obstacle& obstacle : field.obstacles()) obstacles += (obstacles.empty() ? "" : ",") + shape(obstacle);
  for (const std::size_t index : request.ignored) ignored += (ignored.empty() ? "" : ",") + std::to_string(index);
  return "{\"field\":{\"length\":" + number(size.x()) + ",\"width\":" + number(size.y()) +
         "},\"radius\":0,\"seed\":" + std::to_string(request.seed) +
         ",\"robots\":[{\"start\":" + list({request.start.x(), request.start.y()}) +
         ",\"goal\":" + list({request.goal.x(), request.goal.y()}) + ",\"ignore\":[" + ignored + "]}],\"obstacles\":[" +
         obstacles + "]}";
}

}  // namespace regista::testing
