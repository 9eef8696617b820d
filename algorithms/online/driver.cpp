#include "algorithms/online/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "algorithms/lattice/grid_graph.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

constexpr double kLookAhead = 10;    // scan steps for which the rest of a motion is checked
constexpr int kScansWithNoise = 10;  // at one position
constexpr double kGrown = 1.02;      // times its length when last published: the path is published again

/// From the start along the tether to the point nearest to the anchor that the robot can reach. Empty if that is the
/// start.
Polyline path_along_tether(const Problem& truth) {
  try {
    const TetherSpace tether(truth, "an online planner");
    const EdgeIndex& walls = tether.cut_problem().walls();
    Point end = truth.anchor();
    if (!walls.contains(end))
      if (const auto hit = walls.nearest(end)) end = hit->point;
    auto path = tether.cut_problem().transit().path(truth.start(), end);  // on it the tether is the geodesic
    return path && length(*path) > 0 ? std::move(*path) : Polyline{};
  } catch (const Infeasible&) {
    return {};  // the start lies on the cut: the tether could lie in two ways
  }
}

/// p, or the nearest point of the region if that is nearer than `within`.
std::optional<Point> moved_into(const Region& region, const Point& p, double within) {
  const EdgeIndex edges(region);
  if (edges.contains(p)) return p;
  const auto hit = edges.nearest(p, within);
  return hit ? std::optional(hit->point) : std::nullopt;
}

/// nullopt where the start is too near to a wall, or the robot does not fit at all.
std::optional<Problem> possible_problem(const Map& map, const Robot& robot, const Point& start,
                                        const std::optional<Point>& anchor) {
  try {
    return Problem(map, robot, start, anchor);
  } catch (const std::invalid_argument&) { return std::nullopt; }
}

}  // namespace

Polyline View::path_from_start() const {
  Polyline points{start};
  for (const Leg& leg : path.legs) points.insert(points.end(), leg.points.begin() + 1, leg.points.end());
  return points;
}

/// One run. The only class that knows both the truth and the view.
class Drive final : public OnlineRobot {
 public:
  Drive(const Problem& truth, Context& context)
      : truth_(truth),
        context_(context),
        lidar_(truth.map().free, *truth.robot().lidar),
        noise_(context.rng().bits()),
        view_(truth.robot(), truth.start(), truth.anchor()) {
    const Robot& robot = truth.robot();
    scan_step_ = robot_size(robot);
    radius_ = std::max(0.0, robot.radius - truth.tolerance());
    if (!robot.tether) return;
    tether_ = tether_at_start(truth);
    if (truth.anchor() != truth.start()) view_.path_along_tether = path_along_tether(truth);
  }

  Path run(const std::function<void(OnlineRobot&, Context&)>& program) {
    scan();
    program(*this, context_);
    const Path& path = view_.path;
    if (view_.driven > published_) context_.publish(path);
    context_.record("explored_share", explored_share());
    context_.record("replans", static_cast<double>(replans_));
    context_.record("scans", static_cast<double>(scans_));
    if (path.legs.empty())
      throw Infeasible(fmt::format("the lidar shows robot '{}' nowhere to go from its start ({:.6g}, {:.6g})",
                                   truth_.robot().name, truth_.start().x(), truth_.start().y()));
    return path;
  }

  const View& view() const override { return view_; }

  bool go(const Motion& motion) override {
    const bool arrived = drive(motion);
    if (view_.driven > kGrown * published_) {
      context_.publish(view_.path);
      published_ = view_.driven;
    }
    return arrived;
  }

 private:
  /// A scan, unless there have been enough at this position.
  void scan() {
    since_scan_ = 0;
    int& before = scans_at_[square_of_pose()];
    const bool noisy = truth_.robot().lidar->noise > 0;
    if (before < (noisy ? kScansWithNoise : 1)) scan_here(before);
  }
  void scan_here(int& before) {
    ++before;
    view_.belief.add(lidar_.scan(view_.pose, noise_));
    seen_from_ = view_.pose;
    ++scans_;
  }
  /// Of a lattice of half a scan step.
  std::pair<long long, long long> square_of_pose() const {
    const Point at = (view_.pose - truth_.start()) / (scan_step_ / 2);
    return {std::llround(at.x()), std::llround(at.y())};
  }

  bool free(const Point& a, const Point& b) const { return view_.belief.free_for(a, b, radius_); }

  /// Free as believed; if not, one more scan from here decides.
  bool free_from_here(const Point& to) {
    if (free(view_.pose, to)) return true;
    if (seen_from_ == view_.pose) return false;
    since_scan_ = 0;
    scan_here(scans_at_[square_of_pose()]);
    return free(view_.pose, to);
  }

  /// Pulls the tether along if it is long enough.
  bool tether_allows(const Point& to) {
    if (!tether_) return true;
    TautTether pulled = *tether_;
    pulled.drive(to);
    if (pulled.length() > truth_.robot().tether->length + truth_.tolerance()) return false;
    tether_ = std::move(pulled);
    return true;
  }

