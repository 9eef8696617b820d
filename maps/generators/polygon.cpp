// A random simple polygon, from nearly round to strongly non-convex, grown triangle by triangle on a jittered mesh.
//
// Method      Start with one triangle. Add a triangle across a boundary edge if its third vertex is new (one vertex
//             more), or fill an ear, a triangle with two boundary edges (one vertex less). The polygon stays simple.
// Guarantee   Only triangles whose least height is at least the narrowest passage are used. A disc of that diameter
//             passes from any of them to the next, so the polygon is connected for the robot.
// Complexity  O(vertices log vertices)
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  int corners = 40;
  double winding = 0.3;
  double compactness = 0.2;
  double jitter = 0.9;
};

constexpr double kMostMoved = 0.24;  // cells: jitter of a mesh vertex. Cells stay convex, so both diagonals are usable
constexpr double kFirstDensity = 1.3;  // mesh vertices per vertex of the polygon
constexpr double kLooser = 1.2;        // factor of the density after a failed attempt
constexpr int kAttempts = 12;

struct Triangle {
  std::array<std::size_t, 3> vertex{};                    // counter-clockwise
  std::array<std::optional<std::size_t>, 3> neighbour{};  // across the edge from vertex[k] to vertex[(k + 1) % 3]
  bool usable = false;
};

struct TriangleMesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

double least_height(const Point& a, const Point& b, const Point& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return cross(b - a, c - a) / std::sqrt(longest);
}

/// Finds the neighbours of all triangles by sorting their edges.
void link_neighbours(std::vector<Triangle>& triangles) {
  struct Edge {
    std::size_t low, high, triangle, k;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = triangles[t].vertex[k], b = triangles[t].vertex[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t s = 1; s < edges.size(); ++s) {
    const Edge &a = edges[s - 1], &b = edges[s];
    if (a.low != b.low || a.high != b.high) continue;
    triangles[a.triangle].neighbour[a.k] = b.triangle;
    triangles[b.triangle].neighbour[b.k] = a.triangle;
  }
}

/// A jittered grid of about `points` points whose cells are divided by a random diagonal.
TriangleMesh jittered_mesh(const Params& p, double points, Rng& rng) {
  const int columns = std::max(1, static_cast<int>(std::sqrt(points * p.width / p.height) - 0.5));
  const int rows = std::max(1, static_cast<int>(std::ceil(points / (columns + 1))) - 1);
  TriangleMesh mesh;
  const double dx = p.width / (columns + 2 * kMostMoved * p.jitter), dy = p.height / (rows + 2 * kMostMoved * p.jitter);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double x = i + p.jitter * (kMostMoved + rng.between(-kMostMoved, kMostMoved));
      const double y = j + p.jitter * (kMostMoved + rng.between(-kMostMoved, kMostMoved));
      mesh.points.emplace_back(x * dx, y * dy);
    }
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::size_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      const bool rising = rng.chance(0.5);
      for (const auto& vertex : rising ? std::array{std::array{a, b, c}, std::array{a, c, d}}
                                       : std::array{std::array{a, b, d}, std::array{b, c, d}}) {
        const Point &q0 = mesh.points[vertex[0]], &q1 = mesh.points[vertex[1]], &q2 = mesh.points[vertex[2]];
        mesh.triangles.push_back({vertex, {}, least_height(q0, q1, q2) >= narrowest_passage(p)});
      }
    }
  link_neighbours(mesh.triangles);
  return mesh;
}

/// A polygon that grows on a mesh.
class Growth {
 public:
  Growth(const TriangleMesh& mesh, Rng& rng)
      : mesh_(mesh), rng_(rng), inside_(mesh.triangles.size(), false), used_(mesh.points.size(), false) {}

  /// A ring with as many vertices as asked for; nullopt if the polygon cannot grow so far.
  std::optional<Ring> ring(const Params& p) {
    std::vector<std::size_t> usable;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (mesh_.triangles[t].usable) usable.push_back(t);
    if (usable.empty()) return {};
    add(usable[rng_.below(usable.size())]);
    vertices_ = 3;
    while (vertices_ < p.corners) {
      if (rng_.chance(p.compactness)) fill_an_ear();
      if (!grow(p.winding)) return {};
    }
    return outline();
  }

