#include "algorithms/online/star.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/math.hpp"

namespace oxturn {
namespace {

/// How far a wall may be extended, in distances between its two outer hits.
constexpr double kFarthestReach = 10;
constexpr std::size_t kFewestRays = 5;

class Star {
 public:
  Star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules)
      : scan_(scan), direction_(directions), rules_(rules), n_(scan.reading.size()) {
    hit_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) hit_[i] = met(i) ? Point(scan.reading[i] * directions[i]) : Point(0, 0);
    straight_.resize(n_);
    for (std::size_t i = 0; i < n_; ++i) straight_[i] = collinear(i, next(i), next(next(i)));
    const double half = scan.step() / 2;
    cut_ = std::min(scan.lidar.range, rules.apart / (2 * math::sin(half))) * math::cos(half);
  }

  Ring ring(std::vector<Point>* corners) const {
    Ring ring;
    for (std::size_t i = 0; i < n_; ++i) {
      const Wedge wedge = wedge_after(i);
      if (corners != nullptr && wedge.count == 3 && known_corner(wedge)) corners->push_back(wedge.points[1]);
      const Point across = (direction_[i] + direction_[next(i)]).normalized();
      add_cut(ring, wedge, i, across);
    }
    return without_straight_vertices(ring);
  }

 private:
  /// The end of a wedge: a point on each ray, and perhaps one between them.
  struct Wedge {
    Point points[3];
    int count = 2;
  };

  std::size_t next(std::size_t i) const { return i + 1 < n_ ? i + 1 : 0; }
  std::size_t previous(std::size_t i, std::size_t by) const { return (i + n_ - by) % n_; }
  bool met(std::size_t i) const { return std::isfinite(scan_.reading[i]); }

  bool collinear(std::size_t i, std::size_t j, std::size_t k) const {
    if (!met(i) || !met(j) || !met(k)) return false;
    const Point along = hit_[k] - hit_[i];
    const double length = along.norm();
    return length > 4 * rules_.tolerance && std::abs(cross(along, hit_[j] - hit_[i])) <= rules_.tolerance * length;
  }

  struct Wall {
    Point at{0, 0}, along{0, 0};  // `at`: the hit next to the wedge; `along`: away from the wedge
  };
  /// The straight wall that the rays up to i (or from i on) meet, if their last three hits lie in a line.
  std::optional<Wall> wall_before(std::size_t i) const {
    if (!straight_[previous(i, 2)]) return std::nullopt;
    return Wall{hit_[i], hit_[previous(i, 2)] - hit_[i]};
  }
  std::optional<Wall> wall_after(std::size_t i) const {
    if (!straight_[i]) return std::nullopt;
    return Wall{hit_[i], hit_[next(next(i))] - hit_[i]};
  }

  bool known_corner(const Wedge& wedge) const {
    const Point& corner = wedge.points[1];
    const double away = std::max(distance(corner, wedge.points[0]), distance(corner, wedge.points[2]));
    return corner.norm() < cut_ && away <= 2 * rules_.apart;
  }
  bool on(const Wall& wall, const Point& p) const {
    const double length = wall.along.norm();
    return std::abs(cross(wall.along, p - wall.at)) <= rules_.tolerance * length && reaches(wall, p);
  }
  bool reaches(const Wall& wall, const Point& p) const {
    return distance(wall.at, p) <= kFarthestReach * wall.along.norm();
  }

  /// How far along the ray it meets the wall's line; infinity if it does not.
  double meets(const Wall& wall, const Point& direction) const {
    const double turn = cross(direction, wall.along);
    const double t = turn == 0 ? -1 : cross(wall.at, wall.along) / turn;
    return t > 0 ? t : std::numeric_limits<double>::infinity();
  }

