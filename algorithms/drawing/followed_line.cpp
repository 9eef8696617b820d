#include "algorithms/drawing/followed_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "algorithms/smoothing/curve.hpp"
#include "base/math.hpp"
#include "geometry/bends.hpp"

namespace oxturn {
namespace {

constexpr double kRoom = 1.001;        // of the tangents of a corner's arc
constexpr double kEdge = 0.25;         // radii: longer edges near sharp bends are divided
constexpr double kSharpest = 2.6;      // radians: no arc rounds such a corner
constexpr double kStraight = 1e-9;     // 1 / radii
constexpr double kSameHeading = 1e-6;  // radians

double turn(double from, double to) { return std::remainder(to - from, 2 * kPi); }

std::vector<double> arc_lengths(const Polyline& line) {
  std::vector<double> at{0};
  for (std::size_t k = 1; k < line.size(); ++k) at.push_back(at.back() + distance(line[k - 1], line[k]));
  return at;
}

/// A position that moves along a polyline.
class Walker {
 public:
  explicit Walker(const Polyline& line) : line_(line), at_(arc_lengths(line)) {}
  double length() const { return at_.back(); }
  const std::vector<double>& at() const { return at_; }
  /// Never less than before. Sets the edge that holds it.
  Point move_to(double metres) {
    while (edge_ + 2 < line_.size() && at_[edge_ + 1] < metres) ++edge_;
    const double d = at_[edge_ + 1] - at_[edge_];
    return lerp(line_[edge_], line_[edge_ + 1], d > 0 ? std::clamp((metres - at_[edge_]) / d, 0.0, 1.0) : 0);
  }
  double heading_here() const { return heading(line_[edge_], line_[edge_ + 1]); }

 private:
  const Polyline& line_;
  std::vector<double> at_;
  std::size_t edge_ = 0;
};

class Follower {
 public:
  Follower(const Polyline& line, const FollowOptions& options) : options_(options) {
    for (const Point& p : line)
      if (line_.empty() || distance(p, line_.back()) > options.tolerance) line_.push_back(p);
    if (line_.size() > 1)
      line_.back() = line.back();
    else
      line_.push_back(line.back());
  }

  std::vector<Polyline> run() {
    const std::vector<std::size_t> sharp = sharp_vertices(line_, false, options_);
    if (sharp.empty()) return {line_};
    divide(sharp);
    piece_ = {line_.front()};
    std::size_t at = 0;
    for (const auto& [low, high] : stretches_) {
      for (; at < low; ++at) piece_.push_back(line_[at + 1]);
      follow(low, high);
      at = high;
    }
    for (; at + 1 < line_.size(); ++at) piece_.push_back(line_[at + 1]);
    end_piece();
    return split();
  }

 private:
  using Span = std::pair<std::size_t, std::size_t>;

  /// Marks what is near sharp vertices, as far as an arc might begin, and divides the long edges there.
  void divide(const std::vector<std::size_t>& sharp) {
    const std::vector<double> at = arc_lengths(line_);
    std::vector<std::pair<double, double>> near;
    for (const std::size_t v : sharp) {
      const double d = std::abs(turn(heading(line_[v - 1], line_[v]), heading(line_[v], line_[v + 1])));
      const double reach = kRoom * options_.radius * math::tan(std::min(d, kSharpest) / 2);
      const double low = std::max(0.0, at[v] - reach), high = std::min(at.back(), at[v] + reach);
      if (!near.empty() && low <= near.back().second)
        near.back().second = std::max(near.back().second, high);
      else
        near.push_back({low, high});
    }
    Polyline divided;
    std::size_t next = 0;
    for (std::size_t k = 0; k < line_.size(); ++k) {
      divided.push_back(line_[k]);
      if (k + 1 == line_.size()) break;
      divide_edge(k, at, near, next, divided);
    }
    close_spans(near, divided);
    line_ = std::move(divided);
  }

