#include "algorithms/tethered/wall_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/lattice/wall_crossings.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kEqual = 1e-9;   // cell sides, radians: rounding
constexpr double kBesideCut = 2;  // decision 3
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

using Indices = std::vector<std::size_t>;

/// Where an edge of the lattice from a free cell ends at a wall.
struct Stub {
  std::size_t cell;  // vertex
  WallCrossing crossing;
};

/// The walls from one vertex on them to the next. Between two kept vertices they are driven all along, or, with a gap,
/// so far from the left end and so far from the right one.
struct Run {
  double length = 0;
  bool gap = false;
  double from_left = 0, from_right = 0;
};

/// A polyline from one vertex to another one, or only there and back.
struct Branch {
  Polyline line;
  std::size_t to = kNone;
};

/// As much of the line as is `longest` metres long.
Polyline first_part(const Polyline& line, double longest) {
  Polyline part{line.front()};
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double step = distance(line[k - 1], line[k]);
    if (step >= longest) {
      if (longest > 0) part.push_back(lerp(line[k - 1], line[k], longest / step));
      return part;
    }
    longest -= step;
    part.push_back(line[k]);
  }
  return part;
}

}  // namespace

/// Vertices: first the free cells, then the stubs' ends in the order of the ring.
struct WallTree::Impl {
 public:
  Impl(const Problem& problem, double side, double furthest,
       const std::function<bool(const Point&, const Point&)>& is_wall)
      : graph(make_grid_graph_at(problem.configuration_space(), problem.map().name, problem.start(), side)),
        ring(problem.configuration_space().polygons.front().outer),
        longest(furthest) {
    number_cells(problem.start());
    find_stubs(problem.walls());
    make_runs(is_wall);
    grow();
    drop_leaves_on_walls();
    branch_out();
  }

  GridGraph graph;
  std::vector<std::vector<Branch>> branches;  // by vertex
  std::size_t root = 0;
  Indices nodes;  // of the lattice, by cell
  SearchTree<double> tree;

 private:
  // ------------------------------------------------------------------------------------------------- graph
  void number_cells(const Point& start) {
    vertex_of.assign(graph.size(), kNone);
    const std::size_t home = graph.at(graph.cell_of(start));
    for (std::size_t node = 0; node < graph.size(); ++node) {
      if (node == home) root = nodes.size();
      if (node != home && !graph.free(graph.cell(node))) continue;
      vertex_of[node] = nodes.size();
      nodes.push_back(node);
      points.push_back(node == home ? start : graph.centre(node));  // exactly, not rounded
    }
  }
  std::size_t cell_beside(std::size_t cell, Direction d) const {
    const Cell at = graph.cell(nodes[cell]);
    return graph.passable(at, d) ? vertex_of[graph.at(neighbour(at, d))] : kNone;
  }

