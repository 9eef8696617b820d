// A building with many connections and small rooms that branch off: the complex space of Berg 2021.
//
// Source      after the "complex spaces with many connecting paths and small branching rooms" of Berg 2021 (section 4,
//             figures 4.4 and 4.5). There are only pictures: a grid of rooms is our reading.
// Method      A grid of rooms of unequal size. Doors, often two in one wall, along a random spanning tree (Kruskal) and
//             through `loops` of the other walls: nearly every wall is an island that a tether can catch on. Corners of
//             rooms become small rooms with one door: dead ends.
// Guarantee   Every room and every small room is reached. Doors, and what small rooms leave of a room, are at least
//             `passage` robot diameters wide: a small room leaves at least half a door on its side of the wall's
//             middle, so two of them always leave a whole door.
// Complexity  O(cells of wall thickness)
// Decisions   Everything is a multiple of the wall's thickness, stretched a little to fill the size, as in `rooms`.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = 20, height = 15; }
  int columns = 4;
  int rows = 3;
  double wall = 0.15;
  double door = 0;
  int doors = 2;
  double loops = 0.85;
  double branches = 0.35;
  double jitter = 0.3;
};

/// Extent of a room along one axis, in wall thicknesses: [from, to).
struct Span {
  int from = 0, to = 0;
  int size() const { return to - from; }
};

/// `n` rooms with walls between them in `cells`; every room is at least `least` wide. The caller has checked that they
/// fit.
std::vector<Span> spans(int n, int cells, int least, double jitter, Rng& rng) {
  const int spare = cells - (n - 1) - n * least;
  std::vector<double> weight;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += weight.emplace_back(1 + jitter * rng.between(-1.0, 1.0));
  std::vector<Span> all;
  double before = 0;
  for (int i = 0; i < n; ++i) {
    const int given = static_cast<int>(spare * std::min(1.0, before / sum));
    before += weight[static_cast<std::size_t>(i)];
    const int next = i + 1 == n ? spare : static_cast<int>(spare * std::min(1.0, before / sum));
    const int from = i * (least + 1) + given;
    all.push_back({from, from + least + next - given});
  }
  return all;
}

/// A small room in a corner of a room: its size without walls, 0 if there is none.
struct Branch {
  int width = 0, height = 0;
};
enum Corner : std::size_t { kLowerLeft, kLowerRight, kUpperLeft, kUpperRight };
constexpr std::array<Corner, 4> kCorners{kLowerLeft, kLowerRight, kUpperLeft, kUpperRight};
bool is_right(Corner c) { return c == kLowerRight || c == kUpperRight; }
bool is_upper(Corner c) { return c == kUpperLeft || c == kUpperRight; }
using Branches = std::array<Branch, 4>;  // by corner

class Building {
 public:
  Building(const Params& p, const BitGrid& walls, int door, Rng& rng)
      : p_(p),
        door_(door),
        rng_(rng),
        grid_(walls),
        xs_(spans(p.columns, walls.columns, 2 * door + 1, p.jitter, rng)),
        ys_(spans(p.rows, walls.rows, 2 * door + 1, p.jitter, rng)),
        branches_(xs_.size() * ys_.size()) {
    for (const Span& y : ys_)
      for (const Span& x : xs_) open(x, y);
    for (std::size_t room = 0; room < branches_.size(); ++room) add_branches(room);
    open_doors();
  }
  const BitGrid& grid() const { return grid_; }

 private:
  const Span& x_of(std::size_t room) const { return xs_[room % xs_.size()]; }
  const Span& y_of(std::size_t room) const { return ys_[room / xs_.size()]; }

  void open(const Span& x, const Span& y, bool value = true) {
    for (int j = y.from; j < y.to; ++j)
      for (int i = x.from; i < x.to; ++i) grid_.set(i, j, value);
  }

  void add_branches(std::size_t room) {
    const int most_width = (x_of(room).size() - door_) / 2 - 1, most_height = (y_of(room).size() - door_) / 2 - 1;
    for (const Corner corner : kCorners) {
      const bool wanted = rng_.chance(p_.branches);  // always drawn, so that a room's size changes no other draw
      if (!wanted || most_width < door_ || most_height < door_) continue;
      // Where there is room, the door has a jamb on both sides.
      const auto size = [&](int most) { return rng_.between(std::min(door_ + 2, most), most); };
      Branch b;
      b.width = size(most_width);
      b.height = size(most_height);
      branches_[room][corner] = b;
      draw_branch(room, corner, b);
    }
  }

  /// The two walls of a small room, then its one door, through either of them.
  void draw_branch(std::size_t room, Corner corner, const Branch& b) {
    const Span &x = x_of(room), &y = y_of(room);
    const bool right = is_right(corner), upper = is_upper(corner);
    const int wall_x = right ? x.to - b.width - 1 : x.from + b.width;
    const int wall_y = upper ? y.to - b.height - 1 : y.from + b.height;
    const Span along_x = right ? Span{wall_x, x.to} : Span{x.from, wall_x + 1};
    const Span along_y = upper ? Span{wall_y, y.to} : Span{y.from, wall_y + 1};
    open({wall_x, wall_x + 1}, along_y, false);
    open(along_x, {wall_y, wall_y + 1}, false);
    if (rng_.chance(0.5)) {
      const int from = door_position(upper ? wall_y + 1 : y.from, b.height);
      open({wall_x, wall_x + 1}, {from, from + door_});
    } else {
      const int from = door_position(right ? wall_x + 1 : x.from, b.width);
      open({from, from + door_}, {wall_y, wall_y + 1});
    }
  }
  int door_position(int from, int size) {
    const int jamb = size >= door_ + 2 ? 1 : 0;
    return from + rng_.between(jamb, size - door_ - jamb);
  }

