/// Makes a path shorter by simulated annealing of its vertices against a raster of witnesses.
///
///   Annealing annealing(problem, target, points, {.cell = w / 20, .radius = w / 2, .uncovered = 0.01 * area(target)});
///   annealing.run({.moves = 1'000'000, .hot = 0.05 * w, .cold = 0.005 * w}, rng, context);
///   const Polyline shorter = annealing.points();
///
/// Energy: length + price * uncovered area. The price floats, so that the uncovered
/// area stays at what is allowed. New edges lie in configuration space, exactly. The path covers wherever it runs.
///
/// Source      Kirkpatrick, Gelatt and Vecchi, Science 220, 1983; moves: moves.hpp; the floating price is ours
/// Complexity  a move costs a few exact edge tests and what its edges cost in the raster: 2 to 10 microseconds
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/improve/moves.hpp"
#include "algorithms/improve/witnesses.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class Annealing {
 public:
  struct Options {
    double cell = 0;                              // distance of witnesses, metres
    double radius = 0;                            // of the tool, metres
    double uncovered = 0;                         // allowed, square metres
    double price = 0;                             // of uncovered area to begin with, 1 / metres
    bool fixed_end = false;                       // the path ends where it does now
    double least_shift = 0.01, most_shift = 0.3;  // of vertices, in tool widths
  };
  struct Schedule {
    long moves = 0;
    double hot = 0, cold = 0;  // temperatures, metres; geometric in between
  };
  /// `target`: what is to be covered.
  Annealing(const Problem& problem, const Region& target, const Polyline& points, const Options& options);

  /// Points where moves are needed most (Moves::focus).
  void focus(std::vector<Point> points) { moves_.focus(std::move(points)); }
  /// Ends early if cancelled.
  void run(const Schedule& schedule, Rng& rng, const Context& context);
  Polyline points() const { return path_.points(); }
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
  std::array<Witnesses::Capsule, 4> removed_, added_;  // of the move that is tried
};

}  // namespace oxturn
