// Laps of equal tether length, complete: exact level sets in the space cut open, every wall once, nothing missed.
//
// Source      ours, after Berg, "A Geometric Algorithm for Online Tethered Navigation", LTH 2021; it mends what the
//             thesis leaves open (3.1 one-shot corners, 4.2 walls between laps, 5.1 speed, 5.3 order and winding)
// Model       polygons with holes, disc footprint; offline (map known)
// Guarantee   the string equals the geodesic of where the robot stands (except on the ways between parts that the cut
//             isolates, leash.hpp), so it stays within the leash, is never wound and never driven over; covers all
//             that configuration space within the leash reaches, less parts that the robot cannot enter within it.
//             Proof of coverage: let P be the cut space, Q = rims.inner. A point of Q farther than w/2 from the
//             boundary of Q can move w/2 along its geodesic within Q, in either direction, and so meets a level set,
//             in a place that laps.hpp keeps, or comes upon the cut where that is not driven: then laps end there
//             (rims.hpp, at most 1.11 w/2 away). Any other point of P is within w/2 of what is driven of its rims.
// Complexity  n corners, path length m spacings: field and cut O(n log n) on real maps, laps O(levels * triangles met
//             + m log m), order as the tour
// Decisions   1. Levels lie at (k + 1/2) w from the anchor, k = 0, 1, ...: no lap at the anchor itself.
//             2. Walls are driven once; the cut only where it runs across the string (rims.hpp). Where all of a ring
//                is driven it is spliced in, else its stretches take part in the tour.
//             3. order: `tour` (ours) orders runs of laps by a tour on shortest ways inside P; `dfs` is depth-first
//                on the tree of pieces, `bfs` lap by lap, outwards (the thesis's traversals).
//             4. winding = left (right): laps are driven with the string at the left (right) side only, each by itself,
//                and rings likewise wherever the string leaves inwards; joins are free.
//             5. min_tether_angle: where the heading would come nearer to the direction of the string's pull, the
//                robot tacks: short strokes at that angle to it, within a quarter of the tool width, if there is room.
//             6. Short laps (corridors) may be swept by lanes along the string (lanes = 4), out and back: each part of the
//                space is planned with and without them, the shorter path is driven. lanes = 0, or a min_tether_angle,
//                keeps to laps.
#include <algorithm>
#include <cmath>

#include "algorithms/online/sensing.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/tethered/level_sets.hpp"
#include "algorithms/tethered/needed_boundary.hpp"
#include "algorithms/tethered/tacking.hpp"

namespace oxturn {
namespace {

struct Params {
  std::string order = "tour";
  std::string winding = "any";
  double min_tether_angle = 0;
  int lanes = 4;
  bool return_home = false;
};

/// What of all this lies in one part.
struct Share {
  std::vector<LevelSet> laps;
  Region rings;
  std::vector<Strip> chains;
};
Share share_of(const EdgeIndex& part, const std::vector<LevelSet>& laps, const NeededBoundary& rims, double tolerance) {
  const auto inside = [&](const Point& p) { return part.contains(p) || part.nearest(p, tolerance); };
  Share share;
  for (const LevelSet& lap : laps)
    if (inside(lap.line[lap.line.size() / 2])) share.laps.push_back(lap);
  for (const Polygon& ring : rims.rings.polygons)
    if (inside(ring.outer.front())) share.rings.polygons.push_back(ring);
  for (const Polyline& chain : rims.chains)
    if (inside(chain[chain.size() / 2])) share.chains.push_back({{{chain.front(), chain.back(), chain}}, {}, {}, {}});
  return share;
}

class BergComplete final : public CoveragePlanner {
 public:
  explicit BergComplete(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace leash(problem, "berg-complete");
    const double w = problem.robot().tool_width;
    const bool open = p_.order == "tour" && p_.winding == "any";
    const NeededBoundary rims = needed_boundary(leash, open);
    const std::vector<LevelSet> all = laps(leash, rims.space, rims.inner, w, w / 1000);
    if (context.wants_traces()) show(leash, rims, all, context);

    Path path = cover_components(
        leash,
        [&](const TetherSpace::Component& part, Context& inner) {
          Share share = share_of(part.problem.walls(), all, rims, problem.tolerance());
          if (p_.winding == "right") reverse(share.rings);
          const auto outward = outward_neighbours(share.laps, leash.field(), w);
          const Connector connector(part.problem);
          if (p_.winding != "any")
            return with_rings(part.problem, share.rings, wind_level_sets(part.problem, share.laps, outward, connector, inner),
                              w, connector, inner);
          // Lanes save the steps between short laps, but an odd number of them leaves the robot at the wrong end.
          const auto drive = [&](std::vector<Strip> strips) {
            strips.insert(strips.end(), share.chains.begin(), share.chains.end());
            return with_rings(part.problem, share.rings,
                              drive_strips(part.problem, strips, order_of_strips(), connector, inner), w, connector,
                              inner);
          };
          const bool by_level = p_.order == "bfs";
          const auto strips = [&](int lanes) {
            return strips_of(share.laps, outward, part.problem.walls(), w, lanes, by_level);
          };
          const std::vector<Strip> across = strips(0);
          Path best = drive(across);
          if (p_.lanes == 0 || p_.min_tether_angle > 0 || by_level || inner.cancelled()) return best;
          const std::vector<Strip> along = strips(p_.lanes);
          if (lanes_in(along) == lanes_in(across)) return best;  // no run of laps took to lanes
          Path other = drive(along);
          return !inner.cancelled() && other.length() < best.length() ? other : best;
        },
        p_.return_home, context);
    if (p_.min_tether_angle > 0) path = tacked(leash, path, p_.min_tether_angle, w / 4);
    context.publish(path);
    return path;
  }

