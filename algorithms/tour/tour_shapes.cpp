#include "algorithms/tour/tour_shapes.hpp"

#include <algorithm>

#include "algorithms/tour/shape_chains.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Costs between patterns that are known by their ends. The depot's patterns come first.
class ShapeCost final : public ConnectionCost {
 public:
  bool symmetric(const std::vector<PatternId>& reverse) const override {
    return reversible() && std::find(reverse.begin(), reverse.end(), kNoPattern) == reverse.end();
  }
  bool reversible() const { return forbidden_.empty(); }
  const std::vector<Ends>* ends() const override { return &ends_; }
  double operator()(PatternId from, PatternId to) const override {
    if (free_exit_[from] || free_entry_[to]) return 0;
    if (!forbidden_.empty() && is_forbidden(owner_[from], owner_[to])) return kForbidden;
    const Point &a = ends_[from].exit, &b = ends_[to].entry;
    return connection_ ? connection_(a, b) : (a - b).norm();
  }

  void add(const Ends& ends, std::size_t owner, bool free_entry = false, bool free_exit = false) {
    ends_.push_back(ends);
    owner_.push_back(owner);
    free_entry_.push_back(free_entry);
    free_exit_.push_back(free_exit);
  }
  void forbid(std::size_t from, std::size_t to) { forbidden_.push_back({from, to}); }
  void finish(std::function<double(const Point&, const Point&)> connection) {
    connection_ = std::move(connection);
    std::sort(forbidden_.begin(), forbidden_.end());
  }

 private:
  bool is_forbidden(std::size_t from, std::size_t to) const {
    return std::binary_search(forbidden_.begin(), forbidden_.end(), std::pair(from, to));
  }

  std::vector<Ends> ends_;
  std::vector<std::size_t> owner_;                              // element of each pattern
  std::vector<bool> free_entry_, free_exit_;                    // of the depot: connections there cost nothing
  std::vector<std::pair<std::size_t, std::size_t>> forbidden_;  // pairs of elements, sorted
  std::function<double(const Point&, const Point&)> connection_;
};

double length_of(const TourShape& shape) {
  double sum = shape.closed ? distance(shape.points.back(), shape.points.front()) : 0;
  for (std::size_t i = 1; i < shape.points.size(); ++i) sum += distance(shape.points[i - 1], shape.points[i]);
  return sum;
}

}  // namespace

std::string label(const std::vector<TourShape>& shapes, std::size_t shape) {
  const std::string& name = shapes[shape].name;
  return name.empty() ? fmt::format("{}", shape) : fmt::format("'{}'", name);
}

struct ShapeTourModel::Impl {
  explicit Impl(ShapeTour d) : drawing(std::move(d)), element_of(drawing.shapes.size(), kNone) {
    check_shapes();
    for (ShapeChain& chain : chains_of(drawing)) add_element(std::move(chain));
    for (std::size_t s = 0; s < drawing.shapes.size(); ++s)
      if (element_of[s] == kNone) add_element({{s, 0, drawing.shapes[s].closed ? 0 : last(s)}});
    build();
  }

  std::size_t last(std::size_t s) const { return drawing.shapes[s].points.size() - 1; }
  const Point& at(std::size_t s, std::size_t vertex) const { return drawing.shapes[s].points[vertex]; }

  void check_shapes() const {
    if (drawing.shapes.empty()) throw_invalid("a tour over shapes has no shapes; expected at least one");
    for (std::size_t s = 0; s < drawing.shapes.size(); ++s)
      if (drawing.shapes[s].points.empty()) throw_invalid("shape {} has no points, expected at least one", s);
    for (const auto& [outer, inner] : drawing.contained)
      if (outer == inner || std::max(outer, inner) >= drawing.shapes.size())
        throw_invalid("shape {} cannot contain shape {}; expected two of the shapes 0 to {}", outer, inner,
                      drawing.shapes.size() - 1);
  }

  void add_element(ShapeChain chain) {
    for (const ShapeLink& link : chain) element_of[link.shape] = chains.size() + 1;
    chains.push_back(std::move(chain));
  }

  double connection(const Point& a, const Point& b) const {
    return drawing.connection ? drawing.connection(a, b) : distance(a, b);
  }
  /// A chain's own length, with the connections inside it.
  double inner_cost(const ShapeChain& chain) const {
    double sum = 0;
    for (std::size_t k = 0; k < chain.size(); ++k) {
      sum += length_of(drawing.shapes[chain[k].shape]);
      if (k > 0) sum += connection(at(chain[k - 1].shape, chain[k - 1].exit), at(chain[k].shape, chain[k].entry));
    }
    return sum;
  }

  /// Which directions a chain may be driven in: one-way shapes and containment inside the chain decide.
  std::pair<bool, bool> directions(const ShapeChain& chain) const {
    bool forwards = true, backwards = true;
    const auto allow_only = [&](bool forward) { (forward ? backwards : forwards) = false; };
    for (const ShapeLink& link : chain) {
      const TourShape& shape = drawing.shapes[link.shape];
      if (shape.one_way && !shape.closed && last(link.shape) > 0) allow_only(link.entry == 0);
    }
    if (drawing.containment == Containment::strict)
      for (const auto& [outer, inner] : drawing.contained)
        if (chain.size() > 1 && element_of[outer] == element_of[inner] && in(chain, outer) != chain.size() &&
            in(chain, inner) != chain.size())
          allow_only(in(chain, inner) < in(chain, outer));
    if (!forwards && !backwards)
      throw_invalid(
          "the joined shapes {} to {} can be driven in neither direction; remove a joint, a one-way shape or "
          "a containment",
          label(drawing.shapes, chain.front().shape), label(drawing.shapes, chain.back().shape));
    return {forwards, backwards};
  }
  static std::size_t in(const ShapeChain& chain, std::size_t shape) {
    const auto same = [&](const ShapeLink& l) { return l.shape == shape; };
    return static_cast<std::size_t>(std::find_if(chain.begin(), chain.end(), same) - chain.begin());
  }

