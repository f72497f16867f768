#include "sim/near_pairs.h"

#include <algorithm>

namespace regista {

const std::vector<IndexPair>& NearPairs::find(const std::vector<RobotBody>& robots, double distance_m) {
  sort(robots);
  pairs_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Entry& a = order_[i];
    for (std::size_t j = i + 1; j < order_.size(); ++j) {
      const Entry& b = order_[j];
      const double dx = b.x - a.x;
      if (dx > distance_m) break;
      const double dy = b.y - a.y;
      if (dx * dx + dy * dy > distance_m * distance_m) continue;
      pairs_.push_back({std::min(a.robot, b.robot), std::max(a.robot, b.robot)});
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

void NearPairs::sort(const std::vector<RobotBody>& robots) {
  if (order_.size() != robots.size()) {
    order_.clear();
    for (std::uint32_t i = 0; i < robots.size(); ++i) order_.push_back({0.0, 0.0, i});
  }
  for (Entry& entry : order_) {
    const Vec2& position = robots[entry.robot].pose.position_m;
    entry.x = position.x();
    entry.y = position.y();
  }
  for (std::size_t i = 1; i < order_.size(); ++i) {  // insertion sort: linear when almost sorted
    const Entry moved = order_[i];
    std::size_t j = i;
    for (; j > 0 && order_[j - 1].x > moved.x; --j) order_[j] = order_[j - 1];
    order_[j] = moved;
  }
}

}  // namespace regista
