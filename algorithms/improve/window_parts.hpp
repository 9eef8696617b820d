/// The parts of a path in some windows, which may be changed at the same time, and what is outside, which may not.
///
///   const WindowParts parts(path, windows, walls, tool_width, false);
///   std::vector<std::optional<VertexPath>> changed(windows.size());
///   changed[k] = parts.part(k);                          // change it
///   const Joined all = parts.joined(changed);            // the whole path
///
/// Windows are turned as witnesses are, and disjoint. Of the path between two visits of a window, the first and the
/// last vertex are kept beside the visits, so that the path's directions there are known.
///
/// A part stays one path if the rest of the path connects its visits as before. Two parts that connect their visits in
/// another order may contradict each other: together they would be a path and a loop. Then the one whose window comes
/// first is kept, and the other one stays as it was.
///
/// Complexity  O(n k) for n vertices and k windows, some nanoseconds for each pair; joined(): O(n log n), and
///             O(n log k) more for each window that is refused
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/improve/moves.hpp"
#include "algorithms/improve/vertex_path.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {

struct Joined {
  Polyline path;
  std::vector<std::uint8_t> kept;  // the changes of window k
};

class WindowParts {
 public:
  /// `fixed_end`: the path ends where it does now. `walls` must outlive it.
  WindowParts(const Polyline& path, const std::vector<Box>& windows, const EdgeIndex& walls, double width,
              bool fixed_end);

  /// The whole path, with vertices where its edges are cut at the sides of windows.
  const Polyline& path() const { return path_; }
  bool visited(std::size_t k) const { return !parts_[k].visits.empty(); }
  /// The visits of window k one after the other; it must be visited.
  VertexPath part(std::size_t k) const;
  /// The whole path, where the parts that are given stand for those that were.
  Joined joined(const std::vector<std::optional<VertexPath>>& changed) const;

 private:
  static constexpr std::uint32_t kOutside = 0xffffffff;
  struct Visit {
    std::size_t first, last;  // positions in path_
  };
  struct Part {
    std::vector<Visit> visits;
    std::size_t inner = 0;  // vertices of path_ that may move
  };
  /// A part as a sequence: positions in path_, which of them are fixed, and before which of them the path is outside.
  struct Sequence {
    std::vector<std::size_t> at, fixed;
    std::vector<std::uint8_t> outside;
  };
  struct Crossing {
    double first, last;  // parameters of the edge
    std::uint32_t window;
  };
  void add_edge(const Point& a, const Point& b, const std::vector<Box>& windows);
  void add(const Point& p, std::uint32_t window);
  void end_visit(bool fixed);
  std::optional<Point> cut(const Point& from, const Point& to, const Point& at);
  bool last_is_fixed(const Visit& visit) const { return fixed_end_ || visit.last + 1 < path_.size(); }
  Sequence sequence(std::size_t k) const;
  Polyline without_made(const Polyline& path) const;

  class Joining;
  const EdgeIndex& walls_;
  double width_;
  bool fixed_end_;
  Polyline path_;
  std::vector<std::uint32_t> window_;  // of the edge from vertex i to the next one
  std::optional<std::size_t> begin_;   // of the visit that has not ended
  std::vector<Part> parts_;            // by window
  std::vector<Point> made_;            // where edges were cut; sorted
};

}  // namespace oxturn
