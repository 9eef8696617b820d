#include "algorithms/improve/moves.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

// Shares of the moves, in per cent; distances in tool widths.
constexpr std::uint64_t kShiftVertex = 34, kShiftEdge = 15, kSnap = 6, kRemove = 10, kSplit = 10, kMerge = 5,
                        kTwoOpt = 10;
constexpr double kCovering = 0.1;                    // of all moves, as long as something is uncovered
constexpr double kSpikes = 0.4, kShifted = 0.4;      // of these: spikes; of the others: a vertex moves
constexpr double kMostBase = 0.3, kSpikeFrom = 2;    // of a spike: half of its base; distance of its edge
constexpr double kAbout = 0.3;                       // of a point: its nearest edge is looked for so far from it
constexpr std::size_t kMostScanned = 1000;           // edges
constexpr double kCloser = 0.4;                      // than the tool needs to cover the point, at most
constexpr double kNearFocus = 0.8, kSideways = 0.8;  // shares: of moves near the focus, of shifts of edges
constexpr double kOnChord = 1e-7;                    // of a vertex
constexpr double kLeastSplit = 0.02;                 // shorter edges get no vertex, which would cost nothing
constexpr double kPartner = 2.2;                     // distance of vertices for 2-opt and Or-opt
constexpr double kSnapFrom = 0.1, kTouch = 1e-6;     // from a wall
constexpr std::uint64_t kMostMoved = 8;              // vertices that Or-opt moves
constexpr double kCutShort = 0.3;                    // of removals, where asked for: of several vertices in a row
constexpr int kDraws = 4;                            // until a move exists; in windows, much of the path is fixed
constexpr double kLoops = 0.5;                       // share of Or-opt: moves all between two vertices near each other

/// Up to three pairs of neighbours.
struct Links {
  std::array<std::pair<std::size_t, std::size_t>, 3> pairs{};
  std::size_t size = 0;

  /// Nothing if the second one is behind the path's end.
  void add(const VertexPath& path, std::size_t a, std::size_t b) {
    if (a < path.size() && b < path.size()) pairs[size++] = {a, b};
  }
};

/// By how much turning grows at the ends of the links that go. The path's direction is of no importance.
double turning_of_links(const VertexPath& path, const Links& out, const Links& in) {
  double sum = 0;
  std::array<std::size_t, 6> done{};
  std::size_t done_count = 0;
  const auto turn = [&](const std::vector<std::size_t>& beside, std::size_t i) {
    return beside.size() == 2 ? turn_at(path[beside[0]], path[i], path[beside[1]]) : 0;
  };
  const auto change_at = [&](std::size_t i) {
    if (std::find(done.begin(), done.begin() + static_cast<std::ptrdiff_t>(done_count), i) !=
        done.begin() + static_cast<std::ptrdiff_t>(done_count))
      return;
    done[done_count++] = i;
    std::vector<std::size_t> beside;
    if (i > 0) beside.push_back(i - 1);
    if (i + 1 < path.size()) beside.push_back(i + 1);
    sum -= turn(beside, i);
    for (const auto& [a, b] : std::span(out.pairs).first(out.size))
      if (a == i || b == i) std::erase(beside, a == i ? b : a);
    for (const auto& [a, b] : std::span(in.pairs).first(in.size))
      if (a == i || b == i) beside.push_back(a == i ? b : a);
    sum += turn(beside, i);
  };
  for (const Links* links : {&out, &in})
    for (const auto& [a, b] : std::span(links->pairs).first(links->size)) {
      change_at(a);
      change_at(b);
    }
  return sum;
}

}  // namespace

std::optional<Point> on_wall(const Point& p, const EdgeIndex& walls, double width, bool vertex) {
  const auto wall = walls.nearest(p, kSnapFrom * width);
  if (!wall || wall->distance <= kTouch * width) return std::nullopt;
  const EdgeIndex::Edge& e = walls.edges()[wall->edge];
  const Point& end = distance(p, e.a) < distance(p, e.b) ? e.a : e.b;
  if (vertex && distance(p, end) < kSnapFrom * width) return end;
  return lerp(wall->point, p, kTouch * width / wall->distance);
}

double Edges::length() const {
  double sum = 0;
  for (const Edge& e : *this) sum += distance(e.a, e.b);
  return sum;
}

void Change::apply(VertexPath& path) const {
  switch (kind) {
    case Kind::replace:
      return path.replace(first, last - first, std::span(points.data(), point_count));
    case Kind::reverse:
      return path.reverse(first, last);
    case Kind::relocate:
      return path.relocate(first, last, after, turned);
  }
}

double turn_at(const Point& a, const Point& b, const Point& c) {
  const Point in = b - a, out = c - b;
  if (in == Point(0, 0) || out == Point(0, 0)) return 0;
  return std::abs(math::atan2(cross(in, out), in.dot(out)));
}

