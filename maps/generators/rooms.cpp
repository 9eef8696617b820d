// An apartment or office floor: rooms by recursive halving, corridors, doors.
//
// Method      Halve the floor until every piece is a room; large pieces are halved by a corridor instead of a wall.
//             Doors along a spanning tree that prefers corridors (Kruskal), then random further doors.
// Guarantee   Every room is reached through doors at least `passage` robot diameters wide. Rooms are at least two doors
//             wide, so the first rooms on either side of any cut share enough wall for a door: the tree exists.
// Complexity  O(cells of wall thickness)
// Decisions   1. Everything is a multiple of the wall's thickness, stretched a little to fill the size; drawn on bits
//                and traced, so walls are exact.
//             2. Where two corridors meet, they are open to each other over the whole width.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = 15, height = 12; }
  int rooms = 9;
  double wall = 0.15;
  double door = 0;
  double corridor = 0;
  bool corridors = true;
  double jitter = 0.4;
  double loops = 0.1;
};

constexpr int kTries = 50;
constexpr int kLeastServed = 4;  // rooms: smaller pieces get no corridor
constexpr int kCrossing = 12;    // pieces with more rooms are cut by a corridor across, smaller ones by one along
constexpr int kCallsPerRoom = 20, kMoreCalls = 1000;  // of halve(), before an attempt is given up

struct Rect {
  int x0, y0, x1, y1;  // half-open, in wall thicknesses
  int size(int axis) const { return axis == 0 ? x1 - x0 : y1 - y0; }
};

class Plan {
 public:
  Plan(const Params& p, int door, int corridor, Rng& rng)
      : p_(p), rng_(rng), corridor_(corridor), least_(2 * door + 3) {}

  /// Divides `r` into n rooms; leaves the plan as it was and returns false if that fails.
  bool halve(const Rect& r, int n, bool corridors_wanted) {
    // Without a limit a tight floor takes exponential time. Another attempt is cheap.
    if (++calls_ > static_cast<long long>(kCallsPerRoom) * p_.rooms + kMoreCalls) return false;
    if (n == 1) {
      rooms.push_back(r);
      return true;
    }
    const bool wide = r.size(0) > r.size(1) || (r.size(0) == r.size(1) && rng_.chance(0.5));
    const int longer = wide ? 0 : 1;
    if (corridors_wanted && n >= kLeastServed) {
      const int axis = n > kCrossing ? longer : 1 - longer;
      // A corridor along the piece serves both halves; they need none of their own.
      if (cut(r, n, axis, corridor_ + 2, n > kCrossing)) return true;
    }
    return cut(r, n, longer, 1, corridors_wanted) || cut(r, n, 1 - longer, 1, corridors_wanted);
  }

  std::vector<Rect> rooms, corridors;

 private:
  int capacity(const Rect& r) const { return ((r.size(0) + 1) / (least_ + 1)) * ((r.size(1) + 1) / (least_ + 1)); }

  /// Tries a cut `thick` wide; as halve() if it fails.
  bool cut(const Rect& r, int n, int axis, int thick, bool corridors_wanted) {
    const int usable = r.size(axis) - thick;
    if (usable < 2 * least_) return false;
    const double share = 0.5 + p_.jitter * rng_.between(-0.3, 0.3);
    const int n1 = std::clamp(static_cast<int>(n * share + 0.5), 1, n - 1);
    const double position = static_cast<double>(n1) / n + (n == 2 ? p_.jitter * rng_.between(-0.2, 0.2) : 0);
    const int at = std::clamp(static_cast<int>(usable * position + 0.5), least_, usable - least_);
    Rect a = r, b = r, strip = r;
    if (axis == 0) {
      a.x1 = r.x0 + at, b.x0 = a.x1 + thick, strip.x0 = a.x1 + 1, strip.x1 = b.x0 - 1;
    } else {
      a.y1 = r.y0 + at, b.y0 = a.y1 + thick, strip.y0 = a.y1 + 1, strip.y1 = b.y0 - 1;
    }
    if (capacity(a) < n1 || capacity(b) < n - n1) return false;
    const std::size_t kept_rooms = rooms.size(), kept_corridors = corridors.size();
    if (thick > 1) corridors.push_back(strip);
    if (halve(a, n1, corridors_wanted) && halve(b, n - n1, corridors_wanted)) return true;
    rooms.resize(kept_rooms);
    corridors.resize(kept_corridors);
    return false;
  }

  const Params& p_;
  Rng& rng_;
  int corridor_, least_;
  long long calls_ = 0;
};

/// Rooms and corridors drawn on cells, with their labels.
struct Floor {
  BitGrid grid;            // free cells
  std::vector<int> label;  // by cell: 0 for wall, rooms from 1, then corridors
  int rooms, labels;       // how many
};

