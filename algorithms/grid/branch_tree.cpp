#include "algorithms/grid/branch_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/cell_ring.hpp"

namespace oxturn {
namespace {

constexpr double kStraight = 1e-9;         // radians; less than that is rounding
constexpr double kSameDistance = 0x1p-20;  // bucket sides; distances that are closer differ by rounding only
constexpr int kMostRings = 24;             // of buckets in which a visible vertex is searched
constexpr double kMostBuckets = 1e6;       // also along one axis

int clamped(double v, int n) { return static_cast<int>(std::clamp(v, 0.0, n - 1.0)); }

}  // namespace

BranchTree::BranchTree(const Problem& problem, double spacing, LatticePaths& paths) : problem_(problem), paths_(paths) {
  const Box box = bounding_box(problem.configuration_space());
  const Point size = box.size();
  low_ = box.low;
  side_ = std::max({spacing, std::sqrt(size.x() * size.y() / kMostBuckets), size.maxCoeff() / kMostBuckets});
  columns_ = static_cast<int>(size.x() / side_) + 1;
  rows_ = static_cast<int>(size.y() / side_) + 1;
  newest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone);
}

int BranchTree::bucket_column(const Point& p) const { return clamped((p.x() - low_.x()) / side_, columns_); }
int BranchTree::bucket_row(const Point& p) const { return clamped((p.y() - low_.y()) / side_, rows_); }

/// Returns the piece's last vertex.
std::uint32_t BranchTree::add(const Polyline& piece, Kind kind, std::uint32_t parent) {
  const bool closed = kind == Kind::round && piece.size() > 1;
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  vertices_.insert(vertices_.end(), piece.begin(), closed ? piece.end() - 1 : piece.end());
  const auto end = static_cast<std::uint32_t>(vertices_.size());
  first_attached_.resize(end, kNone);
  for (std::uint32_t v = first; v < end; ++v) older_.push_back(std::exchange(newest_[bucket(vertices_[v])], v));
  const auto id = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({first, end, parent, closed, kNone});
  if (parent != kNone) {
    pieces_.back().next = first_attached_[parent];
    first_attached_[parent] = id;
  }
  return end - 1;
}

void BranchTree::begin(const Polyline& piece, Kind kind) { add(piece, kind, kNone); }

// Outwards, ring by ring of buckets. Vertices that are certainly nearer than those of the next ring are tried in the
// order of their distance, the oldest first of those at the same distance.
std::uint32_t BranchTree::nearest_visible(const Point& p) const {
  const EdgeIndex& walls = problem_.walls();
  std::vector<std::pair<double, std::uint32_t>> waiting;  // a heap of distances, in steps of kSameDistance
  const auto later = [](const auto& a, const auto& b) { return a > b; };
  const double step = kSameDistance * side_;
  const int last = std::min(std::max(columns_, rows_), kMostRings);
  for (int ring = 0; ring <= last; ++ring) {
    for_each_in_ring(bucket_column(p), bucket_row(p), ring, columns_, rows_, [&](int i, int j) {
      for (std::uint32_t v = newest_[bucket(i, j)]; v != kNone; v = older_[v]) {
        waiting.emplace_back(std::round(distance(vertices_[v], p) / step), v);
        std::push_heap(waiting.begin(), waiting.end(), later);
      }
    });
    const double certain = ring * side_ / step - 1;
    while (!waiting.empty() && waiting.front().first <= certain) {
      const std::uint32_t v = waiting.front().second;
      if (walls.contains(p, vertices_[v])) return v;
      std::pop_heap(waiting.begin(), waiting.end(), later);
      waiting.pop_back();
    }
  }
  return kNone;
}

BranchTree::Attached BranchTree::attach(const Polyline& piece, Kind kind) {
  const std::uint32_t visible = nearest_visible(piece.front());
  if (visible != kNone) {
    add(piece, kind, visible);
    return Attached::straight;
  }
  std::optional<Connection> found = path_over_lattice(piece.front());
  if (!found) found = path_among_walls(piece.front());
  if (!found) return Attached::not_at_all;
  std::reverse(found->path.begin(), found->path.end());
  attach_by(found->path, found->vertex, piece, kind);
  return Attached::by_path;
}

