/// Splits the edges of an overlay until any two meet at common ends only. Private to geometry, not installed.
///
///   resolve(edges);  // sorted by their ends from then on
///
/// Method      Rounds: edges that come near each other are found (close_pairs.hpp), split at points rounded to the
///             lattice, sorted, and equal ones merged. To split an edge moves it by less than a quantum, so the pieces
///             of two edges can only meet if the edges came within two quanta of each other: the pairs of the first
///             round say which pieces have to be looked at again. Mostly none has to be split, and the second round,
///             which would take as long as the first, is left out.
/// Complexity  O((n + k) log n) for n edges that meet k times, usual data
#pragma once

#include <vector>

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {

/// Equal edges become one with the sum of their weights, edges without weight vanish.
void resolve(std::vector<OverlayEdge>& edges);

/// Calls f(edge) for the edge from p to q, with the given weight to its left; for none if p == q.
template <class F>
void directed(const LatticePoint& p, const LatticePoint& q, Windings weight, F f) {
  if (p < q)
    f(OverlayEdge{p, q, weight});
  else if (q < p)
    f(OverlayEdge{q, p, Windings{} - weight});
}

}  // namespace oxturn