double turning(const Polyline& path) {
  double sum = 0;
  for (std::size_t i = 2; i < path.size(); ++i) sum += turn_at(path[i - 2], path[i - 1], path[i]);
  return sum;
}

double Change::turning(const VertexPath& path) const {
  if (kind == Kind::replace) return turning_of_replaced(path);
  Links out, in;
  if (kind == Kind::reverse) {
    out.add(path, first - 1, first);
    in.add(path, first - 1, last);
    out.add(path, last, last + 1);
    in.add(path, first, last + 1);
  } else {
    out.add(path, first - 1, first);
    out.add(path, last, last + 1);
    in.add(path, first - 1, last + 1);
    out.add(path, after, after + 1);
    in.add(path, after, turned ? last : first);
    in.add(path, turned ? first : last, after + 1);
  }
  return turning_of_links(path, out, in);
}

double Change::turning_of_replaced(const VertexPath& path) const {
  const std::size_t from = first < 2 ? 0 : first - 2, to = std::min(path.size(), last + 2);
  Polyline old, next;
  for (std::size_t i = from; i < to; ++i) old.push_back(path[i]);
  for (std::size_t i = from; i < first; ++i) next.push_back(path[i]);
  next.insert(next.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(point_count));
  for (std::size_t i = last; i < to; ++i) next.push_back(path[i]);
  return oxturn::turning(next) - oxturn::turning(old);
}

double Moves::spread(Rng& rng) const {
  return width_ * sizes_.least * math::exp(rng.unit() * math::log(sizes_.most / sizes_.least));
}

Point Moves::cloud(Rng& rng) const {
  const double size = spread(rng);
  const double x = rng.normal(), y = rng.normal();
  return size * Point(x, y);
}

std::size_t Moves::vertex(const VertexPath& path, Rng& rng) const {
  if (!focus_.empty() && rng.chance(kNearFocus)) {
    const Point& at = focus_[rng.below(focus_.size())];
    const double x = rng.between(-width_, width_), y = rng.between(-width_, width_);
    if (const auto near = path.near(at + Point(x, y), rng)) return *near;
  }
  return rng.below(path.size());
}

/// Of up to kMostScanned edges in a row, the end of the one nearest to p.
std::optional<std::size_t> Moves::nearest_edge(const VertexPath& path, const Point& p, Rng& rng) const {
  std::optional<std::size_t> best;
  double reach = kSpikeFrom * width_, least = reach * reach;
  const std::size_t edges = path.size() - 1, first = edges > kMostScanned ? rng.below(edges) : 0;
  for (std::size_t k = 0; k < std::min(edges, kMostScanned); ++k) {
    const std::size_t i = (first + k) % edges + 1;
    const Point &a = path[i - 1], &b = path[i];
    if (std::min(a.x(), b.x()) - p.x() > reach || p.x() - std::max(a.x(), b.x()) > reach ||
        std::min(a.y(), b.y()) - p.y() > reach || p.y() - std::max(a.y(), b.y()) > reach)
      continue;
    const double square = (nearest_on_segment(p, a, b) - p).squaredNorm();
    if (square >= least || path.edge_fixed(i)) continue;
    least = square;
    reach = std::sqrt(square);
    best = i;
  }
  return best;
}

/// p, or if that is in a wall, a point of the wall beside it.
Point Moves::free(const Point& p) const {
  if (walls_.contains(p)) return p;
  const auto wall = walls_.nearest(p, width_);
  return wall && wall->distance > 0 ? lerp(wall->point, p, -kTouch * width_ / wall->distance) : p;
}

/// So that the tool covers an uncovered point, a vertex near by is shifted, or added to its edge.
std::optional<Change> Moves::cover(const VertexPath& path, Rng& rng) const {
  const Point& at = uncovered_[rng.below(uncovered_.size())];
  if (rng.chance(kSpikes)) return spike(path, at, rng);
  const double x = rng.between(-width_, width_), y = rng.between(-width_, width_);
  const auto i = path.near(at + Point(x, y), rng);
  if (!i || *i == 0) return std::nullopt;
  const bool shifted = movable(path, *i) && rng.chance(kShifted);
  if (!shifted && path.edge_fixed(*i)) return std::nullopt;
  const auto to = covering(at, shifted ? path[*i] : nearest_on_segment(at, path[*i - 1], path[*i]), rng);
  if (!to) return std::nullopt;
  return replaced(path, *i, shifted ? 1 : 0, std::array{*to});
}

/// Where the robot, coming from `from`, covers the point; nullopt: there already.
std::optional<Point> Moves::covering(const Point& at, const Point& from, Rng& rng) const {
  const double far = distance(from, at), reach = width_ * (0.5 - kCloser * rng.unit());
  if (far <= reach) return std::nullopt;
  return free(lerp(at, from, reach / far));
}

