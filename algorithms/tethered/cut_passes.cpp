#include "algorithms/tethered/cut_passes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "algorithms/lanes/joint_cover.hpp"
#include "algorithms/lanes/outline.hpp"
#include "base/graph_search.hpp"
#include "base/math.hpp"
#include "geometry/joined_lines.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/point_outside.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// In tool widths.
constexpr double kPassDistance = 0.49;   // of either pass from the cut
constexpr double kAtJunctions = 0.42;    // the same where three lines of the cut meet: the tool reaches their point
constexpr double kLeastDistance = 0.45;  // passes that come nowhere farther from the cut than this are on it
constexpr double kPieceLength = 0.125;   // of the pieces that the cut is divided into
constexpr double kStraightening = 0.05;  // by which passes may come nearer to the cut to have fewer bends
constexpr double kThinning = 0.01;       // by which a piece's sides may miss those of the pieces that it joins
constexpr std::size_t kMostJoined = 16;  // pieces
constexpr double kBeyond = 0.002;        // the pass where it covers the strip beside it
constexpr double kSkipped[] = {0, 0.02, 0.05};  // of its length, at either end
constexpr double kReach = 0.4999;               // of the tool
constexpr int kFewVertices = 8;                 // of discs
constexpr int kMostHalvings = 2;                // of what no single position or segment covers
constexpr double kDrivenWithin = 1.05;          // distance of what may cover what the passes miss: at least 1
constexpr double kSquare = 0.5;                 // side of the squares around that
constexpr double kLostWithin = 1.0;             // distance from a disconnected part of the pieces that disconnect it
constexpr int kRoundsByPieces = 1;              // after that many, all pieces that meet those are left out, too
constexpr double kLargestPocket = 0.5;          // side of a square; larger disconnected parts are no pockets
constexpr double kChordsPerWidth = 400;         // tool widths over the chord error of dilation

constexpr double kTaper = 0.8;  // distance of a pass from the cut over that of the cut from walls: less than 1

/// So much that the strip keeps off what is `away` from a point of the cut. Less by a piece's length: between two
/// points of the cut it may be nearer than at either.
double half_width_off(double away, double w) {
  return std::clamp(kTaper * (away - kPieceLength * w), 0.0, kPassDistance * w);
}

/// The line in pieces, each end with its half width: so much that the strip between the passes keeps off walls.
std::vector<CutPoint> with_half_widths(const Polyline& line, const std::vector<Point>& junctions,
                                       const Problem& problem) {
  const double w = problem.robot().tool_width;
  const EdgeIndex& walls = problem.walls();
  std::vector<Point> ends;
  for (const Point& end : {line.front(), line.back()})
    if (std::binary_search(junctions.begin(), junctions.end(), end, before)) ends.push_back(end);
  std::vector<CutPoint> points;
  const auto add = [&](const Point& p) {
    if (!points.empty() && points.back().at == p) return;
    const auto wall = walls.nearest(p, w);
    double half_width = half_width_off(wall ? wall->distance : w, w);
    for (const Point& end : ends) half_width = std::min(half_width, kAtJunctions * w + kTaper * distance(p, end));
    points.push_back({p, walls.contains(p) ? half_width : 0});
  };
  const double n = std::max(1.0, std::ceil(length(line) / (kPieceLength * w))), step = length(line) / n;
  double walked = 0;  // before the segment
  double k = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double d = distance(line[i - 1], line[i]);
    for (; k < n && k * step < walked + d; ++k) add(lerp(line[i - 1], line[i], (k * step - walked) / d));
    walked += d;
  }
  add(line.back());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point along = points[std::min(i + 1, points.size() - 1)].at - points[i - (i > 0 ? 1 : 0)].at;
    if (along.norm() > 0) points[i].aside = perpendicular(along).normalized();
  }
  return points;
}

/// A piece of the strip between the passes.
struct StripPiece {
  CutPoint from, to;
  Ring outline() const {
    return {from.at - from.half_width * from.aside, to.at - to.half_width * to.aside, to.at + to.half_width * to.aside,
            from.at + from.half_width * from.aside};
  }
  /// On the left (side = 1) or right (-1) of the cut.
  Ring half(double side) const {
    return {from.at, to.at, to.at + side * to.half_width * to.aside, from.at + side * from.half_width * from.aside};
  }
};

