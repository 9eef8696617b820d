/// Short detours that cover pieces beside a path.
///
///   auto [longer, detours] = with_detours(path, parts, enough, 0.499 * w, connector, walls);
///
///     ---->----.  .---->----        Stop: the robot leaves the path where it passes the piece, goes towards it until
///               \/                  the tool reaches all of it, and comes back.
///               ()
///
/// A piece that no single position covers gets a stroke (strokes.hpp). Of all detours those are made that are shortest
/// for what they cover. Pieces that none reaches on straight lines stay as they are.
///
/// Complexity  O(s + p) for s segments and p pieces, if a piece is near to few segments, and O(d^2) for d detours
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/lanes/nearby_segments.hpp"
#include "algorithms/transit/connector.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// From a point of a path and back to it.
struct Detour {
  std::size_t segment = 0;
  double along = 0;  // of the segment, metres
  Polyline points;   // the first and the last are the point on the path
  double length = 0;
  std::optional<std::size_t> turn = {};  // of a stop: the vertex of the path that it may cut off (lanes/stops.hpp)
  double cut = 0;                        // metres before and after that vertex
};

/// A piece to be covered, or as much of it as is worth it.
struct ToCover {
  Polygon whole;
  std::vector<Polygon> parts;  // of it; one is the whole
};

struct WithDetours {
  Polyline path;
  std::vector<Polyline> detours;  // what it drives besides: nothing that it covered before is lost
};

/// `enough`: square metres after which no more detours are made. `reach`: metres from the robot's centre within which
/// it covers. Pieces of less area than `noticed` get stops only. `walls`: those of the connector.
WithDetours with_detours(const Polyline& path, const std::vector<ToCover>& pieces, double enough, double noticed,
                         double reach, const Connector& connector, const EdgeIndex& walls);

}  // namespace oxturn