  Wedge wedge_after(std::size_t i) const {
    const std::size_t j = next(i);
    const Point &u = direction_[i], &v = direction_[j];
    const double range = scan_.lidar.range;
    if (!met(i) && !met(j)) return {{range * u, range * v, {}}};
    const auto left = met(i) ? wall_before(i) : std::nullopt, right = met(j) ? wall_after(j) : std::nullopt;
    const Point &p = hit_[i], &q = hit_[j];
    if (met(i) && met(j) && ((left && on(*left, q)) || (right && on(*right, p)))) return {{p, q, {}}};

    if (left && right) {
      const double turn = cross(left->along, right->along);
      const Point corner =
          turn == 0 ? Point(0, 0) : Point(left->at + cross(right->at - left->at, right->along) / turn * left->along);
      if (cross(u, corner) > 0 && cross(corner, v) > 0 && reaches(*left, corner) && reaches(*right, corner)) {
        if (cross(q - p, corner - p) <= 0) return {{p, q, {}}};
        return {{p, corner, q}, 3};
      }
    }
    // One wall hides the other: it may continue up to the next ray, in front of whatever that ray met.
    const double a = met(i) ? scan_.reading[i] : range, b = met(j) ? scan_.reading[j] : range;
    const double keep = std::max(0.0, 1 - rules_.caution * scan_.step());
    if (left)
      if (const double t = meets(*left, v); t <= b * (right || !met(j) ? 1 : keep) && reaches(*left, t * v))
        return {{p, t * v, {}}};
    if (right)
      if (const double t = meets(*right, u); t <= a * (left || !met(i) ? 1 : keep) && reaches(*right, t * u))
        return {{t * u, q, {}}};
    const double depth = std::min(a, b) * keep;
    return {{depth * u, depth * v, {}}};
  }

  /// Adds the wedge's end, cut by the line across it where the rays are too far apart.
  void add_cut(Ring& ring, const Wedge& wedge, std::size_t i, const Point& across) const {
    const auto beyond = [&](const Point& p) { return p.dot(across) > cut_; };
    const auto at_cut = [&](const Point& direction) { return Point(cut_ / direction.dot(across) * direction); };
    if (beyond(wedge.points[0])) ring.push_back(at_cut(direction_[i]));
    for (int k = 0; k < wedge.count; ++k) {
      const Point& p = wedge.points[k];
      if (k > 0 && beyond(p) != beyond(wedge.points[k - 1])) {
        const Point& o = wedge.points[k - 1];
        const double d = o.dot(across), e = p.dot(across);
        ring.push_back(lerp(o, p, (cut_ - d) / (e - d)));
      }
      if (!beyond(p)) ring.push_back(p);
    }
    if (beyond(wedge.points[wedge.count - 1])) ring.push_back(at_cut(direction_[next(i)]));
  }

  /// Hits along one wall become one edge.
  Ring without_straight_vertices(const Ring& ring) const {
    Ring kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point& p = ring[k];
      if (!kept.empty() && distance(kept.back(), p) <= rules_.tolerance) continue;
      if (kept.size() >= 2 && k + 1 < ring.size()) {
        const Point& a = kept[kept.size() - 2];
        const Point along = p - a, before = kept.back() - a;
        const double length = along.norm();
        if (before.dot(along) > 0 && before.norm() < length &&
            std::abs(cross(along, before)) <= rules_.tolerance * length)
          kept.pop_back();
      }
      kept.push_back(p);
    }
    return kept;
  }

  const Scan& scan_;
  const std::vector<Point>& direction_;
  StarRules rules_;
  std::size_t n_;
  std::vector<Point> hit_;      // relative to the eye
  std::vector<bool> straight_;  // whether hits i, i + 1, i + 2 lie in a line
  double cut_ = 0;
};

}  // namespace

Ring star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules, std::vector<Point>* corners) {
  if (scan.reading.size() < kFewestRays) return {};
  return Star(scan, directions, rules).ring(corners);
}

Ring noisy_star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules, double margin) {
  const std::size_t n = scan.reading.size();
  if (n < kFewestRays) return {};
  const double farthest = std::min(scan.lidar.range, rules.apart / (2 * math::sin(scan.step() / 2)));
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double least = std::min({scan.reading[i], scan.reading[(i + 1) % n], scan.reading[(i + n - 1) % n]});
    const double safe = std::isfinite(least) ? least * (1 - rules.caution * scan.step()) - margin : scan.lidar.range;
    ring.push_back(std::clamp(safe, 0.0, farthest) * directions[i]);
  }
  return ring;
}

}  // namespace oxturn