  /// The whole tour may be driven backwards at the same cost.
  bool reversible() const {
    return cost.reversible() && std::all_of(chains.begin(), chains.end(), [&](const ShapeChain& chain) {
             return directions(chain) == std::pair(true, true);
           });
  }
  /// Left where it is entered: a polygon or a point, alone.
  bool is_entered_anywhere(const ShapeChain& chain) const {
    const TourShape& shape = drawing.shapes[chain[0].shape];
    return chain.size() == 1 && (shape.closed || shape.points.size() == 1);
  }
  /// The elements' patterns; those of a polygon are its vertices.
  void add_patterns() {
    for (const ShapeChain& chain : chains) {
      const std::size_t element = counts.size();
      const ShapeLink &head = chain.front(), &tail = chain.back();
      const auto first = static_cast<PatternId>(own_costs.size());
      const double own = inner_cost(chain);
      if (is_entered_anywhere(chain)) {
        for (const Point& p : drawing.shapes[head.shape].points) add_pattern({p, p}, element, own, own_costs.size());
      } else {
        const auto [forwards, backwards] = directions(chain);
        const Point &a = at(head.shape, head.entry), &b = at(tail.shape, tail.exit);
        const bool both = forwards && backwards;
        if (forwards) add_pattern({a, b}, element, own, both ? first + 1 : kNoPattern);
        if (backwards) add_pattern({b, a}, element, own, both ? first : kNoPattern);
      }
      counts.push_back(own_costs.size() - first);
    }
  }
  void add_pattern(const ConnectionCost::Ends& ends, std::size_t element, double own, std::size_t reversed) {
    cost.add(ends, element);
    own_costs.push_back(own);
    reverse.push_back(static_cast<PatternId>(reversed));
  }

  void build() {
    const Point anywhere = at(chains.front().front().shape, chains.front().front().entry);
    const Point start = drawing.start.value_or(anywhere), end = drawing.end.value_or(anywhere);
    const bool free_start = !drawing.start, free_end = !drawing.end;
    if (drawing.containment == Containment::literal)
      for (const auto& [outer, inside] : drawing.contained)
        if (element_of[outer] != element_of[inside]) cost.forbid(element_of[outer], element_of[inside]);
    cost.finish(drawing.connection);
    // A depot's entry is where the tour ends, its exit where it starts.
    cost.add({end, start}, 0, free_end, free_start);
    if (reversible()) cost.add({start, end}, 0, free_start, free_end);
    counts = {reversible() ? 2u : 1u};
    reverse = reversible() ? std::vector<PatternId>{1, 0} : std::vector<PatternId>{kNoPattern};
    own_costs.assign(counts[0], 0.0);
    add_patterns();
    problem.emplace(cost, counts, reverse, own_costs);
    if (drawing.containment == Containment::strict)
      for (const auto& [outer, inside] : drawing.contained)
        if (element_of[outer] != element_of[inside])
          problem->require_before(static_cast<ElementId>(element_of[inside]),
                                  static_cast<ElementId>(element_of[outer]));
  }

  ShapeTour drawing;
  std::vector<std::size_t> element_of;  // of each shape
  std::vector<ShapeChain> chains;       // of each element but the depot
  ShapeCost cost;
  std::vector<std::size_t> counts;
  std::vector<PatternId> reverse;
  std::vector<double> own_costs;  // of each pattern
  std::optional<TourProblem> problem;
};

ShapeTourModel::ShapeTourModel(ShapeTour drawing) : impl_(std::make_unique<const Impl>(std::move(drawing))) {}
ShapeTourModel::~ShapeTourModel() = default;
ShapeTourModel::ShapeTourModel(ShapeTourModel&&) noexcept = default;

const TourProblem& ShapeTourModel::problem() const { return *impl_->problem; }

std::vector<ShapeVisit> ShapeTourModel::visits(const Tour& tour) const {
  std::vector<ShapeVisit> visits;
  for (const TourStop& stop : tour) {
    if (stop.element == 0) continue;
    const ShapeChain& chain = impl_->chains[stop.element - 1];
    if (impl_->is_entered_anywhere(chain)) {
      visits.push_back({chain[0].shape, stop.pattern});
      continue;
    }
    const bool both = impl_->problem->pattern_count(static_cast<ElementId>(stop.element)) == 2;
    const bool backwards = both ? stop.pattern == 1 : !impl_->directions(chain).first;
    if (!backwards)
      for (const ShapeLink& link : chain) visits.push_back({link.shape, link.entry});
    else
      for (auto link = chain.rbegin(); link != chain.rend(); ++link) visits.push_back({link->shape, link->exit});
  }
  return visits;
}

}  // namespace oxturn