 private:
  void add(std::size_t t) {
    inside_[t] = true;
    for (const std::size_t v : mesh_.triangles[t].vertex) used_[v] = true;
    // Shuffled; otherwise `winding` would always turn to the same side.
    auto neighbours = mesh_.triangles[t].neighbour;
    rng_.shuffle(neighbours);
    for (const auto& n : neighbours) {
      if (!n || inside_[*n] || !mesh_.triangles[*n].usable) continue;
      int shared = 0;  // boundary edges
      for (const auto& o : mesh_.triangles[*n].neighbour)
        if (o && inside_[*o]) ++shared;
      (shared == 2 ? ears_ : front_).push_back(*n);
    }
  }

  void fill_an_ear() {
    while (!ears_.empty()) {
      const std::size_t t = take(ears_, rng_.below(ears_.size()));
      if (inside_[t]) continue;
      add(t);
      --vertices_;
      return;
    }
  }

  bool grow(double winding) {
    while (!front_.empty()) {
      const std::size_t t = take(front_, rng_.chance(winding) ? front_.size() - 1 : rng_.below(front_.size()));
      if (inside_[t]) continue;
      const auto& vertex = mesh_.triangles[t].vertex;
      // If its third vertex is on the boundary already, it returns as an ear, or never.
      if (std::all_of(vertex.begin(), vertex.end(), [&](std::size_t v) { return used_[v]; })) continue;
      add(t);
      ++vertices_;
      return true;
    }
    return false;
  }

  static std::size_t take(std::vector<std::size_t>& from, std::size_t k) {
    std::swap(from[k], from.back());
    const std::size_t t = from.back();
    from.pop_back();
    return t;
  }

  Ring outline() const {
    std::vector<std::size_t> next(mesh_.points.size());  // along the boundary
    std::size_t first = 0;
    for (std::size_t t = 0; t < inside_.size(); ++t) {
      if (!inside_[t]) continue;
      const Triangle& triangle = mesh_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.neighbour[k] && inside_[*triangle.neighbour[k]]) continue;
        next[triangle.vertex[k]] = triangle.vertex[(k + 1) % 3];
        first = triangle.vertex[k];
      }
    }
    Ring ring;
    std::size_t at = first;
    do {
      ring.push_back(mesh_.points[at]);
      at = next[at];
    } while (at != first);
    return ring;
  }

  const TriangleMesh& mesh_;
  Rng& rng_;
  std::vector<bool> inside_, used_;  // triangles of the polygon; points of those
  std::vector<std::size_t> front_;   // triangles outside with one boundary edge when they were found
  std::vector<std::size_t> ears_;    // with two
  int vertices_ = 0;
};

Region make(const Params& p, Rng& rng) {
  // Dense meshes fill the site better, but growth may get stuck; then a looser mesh is tried.
  double points = kFirstDensity * p.corners + 2;
  for (int attempt = 0; attempt < kAttempts; ++attempt, points *= kLooser) {
    const TriangleMesh mesh = jittered_mesh(p, points, rng);
    if (const auto ring = Growth(mesh, rng).ring(p)) return {{{*ring, {}}}};
  }
  throw_invalid(
      "{} vertices do not fit in {:.4g} x {:.4g} m with passages of {:.4g} m; lower corners, take a larger size "
      "or a smaller robot",
      p.corners, p.width, p.height, narrowest_passage(p));
}

}  // namespace

GeneratorInfo polygon() {
  return describe_site<Params>(
      "polygon", "a random simple polygon",
      "one simple polygon without holes, connected for a disc `passage` robot diameters wide",
      {{"corners", &Params::corners, Range{3, 200000},
        "number of vertices (without jitter, those on a straight line vanish)"},
       {"winding", &Params::winding, Range{0, 1}, "0: grows everywhere; 1: one long winding arm"},
       {"compactness", &Params::compactness, Range{0, 0.9}, "how eagerly notches are filled; 0: strongly non-convex"},
       {"jitter", &Params::jitter, Range{0, 1}, "how far vertices lie off a grid"}},
      make, 2);
}

}  // namespace oxturn::generator
