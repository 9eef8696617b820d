/// What capsules leave of a small convex area, in convex pieces.
///
///   ConvexRest rest(box);
///   for (const Segment& s : nearest_first)
///     if (rest.empty() || !rest.subtract(s.a, s.b, tool_width / 2)) break;   // false: too many pieces
///   if (rest.empty()) ...                                                   // all of the box is covered
///
/// Errs outside: discs about the ends of segments lose what polygons inscribed in them do not cover. Pieces thinner
/// than 1e-9 of the capsule's radius are dropped. O(pieces) for each capsule, of which there are at most kMostPieces.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/region.hpp"

namespace oxturn {

/// Counter-clockwise vertices.
struct ConvexPiece {
  static constexpr std::size_t kMost = 16;
  std::size_t size = 0;
  std::array<Point, kMost> at;
  ConvexPiece() {}  // not initialised: millions are made
  ConvexPiece(const ConvexPiece& o) { *this = o; }
  ConvexPiece& operator=(const ConvexPiece& o) {
    size = o.size;
    for (std::size_t k = 0; k < size; ++k) at[k] = o.at[k];
    return *this;
  }
  const Point* begin() const { return at.data(); }
  const Point* end() const { return at.data() + size; }
};

class ConvexRest {
 public:
  static constexpr std::size_t kMostPieces = 24;

  ConvexRest() = default;
  explicit ConvexRest(const Box& box) { reset(box); }
  void reset(const Box& box);

  /// Takes away what is nearer to the segment than `radius`. False, if that made too many pieces or vertices; then what
  /// is left is not known.
  bool subtract(const Point& a, const Point& b, double radius);
  bool empty() const { return count_ == 0; }
  const ConvexPiece* begin() const { return pieces_.data(); }
  const ConvexPiece* end() const { return pieces_.data() + count_; }

 private:
  using Pieces = std::array<ConvexPiece, kMostPieces>;
  void keep(const ConvexPiece& piece);
  void subtract(const ConvexPiece& piece, const Point& a, const Point& b, double radius);
  void subtract_disc(const ConvexPiece& piece, const Point& centre, double radius, int depth);
  bool split(const ConvexPiece& piece, const Point& normal, double at, double tolerance, ConvexPiece& below,
             ConvexPiece& above);

  Pieces pieces_, next_;
  std::size_t count_ = 0, next_count_ = 0;
  bool fits_ = true;
};

}  // namespace oxturn
