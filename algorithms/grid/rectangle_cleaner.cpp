#include "algorithms/grid/rectangle_cleaner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "algorithms/grid/rectangle_lanes.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/transit/component_links.hpp"
#include "algorithms/transit/nearest_component.hpp"

namespace oxturn {
namespace {

constexpr auto kNoJob = std::numeric_limits<std::uint32_t>::max();
// Where walls have far fewer edges than the lattice has nodes, so many nodes are searched for the nearest rectangle; if
// there is none so near, the triangles of free space are searched, of which there are about as many as edges. To search
// a triangle takes as long as some thirty nodes.
constexpr std::size_t kMostNodes = 20'000, kNodesOfAnEdge = 30;

/// One run.
class RectangleCleaner {
 public:
  RectangleCleaner(const RectangleOptions& options, const Problem& problem, const GridGraph& graph,
                   std::vector<bool> done, Context& context)
      : p_(options),
        problem_(problem),
        graph_(graph),
        context_(context),
        paths_(graph, problem.walls()),
        most_nodes_(graph.size() > kNodesOfAnEdge * problem.walls().edges().size() ? kMostNodes : graph.size()),
        side_(graph.side()),
        lanes_(graph, options, problem.robot()),
        done_(std::move(done)),
        path_(problem.start()) {}

  CleanedRectangles clean() {
    const bool diagonal = p_.lanes == Lanes::diagonal;
    const std::vector<Job> all = diagonal ? std::vector<Job>{} : jobs();
    if (begin(all)) {
      promise(all);
      diagonal ? clean_lanes() : clean_jobs(all);
      if (p_.revisit_skipped) revisit();
    }
    if (context_.wants_traces()) context_.trace("skipped", skipped_);
    result_.path = path_.take();
    return std::move(result_);
  }

 private:
  struct Job {
    CellRectangle rectangle;
    std::vector<Lane> lanes;  // in the order of their lines; all in columns, or all in rows
  };
  enum class Approach { work_if_short, transit };

  /// The lattice's cells that lie entirely in free space, without those that are done; also cells larger than the robot
  /// of which it can reach the centre.
  BitGrid dirty_cells() const {
    BitGrid free = rasterise(problem_.map().free, graph_, 1, 0, CellRule::inside);
    for (std::size_t c = 0; c < free.bits.size(); ++c)
      if (graph_.free(graph_.cell(c))) free.bits[c] = 1;
    free = without_gaps(free, p_.gap, p_.small_obstacle);
    for (std::size_t c = 0; c < done_.size(); ++c)
      if (done_[c]) free.bits[c] = 0;
    return free;
  }

  std::size_t node(const Lane& lane, int along) const { return node_of(graph_, lane, along); }
  std::size_t low_end(const Lane& lane) const { return node(lane, lane.low); }
  std::size_t high_end(const Lane& lane) const { return node(lane, lane.high); }

  /// Maximal runs of nodes that are not done.
  std::vector<Lane> uncleaned_lanes() const {
    std::vector<Lane> lanes;
    for (int i = 0; i < graph_.columns(); ++i)
      for (const Lane& whole : lanes_.runs({true, i, 0, graph_.rows() - 1}))
        for (int j = whole.low; j <= whole.high; ++j) {
          if (done_[graph_.at(i, j)]) continue;
          Lane lane{true, i, j, j};
          while (lane.high < whole.high && !done_[graph_.at(i, lane.high + 1)]) ++lane.high;
          lanes.push_back(lane);
          j = lane.high;
        }
    return lanes;
  }

  /// The partition in which no rectangle begins with columns (rows) that have to be skipped. These count as done, and
  /// what is left of their rectangles may form larger ones with its neighbours; so it is made anew without them.
  std::vector<CellRectangle> partition() {
    BitGrid world = dirty_cells();
    for (;;) {
      std::vector<CellRectangle> all = rectangles_of(world, p_.scan);
      bool anew = false;
      const auto leave_out = [&](const Lane& cells) {
        ++result_.skipped_columns;
        skip(cells);
        for (int k = cells.low; k <= cells.high; ++k) world.bits[node(cells, k)] = 0;
        anew = true;
      };
      for (const CellRectangle& whole : all) {
        CellRectangle r = whole;
        if (!lanes_.start_of(r)) continue;
        for (int i = whole.left; i < r.left; ++i) leave_out({true, i, whole.bottom, whole.top});
        for (int j = whole.bottom; j < r.bottom; ++j) leave_out({false, j, r.left, r.right});
      }
      if (!anew || context_.cancelled()) return all;
    }
  }

