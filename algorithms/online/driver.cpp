#include "algorithms/online/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "algorithms/transit/tether_space.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

constexpr int kMostRefusals = 3;
constexpr double kLooksAhead = 10;  // scan steps
constexpr int kMostLooks = 10;      // at one place, with noise
constexpr double kGrown = 1.02;     // times its length when last published: the path is published again

}  // namespace

Polyline View::way() const {
  Polyline way{start_};
  for (const Leg& leg : path_.legs) way.insert(way.end(), leg.points.begin() + 1, leg.points.end());
  return way;
}

/// From the start back along the string, as near to the anchor as the robot gets. Empty if it stands there.
Polyline along_line(const Problem& truth) {
  try {
    const TetherSpace leash(truth, "an online planner");
    const EdgeIndex& walls = leash.cut_problem().walls();
    Point end = truth.anchor();
    if (!walls.contains(end))
      if (const auto hit = walls.nearest(end)) end = hit->point;
    auto way = leash.cut_problem().transit().path(truth.start(), end);  // keeps the string equal to the geodesic
    return way && length(*way) > 0 ? std::move(*way) : Polyline{};
  } catch (const Infeasible&) {
    return {};  // the start has two strings
  }
}

/// One run. The only place that knows both the truth and the view.
class Drive {
 public:
  Drive(const Problem& truth, Context& context, const OnlineSettings& settings)
      : truth_(truth),
        context_(context),
        lidar_(truth.map().free, *truth.robot().lidar),
        noise_(context.rng().bits()),
        view_(truth.robot(), truth.start(), truth.anchor()) {
    const Robot& robot = truth.robot();
    scan_step_ = settings.scan_step > 0 ? settings.scan_step : robot.radius > 0 ? robot.radius : robot.tool_width / 2;
    radius_ = std::max(0.0, robot.radius - truth.tolerance());
    if (!robot.tether) return;
    string_ = tether_at_start(truth);
    if (truth.anchor() != truth.start()) view_.line_ = along_line(truth);
  }

  Path run(const std::function<void(OnlineRobot&, Context&)>& program) {
    look();
    OnlineRobot robot(*this);
    program(robot, context_);
    const Path& path = view_.path_;
    if (view_.driven_ > published_) context_.publish(path);
    context_.record("explored_share", explored());
    context_.record("replans", static_cast<double>(replans_));
    context_.record("scans", static_cast<double>(scans_));
    if (path.legs.empty())
      throw Infeasible(fmt::format("the lidar shows robot '{}' no place to go from its start ({:.6g}, {:.6g})",
                                   truth_.robot().name, truth_.start().x(), truth_.start().y()));
    return path;
  }

  const View& view() const { return view_; }

  bool go(const Motion& motion) {
    drive(motion);
    if (view_.driven_ > kGrown * published_) {
      context_.publish(view_.path_);
      published_ = view_.driven_;
    }
    return !view_.stopped_;
  }

 private:
  // The world stands still: where the robot has looked about often enough, it need not again.
  void look(bool anew = false) {
    since_scan_ = 0;
    const Point place = (view_.pose_ - truth_.start()) / (scan_step_ / 2);
    int& before = looked_[{std::llround(place.x()), std::llround(place.y())}];
    if (!anew && before >= (lidar_noisy() ? kMostLooks : 1)) return;
    ++before;
    view_.belief_.add(lidar_.scan(view_.pose_, noise_));
    seen_from_ = view_.pose_;
    ++scans_;
  }
  bool lidar_noisy() const { return truth_.robot().lidar->noise > 0; }

  /// Free as believed; where that says no, a last look from here decides.
  bool free_from_here(const Point& to) {
    if (free(view_.pose_, to)) return true;
    if (seen_from_ == view_.pose_) return false;
    look(true);
    return free(view_.pose_, to);
  }

  /// The string is pulled along as far as it goes.
  bool tether_allows(const Point& to) {
    if (!string_) return true;
    TautTether pulled = *string_;
    pulled.drive(to);
    if (pulled.length() > truth_.robot().tether->length + truth_.tolerance()) return false;
    string_ = std::move(pulled);
    return true;
  }

  bool free(const Point& a, const Point& b) const { return view_.belief_.free_for(a, b, radius_); }

  /// Is the motion free from the pose on, as far as is worth a look?
  bool free_ahead(const Polyline& points, std::size_t next) const {
    Point from = view_.pose_;
    double ahead = kLooksAhead * scan_step_;
    for (std::size_t k = next; k < points.size() && ahead > 0; ++k) {
      const double far = distance(from, points[k]);
      const Point to = far > ahead ? lerp(from, points[k], ahead / far) : points[k];
      if (!free(from, to)) return false;
      ahead -= far;
      from = to;
    }
    return true;
  }

