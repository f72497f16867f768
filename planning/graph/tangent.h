// What a common tangent of two bodies is to a search: a leg, and where legs may leave.
#pragma once

#include <limits>

#include "planning/graph/body.h"

namespace regista::graph {

/// A straight leg from one boundary to another, touching both.
struct Tangent {
  Place from;
  Place to;
  Vec2 along = Vec2::Zero();  ///< unit
  double length_m = 0.0;
};

/// A point as a body.
inline Body body_of(const Vec2& point) {
  Body body;
  body.corners[0] = point;
  body.count = 1;
  body.period = 4.0;
  return body;
}

/// Where legs may leave a disc: from one normal on to another, gone round on a side, at most half way round. Nothing
/// narrow allows all.
struct Departures {
  bool is_narrow = false;
  double side = 1.0;
  Vec2 begin = Vec2::Zero();
  Vec2 end = Vec2::Zero();

  /// `normal` may have any length `scale`.
  bool allow(const Vec2& normal, double scale) const {
    constexpr double kRounding = 1e-8;
    const unsigned is_after_begin = side * cross(begin, normal) >= -kRounding * scale;
    const unsigned is_before_end = side * cross(normal, end) >= -kRounding * scale;
    return (static_cast<unsigned>(!is_narrow) | (is_after_begin & is_before_end)) != 0;
  }

  /// The same for several.
  template <class Lanes>
  typename Lanes::mask_type allow(const Lanes& x, const Lanes& y, double scale) const {
    constexpr double kRounding = 1e-8;
    const Lanes after_begin = side * (begin.x() * y - begin.y() * x);
    const Lanes before_end = side * (x * end.y() - y * end.x());
    const Lanes least = is_narrow ? -kRounding * scale : -std::numeric_limits<double>::infinity();
    return after_begin >= least && before_end >= least;
  }
};

/// Overlapping by this little counts as touching. Metres.
inline constexpr double kTangentTouch_m = 1e-9;

/// No corner lies farther out than the touched one, but for rounding.
inline bool supports(const Body& body, std::uint32_t corner, const Vec2& normal) {
  constexpr double kRounding_m = 1e-10;
  for (std::uint32_t k = 0; k < body.count; ++k) {
    if ((body.corners[k] - body.corners[corner]).dot(normal) > kRounding_m) return false;
  }
  return true;
}

}  // namespace regista::graph
