// maps/generators/polygon.cpp
// A random simple polygon, from nearly round to strongly non-convex: grown triangle by triangle on a jittered mesh.
//
// Method      Start with one triangle; add a triangle across a border edge if its third corner is new (one corner
//             more), or fill an ear, a triangle with two border edges (one corner less). The polygon stays simple.
// Guarantee   Only triangles whose least height is the narrowest passage are used; a disc of that diameter passes
//             from any of them to the next, so the polygon stays in one piece for the robot.
// Complexity  O(corners log corners)
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  int corners = 40;
  double winding = 0.3;
  double compactness = 0.2;
  double jitter = 0.9;
};

constexpr int kNone = -1;

struct Triangle {
  std::array<int, 3> corner{};                        // counter-clockwise
  std::array<int, 3> neighbour{kNone, kNone, kNone};  // across the edge corner[k], corner[k + 1]
  bool usable = false;
};

struct Net {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

double least_height(const Point& a, const Point& b, const Point& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return cross(b - a, c - a) / std::sqrt(longest);
}

/// A grid of about `points` points, each moved by up to 0.24 of a cell (cells stay convex, so either diagonal is
/// good), cells cut by a random diagonal.
Net net(const Params& p, double points, Rng& rng) {
  const int columns = std::max(1, static_cast<int>(std::sqrt(points * p.width / p.height) - 0.5));
  const int rows = std::max(1, static_cast<int>(std::ceil(points / (columns + 1))) - 1);
  Net m;
  const double dx = p.width / (columns + 0.48 * p.jitter), dy = p.height / (rows + 0.48 * p.jitter);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double x = i + p.jitter * (0.24 + rng.between(-0.24, 0.24));
      const double y = j + p.jitter * (0.24 + rng.between(-0.24, 0.24));
      m.points.emplace_back(x * dx, y * dy);
    }
  const auto at = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      const bool rising = rng.chance(0.5);
      for (const auto& corner : rising ? std::array{std::array{a, b, c}, std::array{a, c, d}}
                                       : std::array{std::array{a, b, d}, std::array{b, c, d}}) {
        Triangle t;
        t.corner = corner;
        const auto q = [&](std::size_t k) { return m.points[static_cast<std::size_t>(corner[k])]; };
        t.usable = least_height(q(0), q(1), q(2)) >= narrowest(p);
        m.triangles.push_back(t);
      }
    }
  struct Side {
    int low, high, triangle, k;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = m.triangles[t].corner[k], b = m.triangles[t].corner[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), static_cast<int>(k)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  for (std::size_t s = 1; s < sides.size(); ++s) {
    const Side &a = sides[s - 1], &b = sides[s];
    if (a.low != b.low || a.high != b.high) continue;
    m.triangles[static_cast<std::size_t>(a.triangle)].neighbour[static_cast<std::size_t>(a.k)] = b.triangle;
    m.triangles[static_cast<std::size_t>(b.triangle)].neighbour[static_cast<std::size_t>(b.k)] = a.triangle;
  }
  return m;
}

class Growth {
 public:
  Growth(const Net& m, Rng& rng) : mesh_(m), rng_(rng), in_(m.triangles.size(), false), used_(m.points.size(), false) {}

  /// A ring with `corners` corners, or nothing if the polygon got stuck.
  std::optional<Ring> ring(const Params& p) {
    std::vector<int> usable;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (mesh_.triangles[t].usable) usable.push_back(static_cast<int>(t));
    if (usable.empty()) return {};
    add(usable[rng_.below(usable.size())]);
    corners_ = 3;
    while (corners_ < p.corners) {
      if (rng_.chance(p.compactness)) fill_an_ear();
      if (!grow(p.winding)) return {};
    }
    return outline();
  }

 private:
  const Triangle& triangle(int t) const { return mesh_.triangles[static_cast<std::size_t>(t)]; }
  bool in(int t) const { return in_[static_cast<std::size_t>(t)]; }

