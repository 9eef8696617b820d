// Method      Cells half a tool width wide. From each, the capsules near its centre are subtracted, nearest first
//             (convex_rest.hpp): in a cell between two laps that takes a few. Cells that meet the region's boundary
//             take the segments themselves, and what they leave counts only where it lies in the region. The capsules
//             are found through bands of rows, so that few cells' lists are in memory at a time.
#include "algorithms/lanes/covered_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "algorithms/lanes/convex_rest.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kCell = 1;           // radii
constexpr double kOff = 0.04;         // radii: chords are off their curve by this at most
constexpr double kThin = 1e-7;        // radii: what is thinner does not count
constexpr std::size_t kLongest = 32;  // segments under a chord
constexpr std::size_t kFew = 2000;    // segments: an overlay takes milliseconds
constexpr double kMostCells = 1;      // for each segment: with more, an overlay costs less
constexpr int kBand = 64;             // rows
const Point kShift(0.37, 0.61);       // cells: walls seldom lie along the grid's lines

/// Some consecutive segments of a line, and the straight one that stands for them.
struct Chord {
  Point a, b;
  double radius;                        // of its capsule: less by what the chord is off
  std::uint32_t group, line, from, to;  // segments of a line
};

/// A chord with the cells of one row that it reaches.
struct Reach {
  int first, last;
};

/// By how much the points between two of a line are off the straight segment; infinite, if that is more than `most`.
double off_chord(const Polyline& line, std::size_t from, std::size_t to, double most) {
  double off = 0;
  for (std::size_t k = from + 1; k < to && off <= most; ++k)
    off = std::max(off, distance_to_segment(line[k], line[from], line[to]));
  return off <= most ? off : std::numeric_limits<double>::infinity();
}

class CoverGrid {
 public:
  CoverGrid(const Region& region, const std::vector<WideLines>& groups) : region_(region), groups_(groups) {
    cell_ = std::numeric_limits<double>::infinity();
    for (const WideLines& group : groups) {
      cell_ = std::min(cell_, kCell * group.radius);
      for (const Polyline& line : group.lines) segments_ += std::max<std::size_t>(line.size(), 2) - 1;
    }
  }

  bool is_worthwhile() {
    if (segments_ < kFew || region_.empty()) return false;
    Box box = bounding_box(region_);
    const Point size = box.size() / cell_;
    if ((size.x() + 2) * (size.y() + 2) > kMostCells * static_cast<double>(segments_)) return false;
    columns_ = static_cast<int>(size.x()) + 2;
    rows_ = static_cast<int>(size.y()) + 2;
    origin_ = box.low - cell_ * kShift;
    return true;
  }

  OpenCells find() {
    touched_ = rasterise(region_, origin_, cell_, columns_, rows_, CellRule::touches);
    inside_ = rasterise(region_, origin_, cell_, columns_, rows_, CellRule::inside);
    open_ = BitGrid(origin_, cell_, columns_, rows_);
    for (std::size_t g = 0; g < groups_.size(); ++g) add_chords(g);
    is_near_.assign(chords_.size(), false);
    sort_into_bands();
    for (int band = 0; band * kBand < rows_; ++band) look_at(band);
    return {clipped(), near_lines()};
  }

 private:
  static double radius(const WideLines& group) { return group.radius + kSeamShare * group.seam; }
  const Polyline& line(const Chord& c) const { return groups_[c.group].lines[c.line]; }
  double radius(const Chord& c) const { return radius(groups_[c.group]); }
  double off(const Chord& c) const { return radius(c) - c.radius; }

  void add_chords(std::size_t g) {
    const double most = kOff * groups_[g].radius;
    for (std::size_t l = 0; l < groups_[g].lines.size(); ++l) {
      const Polyline& line = groups_[g].lines[l];
      const auto add = [&](std::size_t from, std::size_t to, double off) {
        chords_.push_back({line[from], line[to], radius(groups_[g]) - off, static_cast<std::uint32_t>(g),
                           static_cast<std::uint32_t>(l), static_cast<std::uint32_t>(from),
                           static_cast<std::uint32_t>(to)});
      };
      if (line.size() == 1) add(0, 0, 0);
      for (std::size_t from = 0; from + 1 < line.size();) {
        std::size_t to = from + 1;
        double off = 0;
        while (to + 1 < line.size() && to < from + kLongest) {
          const double wider = off_chord(line, from, to + 1, most);
          if (wider > most) break;
          off = wider, ++to;
        }
        add(from, to, off);
        from = to;
      }
    }
  }

