#include "planning/graph/occluders.h"

#include <experimental/simd>

#include "planning/clearance.h"

namespace regista::graph {
namespace {

/// Single precision rounds by 6e-8; sums and products of four numbers stay far below.
constexpr double kRounding = 1e-5;

double size_of(const Vec2& point) { return point.cwiseAbs().sum(); }

}  // namespace

void Occluders::add(const Obstacle& obstacle) {
  const Vec2 middle = 0.5 * (obstacle.a + obstacle.b);
  const double rounding_m = kRounding * (size_of(middle) + obstacle.radius_m);
  x_[next_] = static_cast<float>(middle.x());
  y_[next_] = static_cast<float>(middle.y());
  radius_[next_] = static_cast<float>(obstacle.radius_m - kTouch_m - rounding_m);
  next_ = (next_ + 1) % kCount;
}

/// The foot of the centre lies on the leg, nearer than the radius.
bool Occluders::surely_block(const ObstacleBoxes::Motion& motion) const {
  using Lanes = std::experimental::fixed_size_simd<float, kCount>;
  const auto load = [](const std::array<float, kCount>& column) {
    return Lanes(column.data(), std::experimental::vector_aligned);
  };
  const auto along_x = static_cast<float>(motion.along.x());
  const auto along_y = static_cast<float>(motion.along.y());
  const auto rounding_m = static_cast<float>(kRounding * size_of(motion.from));
  const Lanes x = load(x_) - static_cast<float>(motion.from.x());
  const Lanes y = load(y_) - static_cast<float>(motion.from.y());
  const Lanes foot = along_x * x + along_y * y;
  const Lanes apart = std::experimental::abs(along_x * y - along_y * x) + rounding_m;
  return any_of(apart < load(radius_) && foot > 0.0F &&
                foot < static_cast<float>((motion.to - motion.from).dot(motion.along)));
}

}  // namespace regista::graph