  /// Of every closed edge from a free cell the first crossing with a wall.
  void find_stubs(const EdgeIndex& walls) {
    struct Candidate {
      std::size_t cell, direction;
      double away;  // cell sides
      std::size_t crossing;
      auto key() const { return std::tuple(cell, direction, away, crossing); }
    };
    const std::vector<WallCrossing> crossings = wall_crossings(graph, ring, LatticeLines::through_centres);
    std::vector<Candidate> candidates;
    const auto offer = [&](const WallCrossing& x, int along, std::size_t number) {
      const Cell c = x.vertical ? Cell{x.line, along} : Cell{along, x.line};
      if (!graph.free(c)) return;
      const Direction up = x.vertical ? kNorth : kEast;
      for (const Direction d : {up, opposite(up)}) {
        const double away = d == up ? x.along - along : along - x.along;
        if (away >= -kEqual && away <= 1 && !graph.passable(c, d))
          candidates.push_back({vertex_of[graph.at(c)], static_cast<std::size_t>(d), away, number});
      }
    };
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const auto below = static_cast<int>(std::floor(crossings[k].along));
      for (const int along : {below - 1, below, below + 1}) offer(crossings[k], along, k);
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.key() < b.key(); });
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const Candidate& c = candidates[k];
      if (k > 0 && candidates[k - 1].cell == c.cell && candidates[k - 1].direction == c.direction) continue;
      stubs.push_back({c.cell, crossings[c.crossing]});
    }
    if (stubs.empty() || !graph.free(graph.cell(nodes[root]))) stub_at_nearest_wall(walls);
    sort_stubs();
  }
  /// For a start on the boundary, and a space too small for the lattice.
  void stub_at_nearest_wall(const EdgeIndex& walls) {
    const EdgeIndex::Nearest wall = *walls.nearest(points[root]);
    const EdgeIndex::Edge& e = walls.edges()[wall.edge];
    const double whole = distance(e.a, e.b), t = whole > 0 ? distance(e.a, wall.point) / whole : 0;
    stubs.push_back({root, {wall.edge, t, wall.point, false, 0, 0}});
  }
  void sort_stubs() {
    std::stable_sort(stubs.begin(), stubs.end(), [](const Stub& a, const Stub& b) {
      return std::tie(a.crossing.edge, a.crossing.t) < std::tie(b.crossing.edge, b.crossing.t);
    });
    stubs_of.resize(nodes.size());
    for (const Stub& stub : stubs) {
      stubs_of[stub.cell].push_back(points.size());
      points.push_back(stub.crossing.at);
    }
  }
  bool is_cell(std::size_t v) const { return v < nodes.size(); }
  const Stub& stub(std::size_t v) const { return stubs[v - nodes.size()]; }

  void make_runs(const std::function<bool(const Point&, const Point&)>& is_wall) {
    const std::size_t first = nodes.size(), count = stubs.size();
    runs.resize(points.size());
    next.resize(points.size());
    previous.resize(points.size());
    for (std::size_t k = 0; k < count; ++k) {
      next[first + k] = first + (k + 1) % count;
      previous[first + (k + 1) % count] = first + k;
    }
    for (std::size_t v = first; v < points.size(); ++v) {
      const Polyline line = walls_after(v);
      runs[v] = {length(line), !to_be_driven(line, is_wall)};
    }
  }
  /// From a vertex on a wall to the next one that is kept.
  Polyline walls_after(std::size_t v) const {
    const WallCrossing &from = stub(v).crossing, &to = stub(next[v]).crossing;
    const bool same = v != next[v] && from.edge == to.edge && from.t == to.t;
    // Of several vertices at one point, only from the last one on is it the whole ring.
    if (same && next[v] > v) return {from.at, to.at};
    return wall_between(ring, from, to);
  }
  bool to_be_driven(const Polyline& line, const std::function<bool(const Point&, const Point&)>& is_wall) const {
    Box box;
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (k > 0 && line[k - 1] != line[k] && is_wall(line[k - 1], line[k])) return true;
      box.add(line[k]);
    }
    const Cell low = graph.cell_of(box.low), high = graph.cell_of(box.high);
    for (int j = low.j; j <= high.j; ++j)
      for (int i = low.i; i <= high.i; ++i)
        if (!graph.free(i, j)) return true;
    return false;
  }

  // -------------------------------------------------------------------------------------------------- tree
  template <class F>
  void for_each_neighbour(std::size_t v, F f) const {
    if (is_cell(v)) {
      for (const Direction d : kAllDirections)
        if (const std::size_t n = cell_beside(v, d); n != kNone) f(n, graph.side());
      for (const std::size_t s : stubs_of[v]) f(s, distance(points[v], points[s]));
    } else {
      f(stub(v).cell, distance(points[v], points[stub(v).cell]));
      if (next[v] != v) f(next[v], distance_along(runs[v]));
      if (previous[v] != v) f(previous[v], distance_along(runs[previous[v]]));
    }
  }
  static double distance_along(const Run& run) { return run.gap ? kBesideCut * run.length : run.length; }
  double cost(std::size_t v) const { return tree.reached(v) ? tree.cost(v) : std::numeric_limits<double>::infinity(); }

  void grow() {
    const double slack = kEqual * graph.side();
    dijkstra(tree, points.size(), root, [&](std::size_t at, auto reach) {
      for_each_neighbour(at, [&](std::size_t n, double d) {
        if (tree.cost(at) + d <= longest + slack) reach(n, d);
      });
    });
    for (std::size_t v = 0; v < points.size(); ++v)
      if (tree.reached(v)) order.push_back(v);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return tree.cost(a) < tree.cost(b); });
    parent.assign(points.size(), kNone);
    children.assign(points.size(), 0);
    for (const std::size_t v : order) {
      if (v == root) continue;
      parent[v] = is_cell(v) ? straightest_parent(v) : *tree.predecessor(v);
      ++children[parent[v]];
    }
  }
  std::size_t straightest_parent(std::size_t v) const {
    std::size_t best = *tree.predecessor(v);
    double least = turn(best, v);
    for_each_neighbour(v, [&](std::size_t p, double d) {
      const bool equal = cost(p) < cost(v) && cost(p) + d <= cost(v) + kEqual * graph.side();
      if (!equal || turn(p, v) >= least - kEqual) return;
      least = turn(p, v);
      best = p;
    });
    return best;
  }
  /// Radians between the edge to p and the one from p to v; none at the root.
  double turn(std::size_t p, std::size_t v) const {
    if (parent[p] == kNone) return 0;
    const Point in = points[p] - points[parent[p]], out = points[v] - points[p];
    return std::abs(math::atan2(cross(in, out), in.dot(out)));
  }

  // Decision 2. First the vertices out of reach, then leaves, the farthest first.
  void drop_leaves_on_walls() {
    last_kept = nodes.size() < points.size() ? nodes.size() : kNone;
    for (std::size_t v = nodes.size(); v < points.size(); ++v)
      if (!tree.reached(v)) drop(v);
    for (auto v = order.rbegin(); v != order.rend(); ++v) {
      if (is_cell(*v) || children[*v] > 0 || next[*v] == *v || !may_drop(*v)) continue;
      --children[parent[*v]];
      parent[*v] = kNone;
      drop(*v);
    }
  }
  /// What is driven of the walls before and after it can be driven from the neighbours.
  bool may_drop(std::size_t v) const {
    const Run &left = runs[previous[v]], &right = runs[v];
    if (left.gap && right.gap && left.from_right + right.from_left > 0) return false;
    const Run merged = joined(left, right);
    const double before = cost(previous[v]), after = cost(next[v]);
    if (merged.gap) return before + merged.from_left <= longest && after + merged.from_right <= longest;
    return (before + after + merged.length) / 2 <= longest;
  }
  static Run joined(const Run& left, const Run& right) {
    Run run{left.length + right.length, left.gap || right.gap};
    run.from_left = left.gap ? left.from_left : left.length + right.from_left;
    run.from_right = right.gap ? right.from_right : right.length + left.from_right;
    return run;
  }
  void drop(std::size_t v) {
    if (next[v] == v) {
      last_kept = kNone;
      return;
    }
    runs[previous[v]] = joined(runs[previous[v]], runs[v]);
    next[previous[v]] = next[v];
    previous[next[v]] = previous[v];
    if (last_kept == v) last_kept = next[v];
  }

  // ---------------------------------------------------------------------------------------------- branches
  void branch_out() {
    branches.resize(points.size());
    for (const std::size_t v : order)
      if (parent[v] != kNone) branches[parent[v]].push_back({line_between(parent[v], v), v});
    if (last_kept == kNone) return;
    std::size_t v = last_kept;
    do {
      if (!by_run(v, next[v]) || !tree_run(v)) add_excursions(v);
      v = next[v];
    } while (v != last_kept);
  }
  /// One is the parent of the other along the walls.
  bool by_run(std::size_t a, std::size_t b) const { return a != b && (parent[a] == b || parent[b] == a); }
  /// The run after v, and not the one on the other side of the ring, joins v and the next vertex in the tree.
  bool tree_run(std::size_t v) const {
    if (next[next[v]] != v) return true;
    return runs[v].length < runs[next[v]].length || (runs[v].length == runs[next[v]].length && v < next[v]);
  }
  Polyline line_between(std::size_t from, std::size_t to) const {
    if (is_cell(from) || is_cell(to)) return {points[from], points[to]};
    if (next[from] == to && tree_run(from)) return walls_after(from);
    Polyline line = walls_after(to);
    std::reverse(line.begin(), line.end());
    return line;
  }
  /// Along the walls between two vertices: from both ends to where they meet, or as far as necessary.
  void add_excursions(std::size_t left) {
    const std::size_t right = next[left];
    const Run& run = runs[left];
    double from_left = run.from_left, from_right = run.from_right;
    if (!run.gap) {
      from_left = std::clamp((run.length + cost(right) - cost(left)) / 2, 0.0, run.length);
      from_right = run.length - from_left;
    }
    Polyline line = walls_after(left);
    add_excursion(left, line, from_left);
    std::reverse(line.begin(), line.end());
    add_excursion(right, line, from_right);
  }
  void add_excursion(std::size_t v, const Polyline& line, double wanted) {
    Polyline part = first_part(line, std::min(wanted, longest - cost(v)));
    if (part.size() > 1) branches[v].push_back({std::move(part)});
  }

  const Ring& ring;
  double longest;
  Indices vertex_of;  // by lattice node
  Polyline points;    // by vertex
  std::vector<Stub> stubs;
  std::vector<Indices> stubs_of;  // by cell
  std::vector<Run> runs;          // by the vertex on whose left they begin
  Indices next, previous;         // of the vertices on walls, those kept
  Indices order, parent, children;
  std::size_t last_kept = kNone;
};

