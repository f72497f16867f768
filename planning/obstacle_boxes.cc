#include "planning/obstacle_boxes.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

// A function of which the program holds a second version for processors with wider registers. Both do the same
// operations, without contraction; what they let through is tested exactly anyway.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define REGISTA_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define REGISTA_WIDE
#endif

namespace regista {
namespace {

/// From here on groups are faster than asking all boxes.
constexpr std::size_t kSmallField = 64;

// The lambdas below, which return such, are always inlined: no call depends on how one is passed.
#pragma GCC diagnostic ignored "-Wpsabi"

/// Several numbers at once; written with the compiler's vectors, which it lowers to whatever the processor has.
using Lanes = float __attribute__((vector_size(32)));
using Bits = std::int32_t __attribute__((vector_size(32)));

/// A bit for each lane.
constexpr Bits kFirstBits{1, 1 << 1, 1 << 2, 1 << 3, 1 << 4, 1 << 5, 1 << 6, 1 << 7};

/// All bits of a lane are set where the box is not separated from the sweep along x, along y, or across the segment
/// (for a point as core, exactly by its distance to the line).
constexpr auto near_bits = [](const auto& block, const auto& sweep) __attribute__((always_inline)) {
  const auto load = [](const auto& column) __attribute__((always_inline)) {
    return *reinterpret_cast<const Lanes*>(column.data());
  };
  const auto magnitude = [](const Lanes& lanes) __attribute__((always_inline)) {
    return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(lanes) & 0x7FFFFFFF);
  };
  const Lanes x = load(block.x) - sweep.x;
  const Lanes y = load(block.y) - sweep.y;
  const Lanes half_x = load(block.half_x);
  const Lanes half_y = load(block.half_y);
  const Lanes radius = load(block.radius);
  const Lanes apart = magnitude(sweep.along_x * y - sweep.along_y * x);
  const float across_x = std::abs(sweep.along_y);
  const float across_y = std::abs(sweep.along_x);
  return (magnitude(x) <= half_x + (radius + sweep.half_x)) & (magnitude(y) <= half_y + (radius + sweep.half_y)) &
         (apart <= across_x * half_x + (across_y * half_y + (radius + sweep.radius)));
};

/// The bits of all lanes in one number.
constexpr auto joined = [](const Bits& bits) __attribute__((always_inline)) {
  const auto low = __builtin_shufflevector(bits, bits, 0, 1, 2, 3);
  const auto halves = low | __builtin_shufflevector(bits, bits, 4, 5, 6, 7);
  const auto quarters = halves | __builtin_shufflevector(halves, halves, 2, 3, 0, 1);
  return static_cast<std::uint32_t>(quarters[0] | quarters[1]);
};

/// A padding box: its radius is below minus anything, so nothing is near enough.
constexpr float kNever = -1e30F;

/// The core's box.
Vec2 middle_of(const Obstacle& obstacle) { return 0.5 * (obstacle.a + obstacle.b); }
Vec2 half_of(const Obstacle& obstacle) { return 0.5 * (obstacle.b - obstacle.a).cwiseAbs(); }

/// No coordinate of it is larger.
Vec2 reach_of(const Obstacle& obstacle) {
  return obstacle.a.cwiseAbs().cwiseMax(obstacle.b.cwiseAbs()) + Vec2::Constant(obstacle.radius_m);
}

}  // namespace

void ObstacleBoxes::Block::set(std::size_t lane, const Vec2& middle, const Vec2& half, double radius_m) {
  const Eigen::Vector4f both = Eigen::Vector4d(middle.x(), middle.y(), half.x(), half.y()).cast<float>();
  x[lane] = both[0];
  y[lane] = both[1];
  half_x[lane] = both[2];
  half_y[lane] = both[3];
  radius[lane] = static_cast<float>(radius_m);
}

void ObstacleBoxes::Block::set(std::size_t lane, const Obstacle& obstacle) {
  set(lane, middle_of(obstacle), half_of(obstacle), obstacle.radius_m);
}

