#include "algorithms/smoothing/connection.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace oxturn {
namespace {

constexpr double kRhos[] = {2, 2.25, 2.5, 3, 3.5, 4, 5};  // radii
constexpr double kAllowed = 1.005;                        // of the greatest curvature; half of it is for the sampling
constexpr double kDetour = 8 * kPi;                       // radii, over the distance
constexpr std::size_t kMostPoints = 32;                   // of a person's Bézier curve
constexpr double kKink = 1e-3, kGap = 1e-6;               // radians; radii

/// Tries one curve after the other.
class Search {
 public:
  Search(const Pose& from, const Pose& to, const ConnectionOptions& options)
      : from_(from), to_(to), options_(options), longest_(distance(from.at, to.at) + kDetour * options.radius) {}

  Connection run() {
    const ConnectionKind first = options_.first;
    const bool found = (first <= ConnectionKind::spiro && try_spiro()) ||
                       (first <= ConnectionKind::bezier && try_bezier()) ||
                       (first <= ConnectionKind::clothoid && try_clothoids());
    if (!found && (empty_ || !best_.allowed)) try_dubins();
    return std::move(best_);
  }

 private:
  bool try_spiro() {
    for (const double rho : kRhos) {
      const double metres = rho * options_.radius;
      std::vector<Point> through = spiro_control_points(from_, to_, metres, options_.rule);
      auto curve = spiro_curve(from_, to_, through, metres);
      if (curve && options_.rule == SpiroRule::literal) {
        const double curvature = largest_curvature(*curve);
        best_ = {std::move(*curve), ConnectionKind::spiro, std::move(through), curvature};
        return true;
      }
      // Without control points rho is but the distance of the points that fix the headings.
      const bool gentle = through.empty();
      if (curve && offer(std::move(*curve), ConnectionKind::spiro, std::move(through))) return true;
      if (gentle) break;
    }
    return false;
  }
  bool try_bezier() {
    Bezier quintic = quintic_connection(from_, to_, options_.radius);
    std::vector<Point> inner(quintic.points.begin() + 1, quintic.points.end() - 1);
    return offer({from_, to_, {std::move(quintic)}}, ConnectionKind::bezier, std::move(inner));
  }
  bool try_clothoids() {
    for (const auto& word : continuous_dubins_words(from_, to_, TurnShape(options_.radius, options_.sharpness)))
      if (offer({from_, to_, {word.begin(), word.end()}}, ConnectionKind::clothoid)) return true;
    return false;
  }
  bool try_dubins() {
    const DubinsWords words = dubins_words(from_, to_, options_.radius);
    for (const Word& word : words.all())
      if (offer(smooth_curve(curve_of(word, from_, to_, options_.radius)), ConnectionKind::dubins)) return true;
    return false;
  }

  /// The curve becomes the result if it is the first one that keeps the radius, or an allowed one. True: it will do.
  bool offer(SmoothCurve curve, ConnectionKind kind, std::vector<Point> through = {}) {
    const double curvature = largest_curvature(curve);
    const JointErrors errors = joint_errors(curve);
    const bool exact = errors.heading <= kKink && errors.position <= kGap * options_.radius;
    const bool drivable = finite(curve) && curvature * options_.radius <= kAllowed && exact;
    // The shortest of the last kind is the only one that must do.
    const bool last_resort = kind == ConnectionKind::dubins && empty_;
    if (!last_resort && !drivable) return false;
    const double metres = length(curve);
    const bool have_one = !empty_ && best_.allowed;
    if ((!last_resort && metres > longest_) || (have_one && metres >= length_)) return false;
    const bool allowed = !options_.allowed || options_.allowed(curve);
    if (!allowed && !empty_) return false;
    best_ = {std::move(curve), kind, std::move(through), curvature, allowed};
    length_ = metres;
    empty_ = false;
    return allowed && !options_.shortest;
  }

  const Pose &from_, &to_;
  const ConnectionOptions& options_;
  double longest_;
  bool empty_ = true;
  double length_ = 0;  // of the best
  Connection best_;
};

bool all_finite(const Pose& pose) { return finite(pose.at) && std::isfinite(pose.heading); }

}  // namespace

Connection smooth_connection(const Pose& from, const Pose& to, const ConnectionOptions& options) {
  if (!all_finite(from) || !all_finite(to))
    throw std::invalid_argument("a connection needs two poses with finite coordinates and headings");
  if (!(options.radius > 0) || !std::isfinite(options.radius))
    throw std::invalid_argument("a connection needs a least turning radius above 0");
  return Search(from, to, options).run();
}

std::optional<Connection> edited_connection(const Pose& from, const Pose& to, ConnectionKind kind,
                                            const std::vector<Point>& points, double radius) {
  std::optional<SmoothCurve> curve;
  if (kind == ConnectionKind::spiro) {
    curve = spiro_curve(from, to, points, 2 * radius);
  } else if (kind == ConnectionKind::bezier) {
    if (points.size() > kMostPoints)
      throw std::invalid_argument(
          fmt::format("a Bézier connection has {} control points, expected at most {}", points.size(), kMostPoints));
    Bezier bezier{{from.at}};
    bezier.points.insert(bezier.points.end(), points.begin(), points.end());
    bezier.points.push_back(to.at);
    curve = SmoothCurve{from, to, {std::move(bezier)}};
  } else {
    throw std::invalid_argument("only spiro and Bézier connections have control points");
  }
  if (!curve || !finite(*curve)) return std::nullopt;
  const double curvature = largest_curvature(*curve);
  return Connection{std::move(*curve), kind, points, curvature};
}

}  // namespace oxturn