  void drive(const Motion& motion) {
    view_.stopped_ = false;
    view_.reached_ = 0;
    std::uint64_t lost = view_.belief_.lost();
    for (std::size_t k = 0; k < motion.points.size(); ++k) {
      const Point to = motion.points[k];
      // Back over the stretch that it came by: free, whatever has come to be believed since.
      const bool back = view_.pose_ == came_to_ && to == came_from_;
      if (!back) came_from_ = view_.pose_;
      while (view_.pose_ != to) {
        if (context_.cancelled()) {
          view_.stopped_ = true;
          return;
        }
        const double left = distance(view_.pose_, to), stretch = scan_step_ - since_scan_;
        const Point at = stretch >= left ? to : lerp(view_.pose_, to, stretch / left);
        if (!back && !free_from_here(at)) return stop();
        if (!tether_allows(at)) return stop();
        move(at, motion.tool);
        came_to_ = at;
        if (since_scan_ < scan_step_ * (1 - 1e-9)) continue;
        look();
        if (view_.belief_.lost() == lost) continue;
        lost = view_.belief_.lost();
        if (!back && !free_ahead(motion.points, k)) return stop();
      }
      view_.reached_ = k + 1;
    }
    if (since_scan_ > 0) look();
  }

  void stop() {
    view_.stopped_ = true;
    ++replans_;
  }

  void move(const Point& to, bool tool) {
    const double far = distance(view_.pose_, to);
    since_scan_ += far;
    view_.driven_ += far;
    Path& path = view_.path_;
    const Point from = view_.pose_;
    view_.pose_ = to;
    if (path.legs.empty() || path.legs.back().tool != tool)
      path.legs.push_back({tool, {from, to}});
    else
      path.legs.back().points.push_back(to);
  }

  double explored() const {
    const double all = area(truth_.target());
    if (!(all > 0)) return 1;
    return std::min(1.0, area(intersect(view_.belief_.region(0), truth_.target())) / all);
  }

  const Problem& truth_;
  Context& context_;
  LidarSimulator lidar_;
  Rng noise_;
  View view_;
  double scan_step_, radius_, since_scan_ = 0, published_ = 0;
  std::size_t replans_ = 0, scans_ = 0;
  std::map<std::pair<long long, long long>, int> looked_;  // times, by squares of half a scan step
  Point seen_from_{0, 0};
  std::optional<TautTether> string_;       // of a robot on a leash, in truth
  Point came_from_{0, 0}, came_to_{0, 0};  // the last stretch driven straight
};

const View& OnlineRobot::view() const { return drive_.view(); }
bool OnlineRobot::go(const Motion& motion) { return drive_.go(motion); }

Path drive_online(const Problem& truth, const std::function<void(OnlineRobot&, Context&)>& program, Context& context,
                  const OnlineSettings& settings) {
  if (!truth.robot().lidar)
    throw Unsupported(fmt::format("robot '{}' has no lidar, which an online planner sees by; give it range and rays",
                                  truth.robot().name));
  if (!truth.robot().footprint.empty())
    throw Unsupported(
        fmt::format("robot '{}' has a polygonal footprint; what a lidar shows is judged for discs only, so "
                    "give it a radius instead",
                    truth.robot().name));
  return Drive(truth, context, settings).run(program);
}

Path drive_online(const Problem& truth, Policy& policy, Context& context, const OnlineSettings& settings) {
  const auto ask = [&](OnlineRobot& robot, Context& inner) {
    const View& view = robot.view();
    for (int refusals = 0; refusals < kMostRefusals && !inner.cancelled();) {
      const auto motion = policy.next(view, inner);
      if (!motion) return;
      const double before = view.driven();
      robot.go(*motion);
      refusals = view.driven() > before ? 0 : refusals + 1;
    }
  };
  return drive_online(truth, ask, context, settings);
}

std::optional<Problem> believed_problem(const View& view, const Point& start, int level) {
  Robot robot = view.robot();
  Map map{"belief", view.belief().region(level), "belief", "belief"};
  if (map.free.empty()) return std::nullopt;
  const double near = 5 * view.belief().cell() * (1 << level);
  const auto nearest = [&](const Region& region, const Point& p) -> std::optional<Point> {
    const EdgeIndex edges(region);
    if (edges.contains(p)) return p;
    const auto hit = edges.nearest(p, near);
    return hit ? std::optional(hit->point) : std::nullopt;
  };
  std::optional<Point> anchor;
  if (robot.tether) {
    anchor = nearest(map.free, view.anchor());
    if (!anchor) return std::nullopt;
    robot.tether->length -= distance(*anchor, view.anchor());
    if (robot.tether->length <= 0) return std::nullopt;
  }
  try {
    return Problem(map, robot, start, anchor);
  } catch (const std::invalid_argument&) {
    // The start is too near a believed wall, or there is no room at all.
  }
  const Region space =
      robot.radius > 0 ? erode(map.free, robot.radius, robot.tool_width / 1000, Bound::inside) : map.free;
  if (space.empty()) return std::nullopt;
  const auto from = nearest(space, start);
  if (!from) return std::nullopt;
  try {
    return Problem(std::move(map), robot, from, anchor);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // the anchor is not yet seen to be joined to the start, or the tether is that short
  }
}

}  // namespace oxturn