/// The last of the points up to `last` to which one piece leads from the first: in between, the ends of its sides lie
/// within `tolerance` of the sides.
std::size_t end_of_piece(const std::vector<CutPoint>& points, std::size_t first, std::size_t last, double tolerance) {
  const auto side = [&](std::size_t i, double sign) {
    return points[i].at + sign * points[i].half_width * points[i].aside;
  };
  const auto straight = [&](std::size_t end) {
    for (std::size_t i = first + 1; i < end; ++i)
      for (const double sign : {-1.0, 1.0})
        if (distance_to_segment(side(i, sign), side(first, sign), side(end, sign)) > tolerance) return false;
    return true;
  };
  std::size_t end = first + 1;
  while (end < last && end - first < kMostJoined && straight(end + 1)) ++end;
  return end;
}

/// Appends the pieces where the strip is nowhere without width, if it becomes wide in between.
void append_wide(const std::vector<CutPoint>& points, double least, double tolerance, std::vector<StripPiece>& pieces) {
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first;
    double widest = points[first].half_width;
    while (last + 1 < points.size() && (last == first || points[last].half_width > 0))
      widest = std::max(widest, points[++last].half_width);
    if (widest >= least)
      for (std::size_t i = first; i < last;) {
        const std::size_t end = end_of_piece(points, i, last, tolerance);
        pieces.push_back({points[i], points[end]});
        i = end;
      }
    first = std::max(last, first + 1);
  }
}

Ring polygon_around(const Point& centre, double radius, int vertices) {
  Ring ring;
  for (int k = 0; k < vertices; ++k) ring.push_back(centre + radius * rotated({1, 0}, 2 * kPi * k / vertices));
  return ring;
}
/// A polygon in a disc.
Ring disc(const Point& centre, double radius, double chord_error) {
  return polygon_around(centre, radius, static_cast<int>(std::ceil(kPi / math::acos(1 - chord_error / radius))));
}
/// A polygon of few vertices around it.
Ring around_disc(const Point& centre, double radius) {
  return polygon_around(centre, radius / math::cos(kPi / kFewVertices), kFewVertices);
}

using Pieces = std::span<const StripPiece>;

/// Calls f(end) for the ends of rows of pieces, where lines of the cut may meet.
template <class F>
void for_each_end(Pieces pieces, double w, F f) {
  const auto visit = [&](const CutPoint& end) {
    if (end.half_width >= kAtJunctions / 2 * w) f(end);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || pieces[i - 1].to.at != pieces[i].from.at) visit(pieces[i].from);
    if (i + 1 == pieces.size() || pieces[i + 1].from.at != pieces[i].to.at) visit(pieces[i].to);
  }
}

/// The strip between the passes, with discs where lines of the cut may meet.
Region strip_of(Pieces pieces, double w) {
  Region parts;
  for_each_end(pieces, w, [&](const CutPoint& end) {
    parts.polygons.push_back({disc(end.at, end.half_width, w / kChordsPerWidth), {}});
  });
  for (const StripPiece& piece : pieces) parts.polygons.push_back({piece.outline(), {}});
  return simplify_inward(unite({parts}), kStraightening * w);
}

/// Finds what of convex polygons lies in a component and is not surely covered from `driven`, which is closed: what is
/// convex lies within half a tool width of a position if its vertices do. What no single position covers is divided.
class DoubtfulParts {
 public:
  DoubtfulParts(const EdgeIndex& component, const EdgeIndex& driven, double w)
      : component_(component), driven_(driven), reach_(kReach * w) {}

  void add(const Ring& convex) {
    for (std::size_t i = 2; i < convex.size(); ++i) add({convex[0], convex[i - 1], convex[i]}, 0);
  }
  /// Does the convex polygon surely lie outside of the component?
  bool is_outside(std::span<const Point> convex, const Point& middle) const {
    if (component_.contains(middle)) return false;
    double radius = 0;
    for (std::size_t i = 0; i < convex.size(); ++i) {
      if (component_.nearest(convex[i], convex[(i + 1) % convex.size()], kTouching * reach_)) return false;
      radius = std::max(radius, distance(convex[i], middle));
    }
    return distance(component_.edges().front().a, middle) > radius;  // nor does it hold the whole component
  }
  void add_whole(Ring polygon) { parts_.polygons.push_back({std::move(polygon), {}}); }
  bool is_uncovered(const Point& p) const { return !driven_.contains(p) && !driven_.nearest(p, reach_); }
  /// They may overlap.
  Region take() { return std::move(parts_); }

