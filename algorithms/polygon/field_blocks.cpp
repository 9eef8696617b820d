#include "algorithms/polygon/field_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/polygon/slab_strips.hpp"
#include "base/math.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr double kSame = 0.01;        // tool widths: sides that differ by less are equal
constexpr double kStraight = 20;      // degrees: ends that bend by less run on
constexpr double kFirstStep = 30;     // degrees between headings
constexpr double kLastStep = 1;       // degrees: the heading is refined to this
constexpr double kDropped = 1e-6;     // squares of the tool width
constexpr double kDivideAgain = 0.7;  // divided again when this share of a component and what it lost since is left
constexpr double kClearlyMore = 1 + 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A block that could be driven next.
struct Candidate {
  double degrees = 0;
  BoustrophedonCell cell = {};  // in LaneFrame(degrees)
  Region region = {};
  Box box = {};
  double area = 0, seconds = 0;  // of driving it, turns included
};

double bend(const Point& before, const Point& at, const Point& after) {
  const Point a = at - before, b = after - at;
  return std::abs(math::atan2(cross(a, b), a.dot(b))) * 180 / kPi;
}

bool runs_on(const Polyline& left, const Polyline& right) {
  return bend(left[left.size() - 2], left.back(), right[1]) < kStraight;
}

/// Whether the right side of `a` is the left side of `b`, and both ends go on nearly straight.
bool may_merge(const BoustrophedonCell& a, const BoustrophedonCell& b, double tool_width) {
  const double same = kSame * tool_width;
  if (std::abs(right_of(a) - left_of(b)) > same || distance(a.lower.back(), b.lower.front()) > same ||
      distance(a.upper.back(), b.upper.front()) > same)
    return false;
  if (std::min({a.lower.size(), a.upper.size(), b.lower.size(), b.upper.size()}) < 2) return false;
  return runs_on(a.lower, b.lower) && runs_on(a.upper, b.upper);
}

/// Between the chains of a cell.
double area_of(const BoustrophedonCell& cell) {
  double twice = 0;
  for (std::size_t i = 1; i < cell.lower.size(); ++i) twice += cross(cell.lower[i - 1], cell.lower[i]);
  for (std::size_t i = 1; i < cell.upper.size(); ++i) twice -= cross(cell.upper[i - 1], cell.upper[i]);
  twice += cross(cell.lower.back(), cell.upper.back()) - cross(cell.lower.front(), cell.upper.front());
  return std::abs(twice) / 2;
}

Candidate candidate_of(BoustrophedonCell cell, double degrees, const Robot& robot) {
  Candidate c{degrees, std::move(cell), {}, {}, 0, 0};
  c.region = {{{outline(c.cell, LaneFrame(degrees)), {}}}};
  c.box = bounding_box(c.region);
  c.area = std::abs(signed_area(c.region.polygons[0].outer));
  const double width = right_of(c.cell) - left_of(c.cell);
  const double lanes = static_cast<double>(slabs_over(0, width, robot.tool_width).count);
  const double metres = width > 0 ? lanes * c.area / width : 0;
  c.seconds = metres / robot.speed + (lanes - 1) * seconds_to_next_lane(robot);
  return c;
}

/// A part of the field, and the blocks into which it can be divided.
struct Component {
  Region region;
  double area = 0;
  double divided = kInfinity;  // its area, with what it lost since candidates were last made
  std::vector<Candidate> candidates = {};
};

class FieldDivision {
 public:
  FieldDivision(const Problem& problem, const Region& near, const Region& field, BlockRule rule)
      : problem_(problem),
        near_(near),
        robot_(problem.robot()),
        width_(robot_.tool_width),
        rule_(rule),
        at_(problem.start()) {
    add_components(field, {});
  }

  std::vector<FieldBlock> run(Context& context) {
    std::vector<FieldBlock> blocks;
    while (!components_.empty() && !context.cancelled()) {
      for (Component& c : components_)
        if ((c.candidates.empty() && c.area != c.divided) || c.area < kDivideAgain * c.divided) divide(c, context);
      const auto [component, candidate] = best();
      blocks.push_back(candidate == kNone ? take_all(component) : take(component, candidate, context));
      if (!blocks.back().strips.empty()) at_ = blocks.back().strips.back().lanes.back().high;
    }
    return blocks;
  }

