/// Makes a path shorter by simulated annealing of its vertices against a raster of witnesses.
///
///   Annealing annealing(walls, path, witnesses, w, {.uncovered = 0.01 * area(target), .price = 5 / w});
///   annealing.run({.moves = 1'000'000, .hot = 0.05 * w, .cold = 0.005 * w}, rng, context);
///   const Polyline shorter = annealing.path().points();
///
/// Energy: length + turn * sum of turns + price * uncovered area. The price floats, so that the uncovered
/// area stays at what is allowed. New edges lie in configuration space, exactly. The path covers wherever it runs.
///
/// Source      Kirkpatrick, Gelatt and Vecchi, Science 220, 1983; moves: moves.hpp; the floating price is ours
/// Complexity  a move costs a few exact edge tests and what its edges cost in the raster: 2 to 10 microseconds
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/improve/moves.hpp"
#include "algorithms/improve/witnesses.hpp"

namespace oxturn {

class Annealing {
 public:
  struct Options {
    double cell = 0;                              // distance of witnesses, metres
    double radius = 0;                            // of the tool, metres
    double uncovered = 0;                         // allowed, square metres
    double price = 0;                             // of uncovered area to begin with, 1 / metres
    bool floating = true;                         // the price
    double turn = 0;                              // metres that a turn by a radian counts
    bool fixed_end = false;                       // the path ends where it does now
    double least_shift = 0.01, most_shift = 0.3;  // of vertices, in tool widths
    bool cut_short = false;                       // loops and long spikes are left out at once, too
    double hot = 0.006;  // temperature in tool widths above which larger targets are annealed as a whole
    AnnealingPart without = AnnealingPart::none;  // moves that are not made, and whether there are windows
  };
  struct Schedule {
    long moves = 0;
    double hot = 0, cold = 0;  // temperatures, metres; geometric in between
  };
  /// `path`: with its fixed vertices. `witnesses`: what is to be covered; without what `path` and what is driven
  /// besides cover. `walls` must outlive it.
  Annealing(const EdgeIndex& walls, VertexPath path, Witnesses witnesses, double tool_width, const Options& options);

  /// Points where moves are needed most (Moves::focus).
  void focus(std::vector<Point> points) { moves_.focus(std::move(points)); }
  /// Ends early if cancelled.
  void run(const Schedule& schedule, Rng& rng, const Context& context);
  const VertexPath& path() const { return path_; }
  const Witnesses& witnesses() const { return witnesses_; }
  double price() const { return price_; }
  double uncovered() const { return static_cast<double>(witnesses_.uncovered()) * witnesses_.area_each(); }

 private:
  bool try_move(double temperature, Rng& rng);
  bool legal(const Edges& edges) const;

  const EdgeIndex& walls_;
  Options options_;
  double price_;
  VertexPath path_;
  Witnesses witnesses_;
  Moves moves_;
  using Capsules = std::array<Witnesses::Capsule, Edges::kMost>;
  Capsules removed_, added_;  // of the move that is tried
};

}  // namespace oxturn
