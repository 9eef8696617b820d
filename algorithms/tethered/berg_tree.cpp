#include "algorithms/tethered/berg_tree.hpp"

#include <algorithm>
#include <utility>

namespace oxturn {

BergTree::BergTree(const BergBoundary& boundary, const Laps& laps, const std::function<bool(const Point&)>& keep,
                   const std::function<bool()>& stop)
    : boundary_(boundary) {
  add_laps(laps, keep, stop);
  const std::vector<bool> useful = find_useful();
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (useful[i] && pieces_[i].parent) pieces_[*pieces_[i].parent].children.push_back(i);
  for (Piece& piece : pieces_)  // round the boundary, also where they are of different laps
    std::ranges::stable_sort(piece.children, {}, [&](std::size_t child) { return pieces_[child].divider; });
  add_regions(useful);
  number_pieces();
  find_lower_dividers();
}

/// A lap's pieces until the next lap's are known. Far from the anchor most are empty, and so are all that grow from
/// them: of these only those from which several grow are kept, and otherwise their parents stand in for them.
class BergTree::OpenLap {
 public:
  OpenLap() = default;
  OpenLap(std::size_t lap, double length, std::vector<BergBoundary::Piece> found, OpenLap& before) {
    for (BergBoundary::Piece& f : found) {
      pieces_.push_back({{lap, length, f.divider, std::nullopt, {}, std::move(f.points)}, before.grow_at(f.divider)});
      keep_all_ = lap == 1;
    }
  }

  /// Moves those that are kept to the end of `pieces`.
  void close(std::vector<Piece>& pieces) {
    for (Open& open : pieces_) {
      open.stands_for = open.piece.parent;
      if (!keep_all_ && open.piece.points.empty() && open.children < 2) continue;
      open.stands_for = pieces.size();
      pieces.push_back(std::move(open.piece));
    }
  }
  /// After the lap before has been closed.
  void find_parents(const OpenLap& before) {
    for (Open& open : pieces_)
      if (open.parent) open.piece.parent = before.pieces_[*open.parent].stands_for;
  }

 private:
  struct Open {
    Piece piece;
    std::optional<std::size_t> parent = std::nullopt;  // in the lap before
    std::size_t children = 0;
    std::optional<std::size_t> stands_for = std::nullopt;  // the piece that is kept
  };

  /// The parent contains the point just left of our divider: the last piece of the lap before that begins no later, or,
  /// round the circle, its last piece.
  std::optional<std::size_t> grow_at(const std::optional<std::size_t>& divider) {
    if (pieces_.empty()) return std::nullopt;
    const auto after =
        std::ranges::upper_bound(pieces_, divider, {}, [](const Open& open) { return open.piece.divider; });
    const auto parent =
        static_cast<std::size_t>((after > pieces_.begin() ? after : pieces_.end()) - pieces_.begin()) - 1;
    ++pieces_[parent].children;
    return parent;
  }

  std::vector<Open> pieces_;
  bool keep_all_ = false;
};

namespace {

/// How many multiples of the step are at most `last`.
std::size_t laps_up_to(double last, double step) {
  constexpr double kMost = 1e15;  // no such path ends
  auto count = static_cast<std::size_t>(std::min(std::max(last / step, 0.0), kMost));
  while (static_cast<double>(count + 1) * step <= last && static_cast<double>(count) < kMost) ++count;
  while (count > 0 && static_cast<double>(count) * step > last) --count;
  return count;
}

}  // namespace

void BergTree::add_laps(const Laps& laps, const std::function<bool(const Point&)>& keep,
                        const std::function<bool()>& stop) {
  const double last = std::min(laps.longest * (1 + 1e-12), boundary_.farthest());
  const BergLengths lengths{laps.step, laps_up_to(last, laps.step)};
  BergSweep sweep(boundary_, {lengths, laps.spacing, laps.thinning, laps.trim, keep});
  OpenLap before;
  for (std::size_t lap = 1; !sweep.at_end() && !stop(); ++lap) {
    OpenLap next(lap, lengths[lap - 1], sweep.next(), before);
    before.close(pieces_);
    next.find_parents(before);
    before = std::move(next);
  }
  before.close(pieces_);
}

/// Pieces with points, or with descendants that have points: others must not count as branches.
std::vector<bool> BergTree::find_useful() const {
  std::vector<bool> useful(pieces_.size());
  for (std::size_t i = pieces_.size(); i-- > 0;) {
    useful[i] = useful[i] || !pieces_[i].points.empty();
    if (useful[i] && pieces_[i].parent) useful[*pieces_[i].parent] = true;
  }
  return useful;
}

/// Breadth-first, so that regions are numbered by increasing length.
void BergTree::add_regions(const std::vector<bool>& useful) {
  struct Open {
    std::size_t first_piece;
    std::optional<std::size_t> parent;  // region
  };
  std::vector<Open> open;
  for (std::size_t i = 0; i < pieces_.size() && pieces_[i].lap == 1; ++i)
    if (useful[i]) open.push_back({i, std::nullopt});
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [first, parent] = open[i];
    const std::size_t index = regions_.size();
    Region& region = regions_.emplace_back();
    std::size_t piece = first;
    region.pieces.push_back(piece);
    while (pieces_[piece].children.size() == 1) region.pieces.push_back(piece = pieces_[piece].children.front());
    (parent ? regions_[*parent].children : roots_).push_back(index);
    for (const std::size_t child : pieces_[piece].children) open.push_back({child, index});
  }
}

