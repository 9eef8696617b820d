#include "algorithms/polygon/nested_spirals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace oxturn {
namespace {

constexpr double kLongShape = 3;       // greatest clearances
constexpr double kLowestSpine = 1;     // greatest clearances; below, the spine would have branches of spokes
constexpr double kMostClosed = 5;      // laps: with more, one fewer matters little
constexpr double kMostOverlap = 0.9;   // of a spiral
constexpr double kClearlyLess = 0.97;  // of the length; a lower spine has more branches, driven there and back
constexpr double kInside = 1.4;        // length in a wide part, over its area by a step
constexpr double kReached = 0.5;       // steps that the tool reaches beyond a lap

/// How a tree is driven.
struct Choice {
  double height = 0;  // of the wave's start
  bool closed = false, nested = false;
};

/// Laps too close to each other: the length times the width over the area of the shape and of a band about it.
bool bunched(const WaveTree::Measures& of, double width) {
  const double swept = of.area + of.boundary * width / 2;
  return (of.spine + of.laps + of.boundary) * width > (1 + kMostOverlap) * swept;
}

/// The shortest of several, the one looked at first unless another one is clearly shorter.
class Shortest {
 public:
  void add(double metres, const Choice& choice) {
    if (metres < kClearlyLess * shortest_) shortest_ = metres, choice_ = choice;
  }
  const Choice& choice() const { return choice_; }

 private:
  double shortest_ = std::numeric_limits<double>::infinity();
  Choice choice_;
};

void add_spirals(WaveTree& tree, const LapWidths& widths, const Point& near, Shortest& shortest) {
  const double clearance = tree.greatest_clearance(), height = tree.height();
  for (const double clearances : {kRootAlone, kSpineHeight, kLowestSpine}) {
    if (clearances == kRootAlone && height > kLongShape * clearance) continue;  // as many times as many laps
    const double high = std::min(clearances * clearance, height), laps = high / widths.step;
    WaveTree::Measures found{};
    bool closed = laps <= 1;
    if (!closed) {
      found = tree.spiral_measures(laps, high, near);
      closed = laps <= kMostClosed && bunched(found, widths.width);
    }
    if (closed) found = tree.closed_measures(laps, high, near);
    shortest.add(found.spine + found.laps, {high, closed, false});
  }
}

void add_nested(const WaveTree& tree, const LapWidths& widths, Shortest& shortest) {
  const double most = std::ceil(tree.greatest_clearance() / widths.step) - 1;
  for (auto laps = static_cast<std::size_t>(std::max(0.0, most)); laps > 0; laps = laps * 3 / 4) {
    const double height = static_cast<double>(laps) * widths.step;
    auto [of, inside] = tree.nested_measures(laps, height);
    const bool closed = static_cast<double>(laps) <= kMostClosed;
    if (!closed) of.laps += (of.spine + of.boundary) / 2;  // one more
    shortest.add(of.spine + of.laps + kInside * inside / widths.step, {height, closed, true});
  }
}

/// Also roots the tree at its centre.
Choice choice_for(WaveTree& tree, const LapWidths& widths, const Point& near) {
  const double reach = kReached * widths.step;
  if (tree.greatest_clearance() > reach) tree.stop_before(reach);
  tree.root_at_centre();
  Shortest shortest;
  add_spirals(tree, widths, near, shortest);
  add_nested(tree, widths, shortest);
  return shortest.choice();
}

WaveSpiral nested(WaveTree& tree, const Choice& choice, const LapWidths& widths, std::size_t first);

/// Inside a wide part, from a leaf and back to it; empty where the tool reaches all of it from outside.
Polyline inside(WaveTree& tree, const LapWidths& widths, std::size_t leaf, const Point& near) {
  if (tree.greatest_clearance() <= kReached * widths.step) return {};
  const Choice choice = choice_for(tree, widths, near);
  WaveSpiral spiral;
  if (choice.nested) {
    spiral = nested(tree, choice, widths, leaf);
  } else {
    tree.start_at(choice.height);
    spiral = tree.laps_at(leaf, choice.height / widths.step, choice.closed, true);
  }
  if (spiral.spine.empty() && spiral.laps.empty()) return {};
  Polyline curve = tree.branch(leaf, spiral.begin);
  curve.insert(curve.end(), spiral.spine.begin(), spiral.spine.end());
  curve.insert(curve.end(), spiral.laps.begin(), spiral.laps.end());
  return curve;
}

/// The first lap from a leaf on and back to it, with what is driven inside of it.
Polyline filled_lap(const WaveTree& tree, double height, const LapWidths& widths, std::size_t first) {
  const Polyline lap = tree.first_lap();
  std::vector<WidePart> wide = tree.wide_parts(height);
  struct Entry {
    std::size_t part, leaf;
  };
  std::vector<Entry> entries(lap.size(), {wide.size(), 0});
  for (std::size_t part = 0; part < wide.size(); ++part)
    for (std::size_t k = 0; k < wide[part].leaf.size(); ++k)
      if (const std::size_t leaf = wide[part].leaf[k]; leaf != WidePart::kGate) entries[leaf] = {part, k};
  std::vector<bool> done(wide.size(), false);
  Polyline filled;
  for (std::size_t j = 0; j <= lap.size(); ++j) {
    const std::size_t leaf = (first + j) % lap.size();
    const auto [part, entry] = entries[leaf];
    if (filled.empty() || filled.back() != lap[leaf]) filled.push_back(lap[leaf]);
    if (part == wide.size() || done[part]) continue;
    done[part] = true;
    const Polyline curve = inside(wide[part].tree, widths, entry, lap[leaf]);
    filled.insert(filled.end(), curve.begin(), curve.end());
    if (filled.back() != lap[leaf]) filled.push_back(lap[leaf]);
  }
  return filled;
}

WaveSpiral nested(WaveTree& tree, const Choice& choice, const LapWidths& widths, std::size_t first) {
  tree.start_at(choice.height);
  WaveSpiral spiral = tree.laps_at(first, choice.height / widths.step, choice.closed, false);
  spiral.spine = filled_lap(tree, choice.height, widths, first);
  return spiral;
}

/// As one spiral, with a spine.
WaveSpiral spiral_of(WaveTree& tree, const Choice& choice, const LapWidths& widths, const Point& near) {
  const double laps = choice.height / widths.step;
  return choice.closed ? tree.closed_laps(laps, choice.height, near) : tree.spiral(laps, choice.height, near);
}

}  // namespace

WaveSpiral spiral_from_spine(WaveTree& tree, const LapWidths& widths, const Point& near) {
  Shortest shortest;
  add_spirals(tree, widths, near, shortest);
  return spiral_of(tree, shortest.choice(), widths, near);
}

WaveSpiral nested_spirals(WaveTree& tree, const LapWidths& widths, const Point& near) {
  const Choice choice = choice_for(tree, widths, near);
  return choice.nested ? nested(tree, choice, widths, tree.leaf_nearest(near)) : spiral_of(tree, choice, widths, near);
}

}  // namespace oxturn
