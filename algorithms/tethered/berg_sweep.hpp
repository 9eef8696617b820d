/// Berg's boundaries one after the other, outwards: what has ended is not looked at again.
///
///   BergSweep sweep(boundary, {.lengths = {.step = 0.2, .count = 3}, .spacing = 0.05});
///   while (!sweep.at_end()) use(sweep.next());
///
/// Method      The boundary as a list, counter-clockwise: arcs about nodes and the dividers between them. When a node
///             or a divider comes into reach, the arc that it lies on is split there. An arc that has ended
///             (berg_node_samples.hpp) leaves the list, and so does a divider directly before another one.
/// Complexity  a boundary costs its samples, its arcs, and what is new in it
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "algorithms/tethered/berg_node_samples.hpp"

namespace oxturn {

class BergSweep {
 public:
  /// `boundary` must outlive it.
  BergSweep(const BergBoundary& boundary, BergSampling sampling);
  BergSweep(const BergSweep&) = delete;
  BergSweep& operator=(const BergSweep&) = delete;

  bool at_end() const { return lap_ == sampling_.lengths.count; }
  /// The boundary at the next length, as BergBoundary::at().
  std::vector<BergBoundary::Piece> next();

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
  struct Activation {
    double length;
    std::int32_t node, event;
  };

  std::int32_t add_arcs_of(std::int32_t node);
  void activate(const Activation& a);
  void put_in_order();
  bool has_ended(const Item& item) const;
  void drop_ended_after(std::int32_t item);
  void add_samples(Item& arc, Polyline& points);
  void add(const Point& p, Polyline& points) const;
  void close_round(std::vector<BergBoundary::Piece>& pieces) const;
  Item& item(std::int32_t i) { return items_[static_cast<std::size_t>(i)]; }

  const BergBoundary& b_;
  const BergSampling sampling_;
  std::size_t lap_ = 0;
  double length_ = 0;
  std::vector<std::unique_ptr<BergNodeSamples>> samples_;  // by node, from its first boundary to its last
  std::vector<Activation> activations_;                    // by length, parents first
  std::size_t active_ = 0;                                 // so many of them have happened
  std::vector<Item> items_;                                // the first one is the list's head
  std::size_t in_order_ = 0;                               // so many items put_in_order() has left
  std::vector<std::int32_t> first_arc_;                    // by node, if one is in the list
};

}  // namespace oxturn