 private:
  using Triangle = std::array<Point, 3>;

  void add(const Triangle& t, int halvings) {
    const Point middle = (t[0] + t[1] + t[2]) / 3;
    if (is_outside(t, middle) || is_covered(t, middle)) return;
    if (halvings == kMostHalvings || is_uncovered(middle)) return add_whole({t[0], t[1], t[2]});
    const Triangle middles{lerp(t[0], t[1], 0.5), lerp(t[1], t[2], 0.5), lerp(t[2], t[0], 0.5)};
    add(middles, halvings + 1);
    for (std::size_t k = 0; k < 3; ++k) add({t[k], middles[k], middles[(k + 2) % 3]}, halvings + 1);
  }
  bool is_covered(const Triangle& t, const Point& middle) const {
    const auto from_near = [&](const Point& p) {
      Point at = p;
      if (!driven_.contains(p)) {
        const auto nearest = driven_.nearest(p, reach_);
        if (!nearest) return false;
        at = nearest->point;
      }
      return std::ranges::all_of(t, [&](const Point& v) { return distance(v, at) <= reach_; });
    };
    return from_near(middle) || std::ranges::any_of(t, from_near);
  }

  static constexpr double kTouching = 1e-4;  // of the reach

  const EdgeIndex &component_, &driven_;
  double reach_;
  Region parts_;
};

/// The pieces in groups that do not come near each other, and the strip of each.
class Strips {
 public:
  Strips(const std::vector<StripPiece>& pieces, double w) : w_(w) {
    std::vector<Box> boxes;
    boxes.reserve(pieces.size());
    for (const StripPiece& piece : pieces) boxes.push_back(box_of(piece));
    const BoxIndex index(boxes);
    const auto components = connected_components(pieces.size(), [&](std::size_t i, auto reach) {
      for (const std::uint32_t j : index.overlapping(boxes[i])) reach(std::size_t{j});
    });
    groups_.resize(static_cast<std::size_t>(components.count));
    for (std::size_t i = 0; i < pieces.size(); ++i)
      groups_[static_cast<std::size_t>(components.of[i])].pieces.push_back(pieces[i]);
    for (Group& group : groups_) group.strip = strip_of(group.pieces, w_);
  }

  bool empty() const {
    return std::ranges::all_of(groups_, [](const Group& group) { return group.pieces.empty(); });
  }
  Region all() const {
    Region region;
    for (const Group& group : groups_)
      region.polygons.insert(region.polygons.end(), group.strip.polygons.begin(), group.strip.polygons.end());
    return region;
  }
  /// Erases pieces, or the whole groups in which there are any. False if there are none.
  template <class Predicate>
  bool erase_if(Predicate predicate, bool whole_groups) {
    bool any = false;
    for (Group& group : groups_) {
      if (std::erase_if(group.pieces, predicate) == 0) continue;
      if (whole_groups) group.pieces.clear();
      group.strip = group.pieces.empty() ? Region{} : strip_of(group.pieces, w_);
      any = true;
    }
    return any;
  }

  /// What of the strip in the component the passes may miss, in polygons that may overlap.
  Region doubtful(const EdgeIndex& component, const EdgeIndex& driven) const {
    DoubtfulParts parts(component, driven, w_);
    for (const Group& group : groups_) {
      for_each_end(group.pieces, w_, [&](const CutPoint& end) { parts.add(around_disc(end.at, end.half_width)); });
      for (const StripPiece& piece : group.pieces)
        for (const double side : {-1.0, 1.0}) add_half(piece.half(side), driven, parts);
    }
    return parts.take();
  }

 private:
  struct Group {
    std::vector<StripPiece> pieces;
    Region strip;
  };

