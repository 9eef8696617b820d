// The nearest of many parts by driven way: entry points in a grid, tried in order of straight distance until no
// straight distance can beat the best way found.
//
// Complexity  add O(1); a question looks at rings of grid cells around the robot, and asks for a shortest path only
//             for a part's points that could still win.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/shortest_path.hpp"

namespace oxturn {

class NearestPart {
 public:
  explicit NearestPart(const ShortestPaths& paths) : paths_(paths) {}
  /// An entry point of a part; `id` is the caller's.
  void add(const Point& p, int part, std::size_t id) { entries_.push_back({p, part, id}); }
  /// The part is done: its points no longer count.
  void drop(int part);

  struct Found {
    std::size_t id;
    Polyline way;  // from the asking point to the entry, both included
  };
  /// nullopt if nothing that is left can be reached. Ties: the entry added first.
  std::optional<Found> from(const Point& p) const;

 private:
  struct Entry {
    Point at;
    int part;
    std::size_t id;
  };
  void index() const;
  bool dropped(int part) const {
    return static_cast<std::size_t>(part) < dropped_.size() && dropped_[static_cast<std::size_t>(part)];
  }
  const ShortestPaths& paths_;
  mutable std::vector<Entry> entries_;
  std::vector<bool> dropped_;
  std::size_t gone_ = 0;
  mutable std::size_t indexed_ = 0;
  mutable Box box_;
  mutable double cell_ = 1;
  mutable int columns_ = 0, rows_ = 0;
  mutable std::vector<std::uint32_t> first_, items_;
};

}  // namespace oxturn
