#include "planning/graph/edge_memo.h"

#include <algorithm>
#include <utility>

namespace regista::graph {
namespace {

constexpr std::size_t kFirstCapacity = 1024;

std::uint64_t key_of(std::uint32_t one, std::uint32_t other) {
  return (std::uint64_t{std::min(one, other)} << 32) | std::max(one, other);
}

/// Multiplying by 2^64/φ spreads neighbouring pairs over the high bits (Knuth, TAOCP 3, 6.4).
std::uint64_t spread(std::uint64_t key) {
  const std::uint64_t product = key * 0x9E3779B97F4A7C15ULL;
  return product ^ (product >> 32);
}

}  // namespace

void EdgeMemo::clear() {
  size_ = 0;
  if (++epoch_ != 0) return;
  for (Entry& entry : entries_) entry.epoch = 0;  // the counter came round
  epoch_ = 1;
}

std::size_t EdgeMemo::slot_of(std::uint64_t key) const {
  const std::size_t mask = entries_.size() - 1;
  std::size_t slot = spread(key) & mask;
  while (entries_[slot].epoch == epoch_ && entries_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

const BlockerList* EdgeMemo::find(std::uint32_t one, std::uint32_t other) const {
  if (entries_.empty()) return nullptr;
  const Entry& entry = entries_[slot_of(key_of(one, other))];
  return entry.epoch == epoch_ ? &entry.blockers : nullptr;
}

void EdgeMemo::insert(std::uint32_t one, std::uint32_t other, BlockerList blockers) {
  if (2 * (size_ + 1) > entries_.size()) grow();
  const std::uint64_t key = key_of(one, other);
  entries_[slot_of(key)] = {key, epoch_, blockers};
  ++size_;
}

void EdgeMemo::grow() {
  std::vector<Entry> old(std::max(kFirstCapacity, 2 * entries_.size()));
  std::swap(old, entries_);
  for (const Entry& entry : old) {
    if (entry.epoch == epoch_) entries_[slot_of(entry.key)] = entry;
  }
}

}  // namespace regista::graph