  /// Holds the discs at its ends, too.
  static Box box_of(const StripPiece& piece) {
    Box box;
    for (const CutPoint* end : {&piece.from, &piece.to}) {
      Box around;
      around.add(end->at);
      around.grow(end->half_width);
      box.add(around);
    }
    return box;
  }
  /// Adds a half of a piece, or what of it the pass beside it may not cover.
  void add_half(const Ring& half, const EdgeIndex& driven, DoubtfulParts& parts, int halvings = 0) const {
    const Point middle = lerp(lerp(half[0], half[1], 0.5), lerp(half[2], half[3], 0.5), 0.5);
    if (parts.is_outside(half, middle) || covered(half, driven)) return;
    if (parts.is_uncovered(middle)) return parts.add_whole(half);
    if (halvings == kMostHalvings) return parts.add(half);
    const Point near = lerp(half[0], half[1], 0.5), far = lerp(half[3], half[2], 0.5);
    add_half({half[0], near, far, half[3]}, driven, parts, halvings + 1);
    add_half({near, half[1], half[2], far}, driven, parts, halvings + 1);
  }
  /// Does some of the pass beside the half cover it?
  bool covered(const Ring& half, const EdgeIndex& driven) const {
    const Point along = half[2] - half[3];
    const double size = along.norm();
    if (size <= 0) return false;
    const Point across = half[3] - half[0] + half[2] - half[1];
    const Point aside = cross(along, across) > 0 ? perpendicular(along) : -perpendicular(along);
    const Point off = kBeyond * w_ / size * aside;
    for (const double skipped : kSkipped) {
      const double t = std::min(skipped * w_ / size, 0.5);
      const Point a = lerp(half[3], half[2], t) + off, b = lerp(half[2], half[3], t) + off;
      if (std::ranges::all_of(half, [&](const Point& p) { return distance_to_segment(p, a, b) <= kReach * w_; }) &&
          driven.contains(a, b))
        return true;
    }
    return false;
  }

  double w_;
  std::vector<Group> groups_;
};

/// Does an edge of a ring or region come nearer to walls than `within`?
template <class Shape>
bool comes_near(const EdgeIndex& walls, const Shape& shape, double within) {
  bool near = false;
  for_each_edge(shape, [&](const Point& a, const Point& b) { near = near || walls.nearest(a, b, within); });
  return near;
}

/// What the tool would reach from `left_out` of the space beyond its walls.
Region beyond_walls(const RingBoxes& target, const RingBoxes& space, const Region& left_out, double w) {
  const Region swept = dilate(left_out, w / 2, w / kChordsPerWidth, Bound::inside);
  std::vector<Box> boxes;
  for (const Polygon& part : swept.polygons) boxes.push_back(bounding_box(part.outer));
  Box around = bounding_box(swept);
  around.grow(w);
  const auto there = [&](const RingBoxes& rings) { return clipped(rings.near(boxes), around); };
  return subtract(intersect(there(target), swept), there(space));
}

/// What the tool would reach from `left_out` of the problem's space, and does not from `driven`: there, and beside
/// walls. What lies across the cut is for the passes there. `target`: near the space as the problem's, elsewhere it may
/// be more.
Region unreached(const Problem& problem, const RingBoxes& target, const RingBoxes& space, const Region& left_out,
                 const Region& driven) {
  const double w = problem.robot().tool_width;
  std::vector<Polyline> lines;
  for_each_edge(left_out, [&](const Point& a, const Point& b) { lines.push_back({a, b}); });
  if (lines.empty()) return {};
  const Region near = intersect(driven, squares_around(lines, kDrivenWithin * w, kSquare * w));
  const Region reached = dilate(near, w / 2, w / kChordsPerWidth, Bound::inside);
  if (!comes_near(problem.walls(), left_out, w / 2)) return subtract(left_out, reached);
  return subtract(unite({left_out, beyond_walls(target, space, left_out, w)}), reached);
}

/// Leaves out polygons of which the tool surely reaches all from `driven`, next to which they lie. Those beside walls
/// stay: from there the tool would reach beyond.
void leave_out_reached(Region& pieces, const EdgeIndex& driven, const EdgeIndex& walls, double w) {
  std::vector<Segment> near;
  std::erase_if(pieces.polygons, [&](const Polygon& piece) {
    Box around = bounding_box(piece.outer);
    around.grow(kReach * w);
    near.clear();
    driven.for_each_near(around, [&](std::size_t e) { near.push_back({driven.edges()[e].a, driven.edges()[e].b}); });
    return cover_inside(near, kReach * w, piece.outer) && !comes_near(walls, piece.outer, w / 2);
  });
}

