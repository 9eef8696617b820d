#include "algorithms/lanes/strips.hpp"

#include <algorithm>

#include "algorithms/tour/generalised_tour.hpp"

namespace oxturn {
namespace {

constexpr double kLongestWorkLink = 3;  // tool widths: longer links between lanes are transit
constexpr std::size_t kFewStrips = 8;   // that generalised_tour orders exactly

const Point& begin_of(const LaneEnds& lane, bool up) { return up ? lane.low : lane.high; }
const Point& end_of(const LaneEnds& lane, bool up) { return up ? lane.high : lane.low; }

Polyline line_of(const LaneEnds& lane) { return lane.curve.empty() ? Polyline{lane.low, lane.high} : lane.curve; }

struct StripLeg {
  bool tool;
  Polyline points;
};

/// What links between lanes are made with.
struct Links {
  const Problem& problem;
  const Connector& connector;
  double tool_width() const { return problem.robot().tool_width; }
};

/// Where a robot that leaves a lane at `a` in direction `along` turns to reach `b`, if it drives along the lanes and
/// across them only: the farther end of the two lanes.
Point square_corner(const Point& a, const Point& along, const Point& b) {
  const double ahead = (b - a).dot(along);
  return ahead > 0 ? Point(a + ahead * along) : Point(b - ahead * along);
}

/// From the end of one lane to the beginning of the next. In the open it turns square, so that both lanes end where
/// the longer one does; along a wall it is straight, beside the wall.
Polyline turn_between(const LaneEnds& from, bool from_up, const LaneEnds& to, bool to_up, const Links& links) {
  const Point &a = end_of(from, from_up), &b = begin_of(to, to_up), &before = begin_of(from, from_up);
  const bool back_and_forth = from_up != to_up && from.curve.empty() && to.curve.empty() && before != a;
  if (back_and_forth && !links.problem.walls().nearest((a + b) / 2, links.tool_width() / 2)) {
    const Point corner = square_corner(a, (a - before).normalized(), b);
    if (links.connector.straight(a, corner) && links.connector.straight(corner, b)) return {a, corner, b};
  }
  return links.connector.path(a, b);
}

/// The link from lane i - 1 to lane i.
Polyline link_before(const Strip& strip, std::size_t i, const std::vector<bool>& up, const Links& links) {
  // A given chain joins like ends only: high to high, or low to low.
  if (!strip.low_links.empty() && up[i] != up[i - 1]) return up[i] ? strip.low_links[i - 1] : strip.high_links[i - 1];
  return turn_between(strip.lanes[i - 1], up[i - 1], strip.lanes[i], up[i], links);
}

/// Lanes and links of a strip in driving order.
std::vector<StripLeg> legs_of(const Strip& strip, const StripPattern& pattern, const Links& links) {
  const std::vector<bool> up = strip.directions(pattern.first_up);
  std::vector<StripLeg> all;
  for (std::size_t i = 0; i < strip.lanes.size(); ++i) {
    if (i > 0) {
      Polyline link = link_before(strip, i, up, links);
      const bool tool = strip.work_links && length(link) <= kLongestWorkLink * links.tool_width();
      all.push_back({tool, std::move(link)});
    }
    Polyline line = line_of(strip.lanes[i]);
    if (!up[i]) std::reverse(line.begin(), line.end());
    all.push_back({true, std::move(line)});
  }
  if (pattern.backwards) {
    std::reverse(all.begin(), all.end());
    for (StripLeg& leg : all) std::reverse(leg.points.begin(), leg.points.end());
  }
  return all;
}

/// The strips in driving order, each with its pattern.
std::vector<TourStop> tour_of(const Problem& problem, const std::vector<Strip>& strips, const Point& from,
                              const std::vector<TourElement>& elements, StripOrder order, const Connector& connector,
                              Context& context) {
  const TourCosts costs(from, elements, connector);
  const bool exactly = order == StripOrder::improved && strips.size() <= kFewStrips;
  if (exactly || order == StripOrder::generalised) return generalised_tour(costs, context);
  std::vector<TourStop> tour;
  if (order == StripOrder::given) {
    for (std::size_t i = 0; i < elements.size(); ++i) tour.push_back({i, 0});
  } else if (order == StripOrder::depth_first) {
    std::vector<std::vector<std::size_t>> neighbours;
    for (const Strip& s : strips) neighbours.push_back(s.neighbours);
    tour = depth_first_tour(costs, problem, neighbours, context);
  } else {
    tour = nearest_tour(costs, problem, context);
  }
  if (order == StripOrder::improved) improve_tour(costs, tour, context);
  if (!context.cancelled()) choose_patterns(costs, tour);
  return tour;
}

void trace_lanes(const std::vector<Strip>& strips, Context& context) {
  std::vector<Polyline> lines;
  for (const Strip& s : strips)
    for (const LaneEnds& lane : s.lanes) lines.push_back(line_of(lane));
  context.trace("lanes", std::move(lines));
}

}  // namespace

std::vector<bool> Strip::directions(bool first_up) const {
  std::vector<bool> up{first_up};
  if (!low_links.empty()) {  // links follow the boundary: strictly alternating
    for (std::size_t i = 1; i < lanes.size(); ++i) up.push_back(!up.back());
    return up;
  }
  // rest[i][u]: the least length of the links after lane i if that lane is driven up (u = 1) or down.
  std::vector<std::array<double, 2>> rest(lanes.size(), {0, 0});
  const auto through = [&](std::size_t i, bool from_up, bool to_up) {
    return distance(end_of(lanes[i], from_up), begin_of(lanes[i + 1], to_up)) + rest[i + 1][to_up];
  };
  for (std::size_t i = lanes.size() - 1; i-- > 0;)
    for (const bool u : {false, true}) rest[i][u] = std::min(through(i, u, u), through(i, u, !u));
  for (std::size_t i = 0; i + 1 < lanes.size(); ++i) {
    const bool u = up.back();
    up.push_back(through(i, u, u) < through(i, u, !u) ? u : !u);
  }
  return up;
}

void connect(std::vector<Strip>& strips, std::size_t a, std::size_t b) {
  if (a == b) return;
  strips[a].neighbours.push_back(b);
  strips[b].neighbours.push_back(a);
}

TourElement Strip::patterns() const {
  TourElement all;
  for (const bool first_up : {true, false}) {
    const std::vector<bool> up = directions(first_up);
    const Point entry = begin_of(lanes.front(), up.front()), exit = end_of(lanes.back(), up.back());
    double links = 0;
    for (std::size_t i = 1; i < lanes.size(); ++i)
      links += distance(end_of(lanes[i - 1], up[i - 1]), begin_of(lanes[i], up[i]));
    const std::size_t forwards = all.size(), backwards = forwards + 1;
    all.push_back({entry, exit, links, backwards});
    all.push_back({exit, entry, links, forwards});
    if (lanes.size() == 1) break;  // beginning at the other end is the same lane backwards
  }
  return all;
}

Path drive_strips(const Problem& problem, const std::vector<Strip>& strips, StripOrder order,
                  const Connector& connector, Context& context) {
  return drive_strips(problem, problem.start(), strips, order, connector, context);
}

Path drive_strips(const Problem& problem, const Point& from, const std::vector<Strip>& strips, StripOrder order,
                  const Connector& connector, Context& context) {
  if (context.wants_traces()) trace_lanes(strips, context);
  std::vector<TourElement> elements;
  for (const Strip& s : strips) elements.push_back(s.patterns());
  const Links links{problem, connector};
  PathBuilder path(from);
  for (const TourStop& stop : tour_of(problem, strips, from, elements, order, connector, context)) {
    if (context.cancelled()) break;
    path.drive(connector.path(path.at(), elements[stop.element][stop.pattern].entry), false);
    for (const StripLeg& leg : legs_of(strips[stop.element], kStripPatterns[stop.pattern], links))
      path.drive(leg.points, leg.tool);
  }
  return path.take();
}

}  // namespace oxturn