  /// Whether the motion is free from the pose on, up to kLookAhead.
  bool free_ahead(const Polyline& points, std::size_t next) const {
    Point from = view_.pose;
    double ahead = kLookAhead * scan_step_;
    for (std::size_t k = next; k < points.size() && ahead > 0; ++k) {
      const double length = distance(from, points[k]);
      const Point to = length > ahead ? lerp(from, points[k], ahead / length) : points[k];
      if (!free(from, to)) return false;
      ahead -= length;
      from = to;
    }
    return true;
  }

  /// False if the robot was stopped.
  bool drive(const Motion& motion) {
    view_.reached = 0;
    std::uint64_t lost = view_.belief.lost();
    for (std::size_t k = 0; k < motion.points.size(); ++k) {
      if (!drive_to(motion, k, lost)) return false;
      view_.reached = k + 1;
    }
    if (since_scan_ > 0) scan();
    return true;
  }

  /// To point k of the motion, in pieces from scan to scan. `lost`: Belief::lost() when the rest was last checked.
  bool drive_to(const Motion& motion, std::size_t k, std::uint64_t& lost) {
    const Point to = motion.points[k];
    // Back over the segment by which it came: free, whatever is believed by now.
    const bool back = view_.pose == came_to_ && to == came_from_;
    if (!back) came_from_ = view_.pose;
    while (view_.pose != to) {
      if (context_.cancelled()) return false;
      const double left = distance(view_.pose, to), piece = scan_step_ - since_scan_;
      const Point at = piece >= left ? to : lerp(view_.pose, to, piece / left);
      if ((!back && !free_from_here(at)) || !tether_allows(at)) return refuse();
      move(at, motion.tool);
      came_to_ = at;
      if (since_scan_ < scan_step_ * (1 - 1e-9)) continue;
      scan();
      if (view_.belief.lost() == lost) continue;
      lost = view_.belief.lost();
      if (!back && !free_ahead(motion.points, k)) return refuse();
    }
    return true;
  }
  bool refuse() {
    ++replans_;
    return false;
  }

  void move(const Point& to, bool tool) {
    const Point from = view_.pose;
    const double length = distance(from, to);
    since_scan_ += length;
    view_.driven += length;
    view_.pose = to;
    Path& path = view_.path;
    if (path.legs.empty() || path.legs.back().tool != tool)
      path.legs.push_back({tool, {from, to}});
    else
      path.legs.back().points.push_back(to);
  }

  double explored_share() const {
    const double all = area(truth_.target());
    if (!(all > 0)) return 1;
    return std::min(1.0, area(intersect(view_.belief.region(0), truth_.target())) / all);
  }

  const Problem& truth_;
  Context& context_;
  LidarSimulator lidar_;
  Rng noise_;
  View view_;
  double scan_step_, radius_, since_scan_ = 0, published_ = 0;
  std::size_t replans_ = 0, scans_ = 0;
  std::map<std::pair<long long, long long>, int> scans_at_;  // by square_of_pose()
  Point seen_from_{0, 0};                                    // the last scan
  std::optional<TautTether> tether_;                         // in truth
  Point came_from_{0, 0}, came_to_{0, 0};                    // the last straight segment driven
};

Path drive_online(const Problem& truth, const std::function<void(OnlineRobot&, Context&)>& program, Context& context) {
  if (!truth.robot().lidar)
    throw Unsupported(fmt::format("robot '{}' has no lidar, which an online planner sees by; give it range and rays",
                                  truth.robot().name));
  if (!truth.robot().footprint.empty())
    throw Unsupported(
        fmt::format("robot '{}' has a polygonal footprint; what a lidar shows is judged for discs only, so "
                    "give it a radius instead",
                    truth.robot().name));
  return Drive(truth, context).run(program);
}

std::optional<Problem> believed_problem(const View& view, const Point& start, int level) {
  Robot robot = view.robot;
  const Map map{"belief", view.belief.region(level), "belief", "belief"};
  if (map.free.empty()) return std::nullopt;
  const double near = 5 * view.belief.cell() * (1 << level);
  std::optional<Point> anchor;
  if (robot.tether) {
    anchor = moved_into(map.free, view.anchor, near);
    if (!anchor) return std::nullopt;
    robot.tether->length -= distance(*anchor, view.anchor);
    if (robot.tether->length <= 0) return std::nullopt;
  }
  if (auto problem = possible_problem(map, robot, start, anchor)) return problem;
  const Region space =
      robot.radius > 0 ? erode(map.free, robot.radius, robot.tool_width / 1000, Bound::inside) : map.free;
  if (space.empty()) return std::nullopt;
  const auto from = moved_into(space, start, near);
  return from ? possible_problem(map, robot, *from, anchor) : std::nullopt;
}

}  // namespace oxturn
