#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>

#include "algorithms/smoothing/car_space.hpp"
#include "algorithms/smoothing/detour_search.hpp"
#include "algorithms/smoothing/route.hpp"

namespace oxturn {
namespace {

constexpr double kCell = 0.25;  // radii
constexpr int kHeadings = 72;
constexpr double kStep = 1.5;          // cells
constexpr double kRouteSpacing = 0.5;  // radii
constexpr double kGreed = 1.2;         // weight of the heuristic
constexpr double kNearGoal = 6;        // radii; nearer than that the rest is tried at every node, else at every fourth
constexpr double kReverse = 1.5;       // a metre backwards costs that much
constexpr std::size_t kFirstPoses = 1000;  // of a thorough search in each direction, then twice as many, and so on
constexpr std::size_t kReverseEffort = 3;  // a Reeds-Shepp curve takes several times as long as a Dubins curve

class LatticeSearch {
 public:
  /// `from`: where it begins, roughly.
  LatticeSearch(const CarSpace& space, const Point& from, const Pose& to)
      : space_(space),
        to_(to),
        radius_(space.radius()),
        route_(space.shortest_path(from, to.at), space.walls(), kRouteSpacing * radius_) {}

  void begin(const std::vector<Pose>& from) {
    for (const Pose& pose : from) add({pose, kNone, {}, 0});
  }
  /// Until `most` poses are known. May be called again, to go on with more of them.
  std::optional<Curve> run(std::size_t most, const Context& context) {
    while (!open_.empty() && nodes_.size() < most && !context.cancelled()) {
      const std::size_t at = open_.top().second;
      open_.pop();
      if (closed_[at]) continue;
      closed_[at] = true;
      if (auto rest = rest_from(at)) return path(at, *rest);
      expand(at);
    }
    return std::nullopt;
  }
  std::size_t poses() const { return nodes_.size(); }
  /// Every pose that the robot can reach was looked at.
  bool nothing_left() const { return open_.empty(); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Node {
    Pose pose;
    std::size_t parent;
    CurvePiece piece;  // from the parent
    double cost;
  };
  using Key = std::array<std::int64_t, 4>;

  Key key(const Node& node) const {
    const double cell = kCell * radius_;
    const auto heading = std::llround(node.pose.heading / (2 * kPi) * kHeadings);
    return {std::llround(node.pose.at.x() / cell), std::llround(node.pose.at.y() / cell),
            ((heading % kHeadings) + kHeadings) % kHeadings, node.piece.gear == Gear::reverse};
  }

  void add(const Node& node) {
    const auto [entry, fresh] = best_.try_emplace(key(node), nodes_.size());
    if (!fresh) {
      if (nodes_[entry->second].cost <= node.cost) return;
      closed_[entry->second] = true;
      entry->second = nodes_.size();
    }
    const double rest = space_.least_length(node.pose, to_);
    open_.push({-(node.cost + kGreed * std::max(rest, route_.rest(node.pose.at))), nodes_.size()});
    nodes_.push_back(node);
    rest_.push_back(rest);
    closed_.push_back(false);
  }

  void expand(std::size_t at) {
    const double length = kStep * kCell * radius_;
    for (const Gear gear : {Gear::forward, Gear::reverse}) {
      if (gear == Gear::reverse && !space_.reverse()) break;
      for (const Steering steering : {Steering::straight, Steering::left, Steering::right}) {
        const Node from = nodes_[at];
        const CurvePiece piece{steering, length, gear};
        if (!space_.free(from.pose, piece)) continue;
        const bool cusp = from.parent != kNone && from.piece.gear != gear;
        const double metre = gear == Gear::reverse ? kReverse : 1;
        add({after(from.pose, piece, radius_), at, piece, from.cost + length * metre + (cusp ? radius_ : 0)});
      }
    }
  }

  std::optional<Curve> rest_from(std::size_t at) const {
    if (rest_[at] > kNearGoal * radius_ && at % 4 != 0) return std::nullopt;
    Curve rest = space_.shortest(nodes_[at].pose, to_);
    if (!space_.free(rest)) return std::nullopt;
    return rest;
  }

  Curve path(std::size_t at, const Curve& rest) const {
    Curve all = rest;
    for (; nodes_[at].parent != kNone; at = nodes_[at].parent) all.pieces.insert(all.pieces.begin(), nodes_[at].piece);
    all.from = nodes_[at].pose;
    return all;
  }

  const CarSpace& space_;
  Pose to_;
  double radius_;
  const Route route_;
  std::vector<Node> nodes_;
  std::vector<double> rest_;
  std::vector<char> closed_;
  std::map<Key, std::size_t> best_;
  /// Cost with sign, so that the cheapest is on top; of equal ones the newest.
  std::priority_queue<std::pair<double, std::size_t>> open_;
};

}  // namespace

std::optional<Curve> lattice_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                    DetourEffort& effort, const Context& context) {
  LatticeSearch search(space, from.front().at, to);
  search.begin(from);
  std::optional<Curve> detour = search.run(effort.most(), context);
  effort.spend((space.reverse() ? kReverseEffort : 1) * search.poses());
  return detour;
}

ThoroughDetour thorough_search(const CarSpace& space, const Pose& from, const Pose& to, std::size_t most,
                               const Context& context) {
  LatticeSearch forwards(space, from.at, to), backwards(space, to.at, turned_round(from));
  forwards.begin({from});
  backwards.begin({turned_round(to)});
  ThoroughDetour result;
  for (std::size_t each = kFirstPoses; !result.curve && !result.nothing_left; each *= 2) {
    result.curve = forwards.run(std::min(each, most), context);
    if (!result.curve && !forwards.nothing_left())
      if (const auto back = backwards.run(std::min(each, most), context)) result.curve = opposite(*back);
    result.nothing_left = !result.curve && (forwards.nothing_left() || backwards.nothing_left());
    if (each >= most || context.cancelled()) break;
  }
  result.poses = forwards.poses() + backwards.poses();
  return result;
}

}  // namespace oxturn
