#include "algorithms/smoothing/drivable_visits.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/smoothing/covering_strokes.hpp"
#include "algorithms/smoothing/needless_strokes.hpp"
#include "algorithms/smoothing/reinserted_strokes.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {
namespace {

constexpr int kRounds = 6;            // each begins with what is exactly uncovered
constexpr double kNoticed = 1e-4;     // squares of the tool's width: smaller pieces are not visited
constexpr double kSlack = 0.97;       // of what may stay uncovered: others measure with errors of their own
constexpr double kLeastGain = 0.02;   // of a piece, or
constexpr double kLeastArea = 2e-3;   // squares of the tool's width: what a visit is worth
constexpr std::size_t kFeasible = 2;  // strokes that can be inserted, of which the better one is
constexpr std::size_t kFailures = 4;  // points of a piece that no stroke gets to, before it is left alone
constexpr double kSamePoint = 0.06;   // tool widths: nearer to a point that failed, others fail too
constexpr double kNear = 2;           // tool widths and radii from a new visit: others may have become cheaper
constexpr double kDetour = 10;        // radii that a detour there and back takes, as a rule
constexpr double kLost = 2e-5;        // of the target, between the points of a raster
constexpr double kLower = 0.6;        // of what the last visits were worth, the next ones may be

class Visits {
 public:
  /// `strokes`: of the path, for the effort.
  Visits(const Problem& problem, const VisitLimits& limits, const CarSpace& space, std::size_t strokes,
         Context& context)
      : problem_(problem),
        width_(problem.robot().tool_width),
        allowed_(kSlack * limits.allowed),
        least_worth_(limits.least_gain * problem.robot().tool_width),
        space_(space),
        context_(context),
        effort_(strokes),
        links_(space, strokes) {}

  std::vector<LinkedStroke> run(std::vector<LinkedStroke> driven, const std::vector<Polyline>& left_out) {
    UncoveredPoints points = uncovered_by(driven);
    cover_by_links(driven, points);
    if (!left_out.empty()) driven = with_strokes(std::move(driven), left_out, links_, width_, effort_, context_);
    for (int round = 0; round < kRounds && !context_.cancelled(); ++round) {
      points = uncovered_by(driven);
      if (points.area() <= allowed_) break;
      std::size_t inserted = 0;
      driven = with_best_visits(std::move(driven), points, inserted);
      if (inserted == 0) break;
      context_.publish(path_of(driven, problem_.start(), space_.chord_error()));
    }
    return without_needless(std::move(driven));
  }

 private:
  /// What would be covered next of an uncovered piece.
  struct Piece {
    const std::vector<std::size_t>* points;
    double whole = 0;  // square metres
    Box box;
    std::size_t failures = 0;
    Polyline stroke = {};                      // the best one; empty: not known
    double worth = 0;                          // square metres for each metre that the path becomes longer
    bool changed = false, left_alone = false;  // changed: the path near it is another one
  };

  UncoveredPoints uncovered_by(const std::vector<LinkedStroke>& driven) const {
    const Path path = path_of(driven, problem_.start(), space_.chord_error());
    return {uncovered(problem_.target(), path, problem_.robot()), width_, kNoticed * width_ * width_};
  }

  /// What is lost between the points of the raster is visited again. Stays as it is if that does not help, or if it
  /// became no shorter.
  std::vector<LinkedStroke> without_needless(std::vector<LinkedStroke> driven) {
    if (context_.cancelled()) return driven;
    std::vector<LinkedStroke> rest = without_needless_strokes(driven, problem_.target(), width_, space_, context_);
    if (rest.size() == driven.size()) return driven;
    allowed_ = uncovered_by(driven).area() + kLost * area(problem_.target());
    UncoveredPoints points = uncovered_by(rest);
    if (points.area() > allowed_) {
      std::size_t inserted = 0;
      rest = with_best_visits(std::move(rest), points, inserted);
      if (uncovered_by(rest).area() > allowed_) return driven;
    }
    return metres(rest) < metres(driven) ? rest : driven;
  }

