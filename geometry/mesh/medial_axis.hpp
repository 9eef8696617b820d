/// The medial axis of a region, and the bridges between its rings that it tells.
///
///   const Region open = cut_along(space, shortest_bridges(space), 1e-3);   // shortest_bridges.hpp: no holes any more
///   const MedialAxis axis = medial_axis(open, 1e-3);
///   axis.nodes[s.node].at;  s.foot;                       // for each spoke s: straight to the boundary
///
/// The axis are the points with two or more nearest boundary points. Parabolas are chords. From each node a spoke leads
/// to each of its nearest boundary points; axis and spokes cut the region into convex faces. Of a polygon without holes
/// the axis is a tree, whose leaves are the convex vertices.
///
/// Voronoi diagrams of edges by Boost.Polygon, exact on a lattice of 2^-30 of the extent. O(n log n) for n edges, and
/// the chords.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

struct MedialAxis {
  struct Node {
    Point at;
    double clearance = 0;  // metres to the boundary
  };
  struct Edge {
    std::size_t a, b;  // nodes
  };
  struct Spoke {
    std::size_t node;
    Point foot;  // on the boundary; at a convex vertex the node itself
  };
  std::vector<Node> nodes = {};
  std::vector<Edge> edges = {};
  std::vector<Spoke> spokes = {};  // by their feet: ring by ring, in the order of its vertices
};

/// `chord_error`: metres between a parabola and its chords. Throws std::invalid_argument unless it is positive.
MedialAxis medial_axis(const Region& region, double chord_error);

struct RingBridges {
  std::vector<Polyline> all = {}, tree = {};  // the shortest first
};
/// The straight lines between different rings that are shorter than all others near them: where the axis between two
/// rings is nearest to both. No two cross. Among them is the minimum spanning tree that connects the rings of each
/// polygon, as shortest_bridges() finds without the axis.
RingBridges bridges_between_rings(const Region& region);

}  // namespace oxturn
