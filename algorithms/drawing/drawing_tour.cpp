#include "algorithms/drawing/drawing_tour.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

#include "algorithms/drawing/stroke_copies.hpp"
#include "algorithms/smoothing/curve.hpp"
#include "algorithms/tour/shape_chains.hpp"
#include "algorithms/tour/solve_tour.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

constexpr std::uint64_t kKicksEach = 600;          // for each element, and at most
constexpr std::uint64_t kKicks = 150'000;          // or the solver's default, if that is more
constexpr std::uint64_t kKicksEachToImprove = 80;  // the same for tours to be improved, and at most
constexpr std::uint64_t kKicksToImprove = 10'000;
constexpr std::uint64_t kFew = 100, kFewerKicks = 6;  // so few elements need fewer for each, but in all
constexpr std::uint64_t kLeastKicks = 15'000, kLeastKicksToImprove = 2'000;
constexpr std::size_t kMostRemembered = 5000;    // patterns: 100 MB
constexpr std::size_t kMostDirectedEntries = 8;  // of a closed stroke that has a heading there; in both directions

/// What is driven as one: one element, or several that are joined. Its visits in driving order.
using Chain = std::vector<ElementVisit>;

/// Costs between patterns. Pattern 0 is the start; 1 is the same if the tour is driven backwards.
class DrawingCost final : public ConnectionCost {
 public:
  explicit DrawingCost(double radius) : radius_(radius) {}

  bool symmetric(const std::vector<PatternId>& reverse) const override {
    return reversible_ && std::find(reverse.begin(), reverse.end(), kNoPattern) == reverse.end();
  }
  const std::vector<Ends>* ends() const override { return &ends_; }
  double operator()(PatternId from, PatternId to) const override {
    if (free_entry_[to] || free_exit_[from]) return 0;
    if (has_raised_[from])
      if (const auto known = raised_.find(key(from, to)); known != raised_.end()) return known->second;
    if (is_forbidden(from, to)) return kForbidden;
    if (!(radius_ > 0) || from < starts_ || to < starts_) return distance(exits_[from].at, entries_[to].at);
    if (known_.empty()) return curve_length(from, to);
    float& known = known_[from * ends_.size() + to];
    if (known < 0) known = static_cast<float>(curve_length(from, to));
    return known;
  }
  /// All patterns are there. Lengths of curves are remembered, unless there are too many.
  void finish(const std::vector<PatternId>& reverse) {
    if (symmetric(reverse)) reverse_ = reverse;
    if (radius_ > 0 && ends_.size() <= kMostRemembered) known_.assign(ends_.size() * ends_.size(), -1);
  }

  void add_start(const Point& at, bool forwards) {
    add({at, 0}, {at, 0}, {}, {});
    free_entry_.back() = forwards;
    free_exit_.back() = !forwards;
    ++starts_;
  }
  void add(const Pose& entry, const Pose& exit, const ElementPort& in, const ElementPort& out) {
    ends_.push_back({entry.at, exit.at});
    entries_.push_back(entry);
    exits_.push_back(exit);
    in_.push_back(in);
    out_.push_back(out);
    free_entry_.push_back(false);
    free_exit_.push_back(false);
    has_raised_.push_back(0);
  }
  void forbid(const ElementPort& a, const ElementPort& b) { ports_.insert({a, b}), ports_.insert({b, a}); }
  /// No direct connection from one element to another.
  void forbid(std::size_t from, std::size_t to) { elements_.insert({from, to}), reversible_ = false; }
  void raise(PatternId from, PatternId to, double cost) {
    raised_[key(from, to)] = cost;
    has_raised_[from] = 1;
  }

 private:
  static std::uint64_t key(PatternId from, PatternId to) { return std::uint64_t{from} << 32 | to; }
  /// Where headings are aligned, rounding decides whether a curve has a full turn; driven backwards it may decide
  /// otherwise. A local search that relies on symmetric costs would never end, so the shorter of both counts.
  double curve_length(PatternId from, PatternId to) const {
    const auto length = [&](PatternId p, PatternId q) {
      return dubins_curve(exits_[p], entries_[q], radius_).length();
    };
    if (reverse_.empty()) return length(from, to);
    const PatternId p = reverse_[to], q = reverse_[from];
    return std::min(length(from, to), length(p, q));
  }
  bool is_forbidden(PatternId from, PatternId to) const {
    if (from < starts_ || to < starts_) return false;
    return (!ports_.empty() && ports_.count({out_[from], in_[to]}) > 0) ||
           (!elements_.empty() && elements_.count({out_[from].element, in_[to].element}) > 0);
  }