 private:
  static void reverse(Region& rings) {
    for (Polygon& polygon : rings.polygons) {
      std::reverse(polygon.outer.begin(), polygon.outer.end());
      for (Ring& hole : polygon.holes) std::reverse(hole.begin(), hole.end());
    }
  }

  std::string order_of_strips() const { return p_.order == "bfs" ? "given" : p_.order == "dfs" ? "dfs" : "improved"; }
  /// A run of laps swept along the string counts as one lane.
  static std::size_t lanes_in(const std::vector<Strip>& strips) {
    std::size_t count = 0;
    for (const Strip& strip : strips) count += strip.lanes.size();
    return count;
  }

  /// Depth-first (or by level), each lap in the one direction.
  Path wind_level_sets(const Problem& within, const std::vector<LevelSet>& all,
                 const std::vector<std::vector<std::size_t>>& outward, const Connector& connector,
                 Context& context) const {
    std::vector<std::size_t> sequence;
    if (p_.order == "bfs") {
      for (std::size_t k = 0; k < all.size(); ++k) sequence.push_back(k);
    } else {
      std::vector<bool> seen(all.size(), false);
      for (std::size_t root = 0; root < all.size(); ++root) {  // by level: outermost last
        std::vector<std::size_t> stack{root};
        while (!stack.empty()) {
          const std::size_t k = stack.back();
          stack.pop_back();
          if (seen[k]) continue;
          seen[k] = true;
          sequence.push_back(k);
          stack.insert(stack.end(), outward[k].rbegin(), outward[k].rend());
        }
      }
    }
    PathBuilder path(within.start());
    for (const std::size_t k : sequence) {
      if (context.cancelled()) break;
      Polyline line = all[k].line;
      if (p_.winding == "right") std::reverse(line.begin(), line.end());
      path.drive(connector.path(path.at(), line.front()), false);
      path.drive(line, true);
    }
    return path.take();
  }

  static void show(const TetherSpace& leash, const NeededBoundary& rims, const std::vector<LevelSet>& all, Context& context) {
    const auto outward = outward_neighbours(all, leash.field(), leash.problem().robot().tool_width);
    context.trace("cut", leash.cut());
    context.trace("rings", rims.rings);
    context.trace("chains", rims.chains);
    std::vector<Polyline> lines, tree;
    const auto middle = [&](std::size_t k) { return all[k].line[all[k].line.size() / 2]; };
    for (std::size_t k = 0; k < all.size(); ++k) {
      lines.push_back(all[k].line);
      for (const std::size_t b : outward[k]) tree.push_back({middle(k), middle(b)});
    }
    context.trace("level sets", std::move(lines));
    context.trace("tree of pieces", std::move(tree));
  }

  Params p_;
};

}  // namespace

PlannerInfo berg_complete() {
  return with_sensing(describe<BergComplete, Params>(
      {.name = "berg-complete",
       .family = "tethered",
       .title = "laps of equal tether length, complete",
       .citation = "oxturn, after Berg 2021",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "covers all that the leash reaches; never over its own line, string the geodesic",
       .parameters = {
           {"order", &Params::order, {"tour", "dfs", "bfs"}, "of the pieces of laps"},
           {"winding",
            &Params::winding,
            {"any", "left", "right"},
            "the side of the robot on which laps keep the string"},
           {"min_tether_angle", &Params::min_tether_angle, Range{0, kPi / 2 - 0.01},
            "radians that the heading keeps from the string's pull, by tacking; 0: none"},
           {"lanes", &Params::lanes, Range{0, 20},
            "short laps (up to so many tool widths) are swept by that many lanes along the string; 0: laps only"},
           {"return_home", &Params::return_home, "drive back to the start at the end"}}}));
}

}  // namespace oxturn