  std::vector<Job> jobs() {
    const std::vector<CellRectangle> all = partition();
    if (context_.wants_traces()) trace_rectangles(all);
    std::vector<Job> drivable;
    for (CellRectangle r : all) {
      const auto cells = static_cast<std::size_t>(r.width()) * static_cast<std::size_t>(r.height());
      if (const std::optional<Lane> start = lanes_.start_of(r)) {
        RectangleLanes::Found found = lanes_.in(r, *start);
        skip(found.before_start);
        for (const Lane& line : found.skipped) skip(line);
        result_.skipped_columns += found.skipped.size();
        drivable.push_back({r, std::move(found.lanes)});
      } else {
        result_.small_cells += cells;
      }
    }
    return drivable;
  }

  void promise(const std::vector<Job>& jobs) {
    const double tool_width = problem_.robot().tool_width;
    if (p_.lanes == Lanes::diagonal || p_.revisit_skipped)
      return promise_free_cells(context_, graph_, Components::all, {}, tool_width);
    if (!context_.wants_promise()) return;
    std::vector<Cell> cells;
    for (const Job& job : jobs)
      for (const Lane& lane : job.lanes)
        for (int k = lane.low; k <= lane.high; ++k) cells.push_back(graph_.cell(node(lane, k)));
    promise_cells(context_, graph_, std::move(cells), tool_width);
  }
  std::size_t start_node(const Job& job) const { return low_end(job.lanes.front()); }

  /// From the start onto the lattice: to a node in sight, else by a shortest path to the first node that has to be
  /// driven.
  bool begin(const std::vector<Job>& jobs) {
    if (jobs.empty() && !p_.revisit_skipped && p_.lanes != Lanes::diagonal) return false;
    // A run of one node has no length to cover, so the tool is on already when the robot arrives.
    const auto has_no_length = [&](std::size_t node) {
      const Cell c = graph_.cell(node);
      return !(graph_.passable(c, kNorth) || graph_.passable(c, kSouth)) ||
             std::ranges::any_of(jobs, [&](const Job& job) {
               return start_node(job) == node && job.lanes.front().low == job.lanes.front().high;
             });
    };
    if (const auto node = paths_.node_near(problem_.start())) {
      at_ = *node;
      path_.drive(graph_.centre(at_), has_no_length(at_));
      return true;
    }
    if (!jobs.empty())
      at_ = start_node(jobs.front());
    else
      while (at_ < graph_.size() && paths_.component(at_) < 0) ++at_;
    if (at_ == graph_.size()) return false;
    go_among_walls(has_no_length(at_) ? side_ : 0);
    return true;
  }

  /// The nearest over the lattice of the jobs that start at some node, unless more than most_nodes_ are nearer.
  std::optional<std::size_t> nearest_over_lattice(std::size_t from, const std::vector<std::uint32_t>& starts) {
    std::size_t nearer = 0;
    const auto ends = [&](std::size_t node) { return starts[node] != kNoJob || ++nearer > most_nodes_; };
    const auto found = paths_.nearest(from, ends);
    if (!found || starts[found->node] == kNoJob) return std::nullopt;
    return starts[found->node];
  }

  /// The nearest by shortest path of the jobs that are left, wherever the lattice leads.
  std::optional<std::size_t> nearest_among_walls(const std::vector<Job>& jobs, const std::vector<bool>& cleaned) {
    if (!among_walls_) {
      among_walls_.emplace(problem_);
      for (std::size_t k = 0; k < jobs.size(); ++k)
        if (!cleaned[k]) among_walls_->add(paths_.centre(start_node(jobs[k])), static_cast<int>(k), k);
    }
    return among_walls_->nearest(path_.at());
  }