  double radius_;
  bool reversible_ = true;
  std::vector<PatternId> reverse_;  // by pattern; empty: costs depend on the direction
  std::size_t starts_ = 0;
  std::vector<Ends> ends_;
  std::vector<Pose> entries_, exits_;
  std::vector<ElementPort> in_, out_;  // by pattern
  std::vector<bool> free_entry_, free_exit_;
  std::set<std::pair<ElementPort, ElementPort>> ports_;
  std::set<std::pair<std::size_t, std::size_t>> elements_;
  std::unordered_map<std::uint64_t, double> raised_;  // looked up, never listed
  std::vector<std::uint8_t> has_raised_;              // by pattern: some connection from there
  mutable std::vector<float> known_;                  // lengths of curves by patterns; below 0: not yet
};

}  // namespace

struct DrawingTour::Impl {
  Impl(const std::vector<DrawingElement>& all, TourDemands d, const Point& start, double radius)
      : elements(all), demands(std::move(d)), directed(radius > 0), cost(radius), element_of(all.size()) {
    add_chains();
    for (const auto& [a, b] : demands.deleted) cost.forbid(a, b);
    if (demands.containment == Containment::literal)
      for (const auto& [outer, inner] : demands.contained)
        if (element_of[outer] != element_of[inner]) cost.forbid(outer, inner);
    add_patterns(start);
    cost.finish(reverse);
    problem.emplace(cost, counts, reverse);
    if (demands.containment == Containment::strict)
      for (const auto& [outer, inner] : demands.contained)
        if (element_of[outer] != element_of[inner])
          problem->require_before(static_cast<ElementId>(element_of[inner]), static_cast<ElementId>(element_of[outer]));
  }

  /// Joined elements as chains, and copies of a stroke; all others are chains of one.
  void add_chains() {
    ShapeTour drawing;
    for (const DrawingElement& e : elements) {
      TourShape shape{.points = {e.first(), e.last()}, .closed = e.closed, .name = e.name};
      if (e.closed) shape.points.assign(e.legs[0].points.begin(), e.legs[0].points.end() - 1);
      drawing.shapes.push_back(std::move(shape));
    }
    for (const auto& [a, b] : demands.joined) drawing.joined.push_back({{a.element, a.at}, {b.element, b.at}});
    joined.assign(elements.size(), false);
    for (const ShapeChain& links : chains_of(drawing)) {
      Chain chain;
      for (const ShapeLink& link : links) {
        const bool closed = elements[link.shape].closed;
        chain.push_back({link.shape, closed ? link.entry : 0, !closed && link.entry != 0});
        joined[link.shape] = true;
      }
      add_chain(std::move(chain));
    }
    std::vector<bool> apart = joined;  // not to be driven with its copies
    for (const auto& [a, b] : demands.deleted) apart[a.element] = apart[b.element] = true;
    for (const std::vector<StrokeCopy>& copies : stroke_copies(elements)) {
      const bool any_apart = std::ranges::any_of(copies, [&](const StrokeCopy& c) { return apart[c.element]; });
      std::size_t k = any_apart ? 0 : add_copies(copies);
      for (; k < copies.size(); ++k)
        if (const std::size_t e = copies[k].element; !joined[e]) add_chain({visit(e, false)});
    }
  }
  ElementVisit visit(std::size_t e, bool turned) const {
    return {e, elements[e].closed ? elements[e].entries.front() : 0, turned && !elements[e].closed};
  }
  /// Many copies of a stroke as one chain, of open ones an odd number. Returns how many.
  std::size_t add_copies(const std::vector<StrokeCopy>& copies) {
    const bool closed = elements[copies[0].element].closed;
    const std::size_t n = closed || copies.size() % 2 == 1 ? copies.size() : copies.size() - 1;
    if (n < 2 || directed || demands.containment == Containment::literal) return 0;
    Chain chain;
    for (std::size_t k = 0; k < n; ++k) chain.push_back(visit(copies[k].element, copies[k].turned != (k % 2 == 1)));
    if (!allowed(chain)) return 0;
    add_chain(std::move(chain));
    return n;
  }
  void add_chain(Chain chain) {
    for (const ElementVisit& visit : chain) element_of[visit.element] = chains.size() + 1;
    chains.push_back(std::move(chain));
  }