WallTree::WallTree(const Problem& problem, double side, double longest,
                   const std::function<bool(const Point&, const Point&)>& is_wall)
    : impl_(std::make_unique<const Impl>(problem, side, longest, is_wall)) {}
WallTree::~WallTree() = default;

const GridGraph& WallTree::lattice() const { return impl_->graph; }

Polyline WallTree::path() const {
  struct Visit {
    std::size_t vertex;
    const Branch* arrival;
    std::size_t next = 0;
  };
  Polyline line;
  const auto drive = [&](auto first, auto last) {
    for (; first != last; ++first)
      if (line.empty() || line.back() != *first) line.push_back(*first);
  };
  std::vector<Visit> stack{{impl_->root, nullptr}};
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.vertex != kNone && top.next < impl_->branches[top.vertex].size()) {
      const Branch& branch = impl_->branches[top.vertex][top.next++];
      drive(branch.line.begin(), branch.line.end());
      stack.push_back({branch.to, &branch});
      continue;
    }
    if (top.arrival != nullptr) drive(top.arrival->line.rbegin(), top.arrival->line.rend());
    stack.pop_back();
  }
  return line;
}

std::vector<Polyline> WallTree::branches() const {
  std::vector<Polyline> lines;
  for (const std::vector<Branch>& from : impl_->branches)
    for (const Branch& branch : from) lines.push_back(branch.line);
  return lines;
}

std::vector<Cell> WallTree::cells() const {
  std::vector<Cell> cells;
  for (std::size_t c = 0; c < impl_->nodes.size(); ++c)
    if (impl_->tree.reached(c)) cells.push_back(impl_->graph.cell(impl_->nodes[c]));
  return cells;
}

}  // namespace oxturn