 private:
  void add_components(const Region& region, std::vector<Candidate> candidates) {
    for (const Polygon& polygon : region.polygons) {
      Component c{{{polygon}}, area(polygon)};
      if (c.area < kDropped * width_ * width_) continue;
      if (region.polygons.size() == 1) {
        c.candidates = std::move(candidates);
      } else if (!candidates.empty()) {
        const EdgeIndex inside(c.region);
        for (const Candidate& k : candidates)
          if (inside.contains(inner_point(k))) c.candidates.push_back(k);
      }
      components_.push_back(std::move(c));
    }
  }
  /// Inside of a candidate: in the middle of the line across its middle.
  static Point inner_point(const Candidate& k) {
    const double x = (left_of(k.cell) + right_of(k.cell)) / 2;
    return LaneFrame(k.degrees).to_world({x, (height_on(k.cell.lower, x) + height_on(k.cell.upper, x)) / 2});
  }

  /// Whether both cover more than is dropped. Boxes about both, each in the other's frame, tell most apart.
  bool overlap(const Candidate& a, const Candidate& b) const {
    if (a.region.empty() || b.region.empty() || !a.box.overlaps(b.box)) return false;
    if (!box_of(a, a.degrees).overlaps(box_of(b, a.degrees)) || !box_of(a, b.degrees).overlaps(box_of(b, b.degrees)))
      return false;
    return holds(a, inner_point(b)) || holds(b, inner_point(a)) ||
           area(intersect(a.region, b.region)) > kDropped * width_ * width_;
  }
  static Box box_of(const Candidate& k, double degrees) {
    const LaneFrame frame(degrees);
    Box box;
    for (const Point& p : k.region.polygons[0].outer) box.add(frame.to_frame(p));
    return box;
  }
  static bool holds(const Candidate& k, const Point& p) {
    const Point q = LaneFrame(k.degrees).to_frame(p);
    return q.x() > left_of(k.cell) && q.x() < right_of(k.cell) && q.y() > height_on(k.cell.lower, q.x()) &&
           q.y() < height_on(k.cell.upper, q.x());
  }

  double value(const Candidate& c, double seconds_there) const {
    const double rate = c.area / (c.seconds + seconds_there);
    return rule_.value == BlockValue::rate ? rate : rate * c.area;
  }
  /// With the drive there, straight.
  double value_from_here(const Candidate& c) const {
    const LaneFrame frame(c.degrees);
    double least = kInfinity;
    for (const Polyline* chain : {&c.cell.lower, &c.cell.upper})
      for (const Point& p : {chain->front(), chain->back()}) least = std::min(least, distance(frame.to_world(p), at_));
    return value(c, least / robot_.speed);
  }

  std::vector<Candidate> along(const Region& region, double degrees) const {
    std::vector<Candidate> all;
    const Region turned = unite({LaneFrame(degrees).to_frame(region)});
    for (BoustrophedonCell& cell : merged_trapezoids(turned, width_))
      if (area_of(cell) >= rule_.least * width_ * width_) all.push_back(candidate_of(std::move(cell), degrees, robot_));
    return all;
  }
  void divide(Component& c, const Context& context) const {
    c.candidates.clear();
    c.divided = c.area;
    if (c.area < rule_.least * width_ * width_) return;
    std::vector<double> headings = lane_directions(c.region);
    for (double d = 0; d < 180; d += kFirstStep) headings.push_back(d);
    double best = 0, heading = 0;
    const auto try_heading = [&](double degrees) {
      bool better = false;
      for (Candidate& k : along(c.region, degrees)) {
        if (const double v = value(k, seconds_to_next_lane(robot_)); v > best * kClearlyMore) {
          best = v;
          heading = degrees;
          better = true;
        }
        c.candidates.push_back(std::move(k));
      }
      return better;
    };
    for (const double d : headings)
      if (!context.cancelled()) try_heading(d);
    for (double step = kFirstStep / 2; step >= kLastStep && !context.cancelled(); step /= 2) {
      const double centre = heading;
      if (!try_heading(centre + step)) try_heading(centre - step);
    }
  }

