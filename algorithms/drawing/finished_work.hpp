/// What of a drawing is finished, and where driving would cross it.
///
///   FinishedWork work(pieces, tool_width / 2);
///   work.finish(0);
///   work.crossed({a, b}, 0);                     // finished pieces that the line drives over
///   work.crossing_m({a, b});                     // metres of it
///
/// A piece is what is drawn in one stroke of the tool: a line as wide as the tool was there. A robot that comes from a
/// stroke, or goes to one, cannot but stand on it: within the tool's half width of a transit's ends nothing counts.
/// Complexity  a query costs the segments of pieces near the line
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/path.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

struct DrawnPiece {
  Polyline points;
  double half_width = 0;
};

class FinishedWork {
 public:
  /// `exempt`: radius of the discs about a transit's ends in which nothing counts.
  FinishedWork(std::vector<DrawnPiece> pieces, double exempt);

  const std::vector<DrawnPiece>& pieces() const { return pieces_; }
  double exempt() const { return exempt_; }
  bool finished(std::size_t piece) const { return finished_[piece]; }
  const std::vector<bool>& finished() const { return finished_; }  // by piece
  void finish(std::size_t piece) { set(piece, true); }
  void undo(std::size_t piece) { set(piece, false); }
  /// The same for equal sets of finished pieces, different for others (but for one chance in 2^64).
  std::uint64_t fingerprint() const { return fingerprint_; }

  /// The finished pieces nearer to the line than their half width, outside of the discs about its ends; and, with
  /// `keep_off`, those nearer than that more, outside of discs larger by as much. Ascending.
  std::vector<std::size_t> crossed(const Polyline& line, double keep_off) const;
  /// Whether crossed() is empty; ends with the first piece that is crossed.
  bool clear(const Polyline& line, double keep_off) const;
  /// Metres of the line inside finished pieces, outside of the discs.
  double crossing_m(const Polyline& line) const;
  /// The same for one segment of a transit from `from` to `to`.
  double crossing_m(const Point& a, const Point& b, const Point& from, const Point& to) const;

 private:
  struct Item {
    Point a, b;
    std::uint32_t piece;
  };
  struct Interval {
    double low, high;  // metres along a segment
    std::size_t piece;
  };
  void set(std::size_t piece, bool finished);
  /// Where the segment is inside finished pieces grown by `growth`, outside of the discs.
  std::vector<Interval> inside(const Point& a, const Point& b, const Point& from, const Point& to, double growth) const;

  std::vector<DrawnPiece> pieces_;
  double exempt_, widest_ = 0;
  std::vector<Item> items_;  // segments of all pieces
  UniformGrid grid_;
  std::vector<bool> finished_;
  std::uint64_t fingerprint_ = 0;
};

}  // namespace oxturn
