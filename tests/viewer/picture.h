// A PNG as a test looks at it: colours at pixels, and how many pixels have a colour.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "modules/viewer/drawing.h"
#include "modules/viewer/view.h"

namespace regista {

class Picture {
 public:
  /// Reads it with ImageMagick, another program than the one that wrote it. Throws when it is no picture.
  explicit Picture(const std::string& file);

  int width() const { return width_; }
  int height() const { return height_; }
  Color at(int x, int y) const;
  Color at(const Vec2& pixel) const;

  /// Pixels within `tolerance` of the colour in every channel, in the square of that half width around a pixel.
  int count_near(Color color, const Vec2& pixel, int half_width, int tolerance = 30) const;
  int count(Color color, int tolerance = 30) const;

  bool operator==(const Picture&) const = default;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> rgb_;
};

bool alike(Color a, Color b, int tolerance = 30);

}  // namespace regista
