#include "algorithms/lanes/strips.hpp"

#include <algorithm>

namespace oxturn {

std::vector<bool> Strip::directions(bool first_up) const {
  std::vector<bool> up{first_up};
  for (std::size_t i = 1; i < lanes.size(); ++i) {
    if (!low_links.empty()) {  // along the boundary: always end by end
      up.push_back(!up.back());
      continue;
    }
    const Point& at = up.back() ? lanes[i - 1].high : lanes[i - 1].low;
    const double to_low = distance(at, lanes[i].low), to_high = distance(at, lanes[i].high);
    up.push_back(to_low == to_high ? !up.back() : to_low < to_high);
  }
  return up;
}

TourElement Strip::patterns() const {
  TourElement all;
  for (const bool first_up : {true, false}) {
    const std::vector<bool> up = directions(first_up);
    const Point entry = up.front() ? lanes.front().low : lanes.front().high;
    const Point exit = up.back() ? lanes.back().high : lanes.back().low;
    double links = 0;
    for (std::size_t i = 1; i < lanes.size(); ++i)
      links += distance(up[i - 1] ? lanes[i - 1].high : lanes[i - 1].low, up[i] ? lanes[i].low : lanes[i].high);
    const std::size_t k = all.size();
    all.push_back({entry, exit, links, k + 1});
    all.push_back({exit, entry, links, k});
    if (lanes.size() == 1) break;  // the other way to begin is the same lane backwards
  }
  return all;
}

namespace {

// The lanes of a strip as legs, in the direction of the pattern's first half.
struct Piece {
  bool tool;
  Polyline points;
};

std::vector<Piece> pieces_of(const Strip& strip, std::size_t pattern, double longest_link, const Connector& connector) {
  const std::vector<bool> up = strip.directions(pattern < 2);
  std::vector<Piece> all;
  for (std::size_t i = 0; i < strip.lanes.size(); ++i) {
    const LaneEnds& lane = strip.lanes[i];
    const Point& from = up[i] ? lane.low : lane.high;
    if (i > 0) {
      const Point& at = up[i - 1] ? strip.lanes[i - 1].high : strip.lanes[i - 1].low;
      Polyline link;
      // The given chain joins equal ends only.
      if (!strip.low_links.empty() && up[i] != up[i - 1])
        link = up[i] ? strip.low_links[i - 1] : strip.high_links[i - 1];
      else
        link = connector.path(at, from);
      const bool tool = length(link) <= longest_link;
      all.push_back({tool, std::move(link)});
    }
    Polyline line = lane.curve.empty() ? Polyline{lane.low, lane.high} : lane.curve;
    if (!up[i]) std::reverse(line.begin(), line.end());
    all.push_back({true, std::move(line)});
  }
  if (pattern % 2 == 1) {
    std::reverse(all.begin(), all.end());
    for (Piece& s : all) std::reverse(s.points.begin(), s.points.end());
  }
  return all;
}

}  // namespace

Path drive_strips(const Problem& problem, const std::vector<Strip>& strips, const std::string& order,
                  const Connector& connector, Context& context) {
  if (context.wants_traces()) {
    std::vector<Polyline> lanes;
    for (const Strip& s : strips)
      for (const LaneEnds& l : s.lanes) lanes.push_back(l.curve.empty() ? Polyline{l.low, l.high} : l.curve);
    context.trace("lanes", std::move(lanes));
  }
  std::vector<TourElement> elements;
  std::vector<std::vector<std::size_t>> neighbours;
  for (const Strip& s : strips) {
    elements.push_back(s.patterns());
    neighbours.push_back(s.neighbours);
  }
  const OpenTour tours(problem.start(), elements, connector);
  std::vector<TourStop> tour;
  if (order == "given")
    for (std::size_t i = 0; i < elements.size(); ++i) tour.push_back({i, 0});
  else
    tour = order == "dfs" ? tours.depth_first(neighbours, context) : tours.nearest(context);
  if (order == "improved") tours.improve(tour, context);
  if (!context.cancelled()) tours.choose_patterns(tour);

  PathBuilder path(problem.start());
  for (const TourStop& stop : tour) {
    if (context.cancelled()) break;
    path.drive(connector.path(path.at(), elements[stop.element][stop.pattern].entry), false);
    for (const Piece& s : pieces_of(strips[stop.element], stop.pattern, 3 * problem.robot().tool_width, connector))
      path.drive(s.points, s.tool);
  }
  return path.take();
}

}  // namespace oxturn
