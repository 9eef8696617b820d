#include "algorithms/grid/rectangle_cleaner.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace oxturn {

double RectangleSettings::side(const Robot& robot) const {
  if (cell_size > 0) return cell_size;
  return robot.radius > 0 ? robot.radius : robot.tool_width / 2;
}

RectangleCleaner::RectangleCleaner(const RectangleSettings& settings, const Problem& problem, const GridGraph& graph,
                                   std::vector<bool> done, Context& context)
    : p_(settings),
      problem_(problem),
      graph_(graph),
      context_(context),
      ways_(graph, problem.walls()),
      side_(graph.side()),
      done_(std::move(done)),
      path_(problem.start()) {}

Path RectangleCleaner::clean() {
  const bool lanes = p_.lanes == "diagonal";
  const std::vector<Job> all = lanes ? std::vector<Job>{} : jobs();
  if (begin(all)) {
    lanes ? clean_lanes() : clean_all(all);
    if (p_.revisit_skipped) revisit();
  }
  if (context_.wants_traces()) context_.trace("skipped", skipped_);
  return path_.take();
}

// From the start onto the lattice: to a node in sight, else the shortest way to the first node that has to be driven.
bool RectangleCleaner::begin(const std::vector<Job>& jobs) {
  if (jobs.empty() && !p_.revisit_skipped && p_.lanes != "diagonal") return false;
  if (const auto node = ways_.node_near(problem_.start())) {
    at_ = *node;
    path_.drive(place(at_), false);
    return true;
  }
  if (!jobs.empty())
    at_ = graph_.at(jobs.front().start.column, jobs.front().start.low);
  else
    while (at_ < graph_.size() && ways_.part(at_) < 0) ++at_;
  if (at_ == graph_.size()) return false;
  go_among_walls(0);
  return true;
}

Point RectangleCleaner::place(std::size_t node) const {
  const auto columns = static_cast<std::size_t>(graph_.columns());
  return graph_.centre(static_cast<int>(node % columns), static_cast<int>(node / columns));
}

// The cells that lie wholly in free space, in the frame of the lattice, less those that are done.
BitGrid RectangleCleaner::dirty_cells() const {
  BitGrid free =
      without_gaps(rasterise(problem_.map().free, graph_, 1, 0, CellRule::inside), p_.gap, p_.small_obstacle);
  for (std::size_t c = 0; c < done_.size(); ++c)
    if (done_[c]) free.bits[c] = 0;
  return free;
}

std::vector<RectangleCleaner::Stretch> RectangleCleaner::stretches(int i, int bottom, int top) const {
  std::vector<Stretch> found;
  for (int j = bottom; j <= top; ++j) {
    if (!graph_.free(i, j)) continue;
    int end = j;
    while (end < top && graph_.passable(i, end, kNorth)) ++end;
    found.push_back({i, j, end});
    j = end;
  }
  return found;
}

void RectangleCleaner::skip(int column, int bottom, int top) {
  if (bottom > top) return;
  counts_.skipped_cells += static_cast<std::size_t>(top - bottom + 1);
  if (context_.wants_traces()) skipped_.push_back({graph_.centre(column, bottom), graph_.centre(column, top)});
}

// Seed 2.3: as near to the lower left as possible; up to `shift` cells up, then the next column. Columns without a place
// are skipped: the rectangle loses them.
std::optional<RectangleCleaner::Stretch> RectangleCleaner::start_of(CellRectangle& r) {
  for (; r.left <= r.right; ++r.left) {
    const std::vector<Stretch> runs = stretches(r.left, r.bottom, std::min(r.top, r.bottom + p_.shift));
    if (!runs.empty()) return runs.front();
  }
  return std::nullopt;
}

std::vector<RectangleCleaner::Job> RectangleCleaner::jobs() {
  const std::vector<CellRectangle> all = rectangles_of(dirty_cells(), p_.scan == "rows");
  if (context_.wants_traces()) context_.trace("rectangles", outlines(all));
  std::vector<Job> drivable;
  for (const CellRectangle& whole : all) {
    const auto cells = static_cast<std::size_t>(whole.width() * whole.height());
    CellRectangle r = whole;
    const std::optional<Stretch> start = start_of(r);
    if (!start || r.width() < p_.smallest || r.height() < p_.smallest) {
      counts_.small_cells += cells;
      continue;
    }
    for (int i = whole.left; i < r.left; ++i) {
      ++counts_.skipped_columns;
      skip(i, r.bottom, r.top);
    }
    skip(r.left, r.bottom, start->low - 1);
    drivable.push_back({r, *start});
  }
  return drivable;
}

