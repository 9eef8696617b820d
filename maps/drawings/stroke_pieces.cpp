#include "maps/drawings/stroke_pieces.hpp"

#include <algorithm>

namespace oxturn {
namespace {

constexpr double kSame = 1e-12;  // of a segment: crossings nearer than this are one

/// Where a segment meets the boundary, as fractions of its length, with 0 and 1 at the ends.
std::vector<double> crossings(const Point& a, const Point& b, const EdgeIndex& region) {
  std::vector<double> at{0, 1};
  Box box;
  box.add(a);
  box.add(b);
  region.for_each_near(box, [&](std::size_t e) {
    const auto& edge = region.edges()[e];
    const Point d = b - a, f = edge.b - edge.a;
    const double det = cross(d, f);
    if (det == 0) return;
    const double t = cross(edge.a - a, f) / det, u = cross(edge.a - a, d) / det;
    if (t > 0 && t < 1 && u >= 0 && u <= 1) at.push_back(t);
  });
  std::ranges::sort(at);
  return at;
}

class Pieces {
 public:
  explicit Pieces(const DrawnStroke& stroke) : stroke_(stroke) {}

  /// Part of segment i, from the fraction t to u of its length.
  void add(std::size_t i, double t, double u) {
    const Point &a = stroke_.points[i], &b = stroke_.points[i + 1];
    if (!open_) begin(t == 0 ? a : lerp(a, b, t), t == 0 ? i : kNone);
    append(u == 1 ? b : lerp(a, b, u), u == 1 ? i + 1 : kNone);
  }
  void end() {
    if (!open_) return;
    if (DrawnStroke& piece = pieces_.back(); piece.nodes.back() + 1 != piece.points.size())
      piece.nodes.push_back(piece.points.size() - 1);
    open_ = false;
  }
  std::vector<DrawnStroke> take() {
    end();
    return std::move(pieces_);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  void begin(const Point& p, std::size_t old) {
    pieces_.push_back({stroke_.element, {p}, stroke_.width, stroke_.tool, {0}, {}, stroke_.line});
    open_ = true;
    note(stroke_.corners, old, pieces_.back().corners);
  }
  void append(const Point& p, std::size_t old) {
    DrawnStroke& piece = pieces_.back();
    piece.points.push_back(p);
    note(stroke_.nodes, old, piece.nodes);
    note(stroke_.corners, old, piece.corners);
  }
  /// Adds the last point to `marks` if its old position is among `old_marks`.
  void note(const std::vector<std::size_t>& old_marks, std::size_t old, std::vector<std::size_t>& marks) {
    if (std::ranges::binary_search(old_marks, old)) marks.push_back(pieces_.back().points.size() - 1);
  }

  const DrawnStroke& stroke_;
  std::vector<DrawnStroke> pieces_;
  bool open_ = false;
};

/// The last piece, continued by the first.
void join_ends(std::vector<DrawnStroke>& pieces) {
  DrawnStroke &last = pieces.back(), &first = pieces.front();
  const std::size_t shift = last.points.size() - 1;
  last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
  const auto shifted = [&](const std::vector<std::size_t>& from, std::vector<std::size_t>& to) {
    for (const std::size_t at : from)
      if (to.empty() || at + shift > to.back()) to.push_back(at + shift);
  };
  shifted(first.nodes, last.nodes);
  shifted(first.corners, last.corners);
  first = std::move(last);
  pieces.pop_back();
}

}  // namespace

std::vector<DrawnStroke> pieces_outside(const DrawnStroke& stroke, const EdgeIndex& region) {
  Pieces pieces(stroke);
  bool erased = false;
  for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
    const std::vector<double> at = crossings(stroke.points[i], stroke.points[i + 1], region);
    for (std::size_t k = 1; k < at.size(); ++k) {
      if (at[k] - at[k - 1] < kSame) continue;
      const Point middle = lerp(stroke.points[i], stroke.points[i + 1], (at[k - 1] + at[k]) / 2);
      if (region.contains(middle)) {
        pieces.end();
        erased = true;
      } else {
        pieces.add(i, at[k - 1], at[k]);
      }
    }
  }
  if (!erased) return {stroke};
  std::vector<DrawnStroke> left = pieces.take();
  const bool closed = stroke.points.front() == stroke.points.back();
  if (closed && left.size() > 1 && left.front().points.front() == left.back().points.back()) join_ends(left);
  return left;
}

}  // namespace oxturn