  /// Jobs that no lattice path leads to follow the job to which a short path among walls connects them: visited at the
  /// end, each would cost a path across the map. root: the component of the lattice that is cleaned first.
  void attach_other_components(const std::vector<Job>& jobs, int root) {
    ComponentLinks links(problem_);
    for (std::size_t k = 0; k < jobs.size(); ++k)
      links.add(paths_.centre(start_node(jobs[k])), paths_.component(start_node(jobs[k])), k);
    followers_.resize(jobs.size());
    for (const ComponentLinks::Link& link : links.tree(root)) followers_[link.from].push_back(link.to);
  }

  struct LeftBehind {
    std::size_t job, node;
  };
  /// The nearest of a job's followers that is left; the others are due when the robot comes back to the node.
  std::optional<std::size_t> follower_of(const LeftBehind& here, const std::vector<Job>& jobs,
                                         const std::vector<bool>& cleaned) {
    if (followers_.empty()) return std::nullopt;
    std::vector<std::size_t>& followers = followers_[here.job];
    std::erase_if(followers, [&](std::size_t k) { return cleaned[k]; });
    if (followers.empty()) return std::nullopt;
    const auto away = [&](std::size_t k) { return distance(path_.at(), paths_.centre(start_node(jobs[k]))); };
    const auto nearest = std::ranges::min_element(followers, {}, away);
    const std::size_t k = *nearest;
    followers.erase(nearest);
    left_behind_.push_back(here);
    return k;
  }

  /// A follower of the job cleaned last, else the nearest over the lattice. Where nothing is left in a component of the
  /// lattice, what would have been next where the robot left the component before.
  std::optional<std::size_t> nearest_job(std::optional<std::size_t> last, const std::vector<Job>& jobs,
                                         const std::vector<bool>& cleaned, const std::vector<std::uint32_t>& starts,
                                         const std::unordered_map<int, std::size_t>& left_in) {
    const auto left = [&](std::size_t node) {
      const auto found = left_in.find(paths_.component(node));
      return found == left_in.end() ? 0 : found->second;
    };
    std::size_t from = at_;
    const auto any_left = [&] { return left(from) > 0; };
    if (last) {
      // A rectangle may end in another component than it began in: of two with jobs left the smaller comes first.
      std::size_t other = start_node(jobs[*last]);
      if (paths_.component(other) != paths_.component(from)) {
        if (!any_left() || (left(other) > 0 && left(other) < left(from))) std::swap(from, other);
        left_behind_.push_back({*last, other});
      }
      if (const auto k = follower_of({*last, from}, jobs, cleaned)) return k;
    }
    while (!any_left() && !left_behind_.empty()) {
      const LeftBehind there = left_behind_.back();
      left_behind_.pop_back();
      if (const auto k = follower_of(there, jobs, cleaned)) return k;
      from = there.node;
    }
    return any_left() ? nearest_over_lattice(from, starts) : std::nullopt;
  }

  /// In order, or the nearest first: over the lattice, or by a shortest path where that leads to none near by.
  void clean_jobs(const std::vector<Job>& jobs) {
    std::vector<bool> cleaned(jobs.size(), false);
    std::vector<std::uint32_t> starts(graph_.size(), kNoJob);  // node -> job
    std::unordered_map<int, std::size_t> left_in;              // starts left, by components of the lattice
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      starts[start_node(jobs[k])] = static_cast<std::uint32_t>(k);
      ++left_in[paths_.component(start_node(jobs[k]))];
    }
    std::size_t first = 0;
    std::optional<std::size_t> last;
    for (std::size_t n = 0; n < jobs.size() && !context_.cancelled(); ++n) {
      while (cleaned[first]) ++first;
      std::size_t k = first;
      if (p_.choose == NextRectangle::nearest) {
        std::optional<std::size_t> next = nearest_job(last, jobs, cleaned, starts, left_in);
        if (!next) next = nearest_among_walls(jobs, cleaned);
        k = next.value_or(first);
        if (n == 0 && left_in.size() > 1) attach_other_components(jobs, paths_.component(start_node(jobs[k])));
      }
      last = k;
      --left_in[paths_.component(start_node(jobs[k]))];
      starts[start_node(jobs[k])] = kNoJob;
      cleaned[k] = true;
      if (among_walls_) among_walls_->remove(static_cast<int>(k));
      clean_rectangle(jobs[k]);
      ++result_.rectangles;
      context_.progress(static_cast<double>(n + 1) / static_cast<double>(jobs.size()));
    }
  }

