#include "picture.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "tests/support/program.h"

namespace regista {

Picture::Picture(const std::string& file) {
  const TemporaryFolder scratch;
  const std::string plain = scratch.path("picture.ppm");
  const RunResult converted = run({"convert", file, "-depth", "8", "ppm:" + plain});
  if (converted.status != 0) throw std::runtime_error("no picture: " + file + ": " + converted.error);
  std::ifstream in(plain, std::ios::binary);
  std::string kind;
  int largest = 0;
  in >> kind >> width_ >> height_ >> largest;
  in.get();
  rgb_.resize(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  in.read(reinterpret_cast<char*>(rgb_.data()), static_cast<std::streamsize>(rgb_.size()));
  if (kind != "P6" || largest != 255 || !in) throw std::runtime_error("cannot read " + plain);
}

Color Picture::at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) throw std::out_of_range("pixel outside the picture");
  const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  return {rgb_[i], rgb_[i + 1], rgb_[i + 2]};
}

Color Picture::at(const Vec2& pixel) const { return at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())); }

int Picture::count_near(Color color, const Vec2& pixel, int half_width, int tolerance) const {
  const int x = static_cast<int>(pixel.x());
  const int y = static_cast<int>(pixel.y());
  int found = 0;
  for (int v = std::max(0, y - half_width); v <= std::min(height_ - 1, y + half_width); ++v) {
    for (int u = std::max(0, x - half_width); u <= std::min(width_ - 1, x + half_width); ++u) {
      found += alike(at(u, v), color, tolerance) ? 1 : 0;
    }
  }
  return found;
}

int Picture::count(Color color, int tolerance) const {
  return count_near(color, {width_ / 2.0, height_ / 2.0}, std::max(width_, height_), tolerance);
}

bool alike(Color a, Color b, int tolerance) {
  return std::abs(a.red - b.red) <= tolerance && std::abs(a.green - b.green) <= tolerance &&
         std::abs(a.blue - b.blue) <= tolerance;
}

}  // namespace regista
