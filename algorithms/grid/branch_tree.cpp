#include "algorithms/grid/branch_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/predicates.hpp"

namespace oxturn {

BranchTree::BranchTree(const Problem& problem, double spacing, LatticePaths& ways) : problem_(problem), ways_(ways) {
  const Box box = bounding_box(problem.configuration_space());
  const Point size = box.size();
  low_ = box.low;
  side_ = std::max({spacing, std::sqrt(size.x() * size.y() / 1e6), size.maxCoeff() / 1e6});
  columns_ = static_cast<int>(size.x() / side_) + 1;
  rows_ = static_cast<int>(size.y() / side_) + 1;
  newest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone);
}

namespace {
int clamped(double v, int n) { return static_cast<int>(std::clamp(v, 0.0, n - 1.0)); }
}  // namespace

std::size_t BranchTree::bucket(const Point& p) const {
  const Point at = (p - low_) / side_;
  return bucket(clamped(at.x(), columns_), clamped(at.y(), rows_));
}

std::uint32_t BranchTree::add(const Polyline& piece, Kind kind, std::uint32_t parent) {
  const bool once = kind == Kind::round && piece.size() > 1;
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  vertices_.insert(vertices_.end(), piece.begin(), once ? piece.end() - 1 : piece.end());
  const auto end = static_cast<std::uint32_t>(vertices_.size());
  first_attached_.resize(end, kNone);
  for (std::uint32_t v = first; v < end; ++v) older_.push_back(std::exchange(newest_[bucket(vertices_[v])], v));
  const auto id = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({first, end, parent, once, kNone});
  if (parent != kNone) {
    pieces_.back().next = first_attached_[parent];
    first_attached_[parent] = id;
  }
  return end - 1;
}

void BranchTree::begin(const Polyline& piece, Kind kind) { add(piece, kind, kNone); }

constexpr int kFarthest = 24;  // rings

// Rings of buckets outwards; what lies nearer than the next ring is looked at in order of distance.
std::uint32_t BranchTree::nearest_visible(const Point& p) const {
  const EdgeIndex& walls = problem_.walls();
  const Point at = (p - low_) / side_;
  const int ci = clamped(at.x(), columns_), cj = clamped(at.y(), rows_);
  std::vector<std::pair<double, std::uint32_t>> waiting;
  const auto later = [](const auto& a, const auto& b) { return a > b; };
  const int last = std::min(std::max(columns_, rows_), kFarthest);
  for (int ring = 0; ring <= last; ++ring) {
    const auto collect = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return;
      for (std::uint32_t v = newest_[bucket(i, j)]; v != kNone; v = older_[v]) {
        waiting.emplace_back((vertices_[v] - p).squaredNorm(), v);
        std::push_heap(waiting.begin(), waiting.end(), later);
      }
    };
    if (ring == 0) collect(ci, cj);
    for (int k = -ring; ring > 0 && k <= ring; ++k) {
      collect(ci + k, cj - ring);
      collect(ci + k, cj + ring);
      if (k == -ring || k == ring) continue;
      collect(ci - ring, cj + k);
      collect(ci + ring, cj + k);
    }
    const double sure = ring * side_;
    while (!waiting.empty() && waiting.front().first <= sure * sure) {
      const std::uint32_t v = waiting.front().second;
      if (walls.contains(p, vertices_[v])) return v;
      std::pop_heap(waiting.begin(), waiting.end(), later);
      waiting.pop_back();
    }
  }
  return kNone;
}

BranchTree::Hung BranchTree::hang(const Polyline& piece, Kind kind) {
  const std::uint32_t visible = nearest_visible(piece.front());
  if (visible != kNone) {
    add(piece, kind, visible);
    return Hung::straight;
  }
  std::optional<Way> way = path_over_lattice(piece.front());
  if (!way) way = path_among_walls(piece.front());
  if (!way) return Hung::not_at_all;
  // Seen from the tree: the way's corners are a chain of their own, at whose end the piece hangs.
  Polyline corners(way->from.rbegin() + 1, way->from.rend() - 1);
  std::uint32_t parent = way->vertex;
  if (!corners.empty()) parent = add(corners, Kind::chain, parent);
  add(piece, kind, parent);
  return Hung::by_path;
}

std::uint32_t BranchTree::vertex_at(const Point& p) const {
  std::uint32_t v = newest_[bucket(p)];
  while (v != kNone && vertices_[v] != p) v = older_[v];
  return v;
}

std::optional<BranchTree::Way> BranchTree::path_over_lattice(const Point& p) {
  auto found = ways_.nearest(p, [this](std::size_t at) { return vertex_at(ways_.place(at)) != kNone; });
  if (!found) return std::nullopt;
  return Way{vertex_at(ways_.place(found->node)), std::move(found->way)};
}

std::optional<BranchTree::Way> BranchTree::path_among_walls(const Point& p) {
  if (!by_path_) by_path_ = std::make_unique<NearestComponent>(problem_);
  for (; known_ < vertices_.size(); ++known_) by_path_->add(vertices_[known_], static_cast<int>(known_), known_);
  auto found = by_path_->from(p);
  if (!found) return std::nullopt;
  return Way{static_cast<std::uint32_t>(found->id), std::move(found->path)};
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> BranchTree::edges() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const Piece& piece : pieces_) {
    if (piece.parent != kNone) all.emplace_back(piece.parent, piece.first);
    for (std::uint32_t v = piece.first; v + 1 < piece.end; ++v) all.emplace_back(v, v + 1);
  }
  return all;
}

bool BranchTree::straight_on(const Point& a, const Point& b, const Point& c) {
  return (b - a).dot(c - b) > 0 && orientation(a, b, c) == 0;
}

Polyline BranchTree::way_round() {
  newest_ = {};
  older_ = {};
  Polyline way;
  way.reserve(vertices_.size());  // about as many
  const auto drive = [&](const Point& p) {
    if (!way.empty() && way.back() == p) return;
    const std::size_t n = way.size();
    if (n >= 2 && straight_on(way[n - 2], way[n - 1], p))
      way.back() = p;
    else
      way.push_back(p);
  };
  struct Visit {
    std::uint32_t piece, vertex, hung;  // where it stands, and the next branch to take there
  };
  std::vector<Visit> open;
  const auto enter = [&](std::uint32_t piece) {
    const std::uint32_t first = pieces_[piece].first;
    drive(vertices_[first]);
    open.push_back({piece, first, first_attached_[first]});
  };
  if (!pieces_.empty()) enter(0);
  while (!open.empty()) {
    Visit& here = open.back();
    const Piece& piece = pieces_[here.piece];
    if (here.hung != kNone) {
      const std::uint32_t branch = here.hung;
      here.hung = pieces_[branch].next;
      enter(branch);  // `here` is stale now
    } else if (here.vertex + 1 < piece.end) {
      drive(vertices_[++here.vertex]);
      here.hung = first_attached_[here.vertex];
    } else {
      if (piece.once)
        drive(vertices_[piece.first]);
      else
        for (std::uint32_t v = piece.end - 1; v-- > piece.first;) drive(vertices_[v]);
      if (piece.parent != kNone) drive(vertices_[piece.parent]);
      open.pop_back();
    }
  }
  return way;
}

}  // namespace oxturn