  /// The component and candidate to drive next; kNone: all that is left of the component.
  std::pair<std::size_t, std::size_t> best() const {
    std::pair<std::size_t, std::size_t> best{0, kNone};
    double most = 0;
    for (std::size_t c = 0; c < components_.size(); ++c)
      for (std::size_t k = 0; k < components_[c].candidates.size(); ++k)
        if (const double v = value_from_here(components_[c].candidates[k]); v > most * kClearlyMore) {
          most = v;
          best = {c, k};
        }
    return best;
  }

  Component remove(std::size_t index) {
    Component c = std::move(components_[index]);
    components_.erase(components_.begin() + static_cast<std::ptrdiff_t>(index));
    return c;
  }
  FieldBlock take(std::size_t component, std::size_t candidate, Context& context) {
    Component c = remove(component);
    const Candidate chosen = std::move(c.candidates[candidate]);
    std::erase_if(c.candidates, [&](const Candidate& k) { return k.region.empty() || overlap(k, chosen); });
    const std::size_t first = components_.size();
    add_components(subtract(c.region, chosen.region), std::move(c.candidates));
    for (std::size_t i = first; i < components_.size(); ++i)
      components_[i].divided = components_[i].area + chosen.area + c.divided - c.area;
    const LaneField field(problem_, space_near(chosen.box), chosen.degrees, width_);
    std::vector<Strip> strips = cell_strips(field, {chosen.cell}, LaneFit::fitted, context);
    std::erase_if(strips, [](const Strip& s) { return s.lanes.empty(); });
    return {chosen.degrees, chosen.region.polygons[0].outer, chosen.area, std::move(strips)};
  }
  FieldBlock take_all(std::size_t component) {
    const Component c = remove(component);
    const double degrees = best_lane_direction(c.region, width_);
    return {degrees, {}, c.area, slab_strips(c.region, degrees, width_, problem_, space_near(bounding_box(c.region)))};
  }
  /// Configuration space without most of the walls that are nowhere near a box.
  Region space_near(Box box) const {
    box.grow(width_);
    return near_.near(box);
  }

  const Problem& problem_;
  RingBoxes near_;
  const Robot& robot_;
  double width_;
  BlockRule rule_;
  Point at_;
  std::vector<Component> components_;
};

}  // namespace

std::vector<BoustrophedonCell> merged_trapezoids(const Region& region, double tool_width) {
  std::vector<BoustrophedonCell> cells = trapezoid_cells(region);
  std::vector<std::size_t> order(cells.size()), next(cells.size(), kNone);
  std::vector<bool> follows(cells.size(), false);
  for (std::size_t a = 0; a < cells.size(); ++a)
    for (const std::size_t b : cells[a].neighbours)
      if (next[a] == kNone && !follows[b] && may_merge(cells[a], cells[b], tool_width)) {
        next[a] = b;
        follows[b] = true;
      }
  std::vector<BoustrophedonCell> merged;
  for (std::size_t a = 0; a < cells.size(); ++a) {
    if (follows[a]) continue;
    BoustrophedonCell cell{std::move(cells[a].lower), std::move(cells[a].upper), {}};
    for (std::size_t b = next[a]; b != kNone; b = next[b]) {
      cell.lower.insert(cell.lower.end(), cells[b].lower.begin() + 1, cells[b].lower.end());
      cell.upper.insert(cell.upper.end(), cells[b].upper.begin() + 1, cells[b].upper.end());
    }
    merged.push_back(std::move(cell));
  }
  return merged;
}

std::vector<FieldBlock> field_blocks(const Problem& problem, const Region& near, const Region& field, BlockRule rule,
                                     Context& context) {
  return FieldDivision(problem, near, field, rule).run(context);
}

}  // namespace oxturn