void RectangleCleaner::clean_all(const std::vector<Job>& jobs) {
  std::vector<bool> cleaned(jobs.size(), false);
  std::unordered_map<std::size_t, std::size_t> starts;  // node -> job; looked up, never listed
  std::vector<std::size_t> left_in(1, 0);               // starts left, by parts of the lattice
  const bool nearest = p_.choose == "nearest";
  for (std::size_t k = 0; nearest && k < jobs.size(); ++k) {
    const std::size_t node = graph_.at(jobs[k].start.column, jobs[k].start.low);
    starts[node] = k;
    left_in.resize(std::max(left_in.size(), static_cast<std::size_t>(ways_.part(node)) + 1), 0);
    ++left_in[static_cast<std::size_t>(ways_.part(node))];
  }
  std::size_t first = 0;
  for (std::size_t n = 0; n < jobs.size() && !context_.cancelled(); ++n) {
    while (cleaned[first]) ++first;
    std::size_t k = first;
    const auto here = static_cast<std::size_t>(ways_.part(at_));
    if (nearest && here < left_in.size() && left_in[here] > 0)
      if (const auto found = ways_.nearest(at_, [&](std::size_t node) { return starts.count(node) > 0; }))
        k = starts.at(found->node);
    const std::size_t node = graph_.at(jobs[k].start.column, jobs[k].start.low);
    if (nearest) {
      --left_in[static_cast<std::size_t>(ways_.part(node))];
      starts.erase(node);
    }
    clean(jobs[k]);
    cleaned[k] = true;
    ++counts_.rectangles;
    context_.progress(double(n + 1) / static_cast<double>(jobs.size()));
  }
}

// The outlook of seed 5.2: no rectangles, but lanes laid over the grid, each as long as it goes; always on to the nearest
// end of one.
void RectangleCleaner::clean_lanes() {
  std::vector<Stretch> lanes;
  std::vector<std::int32_t> lane_at(graph_.size(), -1);  // at the ends of lanes that are left
  for (int i = 0; i < graph_.columns(); ++i)
    for (const Stretch& whole : stretches(i, 0, graph_.rows() - 1))
      for (int j = whole.low; j <= whole.high; ++j) {
        if (done_[graph_.at(i, j)]) continue;
        Stretch lane{i, j, j};
        while (lane.high < whole.high && !done_[graph_.at(i, lane.high + 1)]) ++lane.high;
        for (const int end : {lane.low, lane.high})
          lane_at[graph_.at(i, end)] = static_cast<std::int32_t>(lanes.size());
        lanes.push_back(lane);
        j = lane.high;
      }
  if (context_.wants_traces()) {
    std::vector<Polyline> lines;
    for (const Stretch& s : lanes) lines.push_back({graph_.centre(s.column, s.low), graph_.centre(s.column, s.high)});
    context_.trace("lanes", std::move(lines));
  }
  std::size_t first = 0;
  for (std::size_t n = 0; n < lanes.size() && !context_.cancelled(); ++n) {
    const auto found = ways_.nearest(at_, [&](std::size_t node) { return lane_at[node] >= 0; });
    while (!found && done_[graph_.at(lanes[first].column, lanes[first].low)]) ++first;
    const std::size_t k = found ? static_cast<std::size_t>(lane_at[found->node]) : first;
    const Stretch& lane = lanes[k];
    const bool up = !found || found->node == graph_.at(lane.column, lane.low);
    for (const int end : {lane.low, lane.high}) lane_at[graph_.at(lane.column, end)] = -1;
    drive(lane, up, true);
    context_.progress(double(n + 1) / static_cast<double>(lanes.size()));
  }
}