  void add(int t) {
    in_[static_cast<std::size_t>(t)] = true;
    for (const int c : triangle(t).corner) used_[static_cast<std::size_t>(c)] = true;
    // Shuffled, or `winding` would always turn to the same side.
    std::array<int, 3> next = triangle(t).neighbour;
    rng_.shuffle(next);
    for (const int n : next) {
      if (n == kNone || in(n) || !triangle(n).usable) continue;
      int inside = 0;
      for (const int o : triangle(n).neighbour)
        if (o != kNone && in(o)) ++inside;
      (inside == 2 ? ears_ : front_).push_back(n);
    }
  }

  void fill_an_ear() {
    while (!ears_.empty()) {
      const int t = take(ears_, rng_.below(ears_.size()));
      if (in(t)) continue;
      add(t);
      --corners_;
      return;
    }
  }

  bool grow(double winding) {
    while (!front_.empty()) {
      const int t = take(front_, rng_.chance(winding) ? front_.size() - 1 : rng_.below(front_.size()));
      if (in(t)) continue;
      int fresh = 0;
      for (const int c : triangle(t).corner)
        if (!used_[static_cast<std::size_t>(c)]) ++fresh;
      // Not fresh: its third corner is the border's already. It comes back as an ear, or never.
      if (fresh == 0) continue;
      add(t);
      ++corners_;
      return true;
    }
    return false;
  }

  static int take(std::vector<int>& from, std::size_t k) {
    std::swap(from[k], from.back());
    const int t = from.back();
    from.pop_back();
    return t;
  }

  Ring outline() const {
    std::vector<int> next(mesh_.points.size(), kNone);
    int first = kNone;
    for (std::size_t t = 0; t < in_.size(); ++t) {
      if (!in_[t]) continue;
      const Triangle& tr = mesh_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (tr.neighbour[k] != kNone && in(tr.neighbour[k])) continue;
        next[static_cast<std::size_t>(tr.corner[k])] = tr.corner[(k + 1) % 3];
        first = tr.corner[k];
      }
    }
    Ring ring;
    int at = first;
    do {
      ring.push_back(mesh_.points[static_cast<std::size_t>(at)]);
      at = next[static_cast<std::size_t>(at)];
    } while (at != first);
    return ring;
  }

  const Net& mesh_;
  Rng& rng_;
  std::vector<bool> in_, used_;
  std::vector<int> front_, ears_;
  int corners_ = 0;
};

Region make(const Params& p, Rng& rng) {
  check_site("polygon", p, 2);
  // Tight meshes fill the site better but growth may get stuck; then a looser one.
  double points = 1.3 * p.corners + 2;
  for (int attempt = 0; attempt < 12; ++attempt, points *= 1.2) {
    const Net m = net(p, points, rng);
    if (const auto ring = Growth(m, rng).ring(p)) return finished({{{*ring, {}}}}, p);
  }
  refuse("polygon", std::to_string(p.corners) + " corners do not fit in " + number(p.width) + " x " + number(p.height) +
                        " m with passages of " + number(narrowest(p)) +
                        " m; take fewer corners, a larger size or a smaller robot");
}

}  // namespace

GeneratorInfo polygon() {
  return describe_generator<Params>(
      "polygon", "a random simple polygon",
      "one simple polygon without holes, connected for a disc `passage` robot diameters wide",
      with_site<Params>(
          {{"corners", &Params::corners, Range{3, 200000}, "number of corners (without jitter straight ones vanish)"},
           {"winding", &Params::winding, Range{0, 1}, "0: grows everywhere; 1: one long winding arm"},
           {"compactness", &Params::compactness, Range{0, 0.9},
            "how eagerly notches are filled; 0: strongly non-convex"},
           {"jitter", &Params::jitter, Range{0, 1}, "how far corners lie off a grid"}}),
      make);
}

}  // namespace oxturn::generator
