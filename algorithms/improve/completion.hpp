/// What a path leaves uncovered, exactly, and the path with detours that reach the coverage asked for.
///
///   const Completion completion(problem, 0.999);
///   completion.uncovered(points);                     // a superset, as a region
///   points = completion.completed(points, completion.uncovered(points), context);
///
/// Of the uncovered pieces the smallest stay, as far as the coverage allows. The others get the shortest detours there
/// are (detours.hpp), and what these leave those of lanes/repair.hpp; where that makes the path much longer, it is
/// compared with stops and repair alone.
///
/// Guarantee   the path covers the share asked for; if that is 1, less seams thinner than covered_seam() where only
///             lanes could reach them
/// Complexity  O(m log m) for a path of m segments
#pragma once

#include "algorithms/context.hpp"
#include "algorithms/improve/part.hpp"
#include "algorithms/transit/connector.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class Completion {
 public:
  static constexpr double kChord = 2e-4;  // tool widths: error of arcs where coverage is measured
  /// `problem` must outlive it.
  Completion(const Problem& problem, double coverage, AnnealingPart without = AnnealingPart::none);
  /// What can be covered: all of the target, but where configuration space was restricted.
  const Region& target() const { return target_; }
  /// Square metres that may stay uncovered: slightly less than asked for, because who judges the path measures with an
  /// error.
  double allowed() const;
  /// Is all of the target asked for?
  bool whole() const { return coverage_ >= 1; }
  Region uncovered(const Polyline& points) const;
  /// Without the smallest pieces, as far as the coverage allows.
  Region needed(Region uncovered) const;
  /// `left`: what they leave uncovered.
  Polyline completed(Polyline points, Region left, Context& context) const;

 private:
  /// What lines leave uncovered of the region.
  Region left_of(const Region& region, const std::vector<Polyline>& lines) const;
  Polyline detoured(Polyline points, Region left, double noticed, Context& context) const;

  const Problem& problem_;
  const Connector connector_;
  double width_, coverage_;
  AnnealingPart without_;  // strokes or detours, or none of these
  Region target_;
};

/// The path's vertices, legs joined.
Polyline vertices_of(const Path& path, const Point& start);
/// The path along these points, tool on.
Path driven(const Polyline& points);

}  // namespace oxturn