/// From an edge and back, so that the rest of the edge stays where it is.
std::optional<Change> Moves::spike(const VertexPath& path, const Point& at, Rng& rng) const {
  const double x = rng.between(-kAbout, kAbout), y = rng.between(-kAbout, kAbout);
  const auto i = nearest_edge(path, at + width_ * Point(x, y), rng);
  if (!i) return std::nullopt;
  const Point &a = path[*i - 1], &b = path[*i], from = nearest_on_segment(at, a, b);
  const auto to = covering(at, from, rng);
  if (!to) return std::nullopt;
  const double base = kMostBase * width_ * rng.unit();
  const auto towards = [&](const Point& end) { return lerp(from, end, base / std::max(base, distance(from, end))); };
  const std::array all{towards(a), *to, towards(b)};
  const std::size_t skipped = all[0] == a ? 1 : 0, end = all[2] == b ? 2 : 3;
  return replaced(path, *i, 0, std::span(all).subspan(skipped, end - skipped));
}

std::optional<Change> Moves::propose(const VertexPath& path, Rng& rng) const {
  std::optional<Change> change;
  for (int k = 0; k < kDraws && !change; ++k) change = drawn(path, rng);
  return change;
}

std::optional<Change> Moves::drawn(const VertexPath& path, Rng& rng) const {
  const bool covering = sizes_.without != AnnealingPart::covering,
             reordering = sizes_.without != AnnealingPart::reordering;
  if (covering && !uncovered_.empty() && rng.chance(kCovering)) return cover(path, rng);
  const std::size_t i = vertex(path, rng);
  std::uint64_t kind = rng.below(100);
  const auto is = [&kind](std::uint64_t share) {
    if (kind < share) return true;
    kind -= share;
    return false;
  };
  if (is(kShiftVertex)) return shift_vertex(path, i, rng);
  if (is(kShiftEdge)) return shift_edge(path, i, rng);
  if (is(kSnap)) return sizes_.without == AnnealingPart::walls ? shift_vertex(path, i, rng) : snap(path, i, rng);
  if (is(kRemove)) return sizes_.cut_short && rng.chance(kCutShort) ? cut_short(path, i, rng) : remove(path, i);
  if (is(kSplit)) return split(path, i, rng);
  if (is(kMerge)) return merge(path, i, rng);
  if (!reordering) return shift_vertex(path, i, rng);
  if (is(kTwoOpt)) return two_opt(path, i, rng);
  return or_opt(path, i, rng);
}

/// `first` is above 0.
Change Moves::replaced(const VertexPath& path, std::size_t first, std::size_t count,
                       std::span<const Point> points) const {
  Change change;
  change.first = first;
  change.last = first + count;
  change.point_count = points.size();
  std::copy(points.begin(), points.end(), change.points.begin());
  const bool goes_on = first + count < path.size();
  for (std::size_t k = first; k < first + count + (goes_on ? 1 : 0); ++k) change.removed.add(path[k - 1], path[k]);
  Point at = path[first - 1];
  for (const Point& p : points) {
    change.added.add(at, p);
    at = p;
  }
  if (goes_on) change.added.add(at, path[first + count]);
  return change;
}

std::optional<Change> Moves::shift_vertex(const VertexPath& path, std::size_t i, Rng& rng) const {
  if (!movable(path, i)) return std::nullopt;
  Point to = path[i];
  const std::uint64_t kind = rng.below(4);
  const bool last = i + 1 == path.size();
  if (kind < 2)
    to += cloud(rng);
  else if (kind == 2 || last)
    to = lerp(to, path[last || rng.chance(0.5) ? i - 1 : i + 1], rng.unit());
  else
    to = lerp(to, nearest_on_segment(to, path[i - 1], path[i + 1]), rng.unit());
  return replaced(path, i, 1, std::array{to});
}

std::optional<Change> Moves::shift_edge(const VertexPath& path, std::size_t i, Rng& rng) const {
  if (!movable(path, i) || !movable(path, i + 1)) return std::nullopt;
  Point by = cloud(rng);
  if (rng.chance(kSideways)) {
    const Point side = perpendicular(path[i + 1] - path[i]);
    const double size = side.squaredNorm();
    if (size > 0) by = by.dot(side) / size * side;
  }
  return replaced(path, i, 2, std::array<Point, 2>{path[i] + by, path[i + 1] + by});
}

