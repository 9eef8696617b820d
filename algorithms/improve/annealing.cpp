#include "algorithms/improve/annealing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr long kPeriods = 500, kLeastPeriod = 64, kMostPeriod = 1024;  // in moves: between changes of the price
constexpr double kDearer = 0.03, kCheaper = -0.01;                     // logarithms of the price's changes at most
// Uncovered points are looked for again after so many bytes of the raster a move: some per cent of the time.
constexpr std::size_t kBytesEach = 256, kMostUncovered = 1000;
constexpr double kPriceRange = 6;  // times and parts of the first price that it may reach

}  // namespace

Annealing::Annealing(const EdgeIndex& walls, VertexPath path, Witnesses witnesses, double tool_width,
                     const Options& options)
    : walls_(walls),
      options_(options),
      price_(options.price),
      path_(std::move(path)),
      witnesses_(std::move(witnesses)),
      moves_({tool_width, options.least_shift, options.most_shift, options.cut_short, options.without}, walls) {}

bool Annealing::legal(const Edges& edges) const {
  return std::ranges::all_of(edges, [&](const Edge& e) { return walls_.contains(e.a, e.b); });
}

bool Annealing::try_move(double temperature, Rng& rng) {
  const std::optional<Change> change = moves_.propose(path_, rng);
  if (!change) return false;
  const double most = -temperature * math::log(1 - rng.unit());  // that the energy may rise
  double longer = change->added.length() - change->removed.length();
  if (options_.turn > 0) longer += options_.turn * change->turning(path_);
  const double each = price_ * witnesses_.area_each();
  if (longer - each * static_cast<double>(witnesses_.uncovered()) > most || !legal(change->added)) return false;
  const auto capsules = [&](const Edges& edges, Capsules& out) {
    for (std::size_t k = 0; k < edges.size(); ++k) witnesses_.capsule(edges[k].a, edges[k].b, out[k]);
    return std::span<const Witnesses::Capsule>(out.data(), edges.size());
  };
  const auto removed = capsules(change->removed, removed_), added = capsules(change->added, added_);
  if (!witnesses_.may_change(removed, added, static_cast<long>(std::floor((most - longer) / each)))) return false;
  if (longer + each * static_cast<double>(witnesses_.exchange(removed, added)) > most) {
    witnesses_.exchange(added, removed);
    return false;
  }
  change->apply(path_);
  return true;
}

void Annealing::run(const Schedule& schedule, Rng& rng, const Context& context) {
  double temperature = schedule.hot;
  const long period = std::clamp(schedule.moves / kPeriods, kLeastPeriod, kMostPeriod);
  long next_look = 0;
  for (long k = 0; k < schedule.moves && path_.size() > 1; ++k) {
    if (k % period == 0) {
      if (context.cancelled()) return;
      if (k >= next_look) {
        moves_.uncovered(witnesses_.uncovered_points(kMostUncovered));
        next_look = k + std::max(period, static_cast<long>(witnesses_.bytes() / kBytesEach));
      }
      const double done = static_cast<double>(k) / static_cast<double>(schedule.moves);
      temperature = schedule.hot * math::pow(schedule.cold / schedule.hot, done);
      if (!options_.floating) {
        try_move(temperature, rng);
        continue;
      }
      const double excess = uncovered() / options_.uncovered - 1;
      price_ = std::clamp(price_ * math::exp(std::clamp(kDearer * excess, kCheaper, kDearer)),
                          options_.price / kPriceRange, options_.price * kPriceRange);
    }
    try_move(temperature, rng);
  }
}

}  // namespace oxturn
