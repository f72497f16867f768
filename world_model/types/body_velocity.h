// A velocity as a robot is told it: in its own frame.
#pragma once

#include "world_model/types/geometry.h"
#include "world_model/types/time.h"

namespace regista {

struct BodyVelocity {
  double forward_mps = 0.0;
  double left_mps = 0.0;
  double angular_radps = 0.0;  ///< positive: counter-clockwise
  bool operator==(const BodyVelocity&) const = default;
};

/// A command that was sent, as the prediction wants it: it acts a fixed latency after `captured`.
struct SentVelocity {
  Time captured{};  ///< capture time of the vision the command was made from
  BodyVelocity velocity;
  bool operator==(const SentVelocity&) const = default;
};

/// The field-frame twist of a body with that heading, and back.
inline Twist to_field(const BodyVelocity& body, double heading_rad) {
  return {rotated({body.forward_mps, body.left_mps}, heading_rad), body.angular_radps};
}
inline BodyVelocity to_body(const Twist& twist, double heading_rad) {
  const Vec2 v = rotated(twist.velocity_mps, -heading_rad);
  return {v.x(), v.y(), twist.angular_radps};
}

}  // namespace regista