std::optional<Change> Moves::snap(const VertexPath& path, std::size_t i, Rng& rng) const {
  if (!movable(path, i)) return std::nullopt;
  const auto here = on_wall(path[i], walls_, width_, rng.chance(0.5));
  if (rng.chance(0.5) && movable(path, i + 1)) {
    const auto next = on_wall(path[i + 1], walls_, width_, rng.chance(0.5));
    if (here || next)
      return replaced(path, i, 2, std::array<Point, 2>{here.value_or(path[i]), next.value_or(path[i + 1])});
  }
  if (!here) return std::nullopt;
  return replaced(path, i, 1, std::array{*here});
}

std::optional<Change> Moves::remove(const VertexPath& path, std::size_t i) const {
  if (!movable(path, i)) return std::nullopt;
  // On its chord a vertex costs nothing, and is of use where a part of the edge should move.
  if (i + 1 < path.size() && distance_to_segment(path[i], path[i - 1], path[i + 1]) < kOnChord * width_)
    return std::nullopt;
  return replaced(path, i, 1, {});
}

/// The vertices after i, up to the partner, are left out: a loop around an obstacle, or a spike of many vertices, which
/// no vertex by itself can leave.
std::optional<Change> Moves::cut_short(const VertexPath& path, std::size_t i, Rng& rng) const {
  const auto other = partner(path, i, rng);
  if (!other) return std::nullopt;
  const auto [before, after] = std::minmax(i, *other);
  if (after < before + 3 || after - before >= Edges::kMost) return std::nullopt;
  for (std::size_t k = before + 1; k < after; ++k)
    if (path.fixed(k)) return std::nullopt;
  return replaced(path, before + 1, after - before - 1, {});
}

std::optional<Change> Moves::split(const VertexPath& path, std::size_t i, Rng& rng) const {
  if (i == 0 || path.edge_fixed(i) || distance(path[i - 1], path[i]) < kLeastSplit * width_) return std::nullopt;
  const Point at = lerp(path[i - 1], path[i], rng.unit());
  return replaced(path, i, 0, std::array<Point, 1>{at + cloud(rng)});
}

std::optional<Change> Moves::merge(const VertexPath& path, std::size_t i, Rng& rng) const {
  if (!movable(path, i) || !movable(path, i + 1)) return std::nullopt;
  return replaced(path, i, 2, std::array{lerp(path[i], path[i + 1], rng.unit())});
}

std::optional<std::size_t> Moves::partner(const VertexPath& path, std::size_t i, Rng& rng) const {
  const double far = kPartner * width_;
  const double x = rng.between(-far, far), y = rng.between(-far, far);
  return path.near(path[i] + Point(x, y), rng);
}

/// The vertices after i, up to the partner, are driven in the opposite order.
std::optional<Change> Moves::two_opt(const VertexPath& path, std::size_t i, Rng& rng) const {
  const auto other = partner(path, i, rng);
  if (!other) return std::nullopt;
  const auto [before, last] = std::minmax(i, *other);
  const bool end = last + 1 == path.size();
  if (last < before + 2 || path.edge_fixed(before + 1)) return std::nullopt;
  if (end ? path.fixed(last) : path.edge_fixed(last + 1)) return std::nullopt;
  Change change;
  change.kind = Change::Kind::reverse;
  change.first = before + 1;
  change.last = last;
  change.removed.add(path[before], path[before + 1]);
  change.added.add(path[before], path[last]);
  if (!end) {
    change.removed.add(path[last], path[last + 1]);
    change.added.add(path[before + 1], path[last + 1]);
  }
  return change;
}

/// Some vertices from i on move between the partner and the vertex after it: a few, or up to one near vertex i, as the
/// lanes of a loop.
std::optional<Change> Moves::or_opt(const VertexPath& path, std::size_t i, Rng& rng) const {
  const auto after = partner(path, i, rng);
  const auto last_of_loop = rng.chance(kLoops) ? partner(path, i, rng) : i + rng.below(kMostMoved);
  const std::size_t last = last_of_loop.value_or(0);
  if (last < i || !after || !movable(path, i) || !movable(path, last)) return std::nullopt;
  if (*after + 1 >= i && *after <= last) return std::nullopt;
  const bool tail = last + 1 == path.size(), to_end = *after + 1 == path.size();
  if (to_end ? path.fixed(*after) : path.edge_fixed(*after + 1)) return std::nullopt;
  Change change;
  change.kind = Change::Kind::relocate;
  change.first = i;
  change.last = last;
  change.after = *after;
  change.turned = rng.chance(0.5);
  change.removed.add(path[i - 1], path[i]);
  if (!tail) {
    change.removed.add(path[last], path[last + 1]);
    change.added.add(path[i - 1], path[last + 1]);
  }
  change.added.add(path[*after], path[change.turned ? last : i]);
  if (!to_end) {
    change.removed.add(path[*after], path[*after + 1]);
    change.added.add(path[change.turned ? i : last], path[*after + 1]);
  }
  return change;
}

}  // namespace oxturn