  TourEffort effort(std::uint64_t each, std::uint64_t least, std::uint64_t most) const {
    const std::uint64_t n = chains.size();
    return {.kicks = std::clamp(n > kFew ? each * n : each * n / kFewerKicks, least, most)};
  }

  static Chain backwards(Chain chain) {
    std::reverse(chain.begin(), chain.end());
    for (ElementVisit& visit : chain) visit.backwards = !visit.backwards;
    return chain;
  }
  /// Neither a one-way element nor containment is against it.
  bool allowed(const Chain& chain) const {
    std::map<std::size_t, std::size_t> position;
    for (const ElementVisit& visit : chain) {
      if (visit.backwards && elements[visit.element].one_way) return false;
      position[visit.element] = position.size();
    }
    if (demands.containment == Containment::literal || chain.size() == 1) return true;
    return std::none_of(demands.contained.begin(), demands.contained.end(), [&](const auto& pair) {
      const auto outer = position.find(pair.first), inner = position.find(pair.second);
      return outer != position.end() && inner != position.end() && outer->second < inner->second;
    });
  }

  /// All chains that drive the same as this one, each with its reverse beside it where it is of use.
  std::vector<Chain> variants(const Chain& chain) const {
    std::vector<Chain> all;
    const DrawingElement& e = elements[chain[0].element];
    if (!is_entered_anywhere(chain)) {
      for (const Chain& c : {chain, backwards(chain)})
        if (allowed(c)) all.push_back(c);
      if (all.empty())
        throw_invalid("the connected elements '{}' to '{}' can be driven in neither direction; remove a connection",
                      e.name, elements[chain.back().element].name);
      return all;
    }
    const std::size_t step = directed ? (e.entries.size() + kMostDirectedEntries - 1) / kMostDirectedEntries : 1;
    for (std::size_t k = 0; k < e.entries.size(); k += step) {
      all.push_back(chain);
      for (ElementVisit& visit : all.back()) visit.entry = e.entries[k];
      if (directed) all.push_back({{chain[0].element, e.entries[k], true}});
    }
    return all;
  }

  void add_patterns(const Point& start) {
    std::vector<std::vector<Chain>> all;
    bool reversible = demands.containment == Containment::strict || demands.contained.empty();
    for (const Chain& chain : chains) {
      all.push_back(variants(chain));
      if (all.back().size() < 2 && !is_entered_anywhere(chain)) reversible = false;
    }
    cost.add_start(start, true);
    if (reversible) cost.add_start(start, false);
    counts = {reversible ? 2u : 1u};
    reverse = reversible ? std::vector<PatternId>{1, 0} : std::vector<PatternId>{kNoPattern};
    pattern_chains.assign(counts[0], {});
    for (std::vector<Chain>& of_chain : all) {
      const bool pairs = directed || !is_entered_anywhere(of_chain[0]);
      for (std::size_t k = 0; k < of_chain.size(); ++k) add_pattern(of_chain[k], pairs, k, of_chain.size());
      counts.push_back(of_chain.size());
    }
  }
  /// A closed stroke, or the copies of one, that nothing is joined to.
  bool is_entered_anywhere(const Chain& chain) const {
    return elements[chain[0].element].closed && !joined[chain[0].element];
  }
  void add_pattern(const Chain& chain, bool pairs, std::size_t k, std::size_t of) {
    const ElementVisit &in = chain.front(), &out = chain.back();
    const DrawingElement &first = elements[in.element], &last = elements[out.element];
    const auto id = static_cast<PatternId>(pattern_chains.size());
    cost.add(entry_pose(first, in), exit_pose(last, out), entry_port(first, in), exit_port(last, out));
    reverse.push_back(!pairs ? id : of == 1 ? kNoPattern : k % 2 == 0 ? id + 1 : id - 1);
    pattern_of[pattern_key(in)] = id;
    ending_in[pattern_key(out)] = id;
    pattern_chains.push_back(chain);
  }
  static std::tuple<std::size_t, std::size_t, bool> pattern_key(const ElementVisit& v) {
    return {v.element, v.entry, v.backwards};
  }