BranchTree::Attached BranchTree::attach(const Polyline& piece, Kind kind, const Polyline& path) {
  const std::uint32_t visible = nearest_visible(piece.front());
  if (visible != kNone)
    add(piece, kind, visible);
  else
    attach_by(path, vertex_at(path.front()), piece, kind);
  return visible != kNone ? Attached::straight : Attached::by_path;
}

/// The inner vertices of the path, from the tree outwards, are a chain to whose end the piece is attached.
void BranchTree::attach_by(const Polyline& path, std::uint32_t vertex, const Polyline& piece, Kind kind) {
  const Polyline chain(path.begin() + 1, path.end() - 1);
  if (!chain.empty()) vertex = add(chain, Kind::chain, vertex);
  add(piece, kind, vertex);
}

std::uint32_t BranchTree::vertex_at(const Point& p) const {
  std::uint32_t v = newest_[bucket(p)];
  while (v != kNone && vertices_[v] != p) v = older_[v];
  return v;
}

std::optional<BranchTree::Connection> BranchTree::path_over_lattice(const Point& p) {
  auto found = paths_.nearest(p, [this](std::size_t node) { return vertex_at(paths_.centre(node)) != kNone; });
  if (!found) return std::nullopt;
  return Connection{vertex_at(paths_.centre(found->node)), std::move(found->path)};
}

std::optional<BranchTree::Connection> BranchTree::path_among_walls(const Point& p) {
  if (!among_walls_) among_walls_ = std::make_unique<NearestComponent>(problem_);
  for (; known_ < vertices_.size(); ++known_) among_walls_->add(vertices_[known_], static_cast<int>(known_), known_);
  auto found = among_walls_->from(p);
  if (!found) return std::nullopt;
  return Connection{static_cast<std::uint32_t>(found->id), std::move(found->path)};
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> BranchTree::edges() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
  for (const Piece& piece : pieces_) {
    if (piece.parent != kNone) all.emplace_back(piece.parent, piece.first);
    for (std::uint32_t v = piece.first; v + 1 < piece.end; ++v) all.emplace_back(v, v + 1);
  }
  return all;
}

// Up to rounding: nodes along an edge are hardly ever exactly on it.
bool BranchTree::straight_on(const Point& a, const Point& b, const Point& c) {
  const Point before = b - a, after = c - b;
  return before.dot(after) > 0 && std::abs(cross(before, after)) <= kStraight * before.norm() * after.norm();
}

/// Depth-first along the pieces.
class BranchTree::Around {
 public:
  explicit Around(const BranchTree& tree) : tree_(tree) {
    path_.reserve(tree.vertices_.size());  // about as many points
  }

  Polyline run() {
    if (!tree_.pieces_.empty()) enter(0);
    while (!open_.empty()) {
      Visit& here = open_.back();
      const Piece& piece = tree_.pieces_[here.piece];
      if (here.branch != kNone) {
        const std::uint32_t branch = here.branch;
        here.branch = tree_.pieces_[branch].next;
        enter(branch);  // invalidates `here`
      } else if (here.vertex + 1 < piece.end) {
        drive_to(++here.vertex);
        here.branch = tree_.first_attached_[here.vertex];
      } else {
        leave(piece);
      }
    }
    return std::move(path_);
  }

 private:
  struct Visit {
    std::uint32_t piece, vertex, branch;  // where the robot is, and the next branch to take there
  };
  void enter(std::uint32_t piece) {
    const std::uint32_t first = tree_.pieces_[piece].first;
    drive_to(first);
    open_.push_back({piece, first, tree_.first_attached_[first]});
  }
  void leave(const Piece& piece) {
    if (piece.closed)
      drive_to(piece.first);
    else
      for (std::uint32_t v = piece.end - 1; v-- > piece.first;) drive_to(v);
    if (piece.parent != kNone) drive_to(piece.parent);
    open_.pop_back();
  }
  void drive_to(std::uint32_t vertex) {
    const Point& p = tree_.vertices_[vertex];
    if (!path_.empty() && path_.back() == p) return;
    const std::size_t n = path_.size();
    if (n >= 2 && straight_on(path_[n - 2], path_[n - 1], p))
      path_.back() = p;
    else
      path_.push_back(p);
  }

  const BranchTree& tree_;
  Polyline path_;
  std::vector<Visit> open_;
};

Polyline BranchTree::path_around() {
  newest_ = {};
  older_ = {};
  return Around(*this).run();
}

}  // namespace oxturn
