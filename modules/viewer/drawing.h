// Flat shapes as coloured triangles, the one primitive that every OpenGL driver draws alike (widths of lines are
// ignored by many). Plain values, no OpenGL: scene_builder turns a Drawing into an MRPT scene.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "world_model/types/geometry.h"

namespace regista {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Color&) const = default;
};

/// share = 0: a, share = 1: b.
Color mixed(Color a, Color b, double share);

struct Triangle {
  std::array<std::array<float, 3>, 3> corners;  ///< metres: x, y of the field frame, z up
  Color color;
  bool operator==(const Triangle&) const = default;
};

using Drawing = std::vector<Triangle>;

/// Of what a shape is made: at which height, in which colour. Higher hides lower.
struct Paint {
  double z_m = 0.0;
  Color color;
};

void add_triangle(Drawing& drawing, const std::array<Vec2, 3>& corners, Paint paint);
void add_rectangle(Drawing& drawing, const Vec2& low, const Vec2& high, Paint paint);

/// A ribbon with square ends at its end points.
void add_segment(Drawing& drawing, const Vec2& a, const Vec2& b, double width_m, Paint paint);

/// Ribbons with round corners and ends.
void add_polyline(Drawing& drawing, const std::vector<Vec2>& points, double width_m, Paint paint);

void add_disc(Drawing& drawing, const Vec2& centre, double radius_m, Paint paint);

/// radius_m is the middle of the line.
void add_ring(Drawing& drawing, const Vec2& centre, double radius_m, double width_m, Paint paint);

/// A convex polygon, and the upright wall below its edge from paint.z_m down to z_low_m.
void add_polygon(Drawing& drawing, const std::vector<Vec2>& corners, Paint paint);
void add_wall(Drawing& drawing, const std::vector<Vec2>& corners, double z_low_m, Paint paint);

/// A whole number in strokes, centred; height_m is that of a digit.
void add_number(Drawing& drawing, unsigned number, const Vec2& centre, double height_m, double stroke_m, Paint paint);

}  // namespace regista
