/// In which order, and in which direction, a car-like robot drives its strokes.
///
///   LinkTour tour(strokes, space, start, context);
///   for (const DrivenStroke& s : tour.order()) ...
///   tour.on_progress([&](const std::vector<DrivenStroke>& so_far) { ... });   // before order(): may be called often
///
/// A tour (tour/solve_tour.hpp) over all strokes: open ones from either end, closed ones from some points in both
/// directions. Connections first cost what a curve without obstacles costs. Those of the tour are then tested and cost
/// what the curve found does, and the tour is improved, until all its connections are known, or the effort for tours is
/// spent: most_effort() connections asked for. Connections of the last tour that are not known then are searched when
/// link() asks for them.
/// Complexity  O(n log n) connections looked at for n directions and entries of strokes, and O(n) links searched
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/smoothing/link_costs.hpp"
#include "algorithms/smoothing/strokes.hpp"
#include "algorithms/tour/solve_tour.hpp"

namespace oxturn {

struct DrivenStroke {
  std::size_t stroke = 0;
  PatternId pattern = 0;  // of the tour
  Polyline points;
};

class LinkTour {
 public:
  /// All references must outlive it.
  LinkTour(const std::vector<Stroke>& strokes, const CarSpace& space, const Point& start, Context& context);
  LinkTour(const LinkTour&) = delete;
  LinkTour& operator=(const LinkTour&) = delete;
  /// Ends early if cancelled.
  std::vector<DrivenStroke> order();
  /// `report` is given the order so far whenever more links of it are known.
  void on_progress(std::function<void(const std::vector<DrivenStroke>&)> report) { report_ = std::move(report); }
  /// The free link between two strokes driven one after the other, or from the start; nullopt if none was found.
  const std::optional<Curve>& link(const DrivenStroke* from, const DrivenStroke& to);
  /// The same without a search: nullopt, too, if there was none for that link.
  std::optional<Curve> known_link(const DrivenStroke* from, const DrivenStroke& to) const;

  /// What the search for a tour of so many patterns may cost, as LinkCosts::effort() counts; it may take a tenth more,
  /// because it ends between two steps.
  static std::uint64_t most_effort(std::size_t patterns);
  /// What it has cost.
  std::uint64_t effort() const { return costs_->effort(); }
  /// Directions and entries of all strokes, and the start's two.
  std::size_t patterns() const { return passes_.size() + 2; }
  /// Searches for detours ended early, so there may be links that were not found.
  bool exhausted() const { return effort_.exhausted(); }

 private:
  /// One pattern of a stroke.
  struct Pass {
    std::size_t stroke;
    double from;  // metres along a closed stroke
    bool backwards;
    Pose entry, exit;
  };
  using Key = std::pair<PatternId, PatternId>;

  void add_passes(std::size_t stroke);
  Polyline points(const Pass& pass) const;
  double bound(PatternId from, PatternId to) const;
  std::vector<ConnectionCost::Ends> ends() const;
  /// Tests the connections of the tour; false if all were known.
  bool learn(const TourProblem& problem, const Tour& tour);
  std::vector<DrivenStroke> driven(const TourProblem& problem, const Tour& tour) const;
  Tour from_start(const TourProblem& problem, Tour tour) const;
  /// Searches each link once.
  const std::optional<Curve>& find(PatternId from, PatternId to);
  std::optional<Curve> link_from_start(const Pose& to);
  std::optional<Curve> link_between(const Pose& from, const Pose& to);

  const std::vector<Stroke>& strokes_;
  const CarSpace& space_;
  Point start_;
  Context& context_;
  DetourEffort effort_;
  std::function<void(const std::vector<DrivenStroke>&)> report_;
  std::vector<Pass> passes_;  // pattern p is passes_[p - 2]; patterns 0 and 1 are the start
  std::vector<std::size_t> counts_{2};
  std::vector<PatternId> reverse_{1, 0};
  std::optional<LinkCosts> costs_;  // kBlocked: no link was found
  std::map<Key, std::optional<Curve>> links_;
};

}  // namespace oxturn