  void divide_edge(std::size_t k, const std::vector<double>& at, const std::vector<std::pair<double, double>>& near,
                   std::size_t& next, Polyline& divided) const {
    while (next < near.size() && near[next].second <= at[k]) ++next;
    std::vector<double> cuts;
    for (std::size_t s = next; s < near.size() && near[s].first < at[k + 1]; ++s) {
      const double low = std::max(near[s].first, at[k]), high = std::min(near[s].second, at[k + 1]);
      const double parts = std::ceil((high - low) / (kEdge * options_.radius));
      for (double p = 0; p <= parts; ++p) cuts.push_back(low + (high - low) * p / parts);
    }
    for (const double cut : cuts)
      if (cut > at[k] + options_.tolerance && cut < at[k + 1] - options_.tolerance)
        divided.push_back(lerp(line_[k], line_[k + 1], (cut - at[k]) / (at[k + 1] - at[k])));
  }

  void close_spans(const std::vector<std::pair<double, double>>& near, const Polyline& divided) {
    const std::vector<double> at = arc_lengths(divided);
    for (const auto& [low, high] : near) {
      const double slack = 2 * options_.tolerance + 1e-12 * at.back();
      auto first = std::lower_bound(at.begin(), at.end(), low - slack) - at.begin();
      auto last = std::upper_bound(at.begin(), at.end(), high + slack) - at.begin() - 1;
      stretches_.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(last)});
    }
  }

  double heading_into(std::size_t k) const { return heading(line_[k - 1], line_[k]); }
  double heading_out_of(std::size_t k) const { return heading(line_[k], line_[k + 1]); }
  double heading_through(std::size_t k) const { return heading_into(k) + turn(heading_into(k), heading_out_of(k)) / 2; }

  void follow(std::size_t low, std::size_t high) {
    const bool ends = high + 1 == line_.size();
    std::optional<double> at;  // the heading
    if (piece_.size() > 1) at = heading(piece_[piece_.size() - 2], piece_.back());
    for (std::size_t i = low; i < high;) {
      std::size_t next = i;
      if (at) next = farthest(i, high, [&](std::size_t j) { return smooth(i, j, *at, target(j, high, ends)); });
      if (next > i) {
        append(*smooth(i, next, *at, target(next, high, ends)));
        at = target(next, high, ends);
      } else if (at && smooth(i, i + 1, *at, heading_into(i + 1))) {  // up to a corner
        next = i + 1;
        append(*smooth(i, next, *at, heading_into(next)));
        at = heading_into(next);
      } else {
        end_piece();
        next = std::max(i + 1, farthest(i, high, [&](std::size_t j) { return arc(i, j); }));
        Polyline piece = arc(i, next).value_or(Polyline{line_[i], line_[next]});
        at = arc_end_;
        append(piece);
      }
      i = next;
    }
    if (!ends && at && std::abs(turn(*at, heading_out_of(high))) > kSameHeading) end_piece();
  }

  double target(std::size_t j, std::size_t high, bool ends) const {
    if (j == high) return ends ? heading_into(j) : heading_out_of(j);
    return heading_through(j);
  }

  /// The largest j for which there is a piece from i, by doubling and halving; i if there is none.
  template <class Piece>
  std::size_t farthest(std::size_t i, std::size_t high, Piece piece) const {
    if (piece(high)) return high;
    std::size_t good = i, step = 1;
    while (good + step < high && piece(good + step)) good += step, step *= 2;
    for (; step > 0; step /= 2)
      if (good + step < high && piece(good + step)) good += step;
    return good;
  }

  std::optional<Polyline> smooth(std::size_t i, std::size_t j, double from, double to) const {
    const Curve curve = dubins_curve({line_[i], from}, {line_[j], to}, options_.radius);
    if (curve.length() > 2 * (distance(line_[i], line_[j]) + options_.deviation) + kPi * options_.radius)
      return std::nullopt;
    std::vector<Leg> legs = sampled(curve, options_.chord_error, true);
    if (legs.size() != 1 || !follows(legs[0].points, i, j)) return std::nullopt;
    return std::move(legs[0].points);
  }

