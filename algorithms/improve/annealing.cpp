#include "algorithms/improve/annealing.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr long kPeriod = 1024;  // moves between two changes of price and temperature
constexpr double kDearer = 1.01, kCheaper = 0.995;

}  // namespace

Annealing::Annealing(const Problem& problem, const Region& target, const Polyline& points, const Options& options)
    : walls_(problem.walls()),
      options_(options),
      price_(options.price),
      path_(points, problem.robot().tool_width),
      witnesses_(target, options.cell, options.radius),
      moves_(problem.robot().tool_width, options.fixed_end) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    witnesses_.capsule(points[i - 1], points[i], news_[0]);
    witnesses_.add(news_[0]);
  }
}

bool Annealing::legal(const Edges& edges) const {
  return std::ranges::all_of(edges, [&](const Edge& e) { return walls_.contains(e.a, e.b); });
}

bool Annealing::try_move(double temperature, Rng& rng) {
  const std::optional<Change> change = moves_.propose(path_, rng);
  if (!change) return false;
  const double most = -temperature * std::log(1 - rng.unit());  // that the energy may rise
  const double longer = change->news.length() - change->olds.length();
  const double each = price_ * witnesses_.area_each();
  if (longer - each * static_cast<double>(witnesses_.uncovered()) > most || !legal(change->news)) return false;
  const auto capsules = [&](const Edges& edges, std::array<Witnesses::Capsule, 4>& out) {
    for (std::size_t k = 0; k < edges.size(); ++k) witnesses_.capsule(edges[k].a, edges[k].b, out[k]);
    return std::span<const Witnesses::Capsule>(out.data(), edges.size());
  };
  const auto olds = capsules(change->olds, olds_), news = capsules(change->news, news_);
  if (longer > most && longer - each * static_cast<double>(witnesses_.gain(olds, news)) > most) return false;
  if (longer + each * static_cast<double>(witnesses_.exchange(olds, news)) > most) {
    witnesses_.exchange(news, olds);
    return false;
  }
  change->apply(path_);
  return true;
}

void Annealing::run(const Schedule& schedule, Rng& rng, const Context& context) {
  double temperature = schedule.hot;
  for (long k = 0; k < schedule.moves && path_.size() > 1; ++k) {
    if (k % kPeriod == 0) {
      if (context.cancelled()) return;
      const double done = static_cast<double>(k) / static_cast<double>(schedule.moves);
      temperature = schedule.hot * std::pow(schedule.cold / schedule.hot, done);
      price_ *= uncovered() > options_.uncovered ? kDearer : kCheaper;
    }
    try_move(temperature, rng);
  }
}

}  // namespace oxturn