  double metres(const std::vector<LinkedStroke>& driven) const {
    double sum = 0;
    for (const LinkedStroke& s : driven) sum += space_.cost(s.link) + length(s.stroke);
    return sum;
  }

  void cover_by_links(std::vector<LinkedStroke>& driven, UncoveredPoints& points) const {
    for (LinkedStroke& s : driven) {
      if (s.link.pieces.empty()) continue;
      const Polyline line = points_of(s.link, space_.chord_error());
      if (!points.covers_any(line)) continue;
      points.cover(line);
      s.covers = true;
    }
  }

  static std::vector<Piece> pieces_of(const UncoveredPoints& points) {
    std::vector<Piece> pieces;
    for (const std::vector<std::size_t>& piece : points.pieces()) {
      pieces.push_back({&piece, 0, {}});
      for (const std::size_t k : piece) {
        pieces.back().whole += points.share(k);
        pieces.back().box.add(points.at(k));
      }
    }
    return pieces;
  }

  /// A greedy cover: always what is worth most next, in steps. After each step, the path has new ends and edges near
  /// the visits inserted, so that others near by may follow them and become cheaper.
  std::vector<LinkedStroke> with_best_visits(std::vector<LinkedStroke> driven, UncoveredPoints& points,
                                             std::size_t& inserted) {
    std::vector<Piece> pieces = pieces_of(points);
    double least = -1;
    while (points.area() > allowed_ && !context_.cancelled()) {
      InsertedStrokes more(std::move(driven), links_, width_, effort_, context_);
      for (Piece& piece : pieces) {
        if (std::exchange(piece.changed, false) && !piece.stroke.empty()) evaluate(piece, points, more);
        if (piece.stroke.empty() && !piece.left_alone) choose(piece, points, more);
      }
      std::erase_if(pieces, [](const Piece& piece) { return piece.left_alone; });
      std::ranges::stable_sort(pieces, std::greater{}, &Piece::worth);
      if (pieces.empty() || pieces.front().worth < least_worth_ || context_.cancelled()) return more.take();
      if (least < 0 || pieces.front().worth < least) least = std::max(kLower * pieces.front().worth, least_worth_);
      std::vector<Box> changed;
      for (Piece& piece : pieces) {
        if (piece.worth < least || points.area() <= allowed_) break;
        if (auto box = insert_if_worth(least, piece, points, more)) changed.push_back(*box);
      }
      inserted += changed.size();
      look_again(pieces, changed);
      driven = more.take();
    }
    return driven;
  }

  bool failed_before(const Point& p) const {
    return std::ranges::any_of(failed_, [&](const Point& q) { return distance(p, q) < kSamePoint * width_; });
  }

  /// Metres that the path becomes longer count at least as a tool's width.
  double worth(double gain, const InsertedStrokes::Insertion& insertion) const {
    return gain / std::max(insertion.cost, width_);
  }

  /// Detours are long: is so much worth one there and back?
  bool worth_search(double gain) const { return gain >= least_worth_ * kDetour * space_.radius(); }

  double least_gain(const Piece& piece) const {
    return std::min(kLeastGain * piece.whole, kLeastArea * width_ * width_);
  }

  /// The piece's best stroke, or it is left alone.
  void choose(Piece& piece, const UncoveredPoints& points, const InsertedStrokes& more) {
    for (const std::size_t k : *piece.points) {
      if (context_.cancelled()) return;
      if (points.covered(k) || failed_before(points.at(k))) continue;
      if (choose_over(k, piece, points, more)) return;
      failed_.push_back(points.at(k));
      if (++piece.failures >= kFailures) break;
    }
    piece.left_alone = true;
  }