  std::vector<ElementVisit> visits(const Tour& tour) const {
    std::vector<ElementVisit> order;
    for (const TourStop& stop : tour) {
      const Chain& chain = pattern_chains[problem->pattern_of(stop)];
      order.insert(order.end(), chain.begin(), chain.end());
    }
    return order;
  }
  Tour tour(const std::vector<ElementVisit>& order) const {
    Tour tour{problem->stop_of(0)};
    for (std::size_t k = 0; k < order.size();) {
      const PatternId p = pattern_of.at(pattern_key(order[k]));
      tour.push_back(problem->stop_of(p));
      k += pattern_chains[p].size();
    }
    return tour;
  }

  const std::vector<DrawingElement>& elements;
  TourDemands demands;
  bool directed;
  DrawingCost cost;
  std::vector<std::size_t> element_of;  // of the tour, by element of the drawing
  std::vector<bool> joined;             // by element of the drawing: a person demands a connection
  std::vector<Chain> chains;            // by element of the tour, less 1
  std::vector<std::size_t> counts;
  std::vector<PatternId> reverse;
  std::vector<Chain> pattern_chains;                                                      // by pattern
  std::map<std::tuple<std::size_t, std::size_t, bool>, PatternId> pattern_of, ending_in;  // by first and last visit
  std::optional<TourProblem> problem;
};

DrawingTour::DrawingTour(const std::vector<DrawingElement>& elements, TourDemands demands, const Point& start,
                         double radius)
    : impl_(std::make_unique<Impl>(elements, std::move(demands), start, radius)) {}
DrawingTour::~DrawingTour() = default;

std::vector<ElementVisit> DrawingTour::solve(Context& context) const {
  return impl_->visits(solve_tour(
      *impl_->problem, context,
      impl_->effort(kKicksEach, kLeastKicks, std::max(kKicks, TourEffort{}.kicks_for(impl_->chains.size())))));
}

std::vector<ElementVisit> DrawingTour::improve(const std::vector<ElementVisit>& order, Context& context) const {
  const TourEffort effort = impl_->effort(kKicksEachToImprove, kLeastKicksToImprove, kKicksToImprove);
  return impl_->visits(improved_tour(*impl_->problem, impl_->tour(order), context, effort));
}

bool DrawingTour::allows(const std::vector<ElementVisit>& order) const {
  std::vector<std::size_t> position(impl_->elements.size());
  PatternId last = 0;
  for (std::size_t k = 0; k < order.size();) {
    const auto found = impl_->pattern_of.find(Impl::pattern_key(order[k]));
    if (found == impl_->pattern_of.end() || impl_->cost(last, found->second) >= kForbidden) return false;
    last = found->second;
    for (const ElementVisit& visit : impl_->pattern_chains[last]) {
      if (k == order.size() || order[k] != visit) return false;
      position[visit.element] = k++;
    }
  }
  if (impl_->demands.containment == Containment::literal) return true;
  return std::all_of(impl_->demands.contained.begin(), impl_->demands.contained.end(),
                     [&](const auto& pair) { return position[pair.second] < position[pair.first]; });
}

const TourDemands& DrawingTour::demands() const { return impl_->demands; }

double DrawingTour::cost(const std::vector<ElementVisit>& order) const {
  return impl_->problem->cost(impl_->tour(order));
}

void DrawingTour::raise(const ElementVisit* from, const ElementVisit& to, double cost) {
  const auto q = impl_->pattern_of.find(Impl::pattern_key(to));
  PatternId p = 0;
  if (from != nullptr) {
    const auto found = impl_->ending_in.find(Impl::pattern_key(*from));
    if (found == impl_->ending_in.end()) return;  // a connection inside a chain
    p = found->second;
  }
  if (q == impl_->pattern_of.end()) return;
  impl_->cost.raise(p, q->second, cost);
  if (impl_->problem->symmetric()) impl_->cost.raise(impl_->reverse[q->second], impl_->reverse[p], cost);
}

}  // namespace oxturn
