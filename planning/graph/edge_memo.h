// What is known of the edges of a frame's graph: a flat table from a pair of nodes to the edge's list of blockers.
// Clearing it costs nothing, so a new frame keeps the memory of the last one.
#pragma once

#include <cstdint>
#include <vector>

namespace regista::graph {

/// A range of the graph's arena of obstacle indices.
struct BlockerList {
  std::uint32_t begin = 0;
  std::uint32_t count = 0;
};

/// Open addressing with linear probing; an undirected edge is kept under (smaller, larger).
class EdgeMemo {
 public:
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t epoch = 0;  ///< entries of another epoch count as empty
    BlockerList blockers;
  };

  void clear();

  /// The edge's entry, or nullptr while it is unknown.
  const BlockerList* find(std::uint32_t one, std::uint32_t other) const;

  /// The edge must be unknown.
  void insert(std::uint32_t one, std::uint32_t other, BlockerList blockers);

  /// Calls visit(one, other, blockers) for all known edges, in no particular order.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Entry& entry : entries_) {
      if (entry.epoch != epoch_) continue;
      visit(static_cast<std::uint32_t>(entry.key >> 32), static_cast<std::uint32_t>(entry.key), entry.blockers);
    }
  }

  std::size_t size() const { return size_; }

 private:
  std::size_t slot_of(std::uint64_t key) const;
  void grow();

  std::vector<Entry> entries_;  ///< a power of two, at most half full
  std::size_t size_ = 0;
  std::uint32_t epoch_ = 1;
};

}  // namespace regista::graph
