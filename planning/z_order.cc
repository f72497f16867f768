#include "planning/z_order.h"

#include <array>
#include <utility>

namespace regista {
namespace {

/// Along each axis; a key has twice as many.
constexpr int kBits = 12;

/// Sorted at a time: more need fewer rounds, but each has to go through 2^bits counters.
constexpr int kDigitBits = 8;

/// The lower 12 bits, each moved to twice its place.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | (bits << 8)) & 0x00FF00FFU;
  bits = (bits | (bits << 4)) & 0x0F0F0F0FU;
  bits = (bits | (bits << 2)) & 0x33333333U;
  return (bits | (bits << 1)) & 0x55555555U;
}

}  // namespace

void ZOrder::clear(double extent_m) {
  constexpr double kCells = (1U << kBits) - 1;
  extent_m_ = extent_m;
  scale_ = extent_m > 0.0 ? 0.5 * kCells / extent_m : 0.0;
  entries_.clear();
}

void ZOrder::add(const Vec2& place) {
  const auto cell = [this](double coordinate_m) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>((coordinate_m + extent_m_) * scale_));
  };
  entries_.push_back(
      {spread(cell(place.x())) | (spread(cell(place.y())) << 1), static_cast<std::uint32_t>(entries_.size())});
}

/// Radix sort, the lowest digit first: a comparison sort takes three times as long.
std::span<const ZOrder::Entry> ZOrder::sort() {
  scratch_.resize(entries_.size());
  for (int shift = 0; shift < 2 * kBits; shift += kDigitBits) {
    std::array<std::uint32_t, 1U << kDigitBits> ends{};
    const auto digit = [shift](const Entry& entry) { return (entry.key >> shift) % (1U << kDigitBits); };
    for (const Entry& entry : entries_) ++ends[digit(entry)];
    std::uint32_t begin = 0;
    for (std::uint32_t& end : ends) begin += std::exchange(end, begin);
    for (const Entry& entry : entries_) scratch_[ends[digit(entry)]++] = entry;
    std::swap(entries_, scratch_);
  }
  return entries_;
}

}  // namespace regista