  /// A wall between two neighbouring rooms; `b` lies to the right of `a` or above it.
  struct Wall {
    std::size_t a, b;
    bool upright;
  };

  /// The part of a wall that no small room takes on either side. At least a door long.
  Span common(const Wall& wall) const {
    Span s = wall.upright ? y_of(wall.a) : x_of(wall.a);
    const auto taken = [&](std::size_t room, Corner corner) {
      const Branch& branch = branches_[room][corner];
      return branch.width == 0 ? 0 : (wall.upright ? branch.height : branch.width) + 1;
    };
    const Corner a_high = kUpperRight, b_low = kLowerLeft;
    const Corner a_low = wall.upright ? kLowerRight : kUpperLeft, b_high = wall.upright ? kUpperLeft : kLowerRight;
    s.from += std::max(taken(wall.a, a_low), taken(wall.b, b_low));
    s.to -= std::max(taken(wall.a, a_high), taken(wall.b, b_high));
    return s;
  }

  void open_doors() {
    std::vector<Wall> walls;
    for (std::size_t room = 0; room < branches_.size(); ++room) {
      if (room % xs_.size() + 1 < xs_.size()) walls.push_back({room, room + 1, true});
      if (room / xs_.size() + 1 < ys_.size()) walls.push_back({room, room + xs_.size(), false});
    }
    rng_.shuffle(walls);
    DisjointSets connected(branches_.size());
    for (const Wall& wall : walls) {
      const bool extra = rng_.chance(p_.loops);
      if (connected.unite(wall.a, wall.b) || extra) open_doors_in(wall);
    }
  }
  void open_doors_in(const Wall& wall) {
    const Span span = common(wall);
    const int line = wall.upright ? x_of(wall.a).to : y_of(wall.a).to;
    // Between two doors there is as much wall as a door is wide.
    const int fit = std::clamp((span.size() + door_) / (2 * door_), 1, p_.doors);
    const int doors = rng_.between(1, fit);
    for (int k = 0; k < doors; ++k) {
      const int from = span.from + span.size() * k / doors, to = span.from + span.size() * (k + 1) / doors;
      const int room = to - from - door_ - (k + 1 < doors ? door_ / 2 : 0);
      const int at = from + rng_.between(0, std::max(0, room));
      for (int c = at; c < at + door_; ++c) grid_.set(wall.upright ? line : c, wall.upright ? c : line, true);
    }
  }

  const Params& p_;
  int door_;
  Rng& rng_;
  BitGrid grid_;
  std::vector<Span> xs_, ys_;
  std::vector<Branches> branches_;  // of each room, row by row
};

Region make(const Params& p, Rng& rng) {
  const double door_width = passage_width("door", p.door, 2, p);
  const BitGrid walls = wall_squares(p, p.wall);
  // Limited before the cast: a door wider than the floor is refused below.
  const int door =
      static_cast<int>(std::min(std::ceil(door_width / p.wall), 1.0 * std::max(walls.columns, walls.rows)));
  const auto fit = [&](const char* name, int n, int cells, double metres) {
    const int most = (cells + 1) / (2 * door + 2);  // a room is a little over two doors wide, and a wall thick
    if (n > most)
      throw_invalid(
          "{} is {}, but only {} rooms with doors of {:.4g} m fit in {:.4g} m (a room is two doors wide); take "
          "fewer, narrower doors or a larger size",
          name, n, most, door_width, metres);
  };
  fit("columns", p.columns, walls.columns, p.width);
  fit("rows", p.rows, walls.rows, p.height);
  return traced(Building(p, walls, door, rng).grid(), p);
}

}  // namespace

GeneratorInfo berg_rooms() {
  return describe_site<Params>(
      "berg-rooms", "a building with many connections and small branching rooms, as in Berg 2021",
      "every room and small room reached, small rooms by one door; doors at least `passage` robot diameters wide",
      {{"columns", &Params::columns, Range{1, 10000}, "rooms side by side"},
       {"rows", &Params::rows, Range{1, 10000}, "rooms above each other"},
       {"wall", &Params::wall, Range{0.001, 1000}, "metres; thickness of walls"},
       {"door", &Params::door, Range{0, 1000}, "metres, at least; 0: 2 robot diameters"},
       {"doors", &Params::doors, Range{1, 1000}, "most doors in the wall between two rooms"},
       {"loops", &Params::loops, Range{0, 1}, "probability of doors in a wall that needs none"},
       {"branches", &Params::branches, Range{0, 1},
        "probability that a corner of a room is a small room, where there is space"},
       {"jitter", &Params::jitter, Range{0, 1}, "how unequal the rooms are"}},
      make);
}

}  // namespace oxturn::generator