  /// What the stroke is worth now.
  void evaluate(Piece& piece, const UncoveredPoints& points, const InsertedStrokes& more) {
    const auto insertion = more.insertion_of(piece.stroke, false);
    if (!insertion) return;
    const double gained = gain(*insertion, points);
    piece.worth = worth(gained, *insertion);
    if (gained < least_gain(piece)) piece.stroke.clear();
  }

  bool choose_over(std::size_t k, Piece& piece, const UncoveredPoints& points, const InsertedStrokes& more) {
    std::vector<CoveringStroke> strokes = covering_strokes(points, k, space_, width_);
    std::erase_if(strokes, [&](const CoveringStroke& s) { return s.gain < least_gain(piece); });
    std::size_t feasible = 0;
    piece.worth = 0;
    const auto offer = [&](const CoveringStroke& s, bool search) {
      const auto insertion = more.insertion_of(s.points, search);
      if (!insertion) return;
      ++feasible;
      const double value = worth(gain(*insertion, points), *insertion);
      if (value > piece.worth) piece.worth = value, piece.stroke = s.points;
    };
    for (const CoveringStroke& s : strokes)
      if (feasible < kFeasible) offer(s, false);
    if (feasible == 0 && !strokes.empty() && worth_search(strokes.front().gain)) offer(strokes.front(), true);
    return !piece.stroke.empty();
  }

  std::vector<Polyline> lines(const InsertedStrokes::Insertion& insertion) const {
    std::vector<Polyline> all{points_of(insertion.to, space_.chord_error()), insertion.stroke};
    if (insertion.back) all.push_back(points_of(*insertion.back, space_.chord_error()));
    return all;
  }
  double gain(const InsertedStrokes::Insertion& insertion, const UncoveredPoints& points) const {
    return points.gain(lines(insertion));
  }

  static void fail(Piece& piece) {
    piece.stroke.clear();
    piece.left_alone = ++piece.failures >= kFailures;
  }

  /// Where it was inserted. nullopt: it is worth less now, and another look may find a better one.
  std::optional<Box> insert_if_worth(double least, Piece& piece, UncoveredPoints& points, InsertedStrokes& more) {
    auto insertion = more.insertion_of(piece.stroke, false);
    if (!insertion && worth_search(points.gain({piece.stroke}))) insertion = more.insertion_of(piece.stroke, true);
    if (!insertion) {
      fail(piece);
      return std::nullopt;
    }
    const double gained = gain(*insertion, points);
    piece.worth = worth(gained, *insertion);
    if (gained < least_gain(piece)) {
      fail(piece);
      return std::nullopt;
    }
    if (piece.worth < least) return std::nullopt;
    for (const Polyline& line : lines(*insertion)) points.cover(line);
    const Box box = bounding_box(insertion->stroke);
    more.insert(std::move(*insertion));
    piece.stroke.clear();
    return box;
  }

  /// Pieces near the visits inserted: they may cost less now, and be covered in part.
  void look_again(std::vector<Piece>& pieces, const std::vector<Box>& changed) const {
    std::vector<Box> boxes;
    for (const Piece& piece : pieces) boxes.push_back(piece.box);
    const BoxIndex index(std::move(boxes));
    for (Box box : changed) {
      box.grow(kNear * (width_ + space_.radius()));
      for (const std::uint32_t i : index.overlapping(box)) pieces[i].changed = true;
    }
  }

  const Problem& problem_;
  double width_, allowed_, least_worth_;
  const CarSpace& space_;
  Context& context_;
  DetourEffort effort_;
  KnownLinks links_;
  std::vector<Point> failed_;  // points that no stroke gets to
};

}  // namespace

std::vector<LinkedStroke> with_visits(const Problem& problem, std::vector<LinkedStroke> driven,
                                      const std::vector<Polyline>& left_out, const VisitLimits& limits,
                                      const CarSpace& space, Context& context) {
  if (driven.empty() || context.cancelled()) return driven;
  Visits visits(problem, limits, space, driven.size() + left_out.size(), context);
  return visits.run(std::move(driven), left_out);
}

}  // namespace oxturn
