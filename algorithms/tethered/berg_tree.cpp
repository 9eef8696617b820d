#include "algorithms/tethered/berg_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace oxturn {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

BergTree::BergTree(const BergBoundary& boundary, double step, double longest, double spacing,
                   const std::function<bool(const Point&, double)>& keep, const std::function<bool()>& stop)
    : boundary_(boundary) {
  const double last = std::min(longest * (1 + 1e-12), boundary.farthest());
  std::size_t previous = 0;  // where the lap before begins in pieces_
  while ((laps_ + 1) * step <= last && !stop()) {
    const double length = ++laps_ * step;
    const std::size_t begin = pieces_.size();
    for (BergBoundary::Piece& found : boundary.at(length, spacing)) {
      Piece piece;
      piece.lap = laps_;
      piece.length = length;
      piece.divider = found.divider;
      std::erase_if(found.points, [&](const Point& p) { return !keep(p, length); });
      piece.points = std::move(found.points);
      if (laps_ > 1) {  // the piece of the lap before that holds the place just left of our divider
        auto parent = begin;
        while (parent > previous && pieces_[parent - 1].divider > piece.divider) --parent;
        piece.parent = static_cast<int>((parent > previous ? parent : begin) - 1);
      }
      pieces_.push_back(std::move(piece));
    }
    previous = begin;
  }
  // What leads to nothing is left out, so that it does not count as a branch.
  std::vector<bool> useful(pieces_.size());
  for (std::size_t i = pieces_.size(); i-- > 0;) {
    useful[i] = useful[i] || !pieces_[i].points.empty();
    if (useful[i] && pieces_[i].parent >= 0) useful[at(pieces_[i].parent)] = true;
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (useful[i] && pieces_[i].parent >= 0) pieces_[at(pieces_[i].parent)].children.push_back(static_cast<int>(i));
  std::vector<int> first;
  for (std::size_t i = 0; i < pieces_.size() && pieces_[i].lap == 1; ++i)
    if (useful[i]) first.push_back(static_cast<int>(i));
  // Breadth-first, so that regions are numbered by growing length.
  std::vector<std::pair<int, int>> open;  // first piece, parent region
  for (const int piece : first) open.emplace_back(piece, -1);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [start, parent] = open[i];
    Region region;
    int piece = start;
    region.pieces.push_back(piece);
    while (pieces_[at(piece)].children.size() == 1)
      region.pieces.push_back(piece = pieces_[at(piece)].children.front());
    const int index = static_cast<int>(regions_.size());
    regions_.push_back(std::move(region));
    (parent < 0 ? roots_ : regions_[at(parent)].children).push_back(index);
    for (const int child : pieces_[at(piece)].children) open.emplace_back(child, index);
  }
}

bool BergTree::grew_from(int piece, int ancestor) const {
  while (piece >= 0 && pieces_[at(piece)].lap > pieces_[at(ancestor)].lap) piece = pieces_[at(piece)].parent;
  return piece == ancestor;
}

/// Dividers from the place of one piece to that of another, to the left or to the right.
std::vector<int> BergTree::run(int from, int to, bool left) const {
  const int n = static_cast<int>(boundary_.dividers().size());
  // The place of a piece: just left of its divider.
  const int a = pieces_[at(from)].divider, b = pieces_[at(to)].divider;
  std::vector<int> out;
  if (left)
    for (int d = (a + 1) % n;; d = (d + 1) % n) {
      out.push_back(d);
      if (d == b) break;
    }
  else
    for (int d = a;; d = (d + n - 1) % n) {
      out.push_back(d);
      if (d == (b + 1) % n) break;
    }
  return out;
}

std::vector<int> BergTree::between(int from, int to) const {
  if (grew_from(to, from) || grew_from(from, to)) return {};
  const auto length = [&](int divider) { return boundary_.dividers()[at(divider)].length; };
  std::vector<int> best;
  double farthest = -1;
  for (const bool left : {true, false}) {
    const std::vector<int> all = run(from, to, left);
    const auto lowest = std::min_element(all.begin(), all.end(), [&](int a, int b) { return length(a) < length(b); });
    if (length(*lowest) <= farthest) continue;
    farthest = length(*lowest);
    best.clear();
    double limit = pieces_[at(from)].length;
    for (auto d = all.begin(); d <= lowest; ++d)
      if (length(*d) < limit) {
        best.push_back(*d);
        limit = length(*d);
      }
    std::vector<int> rest;
    limit = pieces_[at(to)].length;
    for (auto d = all.end() - 1; d > lowest; --d)
      if (length(*d) < limit) {
        rest.push_back(*d);
        limit = length(*d);
      }
    best.insert(best.end(), rest.rbegin(), rest.rend());
  }
  return best;
}

}  // namespace oxturn