Floor drawn(const Plan& plan, const BitGrid& walls) {
  Floor floor{walls, {}, static_cast<int>(plan.rooms.size()), 0};
  floor.label.assign(floor.grid.bits.size(), 0);
  for (const auto* rects : {&plan.rooms, &plan.corridors})
    for (const Rect& r : *rects) {
      ++floor.labels;
      for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) {
          floor.label[floor.grid.at(x, y)] = floor.labels;
          floor.grid.set(x, y, true);
        }
    }
  return floor;
}

/// A straight piece of wall between one room and another.
struct WallPiece {
  int a, b;      // labels
  bool upright;  // a vertical wall at x = line
  int line, from, to;
};

std::vector<WallPiece> wall_pieces(const Floor& floor) {
  std::vector<WallPiece> all;
  const auto at = [&](int x, int y) { return floor.label[floor.grid.at(x, y)]; };
  const auto scan = [&](bool upright, int lines, int cells) {
    for (int line = 1; line + 1 < lines; ++line) {
      for (int k = 0; k < cells; ++k) {
        const int x = upright ? line : k, y = upright ? k : line;
        if (at(x, y) != 0) continue;
        const int a = upright ? at(x - 1, y) : at(x, y - 1), b = upright ? at(x + 1, y) : at(x, y + 1);
        if (a == 0 || b == 0) continue;
        if (!all.empty() && all.back().upright == upright && all.back().line == line && all.back().to == k &&
            all.back().a == a && all.back().b == b)
          ++all.back().to;
        else
          all.push_back({a, b, upright, line, k, k + 1});
      }
    }
  };
  scan(true, floor.grid.columns, floor.grid.rows);
  scan(false, floor.grid.rows, floor.grid.columns);
  return all;
}

void open_doors(Floor& floor, int door, double loops, Rng& rng) {
  struct Candidate {
    int corridors;
    std::uint64_t order;
    WallPiece wall;
  };
  std::vector<Candidate> candidates;
  for (const WallPiece& w : wall_pieces(floor))
    if (w.to - w.from >= door) candidates.push_back({(w.a > floor.rooms) + (w.b > floor.rooms), rng.bits(), w});
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return std::tuple(-x.corridors, x.order) < std::tuple(-y.corridors, y.order);
  });
  DisjointSets connected(static_cast<std::size_t>(floor.labels) + 1);
  for (const Candidate& c : candidates) {
    const WallPiece& w = c.wall;
    const bool extra = rng.chance(loops);  // always drawn, so that `loops` changes no other draw
    if (!connected.unite(static_cast<std::size_t>(w.a), static_cast<std::size_t>(w.b)) && !extra) continue;
    int from = w.from, to = w.to;
    if (c.corridors < 2) {
      const int jamb = to - from >= door + 2 ? 1 : 0;  // on both sides, where there is room
      from = rng.between(w.from + jamb, w.to - jamb - door);
      to = from + door;
    }
    for (int k = from; k < to; ++k) floor.grid.set(w.upright ? w.line : k, w.upright ? k : w.line, true);
  }
}

Region make(const Params& p, Rng& rng) {
  const double door_width = passage_width("door", p.door, 2.25, p);
  const double corridor_width = std::max(door_width, passage_width("corridor", p.corridor, 3, p));
  const BitGrid walls = wall_squares(p, p.wall);
  // Limited before the cast: a door wider than the floor is refused below like any other that does not fit.
  const double most = std::max(walls.columns, walls.rows);
  const int door = static_cast<int>(std::min(std::ceil(door_width / p.wall), most));
  const int corridor = static_cast<int>(std::min(std::ceil(corridor_width / p.wall), most));
  for (int attempt = 0; attempt < kTries; ++attempt) {
    Plan plan(p, door, corridor, rng);
    if (!plan.halve({0, 0, walls.columns, walls.rows}, p.rooms, p.corridors)) continue;
    Floor floor = drawn(plan, walls);
    open_doors(floor, door, p.loops, rng);
    return traced(floor.grid, p);
  }
  throw_invalid(
      "{} rooms with doors of {:.4g} m do not fit in {:.4g} x {:.4g} m (a room is at least two doors wide); "
      "take fewer rooms, narrower doors or a larger size",
      p.rooms, door_width, p.width, p.height);
}

}  // namespace

GeneratorInfo rooms() {
  return describe_site<Params>(
      "rooms", "an apartment with doors and corridors",
      "every room reached; doors and corridors at least `passage` robot diameters wide",
      {{"rooms", &Params::rooms, Range{1, 1000000}, "number of rooms, corridors not counted"},
       {"wall", &Params::wall, Range{0.001, 1000}, "metres; thickness of walls"},
       {"door", &Params::door, Range{0, 1000}, "metres, at least; 0: 2.25 robot diameters"},
       {"corridor", &Params::corridor, Range{0, 1000}, "metres, at least; 0: 3 robot diameters; never under a door"},
       {"corridors", &Params::corridors, "corridors where four or more rooms lie and there is space"},
       {"jitter", &Params::jitter, Range{0, 1}, "how unequal the rooms are"},
       {"loops", &Params::loops, Range{0, 1}, "probability of a door that is not needed to reach a room"}},
      make);
}

}  // namespace oxturn::generator