/// The same for that lane and the next three: four boxes as rows, turned into columns.
void ObstacleBoxes::Block::set_four(std::size_t lane, const std::array<const Obstacle*, 4>& obstacles) {
  using Doubles = double __attribute__((vector_size(32)));
  using Floats = float __attribute__((vector_size(16)));
  const auto row = [](const Obstacle& obstacle) __attribute__((always_inline)) {
    const Vec2 middle = middle_of(obstacle);
    const Vec2 half = half_of(obstacle);
    return __builtin_convertvector((Doubles{middle.x(), middle.y(), half.x(), half.y()}), Floats);
  };
  const auto [a, b, c, d] = obstacles;
  const Floats a_row = row(*a), b_row = row(*b), c_row = row(*c), d_row = row(*d);
  const Floats ab = __builtin_shufflevector(a_row, b_row, 0, 4, 1, 5);
  const Floats cd = __builtin_shufflevector(c_row, d_row, 0, 4, 1, 5);
  const Floats ab_half = __builtin_shufflevector(a_row, b_row, 2, 6, 3, 7);
  const Floats cd_half = __builtin_shufflevector(c_row, d_row, 2, 6, 3, 7);
  const auto store = [lane](std::array<float, kLanes> & column, const Floats& four) __attribute__((always_inline)) {
    *reinterpret_cast<Floats*>(column.data() + lane) = four;
  };
  store(x, __builtin_shufflevector(ab, cd, 0, 1, 4, 5));
  store(y, __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
  store(half_x, __builtin_shufflevector(ab_half, cd_half, 0, 1, 4, 5));
  store(half_y, __builtin_shufflevector(ab_half, cd_half, 2, 3, 6, 7));
  store(radius, __builtin_convertvector((Doubles{a->radius_m, b->radius_m, c->radius_m, d->radius_m}), Floats));
}

void ObstacleBoxes::Block::pad(std::size_t lane) {
  x[lane] = y[lane] = half_x[lane] = half_y[lane] = 0.0F;
  radius[lane] = kNever;
}

ObstacleBoxes::Sweep ObstacleBoxes::sweep_of(const Motion& motion) const {
  const Vec2 half = 0.5 * (motion.to - motion.from);
  const Vec2 middle = motion.from + half;
  const Vec2 reach = middle.cwiseAbs() + half.cwiseAbs();
  // Single precision rounds by 6e-8; sums and products of four numbers stay below ten times that.
  const double radius_m = motion.radius_m + 1e-6 * std::max(extent_m_, reach.maxCoeff());
  return {static_cast<float>(middle.x()),
          static_cast<float>(middle.y()),
          static_cast<float>(std::abs(half.x()) + radius_m),
          static_cast<float>(std::abs(half.y()) + radius_m),
          static_cast<float>(motion.along.x()),
          static_cast<float>(motion.along.y()),
          static_cast<float>(radius_m)};
}

REGISTA_WIDE std::uint32_t ObstacleBoxes::hits(const Block* begin, const Block* end, const Sweep& sweep) {
  Bits hits{};
  Bits bit = kFirstBits;
  for (const Block* block = begin; block != end; ++block, bit <<= kLanes) hits |= near_bits(*block, sweep) & bit;
  return joined(hits);
}

REGISTA_WIDE void ObstacleBoxes::group_hits(const Block* blocks, std::uint32_t groups, const Sweep& sweep,
                                            std::array<GroupHits, kChunk>& hits) {
  static_assert(kGroupSize == 2 * kLanes);
  GroupHits* out = hits.data();
  for (; groups != 0; groups &= groups - 1) {
    const Block* const pair = blocks + std::ptrdiff_t{2} * std::countr_zero(groups);
    *out++ = static_cast<GroupHits>(
        joined((near_bits(pair[0], sweep) & kFirstBits) | (near_bits(pair[1], sweep) & (kFirstBits << kLanes))));
  }
}

void ObstacleBoxes::clear() {
  extent_m_ = 0.0;
  groups_.clear();
  index_.clear();
  blocks_.clear();
}

void ObstacleBoxes::append(const Obstacle& obstacle, ObstacleIndex index) {
  extent_m_ = std::max(extent_m_, reach_of(obstacle).maxCoeff());
  const std::size_t lane = index_.size() % kLanes;
  if (lane == 0) {
    blocks_.emplace_back();
    for (std::size_t i = 0; i < kLanes; ++i) blocks_.back().pad(i);
  }
  blocks_.back().set(lane, obstacle);
  index_.push_back(index);
}

void ObstacleBoxes::assign(std::span<const Obstacle> obstacles) {
  groups_.clear();
  index_.resize(obstacles.size());
  const bool is_large = obstacles.size() > kSmallField;
  const std::size_t whole = is_large ? kGroupSize : kLanes;  // groups have no gaps
  const std::size_t padded = (obstacles.size() + whole - 1) / whole * whole;
  blocks_.resize(padded / kLanes);
  std::iota(index_.begin(), index_.end(), ObstacleIndex{0});
  if (is_large) {
    extent_m_ = 0.0;
    for (const Obstacle& obstacle : obstacles) extent_m_ = std::max(extent_m_, reach_of(obstacle).maxCoeff());
    sort_into_groups(obstacles);
  }
  const auto at = [&](std::size_t i) -> const Obstacle& { return obstacles[index_[i]]; };
  std::array<Vec2, 2> extents{Vec2::Zero(), Vec2::Zero()};  // a maximum has to wait for the one before
  std::size_t done = 0;
  for (; done + 4 <= obstacles.size(); done += 4) {
    const std::array four{&at(done), &at(done + 1), &at(done + 2), &at(done + 3)};
    blocks_[done / kLanes].set_four(done % kLanes, four);
    extents[0] = extents[0].cwiseMax(reach_of(*four[0]).cwiseMax(reach_of(*four[1])));
    extents[1] = extents[1].cwiseMax(reach_of(*four[2]).cwiseMax(reach_of(*four[3])));
  }
  for (; done < obstacles.size(); ++done) {
    blocks_[done / kLanes].set(done % kLanes, at(done));
    extents[0] = extents[0].cwiseMax(reach_of(at(done)));
  }
  extent_m_ = extents[0].cwiseMax(extents[1]).maxCoeff();
  for (std::size_t i = obstacles.size(); i < padded; ++i) blocks_[i / kLanes].pad(i % kLanes);
}

/// Neighbours in the list are to be neighbours in the field.
void ObstacleBoxes::sort_into_groups(std::span<const Obstacle> obstacles) {
  order_.clear(extent_m_);
  for (const Obstacle& obstacle : obstacles) order_.add(middle_of(obstacle));
  const std::span<const ZOrder::Entry> order = order_.sort();
  const std::size_t groups = (order.size() + kGroupSize - 1) / kGroupSize;
  groups_.resize((groups + kLanes - 1) / kLanes);
  for (std::size_t group = 0; group < groups; ++group) {
    Vec2 low = Vec2::Constant(extent_m_);
    Vec2 high = -low;
    for (std::size_t i = group * kGroupSize; i < std::min((group + 1) * kGroupSize, order.size()); ++i) {
      index_[i] = order[i].index;
      const Obstacle& obstacle = obstacles[index_[i]];
      const Vec2 reach = half_of(obstacle) + Vec2::Constant(obstacle.radius_m);
      low = low.cwiseMin(middle_of(obstacle) - reach);
      high = high.cwiseMax(middle_of(obstacle) + reach);
    }
    groups_[group / kLanes].set(group % kLanes, 0.5 * (low + high), 0.5 * (high - low), 0.0);
  }
  for (std::size_t i = groups; i < groups_.size() * kLanes; ++i) groups_[i / kLanes].pad(i % kLanes);
}

}  // namespace regista