/// Does the line come nearer to the space than `within`?
bool touches(const EdgeIndex& space, const Polyline& line, double within) {
  if (space.contains(line.front())) return true;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (space.nearest(line[i - 1], line[i], within).has_value()) return true;
  return false;
}

}  // namespace

/// The lattice follows from the box of both regions (overlay/boolean.hpp). No line of the cut leaves the map, so none
/// of those that the space is cut along asks for a coarser one.
Problem with_coarser_space(const Problem& problem) {
  Box around = bounding_box(problem.map().free);
  around.grow(problem.robot().radius + problem.robot().tool_width);
  return problem.restricted(intersect(coarser_space(problem), box_region(around.low, around.high)));
}

CutPasses::CutPasses(const Problem& problem, const std::vector<Polyline>& cut)
    : problem_(problem),
      target_(problem.map().target_area ? problem.target() : problem.map().free),  // the same where it is needed
      space_(problem.configuration_space()),
      lines_(cut),
      junctions_(common_ends(cut, 3)) {
  std::vector<Box> boxes;
  for (const Polyline& line : lines_) boxes.push_back(bounding_box(line));
  boxes_ = BoxIndex(std::move(boxes));
  points_.resize(lines_.size());
}

/// The line's, whose strip keeps off the start as well. Most lines are asked for twice: from either side.
std::vector<CutPoint> CutPasses::points_off(std::size_t line, const Point& start) const {
  if (points_[line].empty()) points_[line] = with_half_widths(lines_[line], junctions_, problem_);
  std::vector<CutPoint> points = points_[line];
  for (CutPoint& p : points)
    p.half_width = std::min(p.half_width, half_width_off(distance(p.at, start), problem_.robot().tool_width));
  return points;
}

PassSpace CutPasses::beside(const Problem& component) const {
  const double w = component.robot().tool_width;
  const Region& whole = component.configuration_space();
  Box box = bounding_box(whole);
  box.grow(w);
  std::vector<StripPiece> pieces;
  for (const std::uint32_t i : boxes_.overlapping(box))
    if (touches(component.walls(), lines_[i], w / 2))
      append_wide(points_off(i, component.start()), kLeastDistance * w, kThinning * w, pieces);
  std::erase_if(pieces, [&](const StripPiece& piece) {  // others do not touch it
    return !component.walls().contains(piece.from.at) &&
           !component.walls().nearest(piece.from.at, piece.to.at, w / 2).has_value();
  });
  Strips strips(pieces, w);
  for (int round = 0; !strips.empty(); ++round) {
    Region space, lost, pockets;
    auto [outside, left_out] = divided(whole, strips.all());
    for (Polygon& part : outside.polygons) {
      const bool only = outside.polygons.size() == 1;  // strips keep off the start
      if (space.empty() && (only || nearly_contains(part, component.start(), component.tolerance())))
        space.polygons.push_back(std::move(part));
      else if (area(part) > kLargestPocket * kLargestPocket * w * w)
        lost.polygons.push_back(std::move(part));
      else
        pockets.polygons.push_back(std::move(part));
    }
    if (lost.empty()) {
      Problem beside = component.restricted(std::move(space), Problem::Transit::shared);
      const Region& driven = beside.configuration_space();
      Region doubtful = strips.doubtful(component.walls(), beside.walls());
      if (!doubtful.empty()) doubtful = intersect(left_out, doubtful);
      leave_out_reached(doubtful, beside.walls(), problem_.walls(), w);
      if (!pockets.empty()) doubtful = unite({doubtful, pockets});
      Region missed = unreached(problem_, target_, space_, doubtful, driven);
      return {std::move(beside), std::move(missed)};
    }
    const EdgeIndex around(lost);
    const auto disconnects = [&](const StripPiece& piece) {
      return around.nearest(piece.from.at, piece.to.at, kLostWithin * w).has_value();
    };
    if (!strips.erase_if(disconnects, round >= kRoundsByPieces)) break;
  }
  return {component, {}};
}

}  // namespace oxturn
