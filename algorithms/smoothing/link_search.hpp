/// The cheapest free curve between two poses, or between poses moved along the lines of their lanes.
///
///   if (const auto link = LinkSearch(space, from, to).cheapest(most)) drive(*link);
///
/// Curves are looked at in the order of their cost, and worked out only once a bound on it comes up. Most that are
/// blocked are so in their first or last piece, which they share: how far these are free is found once for each pose.
/// Complexity  some dozens of curve lengths; some dozens of curves are tested where many are blocked
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "algorithms/smoothing/car_space.hpp"

namespace oxturn {

/// The curves looked at, whatever obstacles they meet: some dozens, in no order.
std::vector<Curve> link_curves(const Pose& from, const Pose& to, double radius, bool reverse);

/// How far the robot can drive from a pose by each steering and gear, as far as it was asked for.
class FreePieces {
 public:
  FreePieces(const CarSpace& space, const Pose& from) : space_(&space), from_(from) {}
  const Pose& from() const { return from_; }
  /// The piece driven from the pose meets an obstacle. An arc is tested in whole chords; the rest of it is not.
  bool blocked(const CurvePiece& piece);

 private:
  struct Known {
    double free = 0, blocked = std::numeric_limits<double>::infinity();  // metres
  };
  bool arc_blocked(const CurvePiece& piece, Known& known) const;

  const CarSpace* space_;
  Pose from_;
  std::array<Known, 6> known_{};
};

class LinkSearch {
 public:
  /// `space` must outlive it.
  LinkSearch(const CarSpace& space, const Pose& from, const Pose& to);
  /// nullopt: none of those that cost less than `most` is free.
  std::optional<Curve> cheapest(double most);

 private:
  /// A pose moved along its lane's line.
  struct Moved {
    double shift;  // metres
    FreePieces pieces;
  };
  /// Two moved poses, bounded by their distance, the same bounded by the shortest curve, or a curve between them.
  enum class Kind : std::uint8_t { near_pair, pair, curve };
  /// The least cost first, then in the order of their making.
  struct Item {
    double least;  // of the cost
    std::size_t made;
    std::uint8_t out, in;  // of outs_ and ins_
    Kind kind;
    std::uint8_t known;  // of a pair: curves in words_, from `word` on, the shortest first
    std::size_t word;
    bool operator>(const Item& other) const { return least != other.least ? least > other.least : made > other.made; }
  };

  double moved(const Item& item) const;
  void add(std::uint8_t out, std::uint8_t in, double most);
  void bound(Item item, double most);
  void work_out(const Item& pair, double most);
  void add_curve(const Item& pair, std::size_t word, double most);
  double cost(const Item& item) const;
  bool moves_blocked(const Item& pair);
  bool ends_blocked(const Item& item);
  Curve link(const Item& item) const;
  void push(const Item& item);
  Item pop();

  const CarSpace& space_;
  Pose from_, to_;
  FreePieces before_, behind_;
  std::vector<Moved> outs_, ins_;  // the first is not moved
  std::vector<Item> heap_;
  std::vector<Word> words_;
  std::size_t made_ = 0;
};

}  // namespace oxturn
