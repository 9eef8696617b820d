// Segments in square buckets, to be added to and asked at any time: is a point within reach of one of them?
//
// Complexity  add O(buckets crossed), a question O(segments nearby); memory O(area / reach^2 + segments)
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

class NearLines {
 public:
  NearLines(const Box& box, double reach);
  void add(const Point& a, const Point& b);
  bool within_reach(const Point& p) const;

 private:
  struct Segment {
    Point a, b;
  };
  int column(double x) const;
  int row(double y) const;
  double reach_, side_;
  Point low_;
  int columns_, rows_;
  std::vector<Segment> segments_;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace oxturn
