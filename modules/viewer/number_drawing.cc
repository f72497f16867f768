#include "modules/viewer/drawing.h"

namespace regista {
namespace {

// Digits as strokes in a box of width 0.55 and height 1, the origin in its middle.
using Strokes = std::vector<std::vector<Vec2>>;
constexpr double kDigitWidth = 0.55;
constexpr double kDigitPitch = 0.80;  // from one digit's middle to the next one's

Strokes strokes_of(unsigned digit) {
  constexpr double w = kDigitWidth / 2;
  constexpr double q = 0.2;  // height of a cut corner
  switch (digit) {
    case 0:
      return {{{-w, 0.5 - q},
               {-w / 2, 0.5},
               {w / 2, 0.5},
               {w, 0.5 - q},
               {w, q - 0.5},
               {w / 2, -0.5},
               {-w / 2, -0.5},
               {-w, q - 0.5},
               {-w, 0.5 - q}}};
    case 1:
      return {{{-w * 0.8, 0.25}, {0.05, 0.5}, {0.05, -0.5}}};
    case 2:
      return {{{-w, 0.3}, {-w / 2, 0.5}, {w / 2, 0.5}, {w, 0.3}, {w, 0.1}, {-w, -0.5}, {w, -0.5}}};
    case 3:
      return {{{-w, 0.5},
               {w, 0.5},
               {0.0, 0.1},
               {w / 2, 0.1},
               {w, -0.1},
               {w, -0.3},
               {w / 2, -0.5},
               {-w / 2, -0.5},
               {-w, -0.35}}};
    case 4:
      return {{{w / 2, -0.5}, {w / 2, 0.5}, {-w, -0.2}, {w, -0.2}}};
    case 5:
      return {{{w, 0.5},
               {-w, 0.5},
               {-w, 0.05},
               {w / 2, 0.1},
               {w, -0.1},
               {w, -0.3},
               {w / 2, -0.5},
               {-w / 2, -0.5},
               {-w, -0.35}}};
    case 6:
      return {{{w, 0.4},
               {w / 2, 0.5},
               {-w / 2, 0.5},
               {-w, 0.3},
               {-w, -0.3},
               {-w / 2, -0.5},
               {w / 2, -0.5},
               {w, -0.3},
               {w, -0.1},
               {w / 2, 0.05},
               {-w, 0.0}}};
    case 7:
      return {{{-w, 0.5}, {w, 0.5}, {-w / 3, -0.5}}};
    case 8:
      return {{{-w / 2, 0.05},
               {-w, 0.25},
               {-w / 2, 0.5},
               {w / 2, 0.5},
               {w, 0.25},
               {w / 2, 0.05},
               {-w / 2, 0.05},
               {-w, -0.2},
               {-w, -0.3},
               {-w / 2, -0.5},
               {w / 2, -0.5},
               {w, -0.3},
               {w, -0.2},
               {w / 2, 0.05}}};
    default:
      return {{{-w, -0.4},
               {-w / 2, -0.5},
               {w / 2, -0.5},
               {w, -0.3},
               {w, 0.3},
               {w / 2, 0.5},
               {-w / 2, 0.5},
               {-w, 0.3},
               {-w, 0.1},
               {-w / 2, -0.05},
               {w, 0.0}}};
  }
}

}  // namespace

void add_number(Drawing& drawing, unsigned number, const Vec2& centre, double height_m, double stroke_m, Paint paint) {
  const std::string digits = std::to_string(number);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const double shift = kDigitPitch * (static_cast<double>(i) - static_cast<double>(digits.size() - 1) / 2);
    for (const std::vector<Vec2>& stroke : strokes_of(static_cast<unsigned>(digits[i] - '0'))) {
      std::vector<Vec2> points;
      for (const Vec2& p : stroke) points.push_back(centre + height_m * Vec2(p.x() + shift, p.y()));
      add_polyline(drawing, points, stroke_m, paint);
    }
  }
}

}  // namespace regista
