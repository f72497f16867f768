// Scenes for the world model's tests: robots that move as told, seen by cameras with seeded noise.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "world_model/world_model.h"

namespace regista::test {

inline constexpr RobotId kY3{Team::yellow, 3};
inline constexpr RobotId kB0{Team::blue, 0};

/// Uniform in [low, high), the same on every machine.
inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Sum of twelve uniforms: mean 0, variance 1, the same on every machine.
inline double normal(std::mt19937_64& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += uniform(random, 0.0, 1.0);
  return sum;
}

inline Time at_ms(double ms) { return from_us(static_cast<std::int64_t>(ms * 1000.0)); }

inline VisionFrame frame(Time captured, std::uint32_t number, std::vector<RobotDetection> robots,
                         std::vector<BallDetection> balls = {}, std::uint32_t camera = 0) {
  return {captured, captured, camera, number, std::move(robots), std::move(balls)};
}

/// Where a robot with that constant motion is at time t_s.
inline Pose moved(const Pose& start, const Twist& twist, double t_s) {
  return {start.position_m + twist.velocity_mps * t_s, wrap_angle(start.heading_rad + twist.angular_radps * t_s)};
}

/// Frames every 10 ms from first_ms to last_ms with one robot in constant motion.
inline void feed(WorldModel& world, RobotId id, const Pose& start, const Twist& twist, int first_ms, int last_ms) {
  for (int ms = first_ms; ms <= last_ms; ms += 10) {
    world.add_frame(
        frame(at_ms(ms), static_cast<std::uint32_t>(ms / 10), {{id, moved(start, twist, 0.001 * ms), 1.0}}));
  }
}

}  // namespace regista::test