  int row(double y) const { return std::clamp(static_cast<int>(std::floor((y - origin_.y()) / cell_)), 0, rows_ - 1); }
  int column(double x) const {
    return std::clamp(static_cast<int>(std::floor((x - origin_.x()) / cell_)), 0, columns_ - 1);
  }
  std::pair<int, int> rows_of(const Chord& c) const {
    const double a = c.a.y(), b = c.b.y(), r = radius(c);
    return {row(std::min(a, b) - r), row(std::max(a, b) + r)};
  }
  void sort_into_bands() {
    bands_.assign(static_cast<std::size_t>((rows_ + kBand - 1) / kBand), {});
    for (std::size_t k = 0; k < chords_.size(); ++k) {
      const auto [first, last] = rows_of(chords_[k]);
      for (int band = first / kBand; band <= last / kBand; ++band)
        bands_[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(k));
    }
  }

  /// The columns of a row that a chord's capsule may reach.
  Reach reach_in(int row, const Chord& c) const {
    const Point &a = c.a, &b = c.b;
    const double r = radius(c), low = origin_.y() + row * cell_ - r, high = low + cell_ + 2 * r, dy = b.y() - a.y();
    double s = 0, t = 1;
    if (dy != 0) {
      s = std::clamp((low - a.y()) / dy, 0.0, 1.0);
      t = std::clamp((high - a.y()) / dy, 0.0, 1.0);
    }
    const double x0 = a.x() + s * (b.x() - a.x()), x1 = a.x() + t * (b.x() - a.x());
    return {column(std::min(x0, x1) - r), column(std::max(x0, x1) + r)};
  }

  /// Lists the chords of each cell of the band, and looks at its cells.
  void look_at(int band) {
    const int low = band * kBand, high = std::min(low + kBand, rows_);
    const std::vector<std::uint32_t>& chords = bands_[static_cast<std::size_t>(band)];
    std::vector<std::uint32_t> first(static_cast<std::size_t>((high - low) * columns_) + 1, 0);
    const auto for_each_entry = [&](auto f) {
      for (const std::uint32_t k : chords) {
        const auto [bottom, top] = rows_of(chords_[k]);
        for (int j = std::max(bottom, low); j <= std::min(top, high - 1); ++j) {
          const Reach reach = reach_in(j, chords_[k]);
          for (int i = reach.first; i <= reach.last; ++i)
            if (touched_.get(i, j)) f(static_cast<std::size_t>((j - low) * columns_ + i), k);
        }
      }
    };
    for_each_entry([&](std::size_t cell, std::uint32_t) { ++first[cell + 1]; });
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<std::uint32_t> entries(first.back()), next(first.begin(), first.end() - 1);
    for_each_entry([&](std::size_t cell, std::uint32_t k) { entries[next[cell]++] = k; });
    for (int j = low; j < high; ++j)
      for (int i = 0; i < columns_; ++i) {
        if (!touched_.get(i, j)) continue;
        const auto cell = static_cast<std::size_t>((j - low) * columns_ + i);
        const std::span<const std::uint32_t> near(entries.data() + first[cell], entries.data() + first[cell + 1]);
        if (is_covered(i, j, near)) continue;
        open_.set(i, j, true);
        for (const std::uint32_t k : near) is_near_[k] = true;
      }
  }

  /// A capsule near a cell, relative to its centre.
  struct Capsule {
    double far2;  // from the centre, squared
    Point a, b;
    double radius;
  };
  bool is_covered(int i, int j, std::span<const std::uint32_t> near) {
    centre_ = touched_.centre(i, j);
    const bool inside = inside_.get(i, j);
    if (inside && is_covered(near, true, true)) return true;
    return is_covered(near, false, inside);
  }

  /// By chords or by the segments under them. `inside`: does all of the cell count?
  bool is_covered(std::span<const std::uint32_t> near, bool chords, bool inside) {
    capsules_.clear();
    for (const std::uint32_t k : near) {
      const Chord& c = chords_[k];
      if (chords || c.to <= c.from + 1) {
        add_capsule(c.a, c.b, c.radius);
        continue;
      }
      const double reach = radius(c) + off(c) + cell_ * std::sqrt(0.5);
      if (distance_to_segment(centre_, c.a, c.b) > reach) continue;
      for (std::size_t s = c.from; s < c.to; ++s) add_capsule(line(c)[s], line(c)[s + 1], radius(c));
    }
    const Point half(cell_ / 2, cell_ / 2);
    rest_.reset({-half, half});
    while (!rest_.empty() && !capsules_.empty()) {  // the nearest first
      const auto nearest = std::ranges::min_element(capsules_, {}, &Capsule::far2);
      if (!rest_.subtract(nearest->a, nearest->b, nearest->radius)) return false;
      *nearest = capsules_.back();
      capsules_.pop_back();
    }
    if (inside) return rest_.empty();
    return std::ranges::none_of(rest_, [this](const ConvexPiece& piece) { return counts(piece); });
  }
  void add_capsule(const Point& a, const Point& b, double radius) {
    const Point from = a - centre_, to = b - centre_;
    const double far2 = nearest_on_segment({0, 0}, from, to).squaredNorm(), reach = radius + cell_ * std::sqrt(0.5);
    if (far2 < reach * reach) capsules_.push_back({far2, from, to, radius});
  }

