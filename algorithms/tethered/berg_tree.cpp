#include "algorithms/tethered/berg_tree.hpp"

#include <algorithm>
#include <utility>

namespace oxturn {

BergTree::BergTree(const BergBoundary& boundary, const Laps& laps,
                   const std::function<bool(const Point&, double)>& keep, const std::function<bool()>& stop)
    : boundary_(boundary) {
  add_laps(laps, keep, stop);
  const std::vector<bool> useful = find_useful();
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (useful[i] && pieces_[i].parent) pieces_[*pieces_[i].parent].children.push_back(i);
  add_regions(useful);
}

void BergTree::add_laps(const Laps& laps, const std::function<bool(const Point&, double)>& keep,
                        const std::function<bool()>& stop) {
  const double last = std::min(laps.longest * (1 + 1e-12), boundary_.farthest());
  std::size_t previous = 0;  // index of the first piece of the lap before
  for (std::size_t lap = 1; static_cast<double>(lap) * laps.step <= last && !stop(); ++lap) {
    const double length = static_cast<double>(lap) * laps.step;
    const std::size_t begin = pieces_.size();
    for (BergBoundary::Piece& found : boundary_.at(length, laps.spacing)) {
      Piece piece{lap, length, found.divider, std::nullopt, {}, {}};
      std::erase_if(found.points, [&](const Point& p) { return !keep(p, length); });
      piece.points = std::move(found.points);
      if (lap > 1) {
        // The parent contains the point just left of our divider: the last piece of the lap before that begins no
        // later, or, round the circle, its last piece.
        std::size_t after = begin;
        while (after > previous && pieces_[after - 1].divider > piece.divider) --after;
        piece.parent = (after > previous ? after : begin) - 1;
      }
      pieces_.push_back(std::move(piece));
    }
    previous = begin;
  }
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

bool BergTree::grew_from(std::size_t piece, std::size_t ancestor) const {
  while (pieces_[piece].lap > pieces_[ancestor].lap && pieces_[piece].parent) piece = *pieces_[piece].parent;
  return piece == ancestor;
}

/// Dividers from one piece to another, turning to the left or to the right. A piece lies just left of its divider.
std::vector<std::size_t> BergTree::dividers_on(Turn turn, std::size_t from, std::size_t to) const {
  const std::size_t n = boundary_.dividers().size();
  const std::size_t a = *pieces_[from].divider, b = *pieces_[to].divider;
  const std::size_t first = turn == Turn::left ? (a + 1) % n : a, last = turn == Turn::left ? b : (b + 1) % n;
  std::vector<std::size_t> dividers{first};
  while (dividers.back() != last) dividers.push_back((dividers.back() + (turn == Turn::left ? 1 : n - 1)) % n);
  return dividers;
}

std::vector<std::size_t> BergTree::between(std::size_t from, std::size_t to) const {
  if (grew_from(to, from) || grew_from(from, to)) return {};
  std::vector<std::size_t> best;
  double farthest = -1;  // lowest divider in the best direction
  for (const Turn turn : {Turn::left, Turn::right}) {
    const std::vector<std::size_t> all = dividers_on(turn, from, to);
    const auto lowest = std::min_element(all.begin(), all.end(),
                                         [&](std::size_t a, std::size_t b) { return length_at(a) < length_at(b); });
    if (length_at(*lowest) <= farthest) continue;
    farthest = length_at(*lowest);
    // Appends the dividers that are lower than all before them and than `limit`.
    const auto descend = [&](auto begin, auto end, double limit, std::vector<std::size_t>& out) {
      for (auto d = begin; d != end; ++d)
        if (length_at(*d) < limit) {
          out.push_back(*d);
          limit = length_at(*d);
        }
    };
    best.clear();
    descend(all.begin(), lowest + 1, pieces_[from].length, best);
    std::vector<std::size_t> ascent;
    descend(all.rbegin(), std::make_reverse_iterator(lowest + 1), pieces_[to].length, ascent);
    best.insert(best.end(), ascent.rbegin(), ascent.rend());
  }
  return best;
}

}  // namespace oxturn
