#include "algorithms/tethered/cut_passes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
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
constexpr std::size_t kMostJoined = 8;   // pieces
constexpr double kDrivenWithin = 2.0;    // distance from the cut of what may cover what its passes miss: at least 1.5
constexpr double kSquare = 1.0;          // side of the squares around the cut
constexpr double kLostWithin = 1.0;      // distance from a disconnected part of the pieces that disconnect it
constexpr double kLargestPocket = 0.5;   // side of a square; larger disconnected parts are no pockets
constexpr double kChordsPerWidth = 400;  // tool widths over the chord error of dilation

constexpr double kTaper = 0.8;  // distance of a pass from the cut over that of the cut from walls: less than 1

/// A point of the cut, how far the passes are from it, and the unit vector to the one on the left.
struct CutPoint {
  Point at;
  double half_width;
  Point aside{0, 0};
};

/// The lines, those joined of which no others end at their common point; and the points where three or more end.
struct CutLines {
  std::vector<Polyline> lines;
  std::vector<Point> junctions;  // sorted
};

CutLines joined(const std::vector<Polyline>& lines) {
  using End = std::pair<std::size_t, bool>;  // a line, and whether it is its beginning
  const auto at = [&](const End& end) { return end.second ? lines[end.first].front() : lines[end.first].back(); };
  std::vector<End> ends;
  for (std::size_t i = 0; i < lines.size(); ++i) ends.insert(ends.end(), {{i, true}, {i, false}});
  std::stable_sort(ends.begin(), ends.end(), [&](const End& a, const End& b) { return before(at(a), at(b)); });
  CutLines cut;
  std::map<End, End> next;
  for (std::size_t i = 0, k = 0; i < ends.size(); i = k) {
    while (k < ends.size() && at(ends[k]) == at(ends[i])) ++k;
    if (k - i == 2) {
      next[ends[i]] = ends[i + 1];
      next[ends[i + 1]] = ends[i];
    } else if (k - i >= 3) {
      cut.junctions.push_back(at(ends[i]));
    }
  }
  std::vector<bool> done(lines.size(), false);
  for (const End& first : ends) {
    if (next.count(first) > 0 || done[first.first]) continue;
    Polyline line{at(first)};
    for (std::optional<End> end = first; end && !done[end->first];) {
      const Polyline& more = lines[end->first];
      done[end->first] = true;
      if (end->second)
        line.insert(line.end(), more.begin() + 1, more.end());
      else
        line.insert(line.end(), more.rbegin() + 1, more.rend());
      const auto found = next.find({end->first, !end->second});
      end = found == next.end() ? std::nullopt : std::optional(found->second);
    }
    cut.lines.push_back(std::move(line));
  }
  return cut;
}

