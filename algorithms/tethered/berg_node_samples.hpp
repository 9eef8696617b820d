/// The samples of a node's arcs in many boundaries at once: what a node sees fits in the processor's cache, what a
/// boundary passes does not.
///
///   BergNodeSamples samples(boundary, node, sampling, 0);
///   for (std::size_t lap = 0; lap < sampling.lengths.count; ++lap)
///     for (const std::int32_t begin : arcs_at(lap)) use(samples.take(lap, begin).points);
///
/// Method      The node's events divide its arc, each from its own length on. An arc whose node sees nothing so far
///             away has ended. With a trim an arc has ended as well when all of its samples are left out, unless an
///             event is to come: where another path is shorter, it is so farther out in the same direction, too.
/// Complexity  the samples; a test of sight only for those of which sight_range.hpp does not know whether they are seen
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "algorithms/tethered/berg_boundary.hpp"

namespace oxturn {

/// Samples that may be left out: where a node surely sees all of its arc, and a straight segment from one sample to a
/// later one is free and within `error` metres of the arc.
struct BergThinning {
  double error = 0;                                              // 0: none are left out
  std::function<bool(const Point&, const Point&)> is_free = {};  // the segment between two points
};

/// Samples to be left out because a shorter tether reaches them.
struct BergTrim {
  std::function<double(const Point&)> shortest = {};  // metres of tether to a point; empty: none are left out
  double slack = 0;                                   // metres by which a lap's length may exceed that
};

/// Of tether, one for each boundary: `step`, twice that and so on, all of them plus `offset`; metres.
struct BergLengths {
  double step = 0;
  std::size_t count = 0;
  double offset = 0;
  double operator[](std::size_t k) const { return static_cast<double>(k + 1) * step + offset; }
};

/// Which boundaries, and which of their points.
struct BergSampling {
  BergLengths lengths;
  double spacing = 0;  // of samples, metres
  BergThinning thinning = {};
  BergTrim trim = {};
  std::function<bool(const Point&)> keep = {};  // is the sample to be given? Empty: all are
};

class BergNodeSamples {
 public:
  static constexpr std::int32_t kNone = -1;
  /// From boundary number `first` on. Boundary and sampling must outlive it.
  BergNodeSamples(const BergBoundary& boundary, std::size_t node, const BergSampling& sampling, std::size_t first);

  struct Taken {
    std::span<const Point> points;
    bool empty;  // so is the arc in all boundaries that follow
  };
  /// Those of the arc in boundary number `lap` that begins at an event, or at the side of the sector (kNone). To be
  /// called for each arc that is not empty, by boundary and by event.
  Taken take(std::size_t lap, std::int32_t begin);
  bool all_taken() const { return next_ == sampled_.size() && has_ended(); }

 private:
  static constexpr std::size_t kAtOnce = 32;  // boundaries
  /// Between two events; kNone and their number: the sides of the sector.
  struct Arc {
    std::int32_t begin, end;
    bool empty = false;
  };
  struct Waiting {
    double length;
    std::int32_t event;
  };
  struct Sampled {
    std::size_t lap;
    std::int32_t begin;
    bool empty;
    std::size_t end;  // of its points
  };
  struct Angles {
    double from, to;
  };
  struct Run {  // of samples
    double first, last;
  };
  /// The samples of an arc: numbers first to last of 0 to `count`.
  struct Steps {
    double from, to;  // radians in the sector
    double count = 1, first = 0, last = 0;
    double turn(double k) const { return from + (to - from) * (k / count); }
    double last_up_to(double angle) const { return std::floor((angle - from) / (to - from) * count); }
  };

  /// Along the samples of an arc.
  struct Walk {
    const Steps& steps;
    double stride, longest_leap;  // samples on, at most: wherever it may begin, and from here
    std::vector<Angles>::const_iterator empty;
    double previous = -1;  // sample that is not empty
    bool driven = false;   // is it to be driven? Of others nothing more is asked, and they are not empty
  };

  bool has_ended() const;
  void sample_laps();
  void split_arcs(std::vector<std::int32_t>& events);
  Steps steps_of(const Arc& arc) const;
  Point direction(double turn) const { return rotated({1, 0}, node_.begin + turn); }  // from the node, a unit vector
  Point at(double turn) const { return node_.at + radius_ * direction(turn); }
  void sample(Arc& arc);
  double look_at(double k, Walk& walk);
  double leap(Walk& walk);
  bool leap_to(double next, const Walk& walk);
  bool is_driven(const Point& p) const { return !sampling_.keep || sampling_.keep(p); }
  bool is_trimmed(const Point& p) const;
  void remember_empty(Arc& arc, const Steps& steps);
  double longest_stride(double turn_per_step) const;
  void add(const Point& p);

  const BergBoundary& b_;
  const BergNode& node_;
  const std::vector<BergBoundary::Event>& events_;
  const BergSampling& sampling_;
  std::size_t lap_;               // the next one to be sampled
  std::vector<Arc> arcs_;         // in it, but for what happens at its length
  std::vector<Waiting> waiting_;  // events, the next one last
  std::vector<Angles> empty_;     // where samples are hidden or trimmed, ascending, disjoint

  double length_ = 0, radius_ = 0;  // of the present boundary and of its arcs
  std::size_t first_point_ = 0;     // of the present arc
  std::vector<Run> kept_;           // of the present arc

  std::vector<Sampled> sampled_;
  std::vector<Point> points_;
  std::size_t next_ = 0, taken_points_ = 0;
};

}  // namespace oxturn