  /// Through both points, as curved as the line between them, or as the radius allows. Sets arc_end_.
  std::optional<Polyline> arc(std::size_t i, std::size_t j) const {
    const Point &a = line_[i], &b = line_[j];
    const double chord = distance(a, b), along = heading(a, b);
    arc_end_ = along;
    if (j == i + 1) return Polyline{a, b};
    if (!(chord > 0)) return std::nullopt;
    const Polyline part(line_.begin() + static_cast<std::ptrdiff_t>(i),
                        line_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    Walker walker(part);
    const Point middle = walker.move_to(walker.length() / 2) - a;
    const double sagitta = cross((b - a) / chord, middle);
    double curvature = -8 * sagitta / (chord * chord + 4 * sagitta * sagitta);  // left positive
    curvature = std::clamp(curvature, -1 / options_.radius, 1 / options_.radius);
    if (std::abs(curvature) * options_.radius < kStraight) {
      Polyline straight{a, b};
      return follows(straight, i, j) ? std::optional(straight) : std::nullopt;
    }
    const double half = std::abs(curvature) * chord / 2;
    if (half >= 1) return std::nullopt;
    const double turned = math::asin(half) * (curvature > 0 ? 1 : -1);
    const Pose from{a, along - turned}, to{b, along + turned};
    const Curve curve{from,
                      to,
                      1 / std::abs(curvature),
                      {{curvature > 0 ? Steering::left : Steering::right, 2 * std::abs(turned / curvature)}}};
    std::vector<Leg> legs = sampled(curve, options_.chord_error, true);
    if (legs.size() != 1 || !follows(legs[0].points, i, j)) return std::nullopt;
    arc_end_ = to.heading;
    return std::move(legs[0].points);
  }

  /// At equal shares of their lengths the piece and the line from i to j are near each other, with like headings.
  bool follows(const Polyline& piece, std::size_t i, std::size_t j) const {
    const Polyline part(line_.begin() + static_cast<std::ptrdiff_t>(i),
                        line_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    Walker a(part), b(piece);
    std::vector<double> shares;
    for (const Walker* w : {&a, &b})
      for (std::size_t k = 0; k < w->at().size(); ++k) {
        shares.push_back(w->at()[k] / w->length());
        if (k > 0) shares.push_back((w->at()[k] + w->at()[k - 1]) / 2 / w->length());
      }
    std::sort(shares.begin(), shares.end());
    for (const double share : shares) {
      if (distance(a.move_to(share * a.length()), b.move_to(share * b.length())) > options_.deviation) return false;
      if (std::abs(turn(a.heading_here(), b.heading_here())) > options_.turn) return false;
    }
    return !options_.free || options_.free(piece);
  }

  void append(const Polyline& points) {
    for (const Point& p : points)
      if (piece_.empty() || p != piece_.back()) piece_.push_back(p);
  }
  /// The next piece begins where this one ends.
  void end_piece() {
    const Point at = piece_.back();
    if (piece_.size() > 1) pieces_.push_back(std::move(piece_));
    piece_ = {at};
  }

  /// What still bends too sharply, as where an arc meets a short edge, is cut there.
  std::vector<Polyline> split() const {
    std::vector<Polyline> result;
    for (const Polyline& piece : pieces_) {
      std::size_t from = 0;
      for (const std::size_t v : sharp_vertices(piece, false, options_)) {
        result.emplace_back(piece.begin() + static_cast<std::ptrdiff_t>(from),
                            piece.begin() + static_cast<std::ptrdiff_t>(v) + 1);
        from = v;
      }
      result.emplace_back(piece.begin() + static_cast<std::ptrdiff_t>(from), piece.end());
    }
    return result;
  }

  const FollowOptions& options_;
  Polyline line_;
  std::vector<Span> stretches_;
  Polyline piece_;
  std::vector<Polyline> pieces_;
  mutable double arc_end_ = 0;
};

}  // namespace

std::vector<std::size_t> sharp_vertices(const Polyline& line, bool closed, const FollowOptions& options) {
  Path path{{{.points = line}}};
  if (closed && line.size() > 2) path.legs[0].points.push_back(line[1]);
  std::vector<std::size_t> found;
  std::size_t k = 1;
  for (const Bend& bend : bends(path, options.tolerance, options.tool_width)) {
    while (k < line.size() && line[k] != bend.at) ++k;
    if (too_sharp(bend, options.radius)) found.push_back(k == line.size() - 1 && closed ? 0 : k);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<Polyline> followed_line(const Polyline& line, const FollowOptions& options) {
  return Follower(line, options).run();
}

}  // namespace oxturn
