#include "planning/graph/tangents.h"

#include <experimental/simd>

namespace regista::graph {

/// In the terms of for_tangents: a corner's normal n must lie on its arc, that is between where it begins and where the
/// next one does; all lengths times d².
std::uint32_t leading_corners(const Body& many, double side, const Vec2& other, bool is_to, double m) {
  using Lanes = std::experimental::native_simd<double>;
  constexpr double kRounding_m = 1e-10;
  const double touch2 = 2.0 * kTangentTouch_m * std::abs(m);
  const double sign = is_to ? 1.0 : -1.0;
  std::uint32_t corners = 0;
  for (std::uint32_t k = 0; k < many.count; k += static_cast<std::uint32_t>(Lanes::size())) {
    const auto at = [&](const auto& value) {
      return Lanes([&](std::size_t lane) { return value((k + static_cast<std::uint32_t>(lane)) % many.count); });
    };
    const auto next = [&](std::uint32_t i) { return (i + 1) % many.count; };
    const auto last = [&](std::uint32_t i) { return (i + many.count - 1) % many.count; };
    const Lanes x = sign * (at([&](std::uint32_t i) { return many.corners[i].x(); }) - other.x());
    const Lanes y = sign * (at([&](std::uint32_t i) { return many.corners[i].y(); }) - other.y());
    const Lanes distance2 = x * x + y * y;
    const Lanes length2 = distance2 - m * m;
    const Lanes length = std::experimental::sqrt(std::experimental::max(length2, Lanes(0.0)));
    const Lanes normal_x = -side * (m * x - length * y);
    const Lanes normal_y = -side * (m * y + length * x);
    const auto beyond = [&](const auto& index) {  // how far the normal lies beyond where that arc begins
      return at([&](std::uint32_t i) { return many.begin_normals[index(i)].x(); }) * normal_y -
             at([&](std::uint32_t i) { return many.begin_normals[index(i)].y(); }) * normal_x;
    };
    const auto own = [](std::uint32_t i) { return i; };
    const Lanes rounding = kRounding_m * distance2;
    const auto is_on_arc = at([&](std::uint32_t i) { return many.side_lengths[i]; }) * beyond(next) <= rounding &&
                           at([&](std::uint32_t i) { return many.side_lengths[last(i)]; }) * beyond(own) >= -rounding;
    const auto leads = length2 >= -touch2 && (is_on_arc || length2 <= touch2);
    corners |= static_cast<std::uint32_t>(leads.__to_bitset().to_ulong()) << k;
  }
  return corners & ((1U << many.count) - 1U);
}

}  // namespace regista::graph