  /// Does some of the piece lie in the region?
  bool counts(const ConvexPiece& piece) {
    if (!edges_) edges_.emplace(region_);
    Box box;
    Point middle(0, 0);
    for (const Point& p : piece) box.add(p + centre_), middle += p / static_cast<double>(piece.size);
    bool meets = false;
    edges_->for_each_near(box, [&](std::size_t e) {
      meets = meets || runs_through(piece, edges_->edges()[e].a - centre_, edges_->edges()[e].b - centre_);
    });
    return meets || edges_->contains(middle + centre_);
  }
  /// Does the segment have points inside the piece, not only along its boundary?
  bool runs_through(const ConvexPiece& piece, const Point& a, const Point& b) const {
    double from = 0, to = 1;
    for (std::size_t k = 0; k < piece.size; ++k) {
      const Point &p = piece.at[k], &q = piece.at[k + 1 < piece.size ? k + 1 : 0];
      const Point side = q - p;
      const double size = side.norm(), thin = kThin * cell_;
      if (size <= thin) continue;
      const double u = cross(side, a - p) / size - thin, v = cross(side, b - p) / size - thin;
      if (u <= 0 && v <= 0) return false;
      if (u < 0) from = std::max(from, u / (u - v));
      if (v < 0) to = std::min(to, u / (u - v));
    }
    return from < to;
  }

  /// The region in the open cells. Holes far from these need not be looked at.
  Region clipped() const {
    const Region cells = trace(open_);
    if (cells.empty()) return {};
    Region part;
    for (const Polygon& polygon : region_.polygons) {
      if (!is_near_open(polygon.outer)) continue;
      Polygon& kept = part.polygons.emplace_back(Polygon{polygon.outer, {}});
      for (const Ring& hole : polygon.holes)
        if (is_near_open(hole)) kept.holes.push_back(hole);
    }
    return intersect(part, cells);
  }
  /// Is a cell that meets a ring's bounding box open?
  bool is_near_open(const Ring& ring) const {
    const Box box = bounding_box(ring);
    for (int j = row(box.low.y()); j <= row(box.high.y()); ++j)
      for (int i = column(box.low.x()); i <= column(box.high.x()); ++i)
        if (open_.get(i, j)) return true;
    return false;
  }

  std::vector<std::vector<Polyline>> near_lines() const {
    std::vector<std::vector<Polyline>> near(groups_.size());
    const Chord* before = nullptr;
    for (std::size_t k = 0; k < chords_.size(); ++k) {
      if (!is_near_[k]) continue;
      const Chord& c = chords_[k];
      const Polyline& points = line(c);
      std::vector<Polyline>& runs = near[c.group];
      const auto begin = points.begin() + c.from, end = points.begin() + c.to + 1;
      if (before == &c - 1 && before->group == c.group && before->line == c.line)
        runs.back().insert(runs.back().end(), begin + 1, end);
      else
        runs.emplace_back(begin, end);
      before = &c;
    }
    return near;
  }

  const Region& region_;
  const std::vector<WideLines>& groups_;
  std::size_t segments_ = 0;
  double cell_;
  Point origin_{0, 0};
  int columns_ = 0, rows_ = 0;
  BitGrid touched_, inside_, open_;
  std::vector<Chord> chords_;
  std::vector<bool> is_near_;                      // by chord
  std::vector<std::vector<std::uint32_t>> bands_;  // of rows: the chords that reach them
  std::optional<EdgeIndex> edges_;                 // of the region, made when first needed
  // Working memory of one cell.
  Point centre_{0, 0};
  std::vector<Capsule> capsules_;
  ConvexRest rest_;
};

}  // namespace

std::optional<OpenCells> in_open_cells(const Region& region, const std::vector<WideLines>& lines) {
  CoverGrid grid(region, lines);
  if (!grid.is_worthwhile()) return std::nullopt;
  return grid.find();
}

}  // namespace oxturn