/// In the order of a walk round the tree.
void BergTree::number_pieces() {
  span_.assign(pieces_.size(), {0, 0});
  std::size_t count = 0;
  std::vector<std::pair<std::size_t, std::size_t>> stack;  // piece, children done
  for (std::size_t root = 0; root < pieces_.size() && pieces_[root].lap == 1; ++root) {
    stack.assign(1, {root, 0});
    span_[root].first = ++count;
    while (!stack.empty()) {
      auto& [piece, done] = stack.back();
      const std::vector<std::size_t>& children = pieces_[piece].children;
      if (done == children.size()) {
        span_[piece].second = count;
        stack.pop_back();
        continue;
      }
      const std::size_t child = children[done++];
      span_[child].first = ++count;
      stack.push_back({child, 0});
    }
  }
}

bool BergTree::grew_from(std::size_t piece, std::size_t ancestor) const {
  return span_[ancestor].first <= span_[piece].first && span_[piece].first <= span_[ancestor].second;
}

/// Twice round, so that the second time all that comes after is known.
void BergTree::find_lower_dividers() {
  const std::size_t n = boundary_.dividers().size();
  for (const Turn turn : {Turn::left, Turn::right}) {
    std::vector<std::size_t>& lower = turn == Turn::left ? lower_left_ : lower_right_;
    lower.resize(n);
    std::vector<std::size_t> chain;  // of those that come after, the lowest first
    for (std::size_t k = 2 * n; k-- > 0;) {
      const std::size_t d = turn == Turn::left ? k % n : n - 1 - k % n;
      while (!chain.empty() && length_at(chain.back()) >= length_at(d)) chain.pop_back();
      lower[d] = chain.empty() ? d : chain.back();
      chain.push_back(d);
    }
  }
}

/// A piece lies just left of its divider.
BergTree::Passage BergTree::passage(Turn turn, std::size_t from, std::size_t to) const {
  const std::size_t n = boundary_.dividers().size();
  const bool left = turn == Turn::left;
  const std::size_t a = *pieces_[from].divider, b = *pieces_[to].divider;
  const std::size_t first = left ? (a + 1) % n : a, last = left ? b : (b + 1) % n;
  const auto steps = [&](std::size_t d) { return left ? (d + n - first) % n : (first + n - d) % n; };  // from the first
  const std::vector<std::size_t>&ahead = left ? lower_left_ : lower_right_, &back = left ? lower_right_ : lower_left_;
  Passage found;
  // Appends the divider if it is lower than `limit`.
  const auto offer = [&](std::size_t d, double limit, std::vector<std::size_t>& out) {
    if (length_at(d) < limit) out.push_back(d);
  };
  std::size_t lowest = first;
  offer(first, pieces_[from].length, found.gates);
  for (std::size_t d = ahead[first]; steps(d) > steps(lowest) && steps(d) <= steps(last); d = ahead[d]) {
    offer(d, pieces_[from].length, found.gates);
    lowest = d;
  }
  found.lowest = length_at(lowest);
  std::vector<std::size_t> ascent;
  for (std::size_t d = last, before = n; steps(d) > steps(lowest) && steps(d) < before; d = back[d]) {
    offer(d, pieces_[to].length, ascent);
    before = steps(d);
  }
  found.gates.insert(found.gates.end(), ascent.rbegin(), ascent.rend());
  return found;
}

std::vector<std::size_t> BergTree::between(std::size_t from, std::size_t to) const {
  if (grew_from(to, from) || grew_from(from, to)) return {};
  Passage left = passage(Turn::left, from, to), right = passage(Turn::right, from, to);
  return right.lowest > left.lowest ? std::move(right.gates) : std::move(left.gates);
}

}  // namespace oxturn