void RectangleCleaner::clean(const Job& job) {
  const CellRectangle& r = job.rectangle;
  const int ci = (r.left + r.right) / 2, cj = (r.bottom + r.top) / 2;
  if (p_.via_centre && graph_.free(ci, cj)) go(graph_.at(ci, cj), false, 0);
  const int step = p_.columns == "tool" ? std::max(1, static_cast<int>(problem_.robot().tool_width / side_ + 1e-9)) : 1;
  bool up = true, first = true;
  for (int i = r.left;; i = std::min(i + step, r.right)) {
    // The first column counts from the start; cells below a shifted one stay (seed).
    std::vector<Stretch> runs = stretches(i, i == r.left ? job.start.low : r.bottom, r.top);
    if (runs.empty()) {
      ++counts_.skipped_columns;
      skip(i, r.bottom, r.top);
    }
    if (!up) std::reverse(runs.begin(), runs.end());
    for (const Stretch& s : runs) {
      drive(s, up, !first);
      first = false;
    }
    if (!runs.empty()) up = !up;
    if (i == r.right) break;
  }
}

void RectangleCleaner::drive(const Stretch& s, bool up, bool may_work) {
  // A stretch of one node has no length to sweep: there the tool comes down for the last bit of the way.
  go(graph_.at(s.column, up ? s.low : s.high), may_work, s.low == s.high ? side_ : 0);
  at_ = graph_.at(s.column, up ? s.high : s.low);
  path_.drive(place(at_), true);
  for (int j = s.low; j <= s.high; ++j) done_[graph_.at(s.column, j)] = true;
}

// Straight with the tool on for the short step to the next column, else the way over the lattice with the tool off but for
// its last `tail` metres. Where the lattice does not lead on, the shortest way among the walls themselves does.
void RectangleCleaner::go(std::size_t node, bool may_work, double tail) {
  if (node == at_) return;
  const Point to = place(node);
  if (may_work && distance(path_.at(), to) <= 2 * std::max(side_, problem_.robot().tool_width) &&
      problem_.walls().contains(path_.at(), to)) {
    path_.drive(to, true);
  } else {
    Polyline way = ways_.way(at_, node);
    at_ = node;
    way.empty() ? go_among_walls(tail) : go_along(std::move(way), tail);
  }
  at_ = node;
}

void RectangleCleaner::go_among_walls(double tail) {
  auto way = problem_.transit().path(path_.at(), place(at_));
  if (!way) throw std::logic_error("two places in configuration space are not connected");
  go_along(std::move(*way), tail);
}

void RectangleCleaner::go_along(Polyline way, double tail) {
  Polyline last{way.back()};
  while (way.size() > 1 && tail > 0) {
    const Point end = way.back();
    way.pop_back();
    const double step = distance(way.back(), end);
    if (step > tail) way.push_back(lerp(end, way.back(), tail / step));
    last.insert(last.begin(), way.back());
    tail -= step;
  }
  path_.drive(way, false);
  if (last.size() > 1) path_.drive(last, true);
}

// Ours: whatever lattice node the robot can reach and has not driven, the nearest first, with all that is bare above and
// below it. Parts of the lattice that hang together with nothing but by ways between its lines come in turn.
void RectangleCleaner::revisit() {
  const auto columns = static_cast<std::size_t>(graph_.columns());
  const auto bare = [&](std::size_t node) { return ways_.part(node) >= 0 && !done_[node]; };
  std::size_t scan = 0;
  while (!context_.cancelled()) {
    std::size_t node;
    if (const auto found = ways_.nearest(at_, bare)) {
      node = found->node;
    } else {
      while (scan < graph_.size() && !bare(scan)) ++scan;
      if (scan == graph_.size()) return;
      node = scan;
    }
    const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
    Stretch s{i, j, j};
    while (graph_.passable(i, s.low, kSouth) && bare(graph_.at(i, s.low - 1))) --s.low;
    while (graph_.passable(i, s.high, kNorth) && bare(graph_.at(i, s.high + 1))) ++s.high;
    drive(s, j - s.low <= s.high - j, true);
  }
}

std::vector<Polyline> RectangleCleaner::outlines(const std::vector<CellRectangle>& rectangles) const {
  std::vector<Polyline> lines;
  for (const CellRectangle& r : rectangles) {
    const Point a = graph_.centre(r.left - 0.5, r.bottom - 0.5), b = graph_.centre(r.right + 0.5, r.bottom - 0.5);
    const Point c = graph_.centre(r.right + 0.5, r.top + 0.5), d = graph_.centre(r.left - 0.5, r.top + 0.5);
    lines.push_back({a, b, c, d, a});
  }
  return lines;
}

}  // namespace oxturn
