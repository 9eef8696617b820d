// The exact tether against an elastic one that follows its robot in small steps: rounded arithmetic, a scan of all
// corners, no events. On random maps and walks both must tell the same length, bends and crossings.
#include <gtest/gtest.h>

#include <algorithm>

#include "metrics/tether.hpp"
#include "tests/support/seeds.hpp"
#include "tethered.hpp"

namespace oxturn {
namespace {

class Elastic {
 public:
  Elastic(const Region& free, const Point& anchor) : anchor_(anchor), robot_(anchor) {
    for_each_ring(free, [&](const Ring& ring) { corners_.insert(corners_.end(), ring.begin(), ring.end()); });
  }

  void drive(const Point& to, double step) {
    const Point from = robot_;
    const int steps = static_cast<int>(std::ceil(distance(from, to) / step));
    for (int k = 1; k <= steps; ++k) move(k == steps ? to : lerp(from, to, static_cast<double>(k) / steps));
  }

  double length() const { return ::oxturn::length(line()); }
  double longest = 0;
  std::size_t most_bends = 0, crossings = 0;

 private:
  struct Bend {
    Point at;
    double side;
  };

  Polyline line() const {
    Polyline all{anchor_};
    for (const Bend& bend : bends_) all.push_back(bend.at);
    all.push_back(robot_);
    return all;
  }

  void move(const Point& to) {
    const Polyline before = line();
    bool over = false;
    for (std::size_t i = 0; i + 2 < before.size(); ++i) {
      const Point &c = before[i], &d = before[i + 1];
      over = over || (cross(d - c, robot_ - c) * cross(d - c, to - c) < 0 &&
                      cross(to - robot_, c - robot_) * cross(to - robot_, d - robot_) < 0);
    }
    crossings += over;
    const Point last = robot_;
    robot_ = to;
    bool released = false;
    while (!bends_.empty()) {
      const Bend b = bends_.back();
      const Point previous = bends_.size() > 1 ? bends_[bends_.size() - 2].at : anchor_;
      if (cross(b.at - previous, to - b.at) * b.side > 0) break;
      bends_.pop_back();
      catch_corners(b.at);
      released = true;
    }
    if (!released) catch_corners(last);
    longest = std::max(longest, length());
    most_bends = std::max(most_bends, bends_.size());
  }

  /// The last segment turns from `from` to the robot and catches on the corners in between, the first of them first.
  void catch_corners(const Point& from) {
    for (;;) {
      const Point pivot = bends_.empty() ? anchor_ : bends_.back().at;
      const double side = cross(from - pivot, robot_ - pivot) > 0 ? 1 : -1;
      const Point* first = nullptr;
      for (const Point& c : corners_) {
        if (c == pivot || c == from) continue;
        if (side * cross(from - pivot, c - pivot) <= 0 || side * cross(robot_ - from, c - from) <= 0 ||
            side * cross(pivot - robot_, c - robot_) <= 0)
          continue;
        if (first == nullptr || side * cross(*first - pivot, c - pivot) < 0) first = &c;
      }
      if (first == nullptr) return;
      bends_.push_back({*first, side});
    }
  }

  Point anchor_, robot_;
  std::vector<Point> corners_;
  std::vector<Bend> bends_;
};

TEST(TetherOracle, AgreesWithAnElasticInSmallSteps) {
  std::size_t crossings = 0, bends = 0;
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem p = leashed(pillars(rng, rng.between(1, 8)), {0.5, 0.5});
    const Polyline path = free_walk(p, rng, 40, 5);
    const TetherRun r = tether_run(p, work(path), p.map_edges(), p.tolerance()).value();
    Elastic elastic(p.map().free, p.anchor());
    for (std::size_t i = 1; i < path.size(); ++i) elastic.drive(path[i], 0.002);
    EXPECT_NEAR(r.longest_m, elastic.longest, 1e-9);
    EXPECT_NEAR(r.end_m, elastic.length(), 1e-9);
    EXPECT_EQ(r.bends_max, elastic.most_bends);
    EXPECT_EQ(r.crossings.size(), elastic.crossings);
    crossings += r.crossings.size();
    bends += r.bends_max;
  }
  EXPECT_GT(crossings, 150u) << "walks that say something";
  EXPECT_GT(bends, 200u);
}

}  // namespace
}  // namespace oxturn