  /// MyCarbot, section 5.2: no rectangles, but lanes over the whole grid; always on to the nearest end of one.
  void clean_lanes() {
    const std::vector<Lane> lanes = uncleaned_lanes();
    std::vector<std::int32_t> lane_at(graph_.size(), -1);  // at the ends of lanes that are left
    for (std::size_t k = 0; k < lanes.size(); ++k)
      for (const std::size_t end : {low_end(lanes[k]), high_end(lanes[k])}) lane_at[end] = static_cast<std::int32_t>(k);
    if (context_.wants_traces()) {
      std::vector<Polyline> lines;
      for (const Lane& s : lanes) lines.push_back({graph_.centre(low_end(s)), graph_.centre(high_end(s))});
      context_.trace("lanes", std::move(lines));
    }
    std::size_t first = 0;
    for (std::size_t n = 0; n < lanes.size() && !context_.cancelled(); ++n) {
      const auto found = paths_.nearest(at_, [&](std::size_t node) { return lane_at[node] >= 0; });
      while (!found && done_[low_end(lanes[first])]) ++first;
      const Lane& lane = lanes[found ? static_cast<std::size_t>(lane_at[found->node]) : first];
      const bool up = !found || found->node == low_end(lane);
      for (const std::size_t end : {low_end(lane), high_end(lane)}) lane_at[end] = -1;
      drive(lane, up, Approach::work_if_short);
      context_.progress(static_cast<double>(n + 1) / static_cast<double>(lanes.size()));
    }
  }

  void clean_rectangle(const Job& job) {
    const CellRectangle& r = job.rectangle;
    const bool strip = r.width() == 1 || r.height() == 1;  // ours: driven from its nearer end
    const int ci = (r.left + r.right) / 2, cj = (r.bottom + r.top) / 2;
    if (p_.via_centre && !strip && graph_.free(ci, cj) && graph_.at(ci, cj) != start_node(job))
      go(graph_.at(ci, cj), Approach::transit, 0);
    std::vector<Lane> lanes = job.lanes;
    bool forth = true;
    if (strip &&
        distance(path_.at(), graph_.centre(r.right, r.top)) < distance(path_.at(), graph_.centre(r.left, r.bottom))) {
      std::ranges::reverse(lanes);
      forth = false;
    }
    Approach approach = Approach::transit;
    for (auto from = lanes.begin(); from != lanes.end(); forth = !forth) {
      const auto to = std::find_if(from, lanes.end(), [&](const Lane& lane) { return lane.line != from->line; });
      if ((from->low < std::prev(to)->low) != forth) std::reverse(from, to);
      for (; from != to; ++from) {
        drive(*from, forth, approach);
        approach = Approach::work_if_short;
      }
    }
  }

  void drive(const Lane& run, bool forth, Approach approach) {
    // A run of one node has no length to cover: there the tool is switched on for the last bit of the approach.
    go(forth ? low_end(run) : high_end(run), approach, run.low == run.high ? side_ : 0);
    at_ = forth ? high_end(run) : low_end(run);
    path_.drive(graph_.centre(at_), true);
    for (int k = run.low; k <= run.high; ++k) done_[node(run, k)] = true;
  }

