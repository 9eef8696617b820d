#include "algorithms/grid/nearest_part.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace oxturn {
namespace {
// Of each part only so many entries, nearest in straight line first, are tried for one question: behind a wall
// thousands may be near in the air, and the next few tell nothing new.
constexpr int kTriesPerPart = 6;
}  // namespace

void NearestPart::drop(int part) {
  if (dropped_.size() <= static_cast<std::size_t>(part)) dropped_.resize(static_cast<std::size_t>(part) + 1, false);
  if (dropped_[static_cast<std::size_t>(part)]) return;
  dropped_[static_cast<std::size_t>(part)] = true;
  for (const Entry& e : entries_) gone_ += e.part == part;
  if (2 * gone_ < entries_.size()) return;
  std::erase_if(entries_, [&](const Entry& e) { return dropped(e.part); });
  gone_ = 0;
  indexed_ = 0;
}

void NearestPart::index() const {
  if (indexed_ == entries_.size()) return;
  box_ = Box{};
  for (const Entry& e : entries_) box_.add(e.at);
  const Point size = box_.size();
  cell_ =
      std::max({std::sqrt(size.x() * size.y() / static_cast<double>(entries_.size())), size.maxCoeff() / 4096, 1e-9});
  columns_ = static_cast<int>(size.x() / cell_) + 1;
  rows_ = static_cast<int>(size.y() / cell_) + 1;
  const auto cell_of = [&](const Point& p) {
    const auto i = static_cast<std::size_t>((p.x() - box_.low.x()) / cell_);
    const auto j = static_cast<std::size_t>((p.y() - box_.low.y()) / cell_);
    return j * static_cast<std::size_t>(columns_) + i;
  };
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Entry& e : entries_) ++first_[cell_of(e.at) + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  items_.resize(entries_.size());
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < entries_.size(); ++k)
    items_[fill[cell_of(entries_[k].at)]++] = static_cast<std::uint32_t>(k);
  indexed_ = entries_.size();
}

std::optional<NearestPart::Found> NearestPart::from(const Point& p) const {
  if (entries_.size() == gone_) return std::nullopt;
  index();
  const int i0 = static_cast<int>(std::clamp((p.x() - box_.low.x()) / cell_, 0.0, columns_ - 1.0));
  const int j0 = static_cast<int>(std::clamp((p.y() - box_.low.y()) / cell_, 0.0, rows_ - 1.0));
  std::optional<Found> best;
  double best_length = std::numeric_limits<double>::infinity();
  std::map<int, int> tries;
  struct Near {
    double straight;
    std::uint32_t entry;
  };
  std::vector<Near> waiting;  // met in rings, not yet tried: a ring's far corner may be farther than the next ring
  const int rings = std::max({i0, columns_ - 1 - i0, j0, rows_ - 1 - j0});
  for (int ring = 0; ring <= rings; ++ring) {
    const auto visit = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return;
      const std::size_t c =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
      for (std::uint32_t k = first_[c]; k < first_[c + 1]; ++k)
        if (!dropped(entries_[items_[k]].part)) waiting.push_back({distance(p, entries_[items_[k]].at), items_[k]});
    };
    for (int i = i0 - ring; i <= i0 + ring; ++i) {
      visit(i, j0 - ring);
      if (ring > 0) visit(i, j0 + ring);
    }
    for (int j = j0 - ring + 1; j < j0 + ring; ++j) {
      visit(i0 - ring, j);
      visit(i0 + ring, j);
    }
    // Everything within `sure` of p has been met by now.
    const double sure = ring == rings ? std::numeric_limits<double>::infinity()
                                      : ring * cell_ - distance(p, p.cwiseMax(box_.low).cwiseMin(box_.high));
    std::sort(waiting.begin(), waiting.end(), [](const Near& a, const Near& b) {
      return a.straight != b.straight ? a.straight < b.straight : a.entry < b.entry;
    });
    std::size_t done = 0;
    for (; done < waiting.size() && waiting[done].straight <= sure; ++done) {
      if (waiting[done].straight >= best_length) return best;
      const Entry& e = entries_[waiting[done].entry];
      if (tries[e.part]++ >= kTriesPerPart) continue;
      std::optional<Polyline> way = paths_.path(p, e.at, best_length);
      if (!way) continue;
      const double far = length(*way);
      if (far >= best_length) continue;
      best_length = far;
      best = Found{e.id, std::move(*way)};
    }
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(done));
    if (best && sure >= best_length) break;
  }
  return best;
}

}  // namespace oxturn
