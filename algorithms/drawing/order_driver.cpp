#include "algorithms/drawing/order_driver.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"
#include "geometry/point_outside.hpp"

namespace oxturn {
namespace {

constexpr double kFillCorner = kPi / 18;  // radians: vertices of fills that turn by less belong to curves
constexpr double kMostAway = 10;          // map sizes: control points of curves from their beginning
constexpr double kMostCurvature = 1.01;   // of the greatest, as for curves that are sampled

/// The corners of a closed stroke after it was turned to begin at `entry`.
std::size_t from_entry(std::size_t corner, std::size_t entry, std::size_t n) { return (corner + n - entry % n) % n; }

}  // namespace

PortCurves curves_of(const Drawing& drawing, const TourDemands& demands) {
  PortCurves curves;
  for (std::size_t k = 0; k < drawing.curves.size(); ++k) {
    const DrawnCurve& c = drawing.curves[k];
    const auto& [from, to] = demands.by_hand[k];
    PortCurve curve{c.kind == DrawnCurve::Kind::spiro ? ConnectionKind::spiro : ConnectionKind::bezier, c.points};
    curves[{from, to}] = curve;
    std::reverse(curve.points.begin(), curve.points.end());
    curves.insert({{to, from}, std::move(curve)});
  }
  return curves;
}

OrderDriver::OrderDriver(const std::vector<DrawingElement>& elements, TransitRouter& router, FinishedWork& work,
                         const SmoothTransits* smooth, const CornerChoice& corners, LastDetours* last)
    : elements_(elements),
      router_(router),
      work_(work),
      smooth_(smooth),
      corners_(corners),
      last_(last),
      first_piece_(pieces_of(elements).first) {}

void OrderDriver::take(Transit t, LastDetour::End why, PathBuilder& path) {
  transits_.push_back(t.path);
  path.drive(t.path, false);
  if (t.crossing_m > 0) crossing_.push_back({std::move(t), why});
}

void OrderDriver::transit(Transit t, const Pose& from, const Pose& to, PathBuilder& path, const Context& context) {
  LastDetour last;
  if (t.crossing_m > 0 && last_ != nullptr) last = last_->find(from, to, context);
  if (last.end == LastDetour::End::found) {
    ++last_detours_;
    const double metres = length(last.path);
    t = {std::move(last.path), metres, 0, true};
  }
  take(std::move(t), last.end, path);
}

Transit OrderDriver::by_hand(const ElementVisit& from, const ElementVisit& to, const PortCurve& curve) {
  const Problem& problem = router_.problem();
  const std::string name =
      fmt::format("the curve between elements '{}' and '{}'", elements_[from.element].name, elements_[to.element].name);
  const Pose exit = exit_pose(elements_[from.element], from), entry = entry_pose(elements_[to.element], to);
  const double radius = smooth_ != nullptr ? smooth_->radius() : problem.robot().tool_width;
  const Box space = bounding_box(problem.configuration_space());
  const double most = kMostAway * distance(space.low, space.high);
  for (const Point& p : curve.points)
    if (!(distance(p, exit.at) <= most))
      throw_invalid("{} has the point {}, which is far off the map; move it", name, to_text(p));
  const auto c = edited_connection(exit, entry, curve.kind, curve.points, radius);
  if (!c)
    throw_invalid("there is no smooth curve through the {} points of {}, the first at {}; move or remove them",
                  curve.points.size(), name, curve.points.empty() ? to_text(exit.at) : to_text(curve.points.front()));
  ++curves_used_;
  Polyline path = sampled(c->curve, kChordError * problem.robot().tool_width);
  for (std::size_t k = 1; k < path.size(); ++k)
    if (const auto p = point_outside(problem.walls(), path[k - 1], path[k], problem.tolerance()))
      throw_invalid("{} leaves configuration space at {}; move its points", name, to_text(*p));
  const double metres = length(path), crossing = work_.crossing_m(path);
  return {std::move(path), metres, crossing, smooth_ == nullptr || c->curvature * radius <= kMostCurvature};
}

std::vector<std::size_t> OrderDriver::corners(const DrawingElement& element, const ElementVisit& visit,
                                              const Polyline& line) const {
  if (element.is_fill()) return corners_of(line, kFillCorner);
  const std::size_t last = line.size() - 1;
  std::vector<std::size_t> found;
  for (std::size_t corner : element.corners) {
    if (element.closed) corner = from_entry(corner % last, visit.entry, last);
    if (visit.backwards) corner = last - corner;
    if (corner > 0 && corner < last) found.push_back(corner);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// One leg with the tool on; what it is left for at corners that cannot be rounded is driven with the tool off.
void OrderDriver::stroke(const DrawingElement& element, const Leg& leg, const ElementVisit& visit, PathBuilder& path,
                         const Context& context) {
  if (!(corners_.radius > 0) || element.followed) return path.drive(leg.points, leg.tool, leg.gear, leg.width);
  CornerOptions options{
      .rule = corners_.rule, .radius = corners_.radius, .largest_deviation = corners_.largest_deviation};
  options.chord_error = kChordError * router_.problem().robot().tool_width;
  options.free = [&](const Polyline& loop) {
    for (std::size_t k = 1; k < loop.size(); ++k)
      if (!router_.problem().walls().contains(loop[k - 1], loop[k])) return false;
    return work_.crossing_m(loop) <= 0;
  };
  const RoundedLine rounded = rounded_corners(leg.points, corners(element, visit, leg.points), options);
  const Leg* before = nullptr;
  for (const Leg& part : rounded.legs) {
    const bool drawn = part.tool && leg.tool;
    if (before != nullptr && smooth_ != nullptr && before->tool && part.tool) {
      const Pose from = last_heading(before->points), to = first_heading(part.points);
      transit(router_.route(from, to), from, to, path, context);
    }
    path.drive(part.points, drawn, part.gear, drawn ? leg.width : 0);
    before = &part;
  }
}

void OrderDriver::drive(const DrawingElement& element, const ElementVisit& visit, const std::vector<Transit>& inner,
                        PathBuilder& path, const Context& context) {
  std::size_t piece = visit.backwards ? first_piece_[visit.element + 1] : first_piece_[visit.element];
  auto next = inner.begin();
  const std::vector<Leg> legs = driven(element, visit);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (is_transit(legs, k)) {
      transit(*next++, last_heading(legs[k - 1].points), first_heading(legs[k + 1].points), path, context);
      continue;
    }
    stroke(element, legs[k], visit, path, context);
    if (legs[k].tool) work_.finish(visit.backwards ? --piece : piece++);
  }
}

void OrderDriver::drive(const DrivenOrder& order, const PortCurves& curves, PathBuilder& path, const Context& context) {
  for (std::size_t piece = 0; piece < work_.pieces().size(); ++piece) work_.undo(piece);
  for (std::size_t k = 0; k < order.order.size(); ++k) {
    const ElementVisit& to = order.order[k];
    const DrawingElement& element = elements_[to.element];
    if (k == 0) {
      take(order.transits[k], {}, path);  // nothing is finished yet
    } else {
      const ElementVisit& from = order.order[k - 1];
      const DrawingElement& before = elements_[from.element];
      const auto curve = curves.find({exit_port(before, from), entry_port(element, to)});
      if (curve != curves.end())
        take(by_hand(from, to, curve->second), LastDetour::End::by_hand, path);
      else
        transit(order.transits[k], exit_pose(before, from), entry_pose(element, to), path, context);
    }
    drive(element, to, order.inner[k], path, context);
  }
}

}  // namespace oxturn
