// Marks the cells inside a star, row by row.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "algorithms/online/belief.hpp"

namespace oxturn {
namespace {

constexpr double kKeepOff = 1e-3;  // cells by which a certain cell lies inside its star: more than all rounding
constexpr std::uint64_t kEveryByte = 0x0101010101010101;

}  // namespace

/// Marks the cells that lie inside the ring: those whose centre does, except those that an edge comes near. Returns
/// whether any of them did not have the mark.
bool Belief::fill(const Ring& ring, const Point& eye, std::uint8_t mark) {
  marked_anew_ = false;
  if (ring.size() < 3) return false;
  std::vector<Point> vertices;  // in cells
  vertices.reserve(ring.size());
  double bottom = 1e300, top = -1e300;
  for (const Point& p : ring) {
    vertices.push_back((eye + p - low_) / cell_);
    bottom = std::min(bottom, vertices.back().y());
    top = std::max(top, vertices.back().y());
  }
  const int first = std::max(0, static_cast<int>(std::floor(bottom - kKeepOff)));
  const int last = std::min(rows_ - 1, static_cast<int>(std::floor(top + kKeepOff)));
  if (last < first) return false;
  const auto rows = static_cast<std::size_t>(last - first + 1);
  if (scratch_.size() < rows) scratch_.resize(rows);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    add_edge(vertices[k], vertices[k + 1 < vertices.size() ? k + 1 : 0], first, last);
  for (int j = first; j <= last; ++j) fill_row(j, scratch_[static_cast<std::size_t>(j - first)], mark);
  return marked_anew_;
}

/// Enters an edge into the rows that it comes near; scratch_[0] is row `first`.
void Belief::add_edge(const Point& p, const Point& q, int first, int last) {
  const Point &a = p.y() <= q.y() ? p : q, &b = p.y() <= q.y() ? q : p;
  const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0;
  const int from = std::max(first, static_cast<int>(std::floor(a.y() - kKeepOff)));
  const int to = std::min(last, static_cast<int>(std::floor(b.y() + kKeepOff)));
  for (int j = from; j <= to; ++j) {
    Row& row = scratch_[static_cast<std::size_t>(j - first)];
    const double y0 = std::clamp(j - kKeepOff, a.y(), b.y()), y1 = std::clamp(j + 1 + kKeepOff, a.y(), b.y());
    double left = b.y() > a.y() ? a.x() + slope * (y0 - a.y()) : a.x();
    double right = b.y() > a.y() ? a.x() + slope * (y1 - a.y()) : b.x();
    if (left > right) std::swap(left, right);
    row.edges.emplace_back(static_cast<int>(std::floor(left - kKeepOff)),
                           static_cast<int>(std::floor(right + kKeepOff)));
    const double centre = j + 0.5;
    if ((a.y() <= centre) != (b.y() <= centre)) row.crossings.push_back(a.x() + slope * (centre - a.y()));
  }
}

void Belief::fill_row(int j, Row& row, std::uint8_t mark) {
  std::sort(row.crossings.begin(), row.crossings.end());
  std::sort(row.edges.begin(), row.edges.end());
  std::size_t edge = 0;
  int done = 0;  // cells before this one are dealt with
  for (std::size_t k = 0; k + 1 < row.crossings.size(); k += 2) {
    int from = std::max({0, done, static_cast<int>(std::ceil(row.crossings[k] - 0.5))});
    const int to = std::min(columns_ - 1, static_cast<int>(std::ceil(row.crossings[k + 1] - 0.5)) - 1);
    while (from <= to) {
      while (edge < row.edges.size() && row.edges[edge].second < from) ++edge;
      if (edge < row.edges.size() && row.edges[edge].first <= from) {
        from = row.edges[edge].second + 1;
        continue;
      }
      const int end = edge < row.edges.size() ? std::min(to, row.edges[edge].first - 1) : to;
      mark_span(j, from, end, mark);
      from = end + 1;
    }
    done = std::max(done, from);
  }
  row.crossings.clear();
  row.edges.clear();
}

/// Block by block; blocks whose cells all have the mark are skipped, and most blocks do.
void Belief::mark_span(int j, int from, int to, std::uint8_t mark) {
  for (int i = from; i <= to;) {
    const int block = i / kBlock, end = std::min(to + 1, (block + 1) * kBlock);
    const bool whole = i == block * kBlock && end == i + kBlock;
    std::uint8_t& marks = block_mark_[block_at(i, j)];
    if ((marks & mark) == 0) {
      const std::size_t first = at(i, j), last = first + static_cast<std::size_t>(end - i);
      bool finished = true;
      if (noisy() && mark == kNear)
        finished = weigh(first, last);
      else
        set_marks(first, last, mark);
      if (whole && finished) marks = static_cast<std::uint8_t>(marks | mark);
    }
    i = end;
  }
}

/// Adds the evidence of a near star to the cells begin .. end - 1. Returns whether all have the most by then.
bool Belief::weigh(std::size_t begin, std::size_t end) {
  bool all = true;
  for (std::size_t c = begin; c < end; ++c) {
    if (weight_[c] == kMost) continue;
    const bool was_free = is_free(c);
    weight_[c] = static_cast<std::int8_t>(std::min(weight_[c] + kFor, kMost));
    all = all && weight_[c] == kMost;
    gained_ += !was_free && is_free(c) ? 1 : 0;
  }
  return all;
}

/// Eight cells at a time.
void Belief::set_marks(std::size_t begin, std::size_t end, std::uint8_t mark) {
  const std::uint64_t marks = kEveryByte * mark;
  std::size_t c = begin;
  for (; c + 8 <= end; c += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, mark_.data() + c, 8);
    if ((eight & marks) == marks) continue;
    marked_anew_ = true;
    const std::uint64_t known = (eight | eight >> 1 | eight >> 2) & kEveryByte;  // far, near or hit
    gained_ += 8 - static_cast<std::uint64_t>(std::popcount(known));
    eight |= marks;
    std::memcpy(mark_.data() + c, &eight, 8);
  }
  for (; c < end; ++c) {
    marked_anew_ = marked_anew_ || (mark_[c] & mark) == 0;
    gained_ += (mark_[c] & (kFar | kNear | kHit)) == 0 ? 1 : 0;
    mark_[c] = static_cast<std::uint8_t>(mark_[c] | mark);
  }
}

}  // namespace oxturn
