#include "algorithms/lanes/boundary_arcs.hpp"

#include <algorithm>
#include <utility>

namespace oxturn {
namespace {

// Of a ring. Slightly more than half, so that rounding does not decide where arcs take half of a symmetric ring.
constexpr double kMostInArcs = 0.52;

}  // namespace

BoundaryArcs::BoundaryArcs(const EdgeIndex& boundary) : boundary_(boundary) {
  const std::vector<EdgeIndex::Edge>& edges = boundary.edges();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e == 0 || edges[e].a != edges[e - 1].b) loops_.push_back({e, e, 0});
    Loop& loop = loops_.back();
    loop_of_edge_.push_back(loops_.size() - 1);
    along_.push_back(loop.length);
    loop.last = e;
    loop.length += distance(edges[e].a, edges[e].b);
  }
}

void BoundaryArcs::add(const Point& p) {
  const auto nearest = boundary_.nearest(p);
  if (!nearest) return;
  const std::size_t e = nearest->edge;
  const double along = along_[e] + distance(boundary_.edges()[e].a, nearest->point);
  stops_.push_back({loop_of_edge_[e], along, e, nearest->point});
}

std::vector<Ring> BoundaryArcs::take(double join) {
  std::sort(stops_.begin(), stops_.end());
  std::vector<Ring> arcs;
  for (std::size_t from = 0; from < stops_.size();) {
    std::size_t to = from;
    while (to < stops_.size() && stops_[to].loop == stops_[from].loop) ++to;
    add_arcs({stops_.begin() + static_cast<std::ptrdiff_t>(from), stops_.begin() + static_cast<std::ptrdiff_t>(to)},
             join, arcs);
    from = to;
  }
  stops_.clear();
  return arcs;
}

/// All stops of one loop, in order.
void BoundaryArcs::add_arcs(const std::vector<Stop>& stops, double join, std::vector<Ring>& arcs) const {
  const Loop& loop = loops_[stops.front().loop];
  const std::size_t n = stops.size();
  const auto gap_after = [&](std::size_t k) {
    return k + 1 < n ? stops[k + 1].along - stops[k].along : stops[0].along + loop.length - stops[k].along;
  };
  std::vector<std::size_t> ends;  // of arcs
  for (std::size_t k = 0; k < n; ++k)
    if (gap_after(k) > join) ends.push_back(k);
  double off = 0;  // of the loop
  for (const std::size_t k : ends) off += gap_after(k);
  if (loop.length - off >= kMostInArcs * loop.length) {
    Ring whole;
    for (std::size_t e = loop.first; e <= loop.last; ++e) whole.push_back(boundary_.edges()[e].a);
    arcs.push_back(std::move(whole));
    return;
  }
  for (std::size_t k = 0; k < ends.size(); ++k)
    arcs.push_back(arc(stops[(ends[(k + ends.size() - 1) % ends.size()] + 1) % n], stops[ends[k]]));
}

Ring BoundaryArcs::arc(const Stop& from, const Stop& to) const {
  const Loop& loop = loops_[from.loop];
  Ring line{from.at};
  const auto go = [&](const Point& p) {
    if (p != line.back()) line.push_back(p);
  };
  const bool same_edge = from.edge == to.edge && from.along <= to.along;
  for (std::size_t e = from.edge; !same_edge;) {
    go(boundary_.edges()[e].b);
    e = e == loop.last ? loop.first : e + 1;
    if (e == to.edge) break;
  }
  go(to.at);
  for (std::size_t k = line.size(); k-- > 2;) line.push_back(line[k - 1]);  // and back
  return line;
}

}  // namespace oxturn