/// The line in pieces, each end with its half width: so much that the strip between the passes keeps off walls and the
/// start.
std::vector<CutPoint> with_half_widths(const Polyline& line, const std::vector<Point>& junctions, const Point& start,
                                       const Problem& problem) {
  const double w = problem.robot().tool_width, most = kPassDistance * w;
  const EdgeIndex& walls = problem.walls();
  std::vector<Point> ends;
  for (const Point& end : {line.front(), line.back()})
    if (std::binary_search(junctions.begin(), junctions.end(), end, before)) ends.push_back(end);
  std::vector<CutPoint> points;
  const auto add = [&](const Point& p) {
    if (!points.empty() && points.back().at == p) return;
    const auto wall = walls.nearest(p, w);
    // Less a piece's length: between two points of the cut a wall may be nearer than at either.
    const double room = std::min(wall ? wall->distance : w, distance(p, start)) - kPieceLength * w;
    double half_width = std::clamp(kTaper * room, 0.0, most);
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

/// The strip between the passes, with discs where lines of the cut may meet.
Region strip_of(const std::vector<StripPiece>& pieces, double w) {
  std::vector<Region> parts;
  const auto add_disc = [&](const CutPoint& end) {
    if (end.half_width < kAtJunctions / 2 * w) return;
    const double h = end.half_width / 1e3;
    const Region square{
        {{{end.at + Point(-h, -h), end.at + Point(h, -h), end.at + Point(h, h), end.at + Point(-h, h)}, {}}}};
    parts.push_back(dilate(square, end.half_width - 2 * h, w / kChordsPerWidth, Bound::inside));
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || pieces[i - 1].to.at != pieces[i].from.at) add_disc(pieces[i].from);
    if (i + 1 == pieces.size() || pieces[i + 1].from.at != pieces[i].to.at) add_disc(pieces[i].to);
    parts.push_back({{{pieces[i].outline(), {}}}});
  }
  return simplify_inward(unite(parts), kStraightening * w);
}

/// What the tool would reach from `left_out` of the space, and does not from `driven`: there, and beside walls. What
/// lies across the cut is for the passes there.
Region unreached(const RingBoxes& target, const RingBoxes& space, const std::vector<StripPiece>& pieces,
                 const Region& left_out, const Region& driven, double w) {
  const double chord = w / kChordsPerWidth;
  std::vector<Polyline> lines;
  for (const StripPiece& piece : pieces) lines.push_back({piece.from.at, piece.to.at});
  const Region near = intersect(driven, squares_around(lines, kDrivenWithin * w, kSquare * w));
  const Region swept = dilate(left_out, w / 2, chord, Bound::inside);
  const Box box = bounding_box(swept);
  const Region beside = subtract(intersect(target.near(box), swept), space.near(box));
  return subtract(unite({left_out, beside}), dilate(near, w / 2, chord, Bound::inside));
}

}  // namespace

CutPasses::CutPasses(const Problem& problem, const std::vector<Polyline>& cut)
    : problem_(problem), target_(problem.target()), space_(problem.configuration_space()) {
  CutLines all = joined(cut);
  lines_ = std::move(all.lines);
  junctions_ = std::move(all.junctions);
  std::vector<Box> boxes;
  for (const Polyline& line : lines_) boxes.push_back(bounding_box(line));
  boxes_ = BoxIndex(std::move(boxes));
}

PassSpace CutPasses::beside(const Problem& component) const {
  const double w = component.robot().tool_width;
  const Region& whole = component.configuration_space();
  Box box = bounding_box(whole);
  box.grow(w);
  std::vector<StripPiece> pieces;
  for (const std::uint32_t i : boxes_.overlapping(box))
    append_wide(with_half_widths(lines_[i], junctions_, component.start(), problem_), kLeastDistance * w, kThinning * w,
                pieces);
  std::erase_if(pieces, [&](const StripPiece& piece) {  // others do not touch it
    return !component.walls().contains(piece.from.at) &&
           !component.walls().nearest(piece.from.at, piece.to.at, w / 2).has_value();
  });
  while (!pieces.empty()) {
    Region space, lost, pockets;
    const Region strip = strip_of(pieces, w);
    for (Polygon& part : subtract(whole, strip).polygons) {
      const EdgeIndex edges(Region{{part}});
      const bool home = edges.contains(component.start()) || edges.nearest(component.start(), component.tolerance());
      if (home && space.empty())
        space.polygons.push_back(std::move(part));
      else if (area(part) > kLargestPocket * kLargestPocket * w * w)
        lost.polygons.push_back(std::move(part));
      else
        pockets.polygons.push_back(std::move(part));
    }
    if (lost.empty()) {
      const Region left_out = unite({intersect(whole, strip), pockets});
      Region missed = unreached(target_, space_, pieces, left_out, space, w);
      return {std::move(space), std::move(missed)};
    }
    const EdgeIndex around(lost);
    const auto disconnects = [&](const StripPiece& piece) {
      return around.nearest(piece.from.at, piece.to.at, kLostWithin * w).has_value();
    };
    if (std::erase_if(pieces, disconnects) == 0) break;
  }
  return {whole, {}};
}

}  // namespace oxturn
