/// Berg's boundaries one after the other, outwards: what has ended is not looked at again.
///
///   BergSweep sweep(boundary, 0.05);
///   for (double length = 0.2; length < boundary.farthest(); length += 0.2) use(sweep.at(length));
///
/// Method      The boundary as a list, counter-clockwise: arcs about nodes and the dividers between them. When a node
///             or a divider comes into reach, the arc that it lies on is split there. An arc whose node sees nothing so
///             far away leaves the list, and so does a divider directly before another one.
/// Complexity  a boundary costs its samples, its arcs, and what is new in it; a test of sight only for samples of which
///             sight_range.hpp does not know whether they are seen
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "algorithms/tethered/berg_boundary.hpp"

namespace oxturn {

/// Samples that may be left out: where a node surely sees all of its arc, and a straight segment from one sample to a
/// later one is free and within `error` metres of the arc; and those that are not wanted, where a test of sight would
/// be needed to know whether they are seen.
struct BergThinning {
  double error = 0;                                              // 0: none are left out
  std::function<bool(const Point&, const Point&)> is_free = {};  // the segment between two points
  std::function<bool(const Point&)> is_wanted = {};              // none: all are
};

class BergSweep {
 public:
  /// `boundary` must outlive it. `spacing`: of samples, metres.
  BergSweep(const BergBoundary& boundary, double spacing, BergThinning thinning = {});

  /// See BergBoundary::at. `length` must not be less than the one before.
  std::vector<BergBoundary::Piece> at(double length);

 private:
  static constexpr std::int32_t kNone = -1;
  /// An arc of a node between two of its events, or a divider.
  struct Item {
    std::int32_t node;             // kNone: a divider
    std::int32_t begin, end;       // events; -1 and their number: the sides of the sector. Of a divider: its number, -
    std::int32_t next = kNone;     // in the list
    std::int32_t sibling = kNone;  // the next arc of the node
  };
  struct Activation {
    double length;
    std::int32_t node, event;
  };

  std::int32_t add_arcs_of(std::int32_t node);
  void activate(const Activation& a);
  bool has_ended(const Item& item) const;
  void drop_ended_after(std::int32_t item);
  void sample(const Item& arc, BergBoundary::Piece& piece) const;
  double longest_stride(double radius, double turn_per_step) const;
  void add(const Point& p, Polyline& points) const;
  void close_round(std::vector<BergBoundary::Piece>& pieces) const;
  Item& item(std::int32_t i) { return items_[static_cast<std::size_t>(i)]; }

  const BergBoundary& b_;
  double spacing_, length_ = 0;
  BergThinning thinning_;
  std::vector<Activation> activations_;  // by length, parents first
  std::size_t active_ = 0;               // so many of them have happened
  std::vector<Item> items_;              // the first one is the list's head
  std::vector<std::int32_t> first_arc_;  // by node
};

}  // namespace oxturn