  /// To a node: straight with the tool on if that is possible and short (the step to the next column), else over the
  /// lattice with the tool off except for the last `tail` metres. Where the lattice leads nowhere, by a shortest path
  /// among walls.
  void go(std::size_t node, Approach approach, double tail) {
    if (node == at_) return;
    const Point to = graph_.centre(node);
    if (approach == Approach::work_if_short &&
        distance(path_.at(), to) <= 2 * std::max(side_, problem_.robot().tool_width) &&
        problem_.walls().contains(path_.at(), to)) {
      at_ = node;
      path_.drive(to, true);
      return;
    }
    Polyline path = paths_.path(at_, node);
    at_ = node;
    path.empty() ? go_among_walls(tail) : go_along(std::move(path), tail);
  }

  void go_among_walls(double tail) {
    auto path = problem_.transit().path(path_.at(), graph_.centre(at_));
    if (!path) throw std::logic_error("two points of configuration space are not connected");
    go_along(std::move(*path), tail);
  }

  void go_along(Polyline path, double tail) {
    Polyline last{path.back()};
    while (path.size() > 1 && tail > 0) {
      const Point end = path.back();
      path.pop_back();
      const double step = distance(path.back(), end);
      if (step > tail) path.push_back(lerp(end, path.back(), tail / step));
      last.insert(last.begin(), path.back());
      tail -= step;
    }
    path_.drive(path, false);
    if (last.size() > 1) path_.drive(last, true);
  }

  /// Ours: drives every node that the robot can reach and has not driven, the nearest first, with all undriven nodes
  /// above and below it. Components that the lattice does not connect come one after the other.
  void revisit() {
    const auto undriven = [&](std::size_t node) { return paths_.component(node) >= 0 && !done_[node]; };
    std::size_t next = 0;
    while (!context_.cancelled()) {
      std::size_t node;
      if (const auto found = paths_.nearest(at_, undriven)) {
        node = found->node;
      } else {
        while (next < graph_.size() && !undriven(next)) ++next;
        if (next == graph_.size()) return;
        node = next;
      }
      const int i = graph_.column(node), j = graph_.row(node);
      Lane run{true, i, j, j};
      while (graph_.passable(i, run.low, kSouth) && undriven(graph_.at(i, run.low - 1))) --run.low;
      while (graph_.passable(i, run.high, kNorth) && undriven(graph_.at(i, run.high + 1))) ++run.high;
      drive(run, j - run.low <= run.high - j, Approach::work_if_short);
    }
  }

  void skip(const Lane& cells) {
    if (cells.low > cells.high) return;
    result_.skipped_cells += static_cast<std::size_t>(cells.high - cells.low + 1);
    if (context_.wants_traces()) skipped_.push_back({graph_.centre(low_end(cells)), graph_.centre(high_end(cells))});
  }

  void trace_rectangles(const std::vector<CellRectangle>& rectangles) {
    std::vector<Polyline> lines;
    for (const CellRectangle& r : rectangles) {
      const Point a = graph_.centre(r.left - 0.5, r.bottom - 0.5), b = graph_.centre(r.right + 0.5, r.bottom - 0.5);
      const Point c = graph_.centre(r.right + 0.5, r.top + 0.5), d = graph_.centre(r.left - 0.5, r.top + 0.5);
      lines.push_back({a, b, c, d, a});
    }
    context_.trace("rectangles", std::move(lines));
  }

  const RectangleOptions& p_;
  const Problem& problem_;
  const GridGraph& graph_;
  Context& context_;
  LatticePaths paths_;
  std::optional<NearestComponent> among_walls_;      // made when first needed
  std::vector<std::vector<std::size_t>> followers_;  // by job; empty: all are in one component of the lattice
  std::vector<LeftBehind> left_behind_;  // where the robot left components of the lattice that it comes back to
  std::size_t most_nodes_;
  double side_;
  RectangleLanes lanes_;
  std::vector<bool> done_;
  std::size_t at_ = 0;  // the node where the path ends
  CleanedRectangles result_;
  std::vector<Polyline> skipped_;
  PathBuilder path_;
};

}  // namespace

CleanedRectangles clean_rectangles(const RectangleOptions& options, const Problem& problem, const GridGraph& graph,
                                   std::vector<bool> done, Context& context) {
  return RectangleCleaner(options, problem, graph, std::move(done), context).clean();
}

}  // namespace oxturn
