/// Strokes in driving order, each with the link that leads to it, and more strokes inserted between and within them.
///
///   KnownLinks links(space, driven.size());
///   InsertedStrokes more(driven, links, problem.robot().tool_width, effort, context);
///   if (const auto insertion = more.insertion_of(line)) more.insert(*insertion);
///   driven = more.take();
///
///    ====== cut =====>        The robot leaves a stroke at a cut, or at its end, drives the new one, and comes back to
///          /   \              where it left, or to the next stroke. Both links are free; they cover as well.
///         '--=--'
///
/// Cuts lie on edges so long that the cut makes no bend sharper. Each is used once; a second set of insertions has new
/// ones. Complexity  build O(n log n) for n metres; insertion_of() some dozens of curves for each of a few cuts near by
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "algorithms/smoothing/known_links.hpp"
#include "geometry/point_grid.hpp"

namespace oxturn {

struct LinkedStroke {
  Curve link;           // from the end of the stroke before, or from the start
  Polyline stroke;      // at least two points
  bool covers = false;  // the link is driven with the tool on
};
/// As legs; links and strokes of the tool's whole width.
Path path_of(const std::vector<LinkedStroke>& strokes, const Point& start, double chord_error);
/// The points of the curve, whatever gear.
Polyline points_of(const Curve& curve, double chord_error);

class InsertedStrokes {
 public:
  /// Of one stroke more.
  struct Insertion {
    std::size_t cut = 0;
    Polyline stroke;
    Curve to;
    std::optional<Curve> back;  // nullopt: the path ends with the stroke
    double cost = 0;            // metres that the path becomes longer, the stroke included
  };

  /// `links` and `context` must outlive it. `effort`: what searches for links may still cost.
  InsertedStrokes(std::vector<LinkedStroke> strokes, KnownLinks& links, double width, DetourEffort& effort,
                  const Context& context);
  InsertedStrokes(const InsertedStrokes&) = delete;
  InsertedStrokes& operator=(const InsertedStrokes&) = delete;
  /// The cheapest of those tried, in either direction of the line. `search`: also by detours around obstacles, if no
  /// simple link is free. nullopt: none was found.
  std::optional<Insertion> insertion_of(const Polyline& line, bool search) const;
  void insert(Insertion insertion);
  /// All strokes in order.
  std::vector<LinkedStroke> take();

 private:
  struct Cut {
    std::size_t stroke;
    std::size_t edge;  // the cut lies on the edge from this point on; that of the last point is the stroke's end
    double along;      // of the edge, metres
    Pose out, in;
    double saved;  // metres of the link that is no longer driven
    bool last;     // nothing follows
  };
  using Candidate = std::pair<double, std::pair<std::size_t, bool>>;  // least cost, cut, backwards

  void add_cuts(std::size_t stroke);
  std::vector<Candidate> candidates(const Polyline& line) const;
  /// A simple link costs less than `most`.
  std::optional<Curve> link(const Pose& from, const Pose& to, bool search, double most) const;
  /// nullopt also if it costs `most` or more.
  std::optional<Insertion> inserted_at(std::size_t cut, Polyline line, bool search, double most) const;

  std::vector<LinkedStroke> strokes_;
  KnownLinks& links_;
  const CarSpace& space_;
  double width_;
  DetourEffort& effort_;
  const Context& context_;
  std::vector<Cut> cuts_;  // in driving order
  std::vector<Point> positions_;
  std::optional<PointGrid> grid_;
  std::vector<std::optional<Insertion>> chosen_;  // by cut
};

}  // namespace oxturn
