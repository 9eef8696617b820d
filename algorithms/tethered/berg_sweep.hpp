/// Berg's boundaries one after the other, outwards: what has ended is not looked at again.
///
///   BergSweep sweep(boundary, 0.05);
///   for (double length = 0.2; length < boundary.farthest(); length += 0.2) use(sweep.at(length));
///
/// Method      The boundary as a list, counter-clockwise: arcs about nodes and the dividers between them. When a node
///             or a divider comes into reach, the arc that it lies on is split there. An arc whose node sees nothing so
///             far away leaves the list, and so does a divider directly before another one. With a trim, an arc leaves
///             it as well when all of its samples are left out: where another path is shorter, it is so farther out in
///             the same direction, too.
/// Complexity  a boundary costs its samples, its arcs, and what is new in it; a test of sight only for samples of which
///             sight_range.hpp does not know whether they are seen
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "algorithms/tethered/berg_boundary.hpp"

namespace oxturn {

/// Samples that may be left out: where a node surely sees all of its arc, and a straight segment from one sample to a
/// later one is free and within `error` metres of the arc.
struct BergThinning {
  double error = 0;                                              // 0: none are left out
  std::function<bool(const Point&, const Point&)> is_free = {};  // the segment between two points
};

/// Samples to be left out because a shorter tether reaches them.
struct BergTrim {
  std::function<double(const Point&)> shortest = {};  // metres of tether to a point; empty: none are left out
  double slack = 0;                                   // metres by which a lap's length may exceed that
};

class BergSweep {
 public:
  /// `boundary` must outlive it. `spacing`: of samples, metres. Of the samples only those are given for which `keep` is
  /// true; empty: all.
  BergSweep(const BergBoundary& boundary, double spacing, BergThinning thinning = {}, BergTrim trim = {},
            std::function<bool(const Point&)> keep = {});

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
    bool empty = false;            // of samples, in this boundary and all that follow
    double reach = std::numeric_limits<double>::infinity();  // metres of tether up to which the node sees something
  };
  struct Angles {
    double from, to;
  };
  /// The samples of an arc: numbers first to last of 0 to `count`.
  struct Steps {
    double from, to;  // radians in the sector
    double count = 1, first = 0, last = 0;
    double turn(double k) const { return from + (to - from) * (k / count); }
    double last_up_to(double angle) const { return std::floor((angle - from) / (to - from) * count); }
  };
  struct Activation {
    double length;
    std::int32_t node, event;
  };

  std::int32_t add_arcs_of(std::int32_t node);
  void activate(const Activation& a);
  void renumber_items();
  bool has_ended(const Item& item) const;
  void drop_ended_after(std::int32_t item);
  struct Run {  // of samples
    double first, last;
  };
  Steps steps_of(const Item& arc) const;
  void sample(Item& arc, Polyline& points);
  bool is_trimmed(const Point& p) const {
    return trim_.shortest && std::abs(length_ - trim_.shortest(p)) > trim_.slack;
  }
  void remember_empty(Item& arc, const Steps& steps);
  double longest_stride(double radius, double turn_per_step) const;
  void add(const Point& p, Polyline& points) const;
  void close_round(std::vector<BergBoundary::Piece>& pieces) const;
  Item& item(std::int32_t i) { return items_[static_cast<std::size_t>(i)]; }

  const BergBoundary& b_;
  double spacing_, length_ = 0;
  BergThinning thinning_;
  BergTrim trim_;
  std::function<bool(const Point&)> keep_;
  std::vector<std::vector<Angles>> empty_;  // by node: where samples are hidden or trimmed, ascending, disjoint
  std::vector<Run> kept_;                   // of the present arc
  std::vector<Activation> activations_;     // by length, parents first
  std::size_t active_ = 0;                  // so many of them have happened
  std::vector<Item> items_;                 // the first one is the list's head
  std::size_t in_order_ = 0;                // so many of them were numbered when renumber_items() was last called
  std::vector<std::int32_t> first_arc_;     // by node
};

}  // namespace oxturn
